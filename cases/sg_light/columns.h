/* The five columns of vectors and registry, roughness n_dot_v n_dot_l tangent2 versine: what is true there, and where
 * it is measured. tangent2 is as in ../sphere_light/columns.h, versine is 1 / sharpness. */
#ifndef LOBE_SG_LIGHT_COLUMNS_H
#define LOBE_SG_LIGHT_COLUMNS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The domain that the tiers state, sharpness 4 to 4096; tangent2 has none of its own. */
#define LOBE_SG_ROUGHNESS_LO 0.22
#define LOBE_SG_N_DOT_V_LO 0.05
#define LOBE_SG_VERSINE_LO 0.000244140625
#define LOBE_SG_VERSINE_HI 0.25

/* The ends of what is measured beyond it: sharpness 1 to 65536. */
#define LOBE_SG_ROUGHNESS_LEAST 0.05
#define LOBE_SG_N_DOT_V_LEAST 0.001
#define LOBE_SG_VERSINE_LEAST 0.0000152587890625

/* A lobe_truth_fn of the columns: the truth of sg_light at the azimuth that tangent2 stands for. */
void lobe_truth_sg_columns(const double *in, double *out, size_t n);

/* The same to 1e-5 relative, at a third of the price. */
void lobe_truth_sg_columns_fast(const double *in, double *out, size_t n);

/* Whether every column is in the stated domain; whether it is measured at all. */
bool lobe_sg_inside(const double row[5]);
bool lobe_sg_taken(const double row[5]);

/* One row from five numbers in [0, 1): in the domain, or (beyond) with roughness, view and versine out to the ends of
 * what is measured, one of the three outside for certain. near: axis within two widths of the light and three alpha of
 * the mirror direction; else it is even over the sphere above 1.5 widths under the horizon. false: draw again. */
bool lobe_sg_draw(double row[5], const double u[5], bool beyond, bool near);

#endif
