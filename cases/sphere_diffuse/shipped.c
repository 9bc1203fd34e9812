#include "shipped.h"
#include <math.h>
#include <stddef.h>
#include "../../models/lobe.h"

static int32_t q30(double x) { return (int32_t)floor(x * 1073741824.0 + 0.5); }

#define TIER(tier, bounds)                                                                                             \
    static double tier##_f32(double c, double s)                                                                       \
    {                                                                                                                  \
        return (double)lobe_sphere_diffuse_##tier##_f32((float)c, (float)s);                                           \
    }                                                                                                                  \
    static double tier##_q30(double c, double s)                                                                       \
    {                                                                                                                  \
        const lobe_scaled_q30 y = lobe_sphere_diffuse_##tier##_q30(q30(c), q30(s));                                    \
        return ldexp(y.mantissa, y.exponent - 30);                                                                     \
    }
#include "tier_rows.h"
#undef TIER

#define TIER(tier, bounds) {#tier, "f32", tier##_f32}, {#tier, "q30", tier##_q30},
static const lobe_sphere_diffuse_shipped shipped[] = {
#include "tier_rows.h"
};

const lobe_sphere_diffuse_shipped *lobe_sphere_diffuse_shipped_at(int i)
{
    return i >= 0 && (size_t)i < sizeof shipped / sizeof shipped[0] ? &shipped[i] : NULL;
}
