/* The sun leaves the map as a directional light: order 3 cannot carry it. */
#ifndef LOBE_ENVIRONMENT_SUN_H
#define LOBE_ENVIRONMENT_SUN_H
#include "environment.h"

typedef struct lobe_sun {
    double direction[3];  /* towards it; unit length */
    double irradiance[3]; /* on a surface that faces it */
    double solid_angle;   /* of the texels that were taken */
} lobe_sun;

/* The share of the map's mean irradiance below which a bright spot is a lamp and stays in the map. */
#define LOBE_SUN_SHARE 0.5

/* Finds the brightest spot, takes what exceeds its surroundings out of the map, and returns it as a directional light.
 * 0 and an unchanged map where the spot carries less than `share` of the map's mean irradiance. */
int lobe_environment_take_sun(lobe_environment *map, double share, lobe_sun *sun);

#endif
