/* An environment at several degrees of blur, quick to look up: for integrals by importance-sampled nodes, each of which
 * stands for the light of its surroundings. */
#ifndef LOBE_ENV_BLURRED_CUBES_H
#define LOBE_ENV_BLURRED_CUBES_H
#include "harmonics.h"

enum { LOBE_BLUR_LEVELS = 6 };

/* Level k is blurred by a Gaussian of LOBE_BLUR_FINEST 2^k radians, level 0 being the environment itself, whose bands
 * have been damped so already. */
#define LOBE_BLUR_FINEST 0.014

typedef struct lobe_blurred_cubes {
    float *texel; /* [level][face][row][column], faces -x +x -y +y -z +z, corners and edges included */
} lobe_blurred_cubes;

/* From the harmonics of level 0. 0 where there is no memory. */
int lobe_blurred_cubes_of(const lobe_harmonics *harmonics, lobe_blurred_cubes *cubes);
void lobe_blurred_cubes_free(lobe_blurred_cubes *cubes);

/* level in [0, LOBE_BLUR_LEVELS - 1] may lie between two. */
double lobe_blurred_cubes_at(const lobe_blurred_cubes *cubes, const double d[3], double level);

/* The level whose blur suits a node that stands for this solid angle. */
double lobe_blurred_cubes_level(double solid_angle);

#endif
