/* The public f32 functions of a bilinear table: at one point, and over arrays. */
#ifndef LOBE_TABLE_ENTRY_H
#define LOBE_TABLE_ENTRY_H
#include "../../core/bits.h"
#include "../lobe.h"
#include "../split_sum_table.h"

/* x inside [0, 1], NaN 0, decided on its bits: an index must hold also where a compiler was told that there are no
 * NaN and leaves out the comparison that lobe_saturate makes. */
LOBE_FN float lobe_table_input(float x)
{
    const uint32_t bits = lobe_bits_from_real(x);
    return lobe_real_from_bits(bits <= 0x3f800000u ? bits : bits <= 0x7f800000u ? 0x3f800000u : 0u);
}

LOBE_FN float lobe_table_between(float a, float b, float part) { return a + part * (b - a); }

LOBE_FN lobe_dfg_f32 lobe_table_lookup(const float *texels, int side, float roughness, float n_dot_v)
{
    const lobe_table_uv at =
        lobe_split_sum_table_texel(lobe_table_input(roughness), lobe_table_input(n_dot_v), (float)(side - 1));
    const int32_t i = (int32_t)at.v, k = (int32_t)at.u;
    /* The last texel belongs to the cell before it. */
    const int32_t row = i < side - 2 ? i : side - 2, column = k < side - 2 ? k : side - 2;
    const float down = at.v - (float)row, along = at.u - (float)column;
    const float *t = texels + 2 * (row * side + column), *below = t + 2 * side;
    lobe_dfg_f32 d;
    d.scale = lobe_saturate(
        lobe_table_between(lobe_table_between(t[0], t[2], along), lobe_table_between(below[0], below[2], along), down));
    d.bias = lobe_saturate(
        lobe_table_between(lobe_table_between(t[1], t[3], along), lobe_table_between(below[1], below[3], along), down));
    return d;
}

#define LOBE_TABLE_F32(name, side)                                                                                     \
    lobe_dfg_f32 name##_f32(float roughness, float n_dot_v)                                                            \
    {                                                                                                                  \
        return lobe_table_lookup(name##_texels_f32, side, roughness, n_dot_v);                                         \
    }                                                                                                                  \
    void name##_n_f32(const float *roughness, const float *n_dot_v, float *scale, float *bias, size_t n)               \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n; i++) {                                                                                      \
            const lobe_dfg_f32 d = lobe_table_lookup(name##_texels_f32, side, roughness[i], n_dot_v[i]);               \
            scale[i] = d.scale;                                                                                        \
            bias[i] = d.bias;                                                                                          \
        }                                                                                                              \
    }

#endif
