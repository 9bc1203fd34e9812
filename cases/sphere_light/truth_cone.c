/* Over the light's directions: theta and psi about its axis, nested. The horizon cuts psi at a known angle, and theta
 * at the light's elevation is a break; so are the mirror direction and a width of the lobe around it. */
#include <math.h>
#include "quadrature.h"
#include "truth_sphere.h"

static const double pi = 3.14159265358979323846;

typedef struct cone {
    double alpha, f0, v[3], l[3], up[3], right[3]; /* up: along the meridian, towards the normal */
    double l_z, sine_l, sine_theta, cos_theta, psi_mirror, relative;
    int diffuse;
} cone;

double lobe_truth_sphere_brdf(double a, const double v[3], const double l[3], double f0)
{
    const double hx = v[0] + l[0], hy = v[1] + l[1], hz = v[2] + l[2];
    const double tangent = hx * hx + hy * hy, z2 = hz * hz, n2 = tangent + z2;
    double q, d, root_v, root_l, x;
    if (l[2] <= 0)
        return 0;
    q = (tangent + a * a * z2) / n2;
    d = a * a / (pi * q * q);
    root_v = sqrt(a * a + (1 - a * a) * v[2] * v[2]);
    root_l = sqrt(a * a + (1 - a * a) * l[2] * l[2]);
    x = 1 - .5 * sqrt(n2);
    return d * .5 * l[2] / (l[2] * root_v + v[2] * root_l) * (f0 + (1 - f0) * x * x * x * x * x);
}

double lobe_truth_sphere_punctual(const lobe_sphere_scene *s)
{
    const double v[3] = {sqrt(1 - s->v_z * s->v_z), 0, s->v_z}, sine = sqrt(1 - s->l_z * s->l_z);
    const double l[3] = {sine * cos(s->azimuth), sine * sin(s->azimuth), s->l_z}, half = sin(.5 * s->sigma);
    return 4 * pi * half * half * lobe_truth_sphere_brdf(s->alpha, v, l, 1);
}

static double at_psi(double psi, void *context)
{
    const cone *c = context;
    const double x = c->sine_theta * cos(psi), y = c->sine_theta * sin(psi);
    double d[3];
    int i;
    for (i = 0; i < 3; i++)
        d[i] = c->cos_theta * c->l[i] + x * c->up[i] + y * c->right[i];
    return c->diffuse ? fmax(d[2], 0) / pi : lobe_truth_sphere_brdf(c->alpha, c->v, d, c->f0);
}

static double at_theta(double theta, void *context)
{
    cone *c = context;
    double q, psi, breaks[4] = {c->psi_mirror, 0, c->psi_mirror - .3, c->psi_mirror + .3};
    c->sine_theta = sin(theta);
    c->cos_theta = cos(theta);
    q = -c->cos_theta * c->l_z / fmax(c->sine_theta * c->sine_l, 1e-300);
    psi = q <= -1 ? pi : q >= 1 ? 0 : acos(q);
    return c->sine_theta * lobe_quadrature(at_psi, c, -psi, psi, breaks, 4, .1 * c->relative, 0);
}

static double integrate(cone *c, double l_z, double azimuth, double sigma, double tolerance)
{
    const double sine = sqrt(fmax(0, 1 - l_z * l_z)), ca = cos(azimuth), sa = sin(azimuth), elevation = asin(l_z);
    const double l[3] = {sine * ca, sine * sa, l_z}, up[3] = {-l_z * ca, -l_z * sa, sine}, right[3] = {-sa, ca, 0};
    const double m[3] = {-c->v[0], 0, c->v[2]};
    double ml, mu, mr, mirror, breaks[5];
    int i;
    for (i = 0; i < 3; i++) {
        c->l[i] = l[i];
        c->up[i] = up[i];
        c->right[i] = right[i];
    }
    c->l_z = l_z;
    c->sine_l = sine;
    c->relative = tolerance;
    ml = m[0] * l[0] + m[2] * l[2];
    mu = m[0] * up[0] + m[2] * up[2];
    mr = m[0] * right[0];
    mirror = atan2(sqrt(mu * mu + mr * mr), ml);
    c->psi_mirror = atan2(mr, mu);
    breaks[0] = mirror;
    breaks[1] = fabs(elevation);
    breaks[2] = mirror - 2 * c->alpha;
    breaks[3] = mirror + 2 * c->alpha;
    breaks[4] = pi - fabs(elevation);
    return lobe_quadrature(at_theta, c, fmax(0, -elevation), sigma, breaks, 5, tolerance, 0);
}

double lobe_truth_sphere_cone(const lobe_sphere_scene *s, double tolerance)
{
    cone c = {.alpha = s->alpha, .f0 = s->f0, .v = {sqrt(1 - s->v_z * s->v_z), 0, s->v_z}};
    return integrate(&c, s->l_z, s->azimuth, s->sigma, tolerance);
}

double lobe_truth_sphere_irradiance(double l_z, double sigma, double tolerance)
{
    cone c = {.alpha = 1, .f0 = 1, .v = {0, 0, 1}, .diffuse = 1};
    return integrate(&c, l_z, 0, sigma, tolerance);
}
