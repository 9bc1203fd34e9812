#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "fit_tiers.h"
#include "../../models/sphere_light_high.h"

static const lobe_sphere_tier tiers[] = {
    {.name = "low",
     .kernel = "lobe_sphere_light_low",
     .source = "models/sphere_light.h",
     .call = lobe_sphere_light_low,
     .count = 6,
     .box = {{0, .5}, {0, 2}, {.2, 3}, {0, 1}, {.1, 2}, {0, 8}},
     .set_weight = {1, 1},
     .energy_weight = .06,
     .energy_cap = .22,
     .searches = 2,
     .generations = 60,
     .seed = 1},
    {.name = "medium",
     .kernel = "lobe_sphere_light_medium",
     .source = "models/sphere_light.h",
     .call = lobe_sphere_light_medium,
     .count = 6,
     .box = {{0, .5}, {0, 12}, {0, 1}, {0, 2}, {0, 4}, {.2, 3}},
     .set_weight = {1, 1},
     .energy_weight = .05,
     .energy_cap = .22,
     .excess_weight = 3,
     .excess_cap = .002,
     .searches = 2,
     .generations = 60,
     .seed = 1},
    {.name = "high",
     .kernel = "lobe_sphere_light_high",
     .source = "models/sphere_light_high.h",
     .call = lobe_sphere_light_high,
     .count = 5,
     .box = {{-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}},
     .set_weight = {1, 1},
     .searches = 2,
     .generations = 40,
     .seed = 1},
};

const lobe_sphere_tier *lobe_sphere_tier_at(int i)
{
    return i >= 0 && (size_t)i < sizeof tiers / sizeof tiers[0] ? &tiers[i] : NULL;
}
