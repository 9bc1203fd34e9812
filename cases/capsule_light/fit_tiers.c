/* The sphere's coefficients are those that ship, and only the capsule's are parameters: so the sphere comes first, and
 * then the dialect learns that it is in a fit. */
#define LOBE_DOUBLE 1
#include "../../models/sphere_light_high.h"
#undef LOBE_COEFFS
#define LOBE_COEFFS const lobe_real *p,
#define LOBE_FIT 1
#include "../../models/capsule_light_high.h"
#include "fit_tiers.h"

#define TIER(name)                                                                                                     \
    static double name(const double *p, const double *row)                                                             \
    {                                                                                                                  \
        return lobe_capsule_light_##name(                                                                              \
            p, row[0], lobe_capsule_of(row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8]));               \
    }
TIER(low)
TIER(medium)
TIER(high)

#define LINE_BOX                                                                                                       \
    {                                                                                                                  \
        {0, .3}, {-1, .2}, {0, 2}, {.5, 6}, {.1, 1}, {.1, 1}, {0, .5}, { .5, 1.5 }                                     \
    }
static const lobe_capsule_tier tiers[] = {
    {.name = "low",
     .kernel = "lobe_capsule_light_low",
     .source = "models/capsule_light.h",
     .call = low,
     .count = 4,
     .box = {{0, 2}, {0, 3}, {0, 4}, {.3, 3}},
     .searches = 2,
     .generations = 40,
     .seed = 1},
    {.name = "medium",
     .kernel = "lobe_capsule_line",
     .source = "models/capsule_light.h",
     .call = medium,
     .count = 8,
     .box = LINE_BOX,
     .searches = 2,
     .generations = 40,
     .seed = 1},
    {.name = "high",
     .kernel = "lobe_capsule_line",
     .source = "models/capsule_light.h",
     .call = high,
     .count = 8,
     .box = LINE_BOX,
     .searches = 2,
     .generations = 40,
     .seed = 1},
};

const lobe_capsule_tier *lobe_capsule_tier_at(int i)
{
    return i >= 0 && (size_t)i < sizeof tiers / sizeof tiers[0] ? &tiers[i] : NULL;
}
