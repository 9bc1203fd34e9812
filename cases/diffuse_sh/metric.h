/* What a tier of diffuse_sh is judged by: the radiance it gives.
 *
 * Light: over lighting with independent coefficients of unit variance the mean square error of the radiance at a point
 * is |c - c_exact|^2, so the relative rms is sqrt(sum |c - c_exact|^2 / sum |c_exact|^2), over 33 x 33 points of
 * roughness and NdotV in [0, 1], edges included, equal weights.
 * Furnace: c0 / c0_exact - 1 on the same points. */
#ifndef LOBE_DIFFUSE_METRIC_H
#define LOBE_DIFFUSE_METRIC_H

typedef void (*lobe_diffuse_model)(double roughness, double n_dot_v, double c[9]);

typedef struct lobe_diffuse_score {
    double light, light_max; /* relative rms; the worst point's */
    double furnace_rms, furnace_max;
} lobe_diffuse_score;

lobe_diffuse_score lobe_diffuse_judge(lobe_diffuse_model model);

#endif
