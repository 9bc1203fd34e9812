#include "shipped.h"
#include <math.h>
#include <stddef.h>
#include "../../models/lobe.h"

static lobe_sg_f32 f32_of(const double row[5])
{
    const lobe_sg_f32 light = {(float)row[1], (float)row[2], (float)row[3], (float)row[4]};
    return light;
}

static int32_t q30(double x) { return (int32_t)floor(x * 1073741824.0 + .5); }

static lobe_sg_q30 q30_of(const double row[5])
{
    const lobe_sg_q30 light = {q30(row[1]), q30(row[2]), q30(row[3]), q30(row[4])};
    return light;
}

#define SG_F32(tier, bounds)                                                                                           \
    static double tier##_f32(const double row[5])                                                                      \
    {                                                                                                                  \
        return (double)lobe_sg_light_##tier##_f32((float)row[0], f32_of(row));                                         \
    }
#define SG_Q30(tier, bounds)                                                                                           \
    static double tier##_q30(const double row[5])                                                                      \
    {                                                                                                                  \
        const lobe_scaled_q30 y = lobe_sg_light_##tier##_q30(q30(row[0]), q30_of(row));                                \
        return ldexp(y.mantissa, y.exponent - 30);                                                                     \
    }
#include "tier_rows.h"
#undef SG_F32
#undef SG_Q30

#define SG_F32(tier, bounds) {#tier, "f32", tier##_f32},
#define SG_Q30(tier, bounds) {#tier, "q30", tier##_q30},
static const lobe_sg_shipped shipped[] = {
#include "tier_rows.h"
};

const lobe_sg_shipped *lobe_sg_shipped_at(int i)
{
    return i >= 0 && (size_t)i < sizeof shipped / sizeof shipped[0] ? &shipped[i] : NULL;
}
