#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "fit_tiers.h"
#include "../../models/sg_light_high.h"

static const lobe_sg_tier tiers[] = {
    {.name = "low",
     .kernel = "lobe_sg_light_low",
     .source = "models/sg_light.h",
     .call = lobe_sg_light_low,
     .count = 8,
     .box = {{.2, 1}, {.6, 3}, {.05, .5}, {0, .2}, {0, 1.5}, {0, 1.5}, {0, 2}, {.05, .5}},
     .searches = 2,
     .generations = 60,
     .seed = 1},
    {.name = "medium",
     .kernel = "lobe_sg_light_medium",
     .source = "models/sg_light.h",
     .call = lobe_sg_light_medium,
     .count = 7,
     .box = {{.2, 1.2}, {1.5, 9}, {.2, 2}, {0, 1.5}, {0, 5}, {0, 4}, {.02, .5}},
     .searches = 2,
     .generations = 60,
     .seed = 1},
    {.name = "high",
     .kernel = "lobe_sg_light_high",
     .source = "models/sg_light_high.h",
     .call = lobe_sg_light_high,
     .count = 16,
     .box = {{.02, 1},
             {.2, 2},
             {-.6, .5},
             {0, 2},
             {.3, 2.5},
             {.15, .8},
             {0, 2},
             {.3, 2},
             {0, 2},
             {.6, 2.5},
             {.5, 6},
             {1, 5},
             {2, 8},
             {.2, .95},
             {.3, 1.3},
             {-.6, .4}},
     .searches = 3,
     .generations = 80,
     .seed = 1},
};

const lobe_sg_tier *lobe_sg_tier_at(int i)
{
    return i >= 0 && (size_t)i < sizeof tiers / sizeof tiers[0] ? &tiers[i] : NULL;
}
