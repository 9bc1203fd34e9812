#include "diffuse_case.h"
#include <math.h>
#include "../../models/coeffs/sg_diffuse_bounds.h"
#include "../fit/random.h"
#include "truth_sg.h"

enum { COUNT = 256, WIDTHS = 7, SIDE = 12 };

void lobe_truth_sg_diffuse_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += 2)
        out[i] = lobe_truth_sg_irradiance(in[0], 1 / in[1], 1e-9);
}

typedef struct list {
    double *points;
    size_t room, count;
} list;

/* Multiples of 2^-24 are exact in f32 and in q30. */
static double exact(double x) { return floor(x * 16777216 + 0.5) / 16777216; }

static void add(list *l, double n_dot_l, double versine)
{
    if (l->count < l->room && l->count < COUNT) {
        l->points[2 * l->count] = exact(fmin(1, fmax(-1, n_dot_l)));
        l->points[2 * l->count + 1] =
            exact(fmin(LOBE_SG_DIFFUSE_VERSINE_HI, fmax(LOBE_SG_DIFFUSE_VERSINE_LO, versine)));
        l->count++;
    }
}

/* Axes overhead, on the horizon, next to it by parts of the width and far under it; then any. */
static size_t points(double domain_lo, int below, uint64_t seed, double *rows, size_t room)
{
    static const double widths[WIDTHS] = {LOBE_SG_DIFFUSE_VERSINE_LO, 0x1p-9, 0x1p-6, 0.07, 0.25, 0.5, 1};
    list l = {rows, room, 0};
    lobe_random random;
    int i, k;
    (void)domain_lo;
    if (below)
        return 0;
    for (i = 0; i < WIDTHS; i++) {
        add(&l, -1, widths[i]);
        add(&l, 1, widths[i]);
        for (k = -3; k <= 3; k++)
            add(&l, 0.7 * k * sqrt(widths[i]), widths[i]);
    }
    lobe_random_seed(&random, seed, 0);
    for (i = 0; i < SIDE; i++)
        for (k = 0; k < SIDE; k++) {
            const double part = (i + lobe_random_unit(&random)) / SIDE;
            add(&l, 2 * (k + lobe_random_unit(&random)) / SIDE - 1, pow(LOBE_SG_DIFFUSE_VERSINE_LO, part));
        }
    while (l.count < COUNT && l.count < l.room) {
        const double n_dot_l = 2 * lobe_random_unit(&random) - 1;
        add(&l, n_dot_l, lobe_random_unit(&random));
    }
    return l.count;
}

static const lobe_tier_bounds rows[] = {
    {"sg_diffuse", "high", "f32", 0, LOBE_SG_DIFFUSE_HIGH_F32_MAX, LOBE_SG_DIFFUSE_HIGH_F32_RMS, 0, 0, 0},
    {"sg_diffuse", "high", "q30", 0, LOBE_SG_DIFFUSE_HIGH_Q30_MAX, LOBE_SG_DIFFUSE_HIGH_Q30_RMS, 0, 0, 0},
};

const lobe_vector_set lobe_sg_diffuse_vectors = {.seed = 1,
                                                 .points = points,
                                                 .bounds = rows,
                                                 .bound_count = (int)(sizeof rows / sizeof rows[0]),
                                                 .domain = "n_dot_l in [-1, 1], versine in [0.000244140625, 1]"};
