#include "bench_table.h"
#include "../models/lobe.h"

enum { SIDE = 64 };

static void lookup(const lobe_value *const *in, lobe_value *const *out, size_t n)
{
    const float *texels = lobe_split_sum_table64_texels_f32;
    size_t i;
    for (i = 0; i < n; i++) {
        float x = in[1][i].f * (float)SIDE - 0.5f, y = in[0][i].f * (float)SIDE - 0.5f;
        int column, row;
        const float *at;
        x = x > 0.0f ? (x < (float)(SIDE - 1) ? x : (float)(SIDE - 1)) : 0.0f;
        y = y > 0.0f ? (y < (float)(SIDE - 1) ? y : (float)(SIDE - 1)) : 0.0f;
        column = (int)x;
        row = (int)y;
        column = column < SIDE - 2 ? column : SIDE - 2;
        row = row < SIDE - 2 ? row : SIDE - 2;
        x -= (float)column;
        y -= (float)row;
        at = texels + 2 * (row * SIDE + column);
        {
            const float a0 = at[0] + x * (at[2] - at[0]), b0 = at[1] + x * (at[3] - at[1]);
            const float a1 = at[2 * SIDE] + x * (at[2 * SIDE + 2] - at[2 * SIDE]);
            const float b1 = at[2 * SIDE + 1] + x * (at[2 * SIDE + 3] - at[2 * SIDE + 1]);
            out[0][i].f = a0 + y * (a1 - a0);
            out[1][i].f = b0 + y * (b1 - b0);
        }
    }
}

const lobe_entry lobe_bench_table64 = {.model = "split_sum", .tier = "plain64", .format = LOBE_F32, .array = lookup};
