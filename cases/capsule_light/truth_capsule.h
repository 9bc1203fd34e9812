/* Ground truth of capsule_light: radiance 1 from the points nearer than radius to a segment, reflected by GGX with
 * height-correlated Smith and Schlick's Fresnel with F90 = 1,
 *
 *   Lo = int over {l that meet the capsule, l.z > 0} of D(h) G2(v, l) F(v.h) / (4 v.z) dl.
 *
 * The shading point is the origin, n = z, v = (sin, 0, v_z). middle, half: the segment's middle, and from there to one
 * of its ends; zero is a sphere. alpha in [2.5e-3, 1], v_z in [1e-3, 1]. The point is outside the capsule, which also
 * may stand end on: its axis may pass through the point. tolerance is relative; ask for [1e-8, 1e-3]. */
#ifndef LOBE_CAPSULE_LIGHT_TRUTH_CAPSULE_H
#define LOBE_CAPSULE_LIGHT_TRUTH_CAPSULE_H
#include <stddef.h>

typedef struct lobe_capsule_scene {
    double alpha, v_z, f0;
    double middle[3], half[3], radius;
} lobe_capsule_scene;

/* NULL, or in what the scene is out of the domain: static text. */
const char *lobe_capsule_refusal(const lobe_capsule_scene *s);

/* Over the directions in polar coordinates about the segment's axis, where the capsule's silhouette is known: two
 * discs, and between their points of contact the tangent planes of a cylinder. NaN out of the domain. */
double lobe_truth_capsule(const lobe_capsule_scene *s, double tolerance);

/* The second opinion: the union of that many spheres (at least 2) along the segment. It is less, and tends to the truth
 * as 1 / spheres^2, so that (4 of twice as many - of so many) / 3 takes most of what is left away. */
double lobe_truth_capsule_spheres(const lobe_capsule_scene *s, double tolerance, int spheres);

/* A lobe_truth_fn: rows of roughness, n_dot_v, middle, half, radius; F0 = 1; to 1e-7. */
void lobe_truth_capsule_rows(const double *in, double *out, size_t n);

/* NULL, or why there is no truth for such a row. */
const char *lobe_truth_capsule_row_refusal(const double *row);

#endif
