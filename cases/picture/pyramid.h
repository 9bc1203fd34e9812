/* An environment in colour at every degree of blur, quick to look up: a cube whose every level is the mean of four
 * texels of the one before, for integrals by nodes each of which stands for the light of its surroundings. */
#ifndef LOBE_PICTURE_PYRAMID_H
#define LOBE_PICTURE_PYRAMID_H
#include "../prefilter/cube.h"

typedef struct lobe_pyramid {
    int size, levels;
    float *texel[LOBE_CUBE_MAX_MIPS]; /* a level: 6 faces x (side + 2)^2 x 4, the neighbours' texels around a face */
} lobe_pyramid;

/* From mip 0 of a cube, colours whose sum is above `most` scaled down to it. 0 where there is no memory. */
int lobe_pyramid_of(const lobe_cube *cube, double most, lobe_pyramid *pyramid);
void lobe_pyramid_free(lobe_pyramid *pyramid);

/* The level whose texels are as large as this solid angle. */
double lobe_pyramid_level(const lobe_pyramid *pyramid, double solid_angle);
/* Trilinear; level counts as the nearest of [0, levels - 1]. The fourth number is not used. */
void lobe_pyramid_at(const lobe_pyramid *pyramid, const double d[3], double level, float rgb[4]);

#endif
