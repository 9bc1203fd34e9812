#include "weight_vectors.h"
#include "../split_sum/points.h"
#include "../split_sum/truth_split_sum.h"
#include "../../models/coeffs/energy_bounds.h"

/* The albedo is energy's high; a sum of eight numbers in f32, or in Q16.16 the half unit of one, adds to its error. */
#define SUMMED 1e-5
#define ROW(model, tier, format, FORMAT)                                                                               \
    {                                                                                                                  \
        model, tier, format, LOBE_ENERGY_HIGH_DOMAIN_LO, LOBE_ENERGY_HIGH_##FORMAT##_MAX + SUMMED,                     \
            LOBE_ENERGY_HIGH_##FORMAT##_RMS + SUMMED, LOBE_ENERGY_HIGH_##FORMAT##_BELOW_MAX + SUMMED, 0, 0             \
    }
#define TIER(model, tier) ROW(model, tier, "f32", F32), ROW(model, tier, "q30", Q30)
#define MODEL(model) TIER(model, "lobes1"), TIER(model, "lobes2"), TIER(model, "lobes4"), TIER(model, "lobes8")

static const lobe_tier_bounds rows[] = {MODEL("env_lobes"), MODEL("env_lobes_sg")};
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
