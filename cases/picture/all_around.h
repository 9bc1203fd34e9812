/* What a surface reflects of a whole environment, integrated without noise: the radiance of mip 0 of a cube is divided
 * into what is brighter than nearly all of it, lamps and suns, which is summed up texel by texel, and the rest, by
 * visible normals. Each converges where the other would show its nodes. */
#ifndef LOBE_PICTURE_ALL_AROUND_H
#define LOBE_PICTURE_ALL_AROUND_H
#include "pyramid.h"

typedef struct lobe_all_around {
    lobe_pyramid rest;
    int count;      /* of bright texels */
    double *bright; /* rows: direction, and radiance beyond that of the rest times solid angle */
} lobe_all_around;

/* 0 where there is no memory. */
int lobe_all_around_of(const lobe_cube *cube, lobe_all_around *light);
void lobe_all_around_free(lobe_all_around *light);

/* frame: in the cube's world the x, y and z of response.h. order^2 nodes on each side of the plane of incidence; nodes:
 * room for 5 order^2 numbers. */
void lobe_all_around_truth(const lobe_all_around *light, double alpha, double n_dot_v, double frame[3][3], int order,
                           double *nodes, double rgb[3]);

#endif
