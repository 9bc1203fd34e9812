/* lobecheck hash: every function's bits against the committed hashes. */
#include "command.h"
#include "hash.h"
#include "hash_file.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>

#define HASH_FILE "vectors/hashes.txt"

static const lobe_hash_line *known_hash(const lobe_hash_line *lines, int count, const lobe_entry *e)
{
    int i;
    for (i = 0; i < count; i++)
        if (lines[i].format == e->format && lobe_same(lines[i].model, e->model) && lobe_same(lines[i].tier, e->tier))
            return &lines[i];
    return NULL;
}

static int check(const char *path)
{
    lobe_hash_line lines[LOBE_HASHES_MAX];
    lobe_vec_error error;
    const int count = lobe_read_hashes(path, lines, &error);
    size_t i;
    int failed = 0, k;
    if (count < 0) {
        lobe_vec_complain(path, &error);
        return 2;
    }
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        const uint64_t hash = lobe_hash_entry(e, LOBE_HASH_COUNT);
        const lobe_hash_line *known = known_hash(lines, count, e);
        const int same = known && known->hash == hash;
        printf("%-14s %-9s %s %016llx ", e->model, e->tier, lobe_format_names[e->format], (unsigned long long)hash);
        if (same)
            printf("OK\n");
        else if (known)
            printf("differs from %016llx\n", (unsigned long long)known->hash);
        else
            printf("is not in %s\n", path);
        failed |= !same;
    }
    for (k = 0; k < count; k++) {
        if (!lobe_find_entry(lines[k].model, lines[k].tier, lines[k].format)) {
            printf("%-14s %-9s %s %016llx is of no function here\n", lines[k].model, lines[k].tier,
                   lobe_format_names[lines[k].format], (unsigned long long)lines[k].hash);
            failed = 1;
        }
    }
    return failed;
}

static int write_hashes(const char *path)
{
    char temporary[1024];
    FILE *stream;
    size_t i;
    int good;
    if (strlen(path) + 5 > sizeof temporary) {
        fprintf(stderr, "lobecheck hash: the file name is too long\n");
        return 2;
    }
    sprintf(temporary, "%s.new", path);
    stream = fopen(temporary, "w");
    if (!stream) {
        fprintf(stderr, "%s: cannot be written: %s\n", temporary, strerror(errno));
        return 2;
    }
    fprintf(stream, "# FNV-1a 64 over the output bits of %d evaluations (harness/hash.c); equal on every target.\n",
            (int)LOBE_HASH_COUNT);
    fprintf(stream, "# command: build/lobecheck hash --write\n");
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        fprintf(stream, "%s %s %s %016llx\n", e->model, e->tier, lobe_format_names[e->format],
                (unsigned long long)lobe_hash_entry(e, LOBE_HASH_COUNT));
    }
    good = !ferror(stream);
    good = fclose(stream) == 0 && good;
    if (!good || rename(temporary, path) != 0) {
        fprintf(stderr, "%s: cannot be written: %s\n", path, strerror(errno));
        remove(temporary);
        return 2;
    }
    return 0;
}

int lobe_command_hash(int argc, char **argv)
{
    const char *path = HASH_FILE, *value;
    int write = 0, i;
    for (i = 0; i < argc; i++) {
        if ((value = lobe_option(argc, argv, &i, "--file")) != NULL) {
            path = value;
        } else if (strcmp(argv[i], "--write") == 0) {
            write = 1;
        } else {
            fprintf(stderr, "lobecheck hash: unexpected '%s'; allowed: --write, --file FILE\n", argv[i]);
            return 2;
        }
    }
    return write ? write_hashes(path) : check(path);
}
