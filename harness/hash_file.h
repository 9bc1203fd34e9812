/* Committed hashes as text: `model tier format hash` a line, '#' starts a comment. */
#ifndef LOBE_HASH_FILE_H
#define LOBE_HASH_FILE_H
#include "conform_core.h"
#include "vec_file.h"

enum { LOBE_HASHES_MAX = 256 };

typedef struct lobe_hash_line {
    char model[32], tier[32];
    lobe_format format;
    uint64_t hash;
} lobe_hash_line;

/* Reads at most LOBE_HASHES_MAX lines. Returns how many, or -1 with the error. */
int lobe_read_hashes(const char *path, lobe_hash_line *lines, lobe_vec_error *error);

#endif
