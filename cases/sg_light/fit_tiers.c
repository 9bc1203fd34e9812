#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "fit_tiers.h"
#include "../../models/sg_light_high.h"

static const lobe_sg_tier tiers[] = {
    {.name = "medium",
     .kernel = "lobe_sg_light_medium",
     .source = "models/sg_light.h",
     .call = lobe_sg_light_medium,
     .count = 6,
     .box = {{.3, 3}, {.3, 4}, {0, 2}, {0, 2}, {0, 1.5}, {.01, 1}},
     .searches = 2,
     .generations = 60,
     .seed = 1},
    {.name = "high",
     .kernel = "lobe_sg_light_high",
     .source = "models/sg_light_high.h",
     .call = lobe_sg_light_high,
     .count = 13,
     .box = {{.02, 1},
             {.3, 3},
             {-.5, .5},
             {0, 1.5},
             {0, 1.5},
             {0, 2},
             {0, 2},
             {.7, 2.2},
             {.2, 1.2},
             {1.2, 4},
             {.1, .7},
             {.3, 1.3},
             {-.4, .4}},
     .searches = 3,
     .generations = 80,
     .seed = 1},
};

const lobe_sg_tier *lobe_sg_tier_at(int i)
{
    return i >= 0 && (size_t)i < sizeof tiers / sizeof tiers[0] ? &tiers[i] : NULL;
}
