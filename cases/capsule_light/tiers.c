#include "tiers.h"
#include "../../models/coeffs/capsule_light_bounds.h"
#include "points.h"

#define ROW(tier, format, prefix, suffix)                                                                              \
    {"capsule_light",                                                                                                  \
     #tier,                                                                                                            \
     format,                                                                                                           \
     0,                                                                                                                \
     prefix##_##suffix##_MAX,                                                                                          \
     prefix##_##suffix##_RMS,                                                                                          \
     prefix##_##suffix##_BELOW_MAX,                                                                                    \
     0,                                                                                                                \
     0},
#define CAPSULE_F32(tier, prefix) ROW(tier, "f32", prefix, F32)
#define CAPSULE_Q30(tier, prefix) ROW(tier, "q30", prefix, Q30)
static const lobe_tier_bounds rows[] = {
#include "tier_rows.h"
};

#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)
#define LIGHT(line) "middle (mx, my, mz) of length 1, arm (ex, ey, ez) to 1, its line at " line " or farther, not set"
const lobe_vector_set lobe_capsule_vectors =
    {
        .seed = 1,
        .points = lobe_capsule_points,
        .bounds = rows,
        .bound_count = (int)(sizeof rows / sizeof rows[0]),
        .domain = "roughness in [" TEXT(LOBE_CAPSULE_ROUGHNESS_LO) ", 1], n_dot_v in [" TEXT(LOBE_CAPSULE_N_DOT_V_LO) ", 1], " LIGHT(
            "1.5 radius and .2") ", radius in [" TEXT(LOBE_CAPSULE_RADIUS_LEAST) ", " TEXT(LOBE_CAPSULE_RADIUS_HI) "]",
        .beyond =
            "roughness in [" TEXT(LOBE_CAPSULE_ROUGHNESS_LEAST) ", 1], n_dot_v in [" TEXT(LOBE_CAPSULE_N_DOT_V_LEAST) ", 1], " LIGHT("1.05 radius") ", radius in [" TEXT(
                LOBE_CAPSULE_RADIUS_LEAST) ", .9], at least one below " TEXT(LOBE_CAPSULE_ROUGHNESS_LO) ", below " TEXT(LOBE_CAPSULE_N_DOT_V_LO) " or above " TEXT(LOBE_CAPSULE_RADIUS_HI),
        .rows = LOBE_CAPSULE_VECTORS};
