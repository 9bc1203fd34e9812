/* A file that appears whole or not at all: written under a temporary name beside its target, then renamed.
 *
 *     lobe_atomic_file file;
 *     if (!lobe_atomic_open(&file, path)) ...            // says why on stderr
 *     fprintf(file.stream, ...);
 *     if (!lobe_atomic_commit(&file)) ...                // says why; the old file still stands
 *     (or lobe_atomic_abandon(&file);)                    // the old file still stands */
#ifndef LOBE_ATOMIC_FILE_H
#define LOBE_ATOMIC_FILE_H

#include <stdbool.h>
#include <stdio.h>

typedef struct lobe_atomic_file {
    FILE *stream;
    char *path, *temporary; /* owned */
} lobe_atomic_file;

bool lobe_atomic_open(lobe_atomic_file *file, const char *path);
/* Flushes, checks every write before, syncs and renames. Either way the handle is closed. */
bool lobe_atomic_commit(lobe_atomic_file *file);
void lobe_atomic_abandon(lobe_atomic_file *file);

#endif
