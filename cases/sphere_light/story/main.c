/* The way to `medium`: its three inner parameters are set free in every cell, then in every pair of alpha and view,
 * then replaced by closed forms; how much each step costs. usage: story CELLS.csv SUMMARY.txt; README.md tells it. */
#define LOBE_DOUBLE 1
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#define LOBE_FIT 1
#include "../../../models/sphere_light.h"
#include "../../fit/atomic_file.h"
#include "../../fit/nelder_mead.h"
#include "../cells.h"
#include "../judge.h"

enum { ALPHAS = 7, HALF_ANGLES = 7, VIEWS = 6, SETS = 2, FREE = 3, COEFFICIENTS = 10, THIN = 1 };
enum { REACH = 2, KNEE = 6, PLATEAU = 9 }; /* coefficients of medium */

/* The shipped coefficients, under other names: this file's are p[i]. */
extern const double lobe_story_shipped[COEFFICIENTS];

typedef struct story {
    lobe_sphere_cells cells[SETS];
    lobe_sphere *light[SETS];
} story;

/* Cells whose parameters are one: half_angle < 0 takes all of them. */
typedef struct group {
    const story *s;
    int alpha, half_angle, view;
} group;

static int cell_of(int alpha, int half_angle, int view) { return (alpha * HALF_ANGLES + half_angle) * VIEWS + view; }

static double square_of(const story *s, int cell, const double p[COEFFICIENTS], int thin)
{
    double sum = 0;
    int set, i;
    for (set = 0; set < SETS; set++) {
        double error = 0, truth = 0;
        for (i = cell * LOBE_SPHERE_POSITIONS; i < (cell + 1) * LOBE_SPHERE_POSITIONS; i += thin) {
            const double t = s->cells[set].truth[i];
            const double e = lobe_sphere_light_medium(p, s->cells[set].in[5 * i], s->light[set][i]) - t;
            error += e * e;
            truth += t * t;
        }
        sum += error / truth / SETS;
    }
    return sum;
}

/* reach, knee, plateau into a set of coefficients without dependencies. */
static void freed(const double x[FREE], double p[COEFFICIENTS])
{
    memcpy(p, lobe_story_shipped, COEFFICIENTS * sizeof *p);
    p[REACH] = x[0];
    p[REACH + 1] = 0;
    p[KNEE] = x[1];
    p[KNEE + 1] = p[KNEE + 2] = 0;
    p[PLATEAU] = x[2];
}

static void errors(void *context, const double *params, size_t count, double *values)
{
    const group *g = context;
    size_t k;
    for (k = 0; k < count; k++) {
        double p[COEFFICIENTS];
        int half_angle;
        freed(params + FREE * k, p);
        values[k] = 0;
        for (half_angle = 0; half_angle < HALF_ANGLES; half_angle++) {
            if (g->half_angle < 0 || g->half_angle == half_angle)
                values[k] += square_of(g->s, cell_of(g->alpha, half_angle, g->view), p, THIN);
        }
    }
}

static void fit(const group *g, double x[FREE])
{
    static const double lower[FREE] = {0, -2, 0}, upper[FREE] = {40, 8, 2};
    const lobe_objective objective = {.f = errors, .ctx = (void *)g, .dim = FREE, .lower = lower, .upper = upper};
    lobe_nm_options options = lobe_nm_default();
    options.size = .05;
    options.value_tolerance = 1e-6;
    options.size_tolerance = 1e-3;
    options.budget = 600;
    lobe_nelder_mead(&objective, &options, x);
}

static const double *row_of(const story *s, int cell) { return s->cells[0].in + 5 * cell * LOBE_SPHERE_POSITIONS; }

/* How much the parameter matters there: the error's rise when it is a quarter off. */
static double weight_of(const story *s, int cell, const double x[FREE], int k)
{
    double y[FREE], p[COEFFICIENTS], before, after;
    memcpy(y, x, sizeof y);
    freed(y, p);
    before = sqrt(square_of(s, cell, p, THIN));
    y[k] = 1.25 * y[k] + .02;
    freed(y, p);
    after = sqrt(square_of(s, cell, p, THIN));
    return fmax(0, after - before);
}

