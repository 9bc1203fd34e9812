/* Fans of taps from a bilinear table of 16 x 16 nodes: the formula of env_lobes.h with its sums over twelve products
 * looked up, and with the width itself in place of its logarithm. The nodes stand in models/tables; the lookup is a
 * texture unit's work in a shader, and models/f32 and models/q30 do it in C.
 *
 * A node holds 3 n - 1 numbers of 16 bits: of every tap in turn its shift Th in 2048ths, its width over the roughness
 * in 8192nds and its part of the albedo in 4096ths, where the last tap has no part: it takes what the others leave, so
 * the weights sum to the albedo whatever was looked up. Interpolated linearly,
 *     angle = theta + a s Th,   width = roughness ratio,   weight = albedo part.
 *
 * Nodes lie where the texels of split_sum_table.h do: node (i, k) at roughness (1.5 - roughness / 2) = i / 15 and
 * 1.25 n_dot_v / (n_dot_v + .25) = k / 15, k running fastest. In a shader: upload the numbers as textures of signed
 * 16-bit channels, 16 by 16, four channels each (3 n with a zero at the end: 1, 2, 3 and 6 textures for 1, 2, 4 and 8
 * taps, 3 of 4 channels used in the first), with linear filter and clamp, fetch at
 * lobe_split_sum_table_uv(roughness, n_dot_v, 16.0), and hand the channels to lobe_env_table_tap; `one` is what a
 * channel's 1 stands for: 32767 for normalised formats (SNORM), 1 where the texture holds the numbers themselves. */
#ifndef LOBE_ENV_LOBES_TABLE_H
#define LOBE_ENV_LOBES_TABLE_H
#include "env_lobes.h"
#include "split_sum_table.h"

/* What all taps of a point share: what their numbers are to be multiplied with. */
LOBE_STRUCT(lobe_env_table_scales)
{
    lobe_real theta;
    lobe_real shift;
    lobe_real width;
    lobe_real weight;
};

LOBE_FN lobe_env_table_scales lobe_env_table_scales_of(lobe_real roughness, lobe_real n_dot_v, lobe_real albedo,
                                                       lobe_real one)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET e = lobe_saturate(albedo);
    LOBE_LET u = LOBE_R(1.0) - v;
    LOBE_LET s = lobe_sqrt(u * (LOBE_R(1.0) + v));
    LOBE_LET theta = LOBE_R(3.14159265358979324) * lobe_arc(s, v);
    LOBE_LET shift = r * r * s * (one * LOBE_R(0.00048828125));
    LOBE_LET width = r * (one * LOBE_R(0.0001220703125));
    LOBE_LET weight = e * (one * LOBE_R(0.000244140625));
    lobe_env_table_scales p;
    p.theta = theta;
    p.shift = shift;
    p.width = width;
    p.weight = weight;
    return p;
}

/* weight: p.weight times the tap's number, or for the last tap what those leave of the albedo. */
LOBE_FN lobe_env_tap lobe_env_table_tap(lobe_env_table_scales p, lobe_real shift, lobe_real width, lobe_real weight)
{
    LOBE_LET angle = p.theta + p.shift * shift;
    LOBE_LET wide = lobe_saturate(p.width * width);
    lobe_env_tap tap;
    tap.angle = angle;
    tap.width = wide;
    tap.weight = weight;
    return tap;
}

/* The parts that four nodes have in a point: (i, k), (i, k + 1), (i + 1, k), (i + 1, k + 1). */
LOBE_STRUCT(lobe_env_table_parts)
{
    lobe_real p00;
    lobe_real p01;
    lobe_real p10;
    lobe_real p11;
};

/* How far the point lies past node (i, k), in [0, 1]. */
LOBE_FN lobe_env_table_parts lobe_env_table_parts_of(lobe_real past_i, lobe_real past_k)
{
    LOBE_LET p11 = past_i * past_k;
    LOBE_LET p10 = past_i - p11;
    LOBE_LET p01 = past_k - p11;
    LOBE_LET p00 = LOBE_R(1.0) - past_i - p01;
    lobe_env_table_parts p;
    p.p00 = p00;
    p.p01 = p01;
    p.p10 = p10;
    p.p11 = p11;
    return p;
}

LOBE_FN lobe_real lobe_env_table_between(lobe_env_table_parts p, lobe_real t00, lobe_real t01, lobe_real t10,
                                         lobe_real t11)
{
    LOBE_LET x = p.p00 * t00 + p.p01 * t01 + p.p10 * t10 + p.p11 * t11;
    return x;
}

#endif
