#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "fit_tiers.h"
#include <string.h>

static const lobe_sphere_tier tiers[] = {
    {.name = "low",
     .kernel = "lobe_sphere_light_low",
     .source = "models/sphere_light.h",
     .call = lobe_sphere_light_low,
     .count = 8,
     .box = {{0, .5}, {0, .5}, {0, 3}, {0, 8}, {0, 3}, {0, 4}, {0, 1}, {.1, 2}},
     .set_weight = {1, 1},
     .energy_weight = .06,
     .energy_cap = .24,
     .searches = 2,
     .generations = 60,
     .seed = 1},
    {.name = "medium",
     .kernel = "lobe_sphere_light_medium",
     .source = "models/sphere_light.h",
     .call = lobe_sphere_light_medium,
     .count = 10,
     .box = {{0, .5}, {0, .5}, {0, 8}, {0, 8}, {0, 1}, {0, 2}, {0, 4}, {-3, 2}, {-1, 2}, {0, 1}},
     .set_weight = {1, 1},
     .energy_weight = .02,
     .energy_cap = .2,
     .excess_weight = 5,
     .excess_cap = .001,
     .searches = 2,
     .generations = 60,
     .seed = 1},
};

const lobe_sphere_tier *lobe_sphere_tier_at(int i)
{
    return i >= 0 && (size_t)i < sizeof tiers / sizeof tiers[0] ? &tiers[i] : NULL;
}

const lobe_sphere_tier *lobe_sphere_tier_named(const char *name)
{
    size_t i;
    for (i = 0; i < sizeof tiers / sizeof tiers[0]; i++)
        if (strcmp(tiers[i].name, name) == 0)
            return &tiers[i];
    return NULL;
}
