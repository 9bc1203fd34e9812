#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "lit_tiers.h"

const double lobe_sphere_f0s[LOBE_SPHERE_F0S] = {1, .5, .1, .04, .02};

static lobe_sphere_lit schlick(const double *p, double roughness, lobe_sphere light)
{
    lobe_sphere_lit lit;
    lit.radiance = 0;
    lit.schlick = lobe_sphere_light_schlick(p, roughness, light);
    return lit;
}

/* high with its Fresnel: the weights are what keeps the error at F0 = .02 within a point of that at 1. A tenth of the
 * true radiance, so that schlick does not live by the errors of the radiance alone. */
static const lobe_sphere_lit_tier tiers[] = {
    {.name = "high",
     .kernel = "lobe_sphere_high_risen",
     .source = "models/sphere_light_high.h",
     .call = lobe_sphere_light_high_lit,
     .count = 17,
     .box = {{0, 1.5},
             {0, 1},
             {-1, 0},
             {-.5, .5},
             {-1, 0},
             {0, 1},
             {0, 1},
             {0, 4},
             {-1, 1},
             {-2, 2},
             {-.5, .5},
             {-.5, .5},
             {-.5, .5},
             {0, 1},
             {-.5, .5},
             {-.5, .5},
             {-.5, .5}},
     .weight = {2, 0, 1, 2, 9},
     .own = .9,
     .true_one = .1,
     .searches = 1, /* the second ends in the same minimum, and takes as long */
     .generations = 40,
     .seed = 1},
    {.name = "schlick",
     .kernel = "lobe_sphere_light_schlick",
     .source = "models/sphere_light_schlick.h",
     .call = schlick,
     .count = 5,
     .box = {{0, 2}, {0, 4}, {0, 2}, {-1, 1}, {-2, 2}},
     .weight = {0, 1, 1, 2, 2},
     .under = {"low", "medium"},
     .searches = 2,
     .generations = 40,
     .seed = 1},
};

const lobe_sphere_lit_tier *lobe_sphere_lit_tier_at(int i)
{
    return i >= 0 && (size_t)i < sizeof tiers / sizeof tiers[0] ? &tiers[i] : NULL;
}
