/* Full integration: the light that Burley's diffuse reflects from every texel of a map, with no basis in between. It
 * knows neither spherical harmonics nor the closed form. */
#ifndef LOBE_ENVIRONMENT_REFLECT_H
#define LOBE_ENVIRONMENT_REFLECT_H
#include "environment.h"

/* The texels as arrays: unit directions, and radiance times solid angle over pi. */
typedef struct lobe_light_texels {
    int count;
    double *x, *y, *z, *light[3];
} lobe_light_texels;

/* 0 where there is no memory. */
int lobe_light_texels_of(const lobe_environment *map, lobe_light_texels *texels);
void lobe_light_texels_free(lobe_light_texels *texels);

/* Reflected radiance for base colour 1; unit normal n, unit view with n.view in [0, 1]. Each is safe to call from
 * several threads. */
void lobe_reflect_texels(const lobe_light_texels *texels, double roughness, const double n[3], const double view[3],
                         double rgb[3]);
/* Adds what a punctual light of this irradiance (on a surface that faces it) reflects: Burley, or Lambert. */
void lobe_reflect_burley(const double direction[3], const double irradiance[3], double roughness, const double n[3],
                         const double view[3], double rgb[3]);
void lobe_reflect_lambert(const double direction[3], const double irradiance[3], const double n[3], double rgb[3]);

#endif
