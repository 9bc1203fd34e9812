#include "tiers.h"
#include "../../models/coeffs/sphere_diffuse_bounds.h"
#include "points.h"

#define ROW(tier, format, max, rms)                                                                                    \
    {                                                                                                                  \
        "sphere_diffuse", #tier, format, 0, max, rms, 0, 0, 0                                                          \
    }
#define TIER(tier, bounds)                                                                                             \
    ROW(tier, "f32", bounds##_F32_MAX, bounds##_F32_RMS), ROW(tier, "q30", bounds##_Q30_MAX, bounds##_Q30_RMS),
static const lobe_tier_bounds rows[] = {
#include "tier_rows.h"
};

const lobe_vector_set lobe_sphere_diffuse_vectors = {.seed = 1,
                                                     .points = lobe_sphere_diffuse_points,
                                                     .bounds = rows,
                                                     .bound_count = (int)(sizeof rows / sizeof rows[0]),
                                                     .domain = "n_dot_l in [-1, 1], sine in (0, 1]"};
