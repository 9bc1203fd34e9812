/* In polar coordinates about the light's centre, theta and psi: the horizon cuts psi at a known angle, and theta where
 * it begins to cut is a break. */
#include "burley_cone.h"
#include <math.h>
#include "../diffuse_sh/truth_diffuse.h"
#include "../sphere_light/quadrature.h"

static const double pi = 3.14159265358979323846;

typedef struct cone {
    double roughness, n_dot_v, view[3], centre[3], up[3], right[3];
    double sine_theta, cos_theta;
} cone;

static double at_psi(double psi, void *context)
{
    const cone *c = context;
    const double x = c->sine_theta * cos(psi), y = c->sine_theta * sin(psi);
    double l[3], l_dot_v = 0;
    int i;
    for (i = 0; i < 3; i++) {
        l[i] = c->cos_theta * c->centre[i] + x * c->up[i] + y * c->right[i];
        l_dot_v += l[i] * c->view[i];
    }
    return l[2] > 0 ? l[2] * lobe_burley_2012(fmin(1, l[2]), c->n_dot_v, l_dot_v, c->roughness) : 0;
}

static double at_theta(double theta, void *context)
{
    cone *c = context;
    double q, psi, breaks[1] = {0};
    c->sine_theta = sin(theta);
    c->cos_theta = cos(theta);
    q = -c->cos_theta * c->centre[2] / fmax(c->sine_theta * c->up[2], 1e-300);
    psi = q <= -1 ? pi : q >= 1 ? 0 : acos(q);
    return c->sine_theta * lobe_quadrature(at_psi, c, -psi, psi, breaks, 1, 1e-9, 1e-12);
}

double lobe_truth_burley_cone(double roughness, double n_dot_v, double n_dot_l, double azimuth, double sine)
{
    const double across = sqrt(fmax(0, 1 - n_dot_l * n_dot_l)), ca = cos(azimuth), sa = sin(azimuth);
    const cone c = {.roughness = roughness,
                    .n_dot_v = n_dot_v,
                    .view = {sqrt(fmax(0, 1 - n_dot_v * n_dot_v)), 0, n_dot_v},
                    .centre = {across * ca, across * sa, n_dot_l},
                    .up = {-n_dot_l * ca, -n_dot_l * sa, across},
                    .right = {-sa, ca, 0}};
    cone work = c;
    double breaks[2] = {fabs(asin(n_dot_l)), pi - fabs(asin(n_dot_l))};
    return lobe_quadrature(at_theta, &work, 0, asin(sine), breaks, 2, 1e-9, 1e-9 * sine * sine);
}
