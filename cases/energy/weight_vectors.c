#include "weight_vectors.h"
#include "../split_sum/points.h"
#include "../split_sum/truth_split_sum.h"
#include "../../models/coeffs/env_lobes_bounds.h"
#include "../../models/coeffs/env_lobes_sg_bounds.h"

#define ROW(model, tier, format, prefix, suffix)                                                                       \
    {                                                                                                                  \
        model, tier, format, prefix##_DOMAIN_LO, prefix##_##suffix##_MAX, prefix##_##suffix##_RMS,                     \
            prefix##_##suffix##_BELOW_MAX, 0, 0                                                                        \
    }
#define ENV(model, tier, prefix, kernel, taps)                                                                         \
    ROW(#model, #tier, "f32", prefix, F32), ROW(#model, #tier, "q30", prefix, Q30),
#define ENV_SG ENV
static const lobe_tier_bounds rows[] = {
#include "../env_lobes/tier_rows.h"
};
enum { ROWS = sizeof rows / sizeof rows[0], VECTOR_ROWS = 256 };

#define COLUMNS(model, vector_set)                                                                                     \
    {                                                                                                                  \
        .name = model, .integral = "E = int D V n.l dl, the sum of the weights",                                       \
        .brdf = "GGX, height-correlated Smith, alpha = roughness^2", .accuracy = "2e-11", .input_count = 2,            \
        .output_count = 1, .inputs = {{"roughness", 0.001, 1.0}, {"n_dot_v", 0.001, 1.0}}, .outputs = {"E"},           \
        .truth = lobe_truth_energy_rows, .vectors = &(vector_set)                                                      \
    }
static const lobe_case prefilter_columns = COLUMNS("env_lobes", lobe_env_lobes_vectors);
static const lobe_case sg_columns = COLUMNS("env_lobes_sg", lobe_env_lobes_sg_vectors);

const lobe_vector_set lobe_env_lobes_vectors = {.seed = 1,
                                                .points = lobe_split_sum_points,
                                                .bounds = rows,
                                                .bound_count = ROWS,
                                                .columns = &prefilter_columns,
                                                .rows = VECTOR_ROWS};
const lobe_vector_set lobe_env_lobes_sg_vectors = {.seed = 1,
                                                   .points = lobe_split_sum_points,
                                                   .bounds = rows,
                                                   .bound_count = ROWS,
                                                   .columns = &sg_columns,
                                                   .rows = VECTOR_ROWS};
