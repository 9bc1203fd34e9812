#include "tiers.h"
#include "points.h"
#include "../../models/coeffs/split_sum_low.h"

/* One line a tier, in both formats; a new tier is its header above and its line below. */
#define TIER(tier, macro) FORMAT(tier, macro, "f32", F32, 0), FORMAT(tier, macro, "q30", Q30, 0)
#define FORMAT(tier, macro, format, suffix, furnace)                                                                   \
    {                                                                                                                  \
        tier, format, macro##_DOMAIN_LO, macro##_##suffix##_MAX, macro##_##suffix##_RMS, macro##_##suffix##_BELOW_MAX, \
            furnace                                                                                                    \
    }
#define COUNT(bounds) ((int)(sizeof(bounds) / sizeof(bounds)[0]))

static const lobe_tier_bounds split_sum[] = {
    TIER("low", LOBE_SPLIT_SUM_LOW),
};

const lobe_vector_set lobe_split_sum_vectors = {1, lobe_split_sum_points, split_sum, COUNT(split_sum)};
