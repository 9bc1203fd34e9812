/* GGX visible normals by spherical caps (Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", 2023):
 * a point of the unit square gives the light direction that a visible normal reflects the view to. */
#ifndef LOBE_ENV_VISIBLE_NORMALS_H
#define LOBE_ENV_VISIBLE_NORMALS_H

/* turn in [0, 1) goes round, height in [0, 1] up the cap. View as in response.h. */
void lobe_visible_normal(double alpha, double n_dot_v, double turn, double height, double h[3]);
void lobe_visible_light(double alpha, double n_dot_v, double turn, double height, double l[3]);

/* The density of l over the sphere of directions; lobe_response is this times lobe_response_shadowing. */
double lobe_visible_light_density(double alpha, double n_dot_v, const double l[3]);

/* Light directions and weights such that sum weight f(l) is the integral of lobe_response f: Gauss-Legendre of this
 * order up the cap, 2 order even turns around it, of which those with y > 0 are kept, order^2 nodes: f must be even in
 * y. Returns how many nodes are above the horizon; rows of x y z weight and the solid angle that each stands for. */
int lobe_visible_nodes(double alpha, double n_dot_v, int order, double *rows);

#endif
