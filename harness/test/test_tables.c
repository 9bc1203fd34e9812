/* The bilinear tables: how a shader addresses them, their ends, and every bad number. Built a second time with
 * -Ofast, where the compiler was told that there is no NaN: an index must hold all the same. */
#include "../../models/lobe.h"
#include "../../models/split_sum_table.h"
#include "cmocka_first.h"
#include <math.h>
#include <string.h>

typedef struct table {
    int side;
    const float *texels;
    lobe_dfg_f32 (*f32)(float roughness, float n_dot_v);
    lobe_dfg_q30 (*q30)(int32_t roughness, int32_t n_dot_v);
} table;

#define TABLE(name, side)                                                                                              \
    {                                                                                                                  \
        side, name##_texels_f32, name##_f32, name##_q30                                                                \
    }
static const table tables[] = {
    TABLE(lobe_split_sum_table32, 32),   TABLE(lobe_split_sum_sep_table32, 32),
    TABLE(lobe_split_sum_table64, 64),   TABLE(lobe_split_sum_sep_table64, 64),
    TABLE(lobe_split_sum_table128, 128), TABLE(lobe_split_sum_sep_table128, 128),
};
enum { TABLES = sizeof tables / sizeof tables[0] };

/* A texture unit: linear filter, clamp to edge, unnormalised coordinates u N - 1/2. */
static float fetch(const table *t, lobe_table_uv uv, int channel)
{
    const float last = (float)(t->side - 1);
    const float x = fminf(fmaxf(uv.u * (float)t->side - 0.5f, 0.0f), last);
    const float y = fminf(fmaxf(uv.v * (float)t->side - 0.5f, 0.0f), last);
    const int k = (int)x < t->side - 2 ? (int)x : t->side - 2, i = (int)y < t->side - 2 ? (int)y : t->side - 2;
    const float *p = t->texels + 2 * (i * t->side + k) + channel, *below = p + 2 * t->side;
    const float a = x - (float)k, b = y - (float)i;
    return (p[0] * (1.0f - a) + p[2] * a) * (1.0f - b) + (below[0] * (1.0f - a) + below[2] * a) * b;
}

/* The coordinates lose 2^-24 of N texels, and texels differ by less than 1 in 4. */
static void addressing(void **state)
{
    int t, a, b;
    (void)state;
    for (t = 0; t < TABLES; t++) {
        const float side = (float)tables[t].side;
        for (a = 0; a <= 200; a++) {
            for (b = 0; b <= 200; b++) {
                const float r = (float)(a * a) / 40000.0f, v = (float)(b * b) / 40000.0f;
                const lobe_table_uv uv = lobe_split_sum_table_uv(r, v, side);
                const lobe_dfg_f32 d = tables[t].f32(r, v);
                assert_true(uv.u >= 0.4999f / side && uv.u <= 1.0f - 0.4999f / side);
                assert_true(uv.v >= 0.4999f / side && uv.v <= 1.0f - 0.4999f / side);
                assert_true(fabsf(fetch(&tables[t], uv, 0) - d.scale) <= 1e-5f);
                assert_true(fabsf(fetch(&tables[t], uv, 1) - d.bias) <= 1e-5f);
            }
        }
    }
}

static void ends(void **state)
{
    int t;
    (void)state;
    for (t = 0; t < TABLES; t++) {
        const int side = tables[t].side;
        const float *texel = tables[t].texels;
        const float ends_of[4][2] = {{0.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}};
        const int at[4] = {0, side - 1, side * (side - 1), side * side - 1};
        int i;
        for (i = 0; i < 4; i++) {
            const lobe_dfg_f32 d = tables[t].f32(ends_of[i][0], ends_of[i][1]);
            assert_true(fabsf(d.scale - texel[2 * at[i]]) <= 1e-7f);
            assert_true(fabsf(d.bias - texel[2 * at[i] + 1]) <= 1e-7f);
        }
    }
}

static int inside(float x)
{
    uint32_t bits; /* a comparison would be optimised away for the very numbers that matter here */
    memcpy(&bits, &x, sizeof bits);
    return bits <= 0x3f800000u;
}

static void bad_numbers(void **state)
{
    static const uint32_t bits[] = {0x80000000u, 0x00000001u, 0xbf800000u, 0x7f7fffffu, 0xff7fffffu, 0x7f800000u,
                                    0xff800000u, 0x7fc00000u, 0xffc00000u, 0x7f800001u, 0x3f7fffffu, 0x3f800001u};
    static const int32_t integers[] = {INT32_MIN,        -1,       0, 1, LOBE_ONE_Q30 - 1, LOBE_ONE_Q30,
                                       LOBE_ONE_Q30 + 1, INT32_MAX};
    size_t i, k;
    int t;
    (void)state;
    for (t = 0; t < TABLES; t++) {
        for (i = 0; i < sizeof bits / sizeof bits[0]; i++) {
            for (k = 0; k < sizeof bits / sizeof bits[0]; k++) {
                float r, v;
                lobe_dfg_f32 d;
                memcpy(&r, &bits[i], sizeof r);
                memcpy(&v, &bits[k], sizeof v);
                d = tables[t].f32(r, v);
                assert_true(inside(d.scale) && inside(d.bias) && inside(d.scale + d.bias));
            }
        }
        for (i = 0; i < sizeof integers / sizeof integers[0]; i++) {
            for (k = 0; k < sizeof integers / sizeof integers[0]; k++) {
                const lobe_dfg_q30 d = tables[t].q30(integers[i], integers[k]);
                assert_true(d.scale >= 0 && d.bias >= 0 && d.scale <= LOBE_ONE_Q30 - d.bias);
            }
        }
    }
}

/* Texels are 65535ths in q30 and millionths in f32; both came from one fit. */
static void formats_agree(void **state)
{
    int t, a, b;
    (void)state;
    for (t = 0; t < TABLES; t++) {
        for (a = 0; a <= 256; a++) {
            for (b = 0; b <= 256; b++) {
                const lobe_dfg_f32 d = tables[t].f32((float)a / 256.0f, (float)b / 256.0f);
                const lobe_dfg_q30 q = tables[t].q30(a << 22, b << 22);
                assert_true(fabs((double)d.scale - q.scale * 0x1p-30) <= 2.5 / 65535.0);
                assert_true(fabs((double)d.bias - q.bias * 0x1p-30) <= 2.5 / 65535.0);
                assert_true(d.scale + d.bias <= 1.0f && q.scale <= LOBE_ONE_Q30 - q.bias);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(addressing),
        cmocka_unit_test(ends),
        cmocka_unit_test(bad_numbers),
        cmocka_unit_test(formats_agree),
    };
    return cmocka_run_group_tests_name("tables", tests, NULL, NULL);
}
