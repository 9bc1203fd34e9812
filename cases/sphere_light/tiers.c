#include "tiers.h"
#include "../../models/coeffs/sphere_light_bounds.h"
#include "columns.h"
#include "points.h"

#define ROW(tier, format, prefix, suffix)                                                                              \
    {"sphere_light",                                                                                                   \
     #tier,                                                                                                            \
     format,                                                                                                           \
     0,                                                                                                                \
     prefix##_##suffix##_MAX,                                                                                          \
     prefix##_##suffix##_RMS,                                                                                          \
     prefix##_##suffix##_BELOW_MAX,                                                                                    \
     0,                                                                                                                \
     0},
#define SPHERE_F32(tier, prefix) ROW(tier, "f32", prefix, F32)
#define SPHERE_Q30(tier, prefix) ROW(tier, "q30", prefix, Q30)
static const lobe_tier_bounds rows[] = {
#include "tier_rows.h"
};

const lobe_case lobe_sphere_columns_case = {
    .name = "sphere_light",
    .integral = "Lo = int D V n.l dl over the part above the horizon of a cone of this sine; radiance 1",
    .brdf = "GGX, height-correlated Smith, alpha = roughness^2, F = 1",
    .accuracy = "5e-7 relative",
    .input_count = 5,
    .output_count = 1,
    .inputs = {{"roughness", LOBE_SPHERE_ROUGHNESS_LEAST, 1},
               {"n_dot_v", LOBE_SPHERE_N_DOT_V_LEAST, 1},
               {"n_dot_l", -1, 1},
               {"tangent2", 0, 1},
               {"sine", LOBE_SPHERE_SINE_LEAST, 1}},
    .outputs = {"radiance"},
    .truth = lobe_truth_sphere_columns,
    .vectors = &lobe_sphere_vectors};

#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)
#define LIGHT "n_dot_l in [-1, 1], tangent2 = |(v + l)/2 along the surface|^2, "
const lobe_vector_set lobe_sphere_vectors = {
    .seed = 1,
    .points = lobe_sphere_points,
    .bounds = rows,
    .bound_count = (int)(sizeof rows / sizeof rows[0]),
    .columns = &lobe_sphere_columns_case,
    .domain = "roughness in [" TEXT(LOBE_SPHERE_ROUGHNESS_LO) ", 1], n_dot_v in [" TEXT(
        LOBE_SPHERE_N_DOT_V_LO) ", 1], " LIGHT "sine in (0, " TEXT(LOBE_SPHERE_SINE_HI) "]",
    .beyond = "roughness in [" TEXT(LOBE_SPHERE_ROUGHNESS_LEAST) ", 1], n_dot_v in [" TEXT(
        LOBE_SPHERE_N_DOT_V_LEAST) ", 1], " LIGHT
                                   "sine in (0, 1], at least one below " TEXT(LOBE_SPHERE_ROUGHNESS_LO) ", below " TEXT(
                                       LOBE_SPHERE_N_DOT_V_LO) " or above " TEXT(LOBE_SPHERE_SINE_HI),
    .rows = LOBE_SPHERE_VECTORS};
