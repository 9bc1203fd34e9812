#include "shipped.h"
#include <math.h>
#include <stddef.h>
#include "../../models/lobe.h"

static int32_t q30(double x) { return (int32_t)floor(x * 1073741824.0 + 0.5); }

static void from_f32(lobe_sh9_f32 in, double c[9])
{
    int k;
    for (k = 0; k < 9; k++)
        c[k] = (double)in.c[k];
}

static void from_q30(lobe_sh9_q30 in, double c[9])
{
    int k;
    for (k = 0; k < 9; k++)
        c[k] = in.c[k] / 1073741824.0;
}

#define SH9(tier, bounds)                                                                                              \
    static void tier##_f32(double r, double v, double c[9])                                                            \
    {                                                                                                                  \
        from_f32(lobe_diffuse_sh_##tier##_f32((float)r, (float)v), c);                                                 \
    }                                                                                                                  \
    static void tier##_q30(double r, double v, double c[9])                                                            \
    {                                                                                                                  \
        from_q30(lobe_diffuse_sh_##tier##_q30(q30(r), q30(v)), c);                                                     \
    }
#define SH9_CONSTANT(tier, bounds)                                                                                     \
    static void tier##_f32(double r, double v, double c[9])                                                            \
    {                                                                                                                  \
        (void)r;                                                                                                       \
        (void)v;                                                                                                       \
        from_f32(lobe_diffuse_sh_##tier##_f32(), c);                                                                   \
    }                                                                                                                  \
    static void tier##_q30(double r, double v, double c[9])                                                            \
    {                                                                                                                  \
        (void)r;                                                                                                       \
        (void)v;                                                                                                       \
        from_q30(lobe_diffuse_sh_##tier##_q30(), c);                                                                   \
    }
#include "tier_rows.h"
#undef SH9
#undef SH9_CONSTANT

#define SH9(tier, bounds) {#tier, "f32", 0, tier##_f32}, {#tier, "q30", 0, tier##_q30},
#define SH9_CONSTANT(tier, bounds) {#tier, "f32", 1, tier##_f32}, {#tier, "q30", 1, tier##_q30},
static const lobe_diffuse_shipped shipped[] = {
#include "tier_rows.h"
};

const lobe_diffuse_shipped *lobe_diffuse_shipped_at(int i)
{
    return i >= 0 && (size_t)i < sizeof shipped / sizeof shipped[0] ? &shipped[i] : NULL;
}
