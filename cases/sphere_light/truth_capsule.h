/* Ground truth of capsule lights: radiance 1 from the points nearer than radius to the segment from p to q, under the
 * BRDF of truth_sphere.h with F = 1. The shading point is the origin, n = z, v = (sin, 0, v_z). */
#ifndef LOBE_SPHERE_LIGHT_TRUTH_CAPSULE_H
#define LOBE_SPHERE_LIGHT_TRUTH_CAPSULE_H

/* spheres 0: the exact silhouette; n > 1: the union of n spheres along the segment, which is the second opinion and
 * tends to the first as 1 / n^2. NaN where the segment's line is not farther than radius from the origin. */
double lobe_truth_capsule(double alpha, double v_z, const double p[3], const double q[3], double radius,
                          double tolerance, int spheres);

#endif
