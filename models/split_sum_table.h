/* Bilinear tables of scale and bias: where a point lies in them. The texels stand in models/tables; the lookup itself
 * is a texture unit's work in a shader, and models/f32 and models/q30 do it in C.
 *
 *     x = roughness (1.5 - roughness / 2),   y = 1.25 n_dot_v / (n_dot_v + .25)
 * both in [0, 1], increasing, finer toward 0 where the terms bend most; texel (i, k) of N by N holds the terms at
 * x = i / (N - 1), y = k / (N - 1), k running fastest, and is fitted, not sampled: that halves the error.
 *
 * In a shader: upload the texels as a two-channel texture of N by N, its first coordinate y and its second x (rows
 * are roughness), with linear filter and clamp, and fetch at
 *     uv = (coordinate (N - 1) + .5) / N.
 * Operations: coordinates 8 with the scaling, lookup in software 18, 26 in all, and 4 reads of a pair. */
#ifndef LOBE_SPLIT_SUM_TABLE_H
#define LOBE_SPLIT_SUM_TABLE_H
#include "../core/scalar.h"

/* u runs along n_dot_v, v along roughness. */
LOBE_STRUCT(lobe_table_uv)
{
    lobe_real u;
    lobe_real v;
};

/* Where a point lies, in [0, last] each: last is N - 1, and texel (i, k) is at v = i, u = k. NaN counts as 0. */
LOBE_FN lobe_table_uv lobe_split_sum_table_texel(lobe_real roughness, lobe_real n_dot_v, lobe_real last)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET n = lobe_saturate(n_dot_v);
    LOBE_LET bend = LOBE_R(1.5) - LOBE_R(0.5) * r;
    LOBE_LET x = r * bend;
    LOBE_LET y = LOBE_R(1.25) * n / (n + LOBE_R(0.25));
    LOBE_LET u = y * last;
    LOBE_LET v = x * last;
    lobe_table_uv at;
    at.u = u;
    at.v = v;
    return at;
}

/* Texture coordinates for a hardware fetch, in [.5 / side, 1 - .5 / side]; side is N, a float. */
LOBE_FN lobe_table_uv lobe_split_sum_table_uv(lobe_real roughness, lobe_real n_dot_v, lobe_real side)
{
    LOBE_LET last = side - LOBE_R(1.0);
    lobe_table_uv at = lobe_split_sum_table_texel(roughness, n_dot_v, last);
    LOBE_LET u = (at.u + LOBE_R(0.5)) / side;
    LOBE_LET v = (at.v + LOBE_R(0.5)) / side;
    at.u = u;
    at.v = v;
    return at;
}

#endif
