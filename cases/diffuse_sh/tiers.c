#include "tiers.h"
#include "../../models/coeffs/diffuse_sh_bounds.h"
#include "points.h"

#define ROW(tier, format, max, rms)                                                                                    \
    {                                                                                                                  \
        "diffuse_sh", #tier, format, 0, max, rms, 0, 0, 0                                                              \
    }
#define SH9(tier, bounds)                                                                                              \
    ROW(tier, "f32", bounds##_F32_MAX, bounds##_F32_RMS), ROW(tier, "q30", bounds##_Q30_MAX, bounds##_Q30_RMS),
#define SH9_CONSTANT(tier, bounds) SH9(tier, bounds)
static const lobe_tier_bounds rows[] = {
#include "tier_rows.h"
};

const lobe_vector_set lobe_diffuse_vectors = {
    .seed = 1, .points = lobe_diffuse_points, .bounds = rows, .bound_count = (int)(sizeof rows / sizeof rows[0])};
