#include "tiers.h"
#include "../../models/coeffs/sg_light_bounds.h"
#include "columns.h"
#include "points.h"

#define ROW(tier, format, prefix, suffix)                                                                              \
    {"sg_light", #tier, format, 0, prefix##_##suffix##_MAX, prefix##_##suffix##_RMS, prefix##_##suffix##_BELOW_MAX,    \
     0,          0},
#define SG_F32(tier, prefix) ROW(tier, "f32", prefix, F32)
#define SG_Q30(tier, prefix) ROW(tier, "q30", prefix, Q30)
static const lobe_tier_bounds rows[] = {
#include "tier_rows.h"
};

const lobe_case lobe_sg_columns_case = {.name = "sg_light",
                                        .integral =
                                            "Lo = int exp((l.axis - 1) / versine) D V n.l dl over the upper hemisphere",
                                        .brdf = "GGX, height-correlated Smith, alpha = roughness^2, F = 1",
                                        .accuracy = "1e-7 relative",
                                        .input_count = 5,
                                        .output_count = 1,
                                        .inputs = {{"roughness", LOBE_SG_ROUGHNESS_LEAST, 1},
                                                   {"n_dot_v", LOBE_SG_N_DOT_V_LEAST, 1},
                                                   {"n_dot_l", -1, 1},
                                                   {"tangent2", 0, 1},
                                                   {"versine", LOBE_SG_VERSINE_LEAST, 1}},
                                        .outputs = {"radiance"},
                                        .truth = lobe_truth_sg_columns,
                                        .vectors = &lobe_sg_vectors};

#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)
#define LIGHT "n_dot_l in [-1, 1], tangent2 = |(v + axis)/2 along the surface|^2, versine = 1 / sharpness in "
#define FROM(roughness, v) "roughness in [" TEXT(roughness) ", 1], n_dot_v in [" TEXT(v) ", 1], "
#define INSIDE "[" TEXT(LOBE_SG_VERSINE_LO) ", " TEXT(LOBE_SG_VERSINE_HI) "]"
const lobe_vector_set lobe_sg_vectors = {
    .seed = 1,
    .points = lobe_sg_points,
    .bounds = rows,
    .bound_count = (int)(sizeof rows / sizeof rows[0]),
    .columns = &lobe_sg_columns_case,
    .domain = FROM(LOBE_SG_ROUGHNESS_LO, LOBE_SG_N_DOT_V_LO) LIGHT INSIDE,
    .beyond = FROM(LOBE_SG_ROUGHNESS_LEAST, LOBE_SG_N_DOT_V_LEAST) LIGHT
    "[" TEXT(LOBE_SG_VERSINE_LEAST) ", 1], at least one below " TEXT(LOBE_SG_ROUGHNESS_LO) ", below " TEXT(
        LOBE_SG_N_DOT_V_LO) " or outside " INSIDE,
    .rows = LOBE_SG_VECTORS};
