#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "front.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../models/split_sum.h"
#include "../fit/atomic_file.h"
#include "../fit/fit_grid.h"
#include "../fit/interrupt.h"
#include "form.h"
#include "front_corr.h"
#include "front_sep.h"

enum { JUDGE = 256 };

typedef struct candidate {
    lobe_form form;
    int operations;
    const char *published; /* the formula of the same cost; NULL: none */
    double published_max;  /* its largest error on this BRDF, from harness/chart/CASE.csv */
} candidate;

/* clang-format off */
#define FORM(brdf, ops) .kernel = "lobe_front_" #brdf "_" #ops, .call = lobe_front_##brdf##_##ops, .lo = 0.02
#define PROGRAM(brdf, ops, n, paper, most) \
    {{.name = "program", FORM(brdf, ops), .count = n, .coarse = 14, .fine = 40, .starts = 800}, ops, paper, most}
#define W_FORM(brdf, ops, n, k, u, e, paper, most) \
    {{.name = "w form", FORM(brdf, ops), .count = n, .ridge = 1e-6, .coarse = 26, .fine = 52, \
      .bends = k, .constant_of_u = u, .first_of_e = e}, ops, paper, most}
/* clang-format on */

static const candidate corr[] = {
    PROGRAM(corr, 14, 12, "Karis 2014", .4714),
    PROGRAM(corr, 16, 12, "Iwanicki-Pesce 2015", .2501),
    PROGRAM(corr, 17, 12, "Lazarov refit 2014", .4459),
    PROGRAM(corr, 18, 13, "Narkowicz 2014", .3272),
    PROGRAM(corr, 25, 20, "HDRP-Lite", .08274),
    W_FORM(corr, 37, 22, 3, 11, 0.5, "Ray Tracing Gems 2019", .3313),
    W_FORM(corr, 43, 21, 1, 9, -0.5, "MaterialX", .1120),
    W_FORM(corr, 49, 27, 2, 14, 0.5, "Unreal 5", .06456),
    /* high, its domain extended */
    {{.name = "high",
      .kernel = "lobe_split_sum_high",
      .call = lobe_split_sum_high,
      .count = 56,
      .lo = 0.005,
      .ridge = 1e-7,
      .coarse = 26,
      .fine = 60,
      .bends = 2,
      .constant_of_u = 28,
      .first_of_e = 0.5},
     80,
     NULL,
     0},
};
static const candidate sep[] = {
    PROGRAM(sep, 14, 10, "Karis 2014", .196),
    PROGRAM(sep, 16, 14, "Iwanicki-Pesce 2015", .1419),
    PROGRAM(sep, 17, 12, "Lazarov refit 2014", .1687),
    PROGRAM(sep, 18, 16, "Narkowicz 2014", .09273),
    PROGRAM(sep, 25, 21, "HDRP-Lite", .3414),
    W_FORM(sep, 37, 21, 2, 11, 0.5, "Ray Tracing Gems 2019", .05744),
    W_FORM(sep, 43, 30, 2, 16, 0.5, "MaterialX", .2908),
    W_FORM(sep, 49, 36, 1, 23, 0.5, "Unreal 5", .3024),
};

/* A uniform grid: what the fit did not see. */
static bool judge_grid(lobe_fit_grid *g, double lo, const lobe_case *c, const lobe_sweep_options *sweep)
{
    lobe_sweep_options options = *sweep;
    size_t i;
    g->count = (size_t)JUDGE * JUDGE;
    g->at = malloc(2 * g->count * sizeof *g->at);
    g->truth = malloc(2 * g->count * sizeof *g->truth);
    if (!g->at || !g->truth) {
        fputs("lobefit: search: not enough memory\n", stderr);
        return false;
    }
    for (i = 0; i < g->count; i++) {
        g->at[2 * i] = lo + (1 - lo) * (double)(i / JUDGE) / (JUDGE - 1);
        g->at[2 * i + 1] = lo + (1 - lo) * (double)(i % JUDGE) / (JUDGE - 1);
    }
    options.label = "truth";
    lobe_sweep(c->truth, g->at, 2, g->truth, 2, g->count, &options);
    return true;
}

