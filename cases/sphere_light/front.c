#define LOBE_DOUBLE 1
#include "front.h"
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "judge.h"
#include "ltc.h"
#include "ltc_fit.h"
#include "operations.h"
#include "peers_fit.h"
#include "row.h"

static double both_horizons(const double row[5])
{
    double cell[LOBE_LTC_VALUES];
    lobe_ltc_at(row[0], row[1], cell);
    return lobe_ltc_both_horizons(cell, row);
}

/* No published code does this: what it would gain. */
static const lobe_sphere_candidate beside = {"LTC both horizons", both_horizons, 4 * LOBE_LTC_NUMBERS};

static void judge(const lobe_sphere_candidate *form, const lobe_sphere_cells *cells, lobe_sphere_score *point,
                  FILE *out)
{
    static lobe_sphere_score score;
#if defined(LOBE_WITH_EMIT)
    const int operations = lobe_sphere_operations(form->name);
#else
    const int operations = -1;
#endif
    lobe_sphere_judge(form, cells, &score);
    if (point->worst == 0)
        *point = score;
    fprintf(out, "%s,%s,%s,", cells->held ? "held" : "fit", cells->mixed ? "mixed" : "uniform", form->name);
    if (operations >= 0)
        fprintf(out, "%d", operations);
    fprintf(out, ",%d,%.4f,%.4f,%.4f,%.4f,%+.3f,%.4f\n", form->bytes, score.all, score.view60, score.view75,
            score.worst, score.energy, lobe_sphere_excess(&score, point, cells));
}

static void judge_all(const lobe_sphere_cells *cells, FILE *out)
{
    static lobe_sphere_score point;
    int i;
    if (!cells->mixed)
        fputs("cells,positions,form,operations,bytes,all,view60,view75,worst_cell,worst_energy,small_over_point\n",
              out);
    point.worst = 0;
    for (i = 0; lobe_sphere_candidate_at(i); i++)
        judge(lobe_sphere_candidate_at(i), cells, &point, out);
    judge(&beside, cells, &point, out);
}

/* The columns of the runtime, not azimuth and half angle: they need no library functions. */
static void print_cells(const lobe_sphere_cells *cells, FILE *out)
{
    int i;
    if (!cells->mixed)
        fputs("# positions cell view roughness n_dot_v n_dot_l tangent2 sine truth\n", out);
    for (i = 0; i < LOBE_SPHERE_COUNT; i++) {
        const double *row = cells->in + 5 * i;
        const lobe_sphere s = lobe_sphere_of_row(row);
        const int cell = i / LOBE_SPHERE_POSITIONS;
        fprintf(out, "%s %d %g %.17g %.17g %.17g %.17g %.17g %.17g\n", cells->mixed ? "mixed" : "uniform", cell,
                lobe_sphere_cell_view(cells, cell), row[0], s.n_dot_v, s.n_dot_l, s.tangent2, s.sine, cells->truth[i]);
    }
}

typedef void print_fn(const lobe_sphere_cells *cells, FILE *out);

/* On the held-out cells of both kinds. */
static bool run(print_fn *print, const lobe_sweep_options *sweep, FILE *out)
{
    int set;
    for (set = 0; set < 2; set++) {
        lobe_sphere_cells cells;
        lobe_sweep_options options = *sweep;
        options.label = "truth";
        if (!lobe_sphere_cells_make(&cells, true, set == 1, &options)) {
            lobe_sphere_cells_free(&cells);
            fputs("lobefit: search: not enough memory\n", stderr);
            return false;
        }
        print(&cells, out);
        lobe_sphere_cells_free(&cells);
    }
    return true;
}

/* The exit status. */
static int write_file(print_fn *print, const lobe_sweep_options *sweep, const char *path)
{
    lobe_atomic_file file;
    if (!lobe_atomic_open(&file, path)) {
        fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", path, strerror(errno));
        return 2;
    }
    if (!run(print, sweep, file.stream)) {
        lobe_atomic_abandon(&file);
        return 1;
    }
    if (!lobe_atomic_commit(&file)) {
        fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", path, strerror(errno));
        return 2;
    }
    return 0;
}

static int write_output(print_fn *print, const lobe_sweep_options *sweep)
{
    if (!run(print, sweep, stdout))
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

enum { CSV, CELLS, PEERS, LTC, FILES };

/* 0, or 2 after a line on stderr. */
static int parse(int argc, char **argv, lobe_sweep_options *sweep, const char *file[FILES])
{
    static const char *const names[FILES] = {"--csv", "--cells", "--peers", "--ltc"};
    int i, k;
    for (i = 0; i < argc; i++) {
        for (k = 0; k < FILES && strcmp(argv[i], names[k]) != 0; k++)
            ;
        if (!strcmp(argv[i], "--progress")) {
            sweep->progress = 1;
        } else if (k < FILES && i + 1 < argc) {
            file[k] = argv[++i];
        } else if (!strcmp(argv[i], "--threads") && i + 1 < argc) {
            sweep->threads = threads_of(argv[++i]);
            if (sweep->threads)
                continue;
            fprintf(stderr, "lobefit: search: --threads '%s' is not a whole number in [1, %d]\n", argv[i],
                    LOBE_SWEEP_THREADS);
            return 2;
        } else {
            fprintf(stderr,
                    "lobefit: search: unknown option '%s', or its value is missing; it takes --csv FILE --cells FILE "
                    "--peers FILE --ltc FILE --threads N --progress\n",
                    argv[i]);
            return 2;
        }
    }
    return 0;
}

int lobe_sphere_front_search(const lobe_case *self, int argc, char **argv)
{
    lobe_sweep_options sweep = lobe_sweep_options_default();
    lobe_ltc_fit_options ltc = lobe_ltc_fit_default();
    const char *file[FILES] = {NULL};
    int status = parse(argc, argv, &sweep, file);
    (void)self;
    ltc.sweep.threads = sweep.threads;
    ltc.sweep.progress = sweep.progress;
    if (!status && file[LTC] && !lobe_ltc_fit(&ltc, file[LTC]))
        status = 2;
    if (!status && file[PEERS] && !lobe_sphere_peers_fit(&sweep, file[PEERS]))
        status = 2;
    if (!status && file[CELLS])
        status = write_file(print_cells, &sweep, file[CELLS]);
    if (!status && file[CSV])
        status = write_file(judge_all, &sweep, file[CSV]);
    if (!status && !file[LTC] && !file[PEERS] && !file[CELLS] && !file[CSV])
        status = write_output(judge_all, &sweep);
    return status;
}
