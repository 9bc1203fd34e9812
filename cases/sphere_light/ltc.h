/* Linearly transformed cosines (Heitz, Dupuy, Hill, Neubelt 2016): the lobe of a roughness and a view is a clamped
 * cosine under a linear map. The table is fitted by ltc_fit.c; a sphere light is an elliptic cone after the map
 * (Heitz and Hill 2017, "Real-Time Line- and Disk-Light Shading with Linearly Transformed Cosines"). */
#ifndef LOBE_SPHERE_LIGHT_LTC_H
#define LOBE_SPHERE_LIGHT_LTC_H

/* A cell: the inverse map [inv11 0 inv13; 0 1 0; inv31 0 inv33] in the frame x towards the view's projection, z the
 * normal, from the lobe to the cosine; and the lobe's integral, its albedo. */
enum { LOBE_LTC_INV11, LOBE_LTC_INV13, LOBE_LTC_INV31, LOBE_LTC_INV33, LOBE_LTC_ALBEDO, LOBE_LTC_VALUES };

/* Roughness outside, from LOBE_LTC_ROUGHNESS_LO (alpha .0025) to 1; inside sqrt(1 - n.v) from 0 to 1. A side of 64 is
 * no nearer to the truth. */
enum { LOBE_LTC_SIDE = 32, LOBE_LTC_NUMBERS = LOBE_LTC_VALUES * LOBE_LTC_SIDE * LOBE_LTC_SIDE };
#define LOBE_LTC_ROUGHNESS_LO .05

/* From the committed table, ltc_table.h, bilinear. */
void lobe_ltc_at(double roughness, double n_dot_v, double cell[LOBE_LTC_VALUES]);

/* The light of a row (roughness, n_dot_v, n_dot_l, azimuth, half angle below pi / 2) as an elliptic cone around its
 * axis, after the map: the length of its form factor without a horizon, and the height of its axis, whose product is
 * what is lit where all of it is above the horizon. */
typedef struct lobe_ltc_factor {
    double length, height;
} lobe_ltc_factor;
lobe_ltc_factor lobe_ltc_factor_of(const double cell[LOBE_LTC_VALUES], const double row[5]);

/* Radiance of that light. Clipped by the cosine's horizon as the published code does, which the map makes another than
 * the surface's: exactly; as the round cone of the same form factor (their table, without its error); or by both
 * horizons, by quadrature where the light goes through the surface's. */
double lobe_ltc_clipped_ellipse(const double cell[LOBE_LTC_VALUES], const double row[5]);
double lobe_ltc_clipped_sphere(const double cell[LOBE_LTC_VALUES], const double row[5]);
double lobe_ltc_both_horizons(const double cell[LOBE_LTC_VALUES], const double row[5]);

#endif
