/* The public q30 functions of a fan from a table: the formulas of ../env_lobes_table.h.
 *
 * Numbers are looked up with 13 bits more than a node has, under 2^28; the rest has block exponents and cannot
 * overflow. Results are held at the ends of Q30. The albedo is lobe_energy_high_q30. */
#ifndef LOBE_Q30_ENV_LOBES_TABLE_ENTRY_H
#define LOBE_Q30_ENV_LOBES_TABLE_ENTRY_H
#include "../../core/q30_arc.h"
#include "../../core/q30_scaled.h"
#include "table_entry.h"

static inline int32_t lobe_env_table_number_q30(const int16_t *node, int numbers, lobe_q_cell down, lobe_q_cell along,
                                                int j)
{
    const int16_t *below = node + LOBE_ENV_TABLE16_SIDE * numbers;
    const int32_t top = lobe_q_table_between(node[j] * 8192, node[numbers + j] * 8192, along.part);
    const int32_t bottom = lobe_q_table_between(below[j] * 8192, below[numbers + j] * 8192, along.part);
    return lobe_q_table_between(top, bottom, down.part);
}

/* 1686629713 / 2^29 is pi. */
static inline void lobe_env_table_q30(const int16_t *nodes, int count, int32_t roughness, int32_t n_dot_v,
                                      lobe_env_tap_q30 *taps)
{
    const int32_t r = lobe_q_saturate(roughness), v = lobe_q_saturate(n_dot_v);
    const int32_t e = lobe_energy_high_q30(roughness, n_dot_v);
    const lobe_q_cell down = lobe_q_table_row(r, LOBE_ENV_TABLE16_SIDE),
                      along = lobe_q_table_column(v, LOBE_ENV_TABLE16_SIDE);
    const lobe_q_scaled root_a = lobe_qs_of(r, 0), one = lobe_qs_of(LOBE_Q30_ONE, 0);
    const lobe_q_scaled s =
        lobe_qs_sqrt(lobe_qs_mul(lobe_qs_of(LOBE_Q30_ONE - v, 0), lobe_qs_add(one, lobe_qs_of(v, 0))));
    const lobe_q_scaled reach = lobe_qs_mul(lobe_qs_mul(root_a, root_a), s);
    const lobe_q_scaled theta = lobe_qs_of(lobe_q_mul(lobe_q_arc(lobe_qs_fixed(s, 30), v), 1686629713, 29), 0);
    const int numbers = 3 * count - 1;
    const int16_t *node = nodes + numbers * (LOBE_ENV_TABLE16_SIDE * down.index + along.index);
    uint32_t rest = (uint32_t)lobe_q16_from_q30(e);
    int t;
    for (t = 0; t < count; t++) {
        const lobe_q_scaled shift = lobe_qs_of(lobe_env_table_number_q30(node, numbers, down, along, 3 * t), 6);
        const lobe_q_scaled width = lobe_qs_of(lobe_env_table_number_q30(node, numbers, down, along, 3 * t + 1), 4);
        taps[t].angle = lobe_qs_fixed(lobe_qs_add(theta, lobe_qs_mul(reach, shift)), 30);
        taps[t].width = lobe_q_saturate(lobe_qs_fixed(lobe_qs_mul(root_a, width), 30));
        if (t < count - 1) {
            const lobe_q_scaled part = lobe_qs_of(lobe_env_table_number_q30(node, numbers, down, along, 3 * t + 2), 5);
            taps[t].weight_q16 = lobe_qs_fixed(lobe_qs_mul(lobe_qs_of(e, 0), part), 16);
            rest -= (uint32_t)taps[t].weight_q16; /* seven of them are under 2^22 */
        }
    }
    taps[count - 1].weight_q16 = (int32_t)rest;
}

#define LOBE_ENV_TABLE_Q30(name, count)                                                                                \
    void name##_q30(int32_t roughness, int32_t n_dot_v, lobe_env_tap_q30 taps[count])                                  \
    {                                                                                                                  \
        lobe_env_table_q30(name##_i16, count, roughness, n_dot_v, taps);                                               \
    }

#endif
