#include "shipped.h"
#include <math.h>
#include <stddef.h>
#include "../../models/lobe.h"

static lobe_sphere_f32 f32_of(const double row[5])
{
    return lobe_sphere_of_f32((float)row[1], (float)row[2], (float)row[3], (float)row[4]);
}

static int32_t q30(double x) { return (int32_t)floor(x * 1073741824.0 + .5); }

static lobe_sphere_q30 q30_of(const double row[5])
{
    const lobe_sphere_q30 light = {q30(row[1]), q30(row[2]), q30(row[3]), q30(row[4])};
    return light;
}

#define SPHERE_F32(tier, bounds)                                                                                       \
    static double tier##_f32(const double row[5])                                                                      \
    {                                                                                                                  \
        return (double)lobe_sphere_light_##tier##_f32((float)row[0], f32_of(row));                                     \
    }
#define SPHERE_Q30(tier, bounds)                                                                                       \
    static double tier##_q30(const double row[5])                                                                      \
    {                                                                                                                  \
        const lobe_scaled_q30 y = lobe_sphere_light_##tier##_q30(q30(row[0]), q30_of(row));                            \
        return ldexp(y.mantissa, y.exponent - 30);                                                                     \
    }
#include "tier_rows.h"
#undef SPHERE_F32
#undef SPHERE_Q30

#define SPHERE_F32(tier, bounds) {#tier, "f32", tier##_f32},
#define SPHERE_Q30(tier, bounds) {#tier, "q30", tier##_q30},
static const lobe_sphere_shipped shipped[] = {
#include "tier_rows.h"
};

const lobe_sphere_shipped *lobe_sphere_shipped_at(int i)
{
    return i >= 0 && (size_t)i < sizeof shipped / sizeof shipped[0] ? &shipped[i] : NULL;
}
