/* The fan whose number of taps follows a need, in integers: the formulas of ../env_lobes_adaptive.h; see env_lobes.h.
 *
 * Terms are the twelve of every fan and the gates, or for the need three with roughness. The sum of a row's magnitudes
 * is under 2047, of the need's under 511, which test_env_lobes.c holds. Next to where a tap comes in the count may
 * differ from that of another format; its weight is then under a unit. */
#ifndef LOBE_Q30_ENV_LOBES_ADAPTIVE_H
#define LOBE_Q30_ENV_LOBES_ADAPTIVE_H
#include "env_lobes.h"

enum {
    LOBE_ENV_ADAPTIVE_TAPS = 6,
    LOBE_ENV_ADAPTIVE_GATES = 5,
    LOBE_ENV_ADAPTIVE_COLUMNS = LOBE_ENV_COLUMNS + LOBE_ENV_ADAPTIVE_GATES,
    LOBE_ENV_ADAPTIVE_NEEDS = LOBE_ENV_COLUMNS + 3,
    LOBE_ENV_NEED_BITS = 22,
    LOBE_ENV_ADAPTIVE_ROW_COUNT = 3 * LOBE_ENV_ADAPTIVE_TAPS - 1
};

#define LOBE_ENV_NEED_Q(x) LOBE_Q_CONSTANT(x, LOBE_ENV_NEED_BITS)
#define LOBE_ENV_NEED_ROW                                                                                              \
    {                                                                                                                  \
        LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C0), LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C1),                      \
            LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C2), LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C3),                  \
            LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C4), LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C5),                  \
            LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C6), LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C7),                  \
            LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C8), LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C9),                  \
            LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C10), LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C11),                \
            LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C12), LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C13),                \
            LOBE_ENV_NEED_Q(LOBE_ENV_LOBES_ADAPTIVE_C14)                                                               \
    }
#define LOBE_ENV_ADAPTIVE_ROW(P, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q)                                    \
    {                                                                                                                  \
        LOBE_ENV_Q(P##a), LOBE_ENV_Q(P##b), LOBE_ENV_Q(P##c), LOBE_ENV_Q(P##d), LOBE_ENV_Q(P##e), LOBE_ENV_Q(P##f),    \
            LOBE_ENV_Q(P##g), LOBE_ENV_Q(P##h), LOBE_ENV_Q(P##i), LOBE_ENV_Q(P##j), LOBE_ENV_Q(P##k),                  \
            LOBE_ENV_Q(P##l), LOBE_ENV_Q(P##m), LOBE_ENV_Q(P##n), LOBE_ENV_Q(P##o), LOBE_ENV_Q(P##p), LOBE_ENV_Q(P##q) \
    }
#define LOBE_ENV_ADAPTIVE_ROWS                                                                                         \
    {                                                                                                                  \
        LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29,   \
                              30, 31),                                                                                 \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45,   \
                                  46, 47, 48),                                                                         \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62,   \
                                  63, 64, 65),                                                                         \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79,   \
                                  80, 81, 82),                                                                         \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 83, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96,   \
                                  97, 98, 99),                                                                         \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 100, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110,    \
                                  111, 112, 113, 114, 115, 116),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 117, 118, 119, 120, 121, 122, 123, 124, 125, 126, 127,    \
                                  128, 129, 130, 131, 132, 133),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 134, 135, 136, 137, 138, 139, 140, 141, 142, 143, 144,    \
                                  145, 146, 147, 148, 149, 150),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 151, 152, 153, 154, 155, 156, 157, 158, 159, 160, 161,    \
                                  162, 163, 164, 165, 166, 167),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 168, 169, 170, 171, 172, 173, 174, 175, 176, 177, 178,    \
                                  179, 180, 181, 182, 183, 184),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 185, 186, 187, 188, 189, 190, 191, 192, 193, 194, 195,    \
                                  196, 197, 198, 199, 200, 201),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 202, 203, 204, 205, 206, 207, 208, 209, 210, 211, 212,    \
                                  213, 214, 215, 216, 217, 218),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 219, 220, 221, 222, 223, 224, 225, 226, 227, 228, 229,    \
                                  230, 231, 232, 233, 234, 235),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 236, 237, 238, 239, 240, 241, 242, 243, 244, 245, 246,    \
                                  247, 248, 249, 250, 251, 252),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 253, 254, 255, 256, 257, 258, 259, 260, 261, 262, 263,    \
                                  264, 265, 266, 267, 268, 269),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 270, 271, 272, 273, 274, 275, 276, 277, 278, 279, 280,    \
                                  281, 282, 283, 284, 285, 286),                                                       \
            LOBE_ENV_ADAPTIVE_ROW(LOBE_ENV_LOBES_ADAPTIVE_C, 287, 288, 289, 290, 291, 292, 293, 294, 295, 296, 297,    \
                                  298, 299, 300, 301, 302, 303)                                                        \
    }

/* How far each tap but the first has come in, Q30. */
static inline void lobe_env_gates_fixed(const lobe_env_fixed *p, int32_t roughness, const int32_t *row, int32_t *gate)
{
    const int32_t r = lobe_q_saturate(roughness);
    int32_t need = row[0];
    int k;
    for (k = 1; k < LOBE_ENV_COLUMNS; k++)
        need += lobe_q_mul(row[k], p->f[k], 30);
    need += lobe_q_mul(row[LOBE_ENV_COLUMNS], r, 30);
    need += lobe_q_mul(row[LOBE_ENV_COLUMNS + 1], lobe_q_mul(r, p->f[1], 30), 30);
    need += lobe_q_mul(row[LOBE_ENV_COLUMNS + 2], lobe_q_mul(r, p->f[3], 30), 30);
    for (k = 0; k < LOBE_ENV_ADAPTIVE_GATES; k++)
        gate[k] = lobe_q_clamp(need - (k << LOBE_ENV_NEED_BITS), 0, 1 << LOBE_ENV_NEED_BITS)
                  << (30 - LOBE_ENV_NEED_BITS);
}

/* One quantity, Q20. */
static inline int32_t lobe_env_gated_fixed(const lobe_env_fixed *p, const int32_t *gate, const int32_t *row)
{
    int32_t sum = lobe_env_sum_fixed(p, row);
    int k;
    for (k = 0; k < LOBE_ENV_ADAPTIVE_GATES; k++)
        sum += lobe_q_mul(row[LOBE_ENV_COLUMNS + k], gate[k], 30);
    return sum;
}

#endif
