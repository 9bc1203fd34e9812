/* The five columns of vectors and registry, roughness n_dot_v n_dot_l tangent2 sine: what is true there, and where it
 * is measured. tangent2 of two directions with heights v and l lies between ((sv - sl)/2)^2 and ((sv + sl)/2)^2, sv and
 * sl their sines: only such rows are light and view at all. */
#ifndef LOBE_SPHERE_LIGHT_COLUMNS_H
#define LOBE_SPHERE_LIGHT_COLUMNS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The domain that the tiers state; tangent2 has none of its own. */
#define LOBE_SPHERE_ROUGHNESS_LO 0.22
#define LOBE_SPHERE_N_DOT_V_LO 0.08
#define LOBE_SPHERE_SINE_HI 0.7072

/* The ends of what is measured beyond it: those of the truth. */
#define LOBE_SPHERE_ROUGHNESS_LEAST 0.05
#define LOBE_SPHERE_N_DOT_V_LEAST 0.001
#define LOBE_SPHERE_SINE_LEAST 0.0001001

/* A lobe_truth_fn of the columns: the truth of sphere_light at the azimuth that tangent2 stands for. */
void lobe_truth_sphere_columns(const double *in, double *out, size_t n);

/* The same to 2e-6 relative, at a fifth of the price: for a hundred thousand rows of which the worst are looked at
 * again.
 */
void lobe_truth_sphere_columns_fast(const double *in, double *out, size_t n);

/* The azimuth between view and light, pi on the mirror's side. */
double lobe_sphere_azimuth(const double row[5]);

/* The nearest row of multiples of 2^-24 that is a light and a view. false where there is none: beside a direction that
 * stands exactly on the normal. */
bool lobe_sphere_place(double row[5], double roughness, double v, double l, double azimuth, double sine);

/* Whether every column is in the stated domain; whether the truth takes the row. */
bool lobe_sphere_inside(const double row[5]);
bool lobe_sphere_taken(const double row[5]);

/* One row from five numbers in [0, 1): in the domain, or (beyond) with roughness, view and sine down and up to the ends
 * of the truth, one of the three outside for certain. near: light within its half angle and three alpha of the mirror
 * direction; else it is even over the sphere above its own setting. false: draw again. */
bool lobe_sphere_draw(double row[5], const double u[5], bool beyond, bool near);

#endif