static void write_story(const story *s, FILE *csv, FILE *summary)
{
    double sums[4] = {0, 0, 0, 0}, view75[4] = {0, 0, 0, 0};
    int alpha, half_angle, view, k, grazing = 0;
    fputs("alpha,half_angle,view,reach,knee,plateau,reach_matters,knee_matters,plateau_matters,"
          "free,pair,closed,pair_reach,pair_knee,pair_plateau\n",
          csv);
    for (alpha = 0; alpha < ALPHAS; alpha++) {
        for (view = 0; view < VIEWS; view++) {
            double pair[FREE] = {6, 1, .3}, p[COEFFICIENTS];
            const group all = {s, alpha, -1, view};
            fit(&all, pair);
            for (half_angle = 0; half_angle < HALF_ANGLES; half_angle++) {
                const int cell = cell_of(alpha, half_angle, view);
                const group one = {s, alpha, half_angle, view};
                const double *row = row_of(s, cell);
                double x[FREE], error[3];
                memcpy(x, pair, sizeof x);
                fit(&one, x);
                freed(x, p);
                error[0] = square_of(s, cell, p, 1);
                freed(pair, p);
                error[1] = square_of(s, cell, p, 1);
                error[2] = square_of(s, cell, lobe_story_shipped, 1);
                fprintf(csv, "%g,%g,%.0f,%.4f,%.4f,%.4f,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f,%.4f,%.4f,%.4f\n",
                        row[0] * row[0], row[4] * 180 / 3.14159265358979323846,
                        acos(row[1]) * 180 / 3.14159265358979323846, x[0], x[1], x[2], weight_of(s, cell, x, 0),
                        weight_of(s, cell, x, 1), weight_of(s, cell, x, 2), sqrt(error[0]), sqrt(error[1]),
                        sqrt(error[2]), pair[0], pair[1], pair[2]);
                grazing += row[1] < .26;
                for (k = 0; k < 3; k++) {
                    sums[k] += error[k];
                    view75[k] += row[1] < .26 ? error[k] : 0;
                }
            }
        }
    }
    fputs("# Written by make sphere-light-story. Relative L2 error in per cent, root of the mean square over the 294 "
          "fit\n"
          "# cells and both sets of positions: all views / from 75 degrees; free numbers.\n",
          summary);
    for (k = 0; k < 3; k++) {
        static const char *const name[3] = {"a reach, a knee and a plateau a cell      ",
                                            "the same for all half angles               ",
                                            "closed forms in alpha and n.v: medium      "};
        static const int numbers[3] = {FREE * ALPHAS * HALF_ANGLES * VIEWS, FREE * ALPHAS * VIEWS, 6};
        fprintf(summary, "%s %5.2f / %5.2f  %4d\n", name[k], 100 * sqrt(sums[k] / LOBE_SPHERE_CELLS),
                100 * sqrt(view75[k] / grazing), numbers[k]);
    }
}

static bool prepare(story *s)
{
    lobe_sweep_options options = lobe_sweep_options_default();
    int set, i;
    for (set = 0; set < SETS; set++) {
        s->light[set] = malloc(LOBE_SPHERE_COUNT * sizeof *s->light[set]);
        if (!s->light[set] || !lobe_sphere_cells_make(&s->cells[set], false, set == 1, &options))
            return false;
        for (i = 0; i < LOBE_SPHERE_COUNT; i++) {
            const double *row = s->cells[set].in + 5 * i;
            const double v = row[1], l = row[2], sv = sqrt(1 - v * v), sl = sqrt(1 - l * l);
            const double cross = cos(.5 * row[3]), apart = sv - sl;
            s->light[set][i] = lobe_sphere_of(v, l, .25 * apart * apart + sv * sl * cross * cross, sin(row[4]));
        }
    }
    return true;
}

int main(int argc, char **argv)
{
    lobe_atomic_file csv, summary;
    story s;
    if (argc != 3) {
        fputs("usage: story CELLS.csv SUMMARY.txt\n", stderr);
        return 2;
    }
    if (!prepare(&s)) {
        fputs("story: not enough memory\n", stderr);
        return 2;
    }
    if (!lobe_atomic_open(&csv, argv[1]))
        return 2;
    if (!lobe_atomic_open(&summary, argv[2])) {
        lobe_atomic_abandon(&csv);
        return 2;
    }
    write_story(&s, csv.stream, summary.stream);
    return lobe_atomic_commit(&csv) && lobe_atomic_commit(&summary) ? 0 : 2;
}
