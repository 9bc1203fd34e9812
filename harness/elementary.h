/* The elementary functions of core with their oracles, bounds and domains: one list for the exhaustive measurement
 * and for the strided test. The oracle is the host's libm in double, whose own error is below 1e-8 of our ulp. */
#ifndef LOBE_HARNESS_ELEMENTARY_H
#define LOBE_HARNESS_ELEMENTARY_H
#include "../core/power.h"
#include "../core/reciprocal.h"
#include "../core/sqrt.h"
#include <math.h>
#include <stdint.h>

typedef struct lobe_elementary {
    const char *name;
    float (*got)(float);
    double (*want)(double);
    double bound;         /* in ulp of the true result */
    uint32_t first, last; /* bits of the domain's smallest and largest magnitude */
    int both_signs;       /* the negative numbers from -0 down to `negative_last` too */
    uint32_t negative_last;
} lobe_elementary;

/* Out-of-line copies, so that a table can hold them. */
static float elementary_exp2(float x) { return lobe_exp2(x); }
static float elementary_log2(float x) { return lobe_log2(x); }
static float elementary_reciprocal(float x) { return lobe_reciprocal(x); }
static float elementary_sqrt(float x) { return lobe_sqrt(x); }
static float elementary_sqrt_soft(float x) { return lobe_sqrt_soft(x); }
static float elementary_pow5(float x) { return lobe_pow5(x); }
static double oracle_reciprocal(double x) { return 1.0 / x; }
static double oracle_pow5(double x) { return x * x * x * x * x; }

static const lobe_elementary lobe_elementaries[] = {
    {"exp2", elementary_exp2, exp2, LOBE_EXP2_ULP, 0x00000000u, 0x42ffffffu, 1, 0xc2fc0000u},
    {"log2", elementary_log2, log2, LOBE_LOG2_ULP, 0x00800000u, 0x7f7fffffu, 0, 0},
    {"reciprocal", elementary_reciprocal, oracle_reciprocal, LOBE_RECIPROCAL_ULP, 0x00800000u, 0x7e800000u, 0, 0},
    {"sqrt", elementary_sqrt, sqrt, LOBE_SQRT_ULP, 0x00000000u, 0x7f7fffffu, 0, 0},
    {"sqrt_soft", elementary_sqrt_soft, sqrt, LOBE_SQRT_ULP, 0x00000000u, 0x7f7fffffu, 0, 0},
    {"pow5", elementary_pow5, oracle_pow5, LOBE_POW5_ULP, 0x33000000u, 0x4c000000u, 1, 0xcc000000u},
};
#define LOBE_ELEMENTARIES (sizeof lobe_elementaries / sizeof lobe_elementaries[0])

typedef struct lobe_worst {
    double ulp;
    uint32_t input;
    uint64_t points;
} lobe_worst;

static float lobe_float_of(uint32_t bits) { return lobe_real_from_bits(bits); }

/* |got - want| in units of the last place of a float that has want's exponent. */
static double lobe_ulp_error(float got, double want)
{
    union {
        double real;
        uint64_t bits;
    } u;
    const double error = fabs((double)got - want);
    if (!(error < INFINITY))
        return INFINITY;
    if (want == 0.0)
        return error == 0.0 ? 0.0 : INFINITY;
    u.real = want;
    u.bits &= (uint64_t)0x7ff << 52; /* 2^exponent */
    if (u.bits < (uint64_t)(1023 - 126) << 52)
        u.bits = (uint64_t)(1023 - 126) << 52; /* denormal results share one ulp */
    return error / u.real * 8388608.0;
}

/* Measures bits first, first + stride, ... up to last into `worst`; the earliest input wins a tie. */
static void lobe_measure(const lobe_elementary *f, uint32_t first, uint32_t last, uint32_t stride, lobe_worst *worst)
{
    uint64_t bits;
    for (bits = first; bits <= last; bits += stride) {
        const float x = lobe_float_of((uint32_t)bits);
        const double ulp = lobe_ulp_error(f->got(x), f->want((double)x));
        if (ulp > worst->ulp) {
            worst->ulp = ulp;
            worst->input = (uint32_t)bits;
        }
        worst->points++;
    }
}

#endif
