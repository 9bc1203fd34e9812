#include "front.h"
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/sweep.h"
#include "judge.h"
#include "rooms.h"
#include "shape.h"

/* Seeds that training.c does not use. */
static const struct {
    lobe_room room;
    unsigned seed;
} rooms[] = {
    {LOBE_ROOM_SKY, 101},     {LOBE_ROOM_SKY, 102},    {LOBE_ROOM_LAMPS, 101},  {LOBE_ROOM_LAMPS, 102},
    {LOBE_ROOM_CHECKER, 101}, {LOBE_ROOM_CLOUDS, 101}, {LOBE_ROOM_CLOUDS, 102},
};
enum { ROOMS = sizeof rooms / sizeof rooms[0], FILES = 8, WIDTH = 256 };

typedef struct request {
    lobe_sweep_options sweep;
    const char *csv, *maps[FILES];
    int map_count;
} request;

/* One map's errors and their part of the means. */
static bool judge_one(const char *name, const lobe_environment *map, const request *r, lobe_judge_errors *sum,
                      FILE *out)
{
    lobe_judge_errors e;
    if (!lobe_judge_environment(map, 7, r->sweep.threads, &e)) {
        fputs("lobefit: search: not enough memory\n", stderr);
        return false;
    }
    for (int m = 0; m < LOBE_JUDGE_MODELS; m++) {
        fprintf(out, "%s,%s,%.4f,%.4f,%.4f,%.4f\n", name, lobe_judge_name[m], e.relative[m],
                e.relative[m] / e.relative[0], e.rms[m], e.rms[m] / e.rms[0]);
        sum->relative[m] += e.relative[m] * e.relative[m];
        sum->rms[m] += e.rms[m] * e.rms[m];
    }
    return true;
}

/* The name without its folder. */
static const char *short_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Averaged down to WIDTH columns where they divide. */
static bool judge_file(const char *path, const request *r, lobe_judge_errors *sum, FILE *out)
{
    lobe_environment map, small;
    bool good;
    if (!lobe_environment_load(path, &map))
        return false;
    if (map.width % WIDTH || !lobe_environment_shrink(&map, map.width / WIDTH, &small)) {
        fprintf(stderr, "lobefit: search: '%s' has %d columns, expected a multiple of %d\n", path, map.width, WIDTH);
        lobe_environment_free(&map);
        return false;
    }
    good = judge_one(short_name(path), &small, r, sum, out);
    lobe_environment_free(&small);
    lobe_environment_free(&map);
    return good;
}

/* The shape over 36 points. */
static void judge_shape(FILE *out)
{
    static const double alpha[6] = {.04, .1, .2, .4, .7, 1}, view[6] = {.1, .25, .4, .6, .8, 1};
    for (int m = 0; m < LOBE_JUDGE_MODELS; m++) {
        double sum = 0;
        for (int i = 0; i < 36; i++) {
            lobe_cell_tap taps[LOBE_CELL_TAPS];
            const int count = lobe_judge_taps(m, alpha[i / 6], view[i % 6], taps);
            const double e = lobe_shape_error(alpha[i / 6], view[i % 6], taps, count);
            sum += e * e / 36;
        }
        fprintf(out, "shape,%s,%.4f,,,\n", lobe_judge_name[m], sqrt(sum));
    }
}

static bool run(const request *r, FILE *out)
{
    lobe_judge_errors sum;
    memset(&sum, 0, sizeof sum);
    fputs("environment,model,relative,of_split_sum,rms,rms_of_split_sum\n", out);
    for (int i = 0; i < (int)ROOMS; i++) {
        lobe_environment map;
        char name[40];
        bool good;
        if (!lobe_room_make(&map, rooms[i].room, WIDTH, rooms[i].seed))
            return false;
        snprintf(name, sizeof name, "%s %u", lobe_room_name[rooms[i].room], rooms[i].seed);
        good = judge_one(name, &map, r, &sum, out);
        lobe_environment_free(&map);
        if (!good)
            return false;
    }
    for (int i = 0; i < r->map_count; i++) {
        if (!judge_file(r->maps[i], r, &sum, out))
            return false;
    }
    for (int m = 0; m < LOBE_JUDGE_MODELS; m++)
        fprintf(out, "all,%s,%.4f,%.4f,%.4f,%.4f\n", lobe_judge_name[m],
                sqrt(sum.relative[m] / (double)((int)ROOMS + r->map_count)), sqrt(sum.relative[m] / sum.relative[0]),
                sqrt(sum.rms[m] / (double)((int)ROOMS + r->map_count)), sqrt(sum.rms[m] / sum.rms[0]));
    judge_shape(out);
    return true;
}

/* 0, or 2 after a line on stderr. */
static int parse(int argc, char **argv, request *r)
{
    memset(r, 0, sizeof *r);
    r->sweep = lobe_sweep_options_default();
    for (int i = 0; i < argc; i++) {
        if (strcmp(argv[i], "--progress") == 0)
            continue;
        if (i + 1 < argc && strcmp(argv[i], "--csv") == 0) {
            r->csv = argv[++i];
        } else if (i + 1 < argc && strcmp(argv[i], "--map") == 0 && r->map_count < FILES) {
            r->maps[r->map_count++] = argv[++i];
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
                    "most %d) --threads N --progress\n",
                    argv[i], FILES);
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
        if (!run(&r, stdout))
            return 2;
        return fflush(stdout) != 0 || ferror(stdout) ? 2 : 0;
    }
    if (!lobe_atomic_open(&file, r.csv)) {
        fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", r.csv, strerror(errno));
        return 2;
    }
    if (!run(&r, file.stream)) {
        lobe_atomic_abandon(&file);
        return 2;
    }
    if (!lobe_atomic_commit(&file)) {
        fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", r.csv, strerror(errno));
        return 2;
    }
    return 0;
}
