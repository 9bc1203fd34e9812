/* Burley's diffuse (Disney 2012) under a sphere light as it is, by quadrature over the part of the light above the
 * horizon: what nine spherical harmonics of the same light are compared with.
 *
 * n = z, the view in the x-z plane at height n_dot_v; the light's centre at height n_dot_l and that azimuth from the
 * view's side. Radiance 1, base colour 1. sine in [1e-4, 1]. To 1e-8 sine^2 or better. */
#ifndef LOBE_BURLEY_CONE_H
#define LOBE_BURLEY_CONE_H

double lobe_truth_burley_cone(double roughness, double n_dot_v, double n_dot_l, double azimuth, double sine);

#endif
