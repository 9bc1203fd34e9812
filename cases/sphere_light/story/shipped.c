/* What ships, for the program that has the coefficients as p[i]. */
#define LOBE_DOUBLE 1
#include "../../../core/dialect.h"
#include "../../../models/coeffs/sphere_light_medium.h"

extern const double lobe_story_shipped[10];
const double lobe_story_shipped[10] = {
    LOBE_SPHERE_LIGHT_MEDIUM_C0, LOBE_SPHERE_LIGHT_MEDIUM_C1, LOBE_SPHERE_LIGHT_MEDIUM_C2, LOBE_SPHERE_LIGHT_MEDIUM_C3,
    LOBE_SPHERE_LIGHT_MEDIUM_C4, LOBE_SPHERE_LIGHT_MEDIUM_C5, LOBE_SPHERE_LIGHT_MEDIUM_C6, LOBE_SPHERE_LIGHT_MEDIUM_C7,
    LOBE_SPHERE_LIGHT_MEDIUM_C8, LOBE_SPHERE_LIGHT_MEDIUM_C9};