static bool explore(const lobe_case *self, const candidate *k, const lobe_sweep_options *sweep, FILE *out)
{
    lobe_fit_grid coarse = {0}, fine = {0}, judge = {0};
    double c[LOBE_FORM_COEFFICIENTS], max[LOBE_FORM_CHANNELS] = {0}, square[LOBE_FORM_CHANNELS] = {0}, errors[3];
    const lobe_form *f = &k->form;
    size_t r;
    int i;
    bool good = lobe_fit_grid_make(&coarse, f->coarse, f->lo, self, sweep) &&
                lobe_fit_grid_make(&fine, f->fine, f->lo, self, sweep) && judge_grid(&judge, f->lo, self, sweep) &&
                lobe_form_solve(f, &coarse, &fine, 1, sweep->progress, c);
    for (r = 0; good && r < judge.count; r++) {
        lobe_form_errors(f, c, &judge, r, errors);
        for (i = 0; i < LOBE_FORM_CHANNELS; i++) {
            max[i] = fmax(max[i], fabs(errors[i]));
            square[i] += errors[i] * errors[i];
        }
    }
    if (good) {
        const double largest = fmax(max[0], fmax(max[1], max[2])), n = (double)judge.count;
        fprintf(out, "%s,%d,%s,%g,%zu,%.4g,%.4g,%.4g,%.4g,%.4g,%.4g,%s,", self->name, k->operations, f->kernel, f->lo,
                f->count, largest, max[0], max[1], max[2], sqrt(square[0] / n), sqrt(square[1] / n),
                k->published ? k->published : "");
        if (k->published)
            fprintf(out, "%.4g,%.2f", k->published_max, k->published_max / largest);
        else
            fputc(',', out);
        fputc('\n', out);
        fflush(out);
    }
    lobe_fit_grid_free(&coarse);
    lobe_fit_grid_free(&fine);
    lobe_fit_grid_free(&judge);
    return good;
}

static bool run(const lobe_case *self, const lobe_sweep_options *sweep, FILE *out)
{
    const bool separable = !strcmp(self->name, "split_sum_sep");
    const candidate *list = separable ? sep : corr;
    const size_t count = separable ? sizeof sep / sizeof sep[0] : sizeof corr / sizeof corr[0];
    size_t i;
    fputs(
        "case,operations,form,lo,coefficients,max,max_scale,max_bias,max_e,rms_scale,rms_bias,published,published_max,"
        "times_better\n",
        out);
    for (i = 0; i < count; i++) {
        if (!explore(self, &list[i], sweep, out))
            return false;
    }
    return true;
}

int lobe_front_search(const lobe_case *self, int argc, char **argv)
{
    lobe_sweep_options sweep = lobe_sweep_options_default();
    const char *csv = NULL;
    lobe_atomic_file file;
    int i;
    for (i = 0; i < argc; i++) {
        if (!strcmp(argv[i], "--csv") && i + 1 < argc) {
            csv = argv[++i];
        } else if (!strcmp(argv[i], "--progress")) {
            sweep.progress = 1;
        } else {
            fprintf(stderr, "lobefit: search: unknown option '%s'; it takes --csv FILE --progress\n", argv[i]);
            return 2;
        }
    }
    lobe_interrupt_install();
    if (!csv)
        return run(self, &sweep, stdout) ? 0 : 1;
    if (!lobe_atomic_open(&file, csv)) {
        fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", csv, strerror(errno));
        return 2;
    }
    if (!run(self, &sweep, file.stream)) {
        lobe_atomic_abandon(&file);
        return 1;
    }
    if (!lobe_atomic_commit(&file)) {
        fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", csv, strerror(errno));
        return 2;
    }
    return 0;
}
