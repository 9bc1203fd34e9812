#define LOBE_DOUBLE 1
#include "table_contenders.h"
#include <math.h>
#include <stddef.h>
#include "../../models/env_lobes_table.h"
#include "../../models/lobe.h"
#include "kernels.h"

typedef struct shipped {
    int taps;
    const int16_t *nodes;
} shipped;

/* The kernel's text, in double. */
static int look_up(const void *ctx, double alpha, double n_dot_v, lobe_cell_tap *taps)
{
    enum { SIDE = LOBE_ENV_TABLE16_SIDE };
    const shipped *t = ctx;
    const double r = sqrt(alpha);
    const lobe_table_uv at = lobe_split_sum_table_texel(r, n_dot_v, SIDE - 1);
    const int row = (int)fmin(at.v, SIDE - 2), column = (int)fmin(at.u, SIDE - 2), numbers = 3 * t->taps - 1;
    const int16_t *above = t->nodes + numbers * (SIDE * row + column), *below = above + numbers * SIDE;
    const lobe_env_table_parts parts = lobe_env_table_parts_of(at.v - row, at.u - column);
    const lobe_env_table_scales scales = lobe_env_table_scales_of(r, n_dot_v, 1, 1);
    double rest = 1;
    for (int i = 0; i < t->taps; i++) {
        double x[3];
        for (int k = 0; k < (i < t->taps - 1 ? 3 : 2); k++) {
            const int j = 3 * i + k;
            x[k] = lobe_env_table_between(parts, above[j], above[numbers + j], below[j], below[numbers + j]);
        }
        const double weight = i < t->taps - 1 ? scales.weight * x[2] : rest;
        const lobe_env_tap tap = lobe_env_table_tap(scales, x[0], x[1], weight);
        const lobe_cell_tap out = {tap.angle, log(lobe_prefilter_t_of_alpha(tap.width * tap.width)), weight};
        taps[i] = out;
        rest -= weight;
    }
    return t->taps;
}

static const shipped one = {1, lobe_env_lobes1_table16_i16}, two = {2, lobe_env_lobes2_table16_i16},
                     four = {4, lobe_env_lobes4_table16_i16}, eight = {8, lobe_env_lobes8_table16_i16};

const lobe_judge_model lobe_table_contender[LOBE_TABLE_CONTENDERS] = {
    {"lobes1_table16", look_up, NULL, &one},
    {"lobes2_table16", look_up, NULL, &two},
    {"lobes4_table16", look_up, NULL, &four},
    {"lobes8_table16", look_up, NULL, &eight},
};
