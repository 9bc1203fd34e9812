#include "front.h"
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/emit.h"
#include "judge.h"
#include "ndf.h"
#include "operations.h"

static void judge_all(const lobe_sg_cells *cells, FILE *out)
{
    static lobe_sg_score score;
    int i;
    for (i = 0; lobe_sg_candidate_at(i); i++) {
        const lobe_sg_candidate *form = lobe_sg_candidate_at(i);
#if defined(LOBE_WITH_EMIT)
        const int operations = lobe_sg_operations(form->name);
#else
        const int operations = -1;
#endif
        lobe_sg_judge(form, cells, &score);
        fprintf(out, "%s,%s,%s,", cells->held ? "held" : "fit", cells->mixed ? "mixed" : "uniform", form->name);
        if (operations >= 0)
            fprintf(out, "%d", operations);
        fprintf(out, ",%.4f,%.4f,%.4f,%+.3f\n", score.all, score.smooth, score.worst, score.energy);
    }
}

/* On both kinds of cells, with both kinds of positions. */
static bool run(const lobe_sweep_options *sweep, FILE *out)
{
    int set;
    fputs("cells,positions,form,operations,all,smooth,worst_cell,worst_energy\n", out);
    for (set = 0; set < 4; set++) {
        lobe_sg_cells cells;
        lobe_sweep_options options = *sweep;
        const bool good = (options.label = "truth", lobe_sg_cells_make(&cells, set < 2, set & 1, &options));
        if (good)
            judge_all(&cells, out);
        else
            fputs("lobefit: search: not enough memory\n", stderr);
        lobe_sg_cells_free(&cells);
        if (!good)
            return false;
    }
    return true;
}

static bool run_ndf(const lobe_sweep_options *sweep, FILE *out)
{
    (void)sweep;
    return lobe_ndf_write(out);
}

typedef bool run_fn(const lobe_sweep_options *sweep, FILE *out);

/* The exit status. */
static int write_file(run_fn *run_one, const lobe_sweep_options *sweep, const char *path)
{
    lobe_atomic_file file;
    if (!lobe_atomic_open(&file, path)) {
        fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", path, strerror(errno));
        return 2;
    }
    if (!run_one(sweep, file.stream)) {
        lobe_atomic_abandon(&file);
        return 1;
    }
    if (!lobe_atomic_commit(&file)) {
        fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", path, strerror(errno));
        return 2;
    }
    return 0;
}

static int write_output(const lobe_sweep_options *sweep)
{
    if (!run(sweep, stdout))
        return 1;
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "lobefit: search: <stdout>: cannot write: %s\n", strerror(errno));
        return 2;
    }
    return 0;
}

/* A whole number in [1, LOBE_SWEEP_THREADS], or 0. */
static int threads_of(const char *text)
{
    char *rest;
    const long n = strtol(text, &rest, 10);
    return rest == text || *rest != '\0' || n < 1 || n > LOBE_SWEEP_THREADS ? 0 : (int)n;
}

int lobe_sg_front_search(const lobe_case *self, int argc, char **argv)
{
    lobe_sweep_options sweep = lobe_sweep_options_default();
    const char *path = NULL, *ndf = NULL;
    int i, status = 0;
    (void)self;
    for (i = 0; i < argc; i++) {
        if (!strcmp(argv[i], "--progress")) {
            sweep.progress = 1;
        } else if (!strcmp(argv[i], "--csv") && i + 1 < argc) {
            path = argv[++i];
        } else if (!strcmp(argv[i], "--ndf") && i + 1 < argc) {
            ndf = argv[++i];
        } else if (!strcmp(argv[i], "--threads") && i + 1 < argc) {
            sweep.threads = threads_of(argv[++i]);
            if (sweep.threads)
                continue;
            fprintf(stderr, "lobefit: search: --threads '%s' is not a whole number in [1, %d]\n", argv[i],
                    LOBE_SWEEP_THREADS);
            return 2;
        } else {
            fprintf(stderr,
                    "lobefit: search: unknown option '%s', or its value is missing; it takes --csv FILE --ndf FILE "
                    "--threads N --progress\n",
                    argv[i]);
            return 2;
        }
    }
    if (ndf)
        status = write_file(run_ndf, &sweep, ndf);
    if (!status && path)
        status = write_file(run, &sweep, path);
    if (!status && !ndf && !path)
        status = write_output(&sweep);
    return status;
}
