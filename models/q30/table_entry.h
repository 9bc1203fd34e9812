/* The public q30 functions of a bilinear table of 16-bit texels. */
#ifndef LOBE_Q30_TABLE_ENTRY_H
#define LOBE_Q30_TABLE_ENTRY_H
#include "../../core/q30.h"
#include "../lobe.h"

/* Position along an axis: the cell, and the part of it that was passed, Q24 in [0, 1]. x in [0, 1], Q30. */
typedef struct lobe_q_cell {
    int32_t index, part;
} lobe_q_cell;

static inline lobe_q_cell lobe_q_table_cell(int32_t x, int side)
{
    const int32_t at = lobe_q_shift_right(x, 6) * (side - 1); /* Q24, under 2^31 for a side of up to 128 */
    lobe_q_cell cell;
    cell.index = lobe_q_min(at >> 24, side - 2);
    cell.part = at - cell.index * ((int32_t)1 << 24);
    return cell;
}

/* Those of ../split_sum_table.h, of inputs in [0, 1]. */
static inline lobe_q_cell lobe_q_table_row(int32_t roughness, int side)
{
    return lobe_q_table_cell(lobe_q_mul(roughness, 3 * ((int32_t)1 << 29) - (roughness >> 1), 30), side);
}

static inline lobe_q_cell lobe_q_table_column(int32_t n_dot_v, int side)
{
    const lobe_q_inverse inverse = lobe_q_reciprocal(n_dot_v + ((int32_t)1 << 28));
    return lobe_q_table_cell(lobe_q_min(lobe_q_ratio(n_dot_v + (n_dot_v >> 2), inverse), LOBE_Q30_ONE), side);
}

/* |b - a| under 2^31; the result lies between them. */
static inline int32_t lobe_q_table_between(int32_t a, int32_t b, int32_t part)
{
    return a + lobe_q_mul(b - a, part, 24);
}

static inline int32_t lobe_q_table_channel(const uint16_t *t, int side, lobe_q_cell down, lobe_q_cell along)
{
    const uint16_t *below = t + 2 * side;
    const int32_t top = lobe_q_table_between((int32_t)t[0] << 14, (int32_t)t[2] << 14, along.part);
    const int32_t bottom = lobe_q_table_between((int32_t)below[0] << 14, (int32_t)below[2] << 14, along.part);
    const int32_t sum = lobe_q_table_between(top, bottom, down.part);
    return sum + lobe_q_shift_right(sum, 16); /* 65535 is 1: times 65536 / 65535 */
}

/* Beside the texels' own 16 bits the error is at most 4 units for the coordinates' share of a cell, 2^-24, times the
 * largest step between texels, and 4 units of 2^-30 of rounding. */
static inline lobe_dfg_q30 lobe_q_table_lookup(const uint16_t *texels, int side, int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness), v = lobe_q_saturate(n_dot_v);
    const lobe_q_cell down = lobe_q_table_row(r, side), along = lobe_q_table_column(v, side);
    const uint16_t *t = texels + 2 * (down.index * side + along.index);
    lobe_dfg_q30 d;
    d.scale = lobe_q_table_channel(t, side, down, along);
    d.bias = lobe_q_table_channel(t + 1, side, down, along);
    return d;
}

#define LOBE_TABLE_Q30(name, side)                                                                                     \
    lobe_dfg_q30 name##_q30(int32_t roughness, int32_t n_dot_v)                                                        \
    {                                                                                                                  \
        return lobe_q_table_lookup(name##_texels_u16, side, roughness, n_dot_v);                                       \
    }                                                                                                                  \
    void name##_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias, size_t n)       \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n; i++) {                                                                                      \
            const lobe_dfg_q30 d = lobe_q_table_lookup(name##_texels_u16, side, roughness[i], n_dot_v[i]);             \
            scale[i] = d.scale;                                                                                        \
            bias[i] = d.bias;                                                                                          \
        }                                                                                                              \
    }

#endif
