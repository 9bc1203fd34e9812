/* Directions drawn with a density: round lobes about +z, and the anisotropic Gaussian. a and b in [0, 1) are the random
 * numbers. Visible normals: visible_normals.h. Densities are over the sphere, in 1 / steradian, and integrate to 1. */
#ifndef LOBE_ENV_SAMPLERS_H
#define LOBE_ENV_SAMPLERS_H

/* exp(sharpness (z - 1)). */
void lobe_sample_sg(double sharpness, double a, double b, double d[3]);
double lobe_sample_sg_density(double sharpness, double z);

/* exp(-x_sharpness x^2 - y_sharpness y^2) z on the upper hemisphere: a Gaussian on the unit disc that is stretched by
 * the two sharpnesses, cut at the disc's edge along every radius. */
void lobe_sample_asg(double x_sharpness, double y_sharpness, double a, double b, double d[3]);
double lobe_sample_asg_density(double x_sharpness, double y_sharpness, const double d[3]);

/* 1 / (1 + k (1 - z))^2 on the upper hemisphere, k = 1 / (2 t^2): what a prefilter tap is without its cosine. */
void lobe_sample_tap(double t, double a, double b, double d[3]);
double lobe_sample_tap_density(double t, double z);

#endif
