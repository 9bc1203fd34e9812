#include "shipped.h"
#include <math.h>
#include <stddef.h>
#include "../../models/lobe.h"

static lobe_capsule_f32 f32_of(const double *row)
{
    const lobe_capsule_f32 c = {(float)row[1],
                                {(float)row[2], (float)row[3], (float)row[4]},
                                {(float)row[5], (float)row[6], (float)row[7]},
                                (float)row[8]};
    return c;
}

static int32_t q30(double x) { return (int32_t)floor(x * 1073741824.0 + .5); }

static lobe_capsule_q30 q30_of(const double *row)
{
    const lobe_capsule_q30 c = {
        q30(row[1]), {q30(row[2]), q30(row[3]), q30(row[4])}, {q30(row[5]), q30(row[6]), q30(row[7])}, q30(row[8])};
    return c;
}

#define CAPSULE_F32(tier, bounds)                                                                                      \
    static double tier##_f32(const double *row)                                                                        \
    {                                                                                                                  \
        return (double)lobe_capsule_light_##tier##_f32((float)row[0], f32_of(row));                                    \
    }
#define CAPSULE_Q30(tier, bounds)                                                                                      \
    static double tier##_q30(const double *row)                                                                        \
    {                                                                                                                  \
        const lobe_scaled_q30 y = lobe_capsule_light_##tier##_q30(q30(row[0]), q30_of(row));                           \
        return ldexp(y.mantissa, y.exponent - 30);                                                                     \
    }
#include "tier_rows.h"
#undef CAPSULE_F32
#undef CAPSULE_Q30

#define CAPSULE_F32(tier, bounds) {#tier, "f32", tier##_f32},
#define CAPSULE_Q30(tier, bounds) {#tier, "q30", tier##_q30},
static const lobe_capsule_shipped shipped[] = {
#include "tier_rows.h"
};

const lobe_capsule_shipped *lobe_capsule_shipped_at(int i)
{
    return i >= 0 && (size_t)i < sizeof shipped / sizeof shipped[0] ? &shipped[i] : NULL;
}
