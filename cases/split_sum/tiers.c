#include "tiers.h"
#include "points.h"
/* Rows of a model whose bounds were not measured yet are left out: `lobefit bounds MODEL` needs this program first. */
#if __has_include("../../models/coeffs/split_sum_bounds.h")
#include "../../models/coeffs/split_sum_bounds.h"
#else
#include "../../models/coeffs/split_sum_low.h"
#endif
#define ROWS_split_sum(...) __VA_ARGS__
#if __has_include("../../models/coeffs/split_sum_sep_bounds.h")
#include "../../models/coeffs/split_sum_sep_bounds.h"
#define ROWS_split_sum_sep(...) __VA_ARGS__
#else
#define ROWS_split_sum_sep(...)
#endif
#if __has_include("../../models/coeffs/energy_bounds.h")
#include "../../models/coeffs/energy_bounds.h"
#define ROWS_energy(...) __VA_ARGS__
#else
#define ROWS_energy(...)
#endif

#define BOTH(model, tier, prefix, row) row(#model, #tier, "f32", prefix, F32), row(#model, #tier, "q30", prefix, Q30),
#define ROW(model, tier, format, prefix, suffix)                                                                       \
    {                                                                                                                  \
        model, tier, format, prefix##_DOMAIN_LO, prefix##_##suffix##_MAX, prefix##_##suffix##_RMS,                     \
            prefix##_##suffix##_BELOW_MAX, 0, 0                                                                        \
    }
#define FURNACE_ROW(model, tier, format, prefix, suffix)                                                               \
    {                                                                                                                  \
        model, tier, format, prefix##_DOMAIN_LO, prefix##_##suffix##_MAX, prefix##_##suffix##_RMS,                     \
            prefix##_##suffix##_BELOW_MAX, prefix##_##suffix##_FURNACE, prefix##_##suffix##_BELOW_FURNACE              \
    }
#define DFG(model, tier, prefix) ROWS_##model(BOTH(model, tier, prefix, ROW))
#define ENERGY(model, tier, prefix) ROWS_##model(BOTH(model, tier, prefix, FURNACE_ROW))

static const lobe_tier_bounds rows[] = {
#include "tier_rows.h"
};

const lobe_vector_set lobe_split_sum_vectors = {
    .seed = 1, .points = lobe_split_sum_points, .bounds = rows, .bound_count = (int)(sizeof rows / sizeof rows[0])};
