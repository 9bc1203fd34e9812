/* A ball on a floor that is seen at grazing angles, under light from all around: shaded by the truth, by the split sum
 * and by every number of taps of env_lobes, all through one filtered cube, as an engine has them. Mirrors of every
 * roughness (F = 1) that see nothing but the environment: no shadow, no second bounce. */
#ifndef LOBE_PICTURE_ENVIRONMENTS_H
#define LOBE_PICTURE_ENVIRONMENTS_H
#include <stddef.h>
#include "../environment/environment.h"
#include "../prefilter/prefilter.h"
#include "all_around.h"

enum { LOBE_AROUND_COLUMNS = 6, LOBE_AROUND_ALPHAS = 4, LOBE_AROUND_ORDER = 40 };
extern const char *const lobe_around_column[LOBE_AROUND_COLUMNS];
extern const double lobe_around_alpha[LOBE_AROUND_ALPHAS];

typedef struct lobe_around {
    lobe_prefilter_scale scale;
    lobe_cube cube;        /* what the forms look up */
    lobe_all_around light; /* what the truth sums up */
    double turn;           /* azimuth in the map that the eye looks to */
    int order;             /* of the truth, all_around.h */
} lobe_around;

/* The cube has `side` texels. 0 where there is no memory. */
int lobe_around_of(const lobe_environment *map, int side, double turn, int threads, lobe_around *around);
void lobe_around_free(lobe_around *around);

/* The azimuth of the brightest texel. */
double lobe_around_brightest(const lobe_environment *map);

/* At a point of the picture, x in [-1, 1] to the right, y up in the same unit: 1 where there is a surface, else 0 and
 * the environment itself. */
int lobe_around_see(const lobe_around *around, double x, double y, double rgb[3]);

/* Values a point: rgb[alpha][column][channel]; 0 where there is no surface. */
enum { LOBE_AROUND_VALUES = LOBE_AROUND_ALPHAS * LOBE_AROUND_COLUMNS * 3 };

/* Points of the picture, two numbers each; a lobe_batch_fn whose context is a lobe_around. NaN where there is no
 * memory. */
void lobe_around_shade(void *around, const double *points, size_t count, double *rgb);

/* One surface, the view and the normal of unit length, all columns. nodes: room for 5 order^2 numbers. */
void lobe_around_reflect(const lobe_around *around, double alpha, const double view[3], const double normal[3],
                         double *nodes, double rgb[LOBE_AROUND_COLUMNS][3]);

#endif
