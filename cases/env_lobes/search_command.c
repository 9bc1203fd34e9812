#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/sweep.h"
#include "front.h"

typedef struct request {
    lobe_sweep_options sweep;
    lobe_held held;
    const char *csv;
    bool (*write)(const lobe_held *held, int threads, FILE *out);
} request;

/* 0, or 2 after a line on stderr. */
static int parse(int argc, char **argv, request *r)
{
    memset(r, 0, sizeof *r);
    r->sweep = lobe_sweep_options_default();
    r->write = lobe_front_write;
    for (int i = 0; i < argc; i++) {
        if (strcmp(argv[i], "--progress") == 0)
            continue;
        if (strcmp(argv[i], "--fresnel") == 0) {
            r->write = lobe_fresnel_front_write;
        } else if (strcmp(argv[i], "--shape") == 0) {
            r->write = lobe_shape_front_write;
        } else if (i + 1 < argc && strcmp(argv[i], "--csv") == 0) {
            r->csv = argv[++i];
        } else if (i + 1 < argc && strcmp(argv[i], "--map") == 0 && r->held.file_count < LOBE_HELD_FILES) {
            r->held.files[r->held.file_count++] = argv[++i];
        } else if (i + 1 < argc && strcmp(argv[i], "--threads") == 0) {
            char *rest;
            const long n = strtol(argv[++i], &rest, 10);
            if (rest == argv[i] || *rest || n < 1 || n > LOBE_SWEEP_THREADS) {
                fprintf(stderr, "lobefit: search: --threads '%s' is not a whole number in [1, %d]\n", argv[i],
                        LOBE_SWEEP_THREADS);
                return 2;
            }
            r->sweep.threads = (int)n;
        } else {
            fprintf(stderr,
                    "lobefit: search: unknown option '%s', or its value is missing; it takes --csv FILE --map FILE (at "
                    "most %d) --threads N --progress --fresnel --shape\n",
                    argv[i], LOBE_HELD_FILES);
            return 2;
        }
    }
    return 0;
}

int lobe_env_lobes_search(const lobe_case *self, int argc, char **argv)
{
    request r;
    lobe_atomic_file file;
    (void)self;
    if (parse(argc, argv, &r))
        return 2;
    if (!r.csv) {
        if (!r.write(&r.held, r.sweep.threads, stdout))
            return 2;
        return fflush(stdout) != 0 || ferror(stdout) ? 2 : 0;
    }
    if (!lobe_atomic_open(&file, r.csv)) {
        fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", r.csv, strerror(errno));
        return 2;
    }
    if (!r.write(&r.held, r.sweep.threads, file.stream)) {
        lobe_atomic_abandon(&file);
        return 2;
    }
    if (!lobe_atomic_commit(&file)) {
        fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", r.csv, strerror(errno));
        return 2;
    }
    return 0;
}
