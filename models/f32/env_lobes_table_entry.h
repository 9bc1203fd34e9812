/* The public f32 functions of a fan from a table. */
#ifndef LOBE_ENV_LOBES_TABLE_ENTRY_H
#define LOBE_ENV_LOBES_TABLE_ENTRY_H
#include "../energy.h"
#include "../env_lobes_table.h"
#include "env_lobes_entry.h"
#include "table_entry.h"

/* Number j of the point; node is the first of its four. */
static inline float lobe_env_table_number(const int16_t *node, int numbers, lobe_env_table_parts p, int j)
{
    const int16_t *below = node + LOBE_ENV_TABLE16_SIDE * numbers;
    return lobe_env_table_between(p, (float)node[j], (float)node[numbers + j], (float)below[j],
                                  (float)below[numbers + j]);
}

static inline void lobe_env_table_f32(const int16_t *nodes, int count, float roughness, float n_dot_v,
                                      lobe_env_tap_f32 *taps)
{
    const float r = lobe_table_input(roughness), v = lobe_table_input(n_dot_v);
    const float e = lobe_energy_high(r, v);
    const lobe_table_uv at = lobe_split_sum_table_texel(r, v, (float)(LOBE_ENV_TABLE16_SIDE - 1));
    const int32_t i = (int32_t)at.v, k = (int32_t)at.u, last = LOBE_ENV_TABLE16_SIDE - 2;
    /* The last node belongs to the cell before it. */
    const int32_t row = i < last ? i : last, column = k < last ? k : last;
    const lobe_env_table_parts parts = lobe_env_table_parts_of(at.v - (float)row, at.u - (float)column);
    const lobe_env_table_scales point = lobe_env_table_scales_of(r, v, e, 1.0f);
    const int numbers = 3 * count - 1;
    const int16_t *node = nodes + numbers * (LOBE_ENV_TABLE16_SIDE * row + column);
    float rest = e;
    int t;
    for (t = 0; t < count; t++) {
        const float shift = lobe_env_table_number(node, numbers, parts, 3 * t);
        const float width = lobe_env_table_number(node, numbers, parts, 3 * t + 1);
        const float weight =
            t < count - 1 ? point.weight * lobe_env_table_number(node, numbers, parts, 3 * t + 2) : rest;
        taps[t] = lobe_env_tap_out(lobe_env_table_tap(point, shift, width, weight));
        rest -= weight;
    }
}

#define LOBE_ENV_TABLE_F32(name, count)                                                                                \
    void name##_f32(float roughness, float n_dot_v, lobe_env_tap_f32 taps[count])                                      \
    {                                                                                                                  \
        lobe_env_table_f32(name##_i16, count, roughness, n_dot_v, taps);                                               \
    }

#endif
