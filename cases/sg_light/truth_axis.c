/* Over the light's directions: theta and psi about the axis, nested. The horizon cuts psi at a known angle, and theta
 * at the axis's elevation is a break; so are the mirror direction, a width of the lobe around it, and widths of the
 * Gaussian. */
#include <math.h>
#include "../sphere_light/quadrature.h"
#include "../sphere_light/truth_sphere.h"
#include "truth_sg.h"

static const double pi = 3.14159265358979323846;

typedef struct about_axis {
    double alpha, sharpness, v[3], l[3], up[3], right[3]; /* up: along the meridian, towards the normal */
    double l_z, sine_l, sine_theta, cos_theta, psi_mirror, relative, most;
    int diffuse;
} about_axis;

static double at_psi(double psi, void *context)
{
    const about_axis *c = context;
    const double x = c->sine_theta * cos(psi), y = c->sine_theta * sin(psi);
    double d[3];
    int i;
    for (i = 0; i < 3; i++)
        d[i] = c->cos_theta * c->l[i] + x * c->up[i] + y * c->right[i];
    return c->diffuse ? fmax(d[2], 0) / pi : lobe_truth_sphere_brdf(c->alpha, c->v, d, 1);
}

static double at_theta(double theta, void *context)
{
    about_axis *c = context;
    const double half = sin(.5 * theta), weight = sin(theta) * exp(-2 * c->sharpness * half * half);
    const double m = c->psi_mirror, lobe = atan2(2 * c->alpha, sin(theta));
    double q, psi, ring, breaks[6] = {m, 0, m - lobe, m + lobe, m - 3 * lobe, m + 3 * lobe};
    c->sine_theta = sin(theta);
    c->cos_theta = cos(theta);
    q = -c->cos_theta * c->l_z / fmax(c->sine_theta * c->sine_l, 1e-300);
    psi = q <= -1 ? pi : q >= 1 ? 0 : acos(q);
    ring = weight * lobe_quadrature(at_psi, c, -psi, psi, breaks, 6, .1 * c->relative,
                                    1e-3 * c->relative * c->most / fmax(weight, 1e-300));
    c->most = fmax(c->most, ring);
    return ring;
}

static double integrate(about_axis *c, double l_z, double azimuth, double tolerance)
{
    const double sine = sqrt(fmax(0, 1 - l_z * l_z)), ca = cos(azimuth), sa = sin(azimuth), elevation = asin(l_z);
    const double l[3] = {sine * ca, sine * sa, l_z}, up[3] = {-l_z * ca, -l_z * sa, sine}, right[3] = {-sa, ca, 0};
    const double m[3] = {-c->v[0], 0, c->v[2]}, width = sqrt(1 / c->sharpness);
    double ml, mu, mr, mirror, breaks[10], end;
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
    breaks[5] = width;
    breaks[6] = 2 * width;
    breaks[7] = 4 * width;
    breaks[8] = mirror - 6 * c->alpha;
    breaks[9] = mirror + 6 * c->alpha;
    /* to exp(-60) of what the brightest direction above the horizon has */
    end = fmax(0, -elevation);
    end = 2 * asin(sqrt(fmin(1, .5 * (1 - cos(end)) + 30 / c->sharpness)));
    return lobe_quadrature(at_theta, c, fmax(0, -elevation), end, breaks, 10, tolerance, 0);
}

double lobe_truth_sg_axis(const lobe_sg_scene *s, double tolerance)
{
    about_axis c = {.alpha = s->alpha, .sharpness = s->sharpness, .v = {sqrt(1 - s->v_z * s->v_z), 0, s->v_z}};
    return integrate(&c, s->l_z, s->azimuth, tolerance);
}

double lobe_truth_sg_irradiance(double l_z, double sharpness, double tolerance)
{
    about_axis c = {.alpha = 1, .sharpness = sharpness, .v = {0, 0, 1}, .diffuse = 1};
    return integrate(&c, l_z, 0, tolerance);
}

double lobe_truth_sg_punctual(const lobe_sg_scene *s)
{
    const double v[3] = {sqrt(1 - s->v_z * s->v_z), 0, s->v_z}, sine = sqrt(1 - s->l_z * s->l_z);
    const double l[3] = {sine * cos(s->azimuth), sine * sin(s->azimuth), s->l_z};
    return -2 * pi * expm1(-2 * s->sharpness) / s->sharpness * lobe_truth_sphere_brdf(s->alpha, v, l, 1);
}

void lobe_truth_sg_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += 5) {
        const lobe_sg_scene s = {in[0] * in[0], in[1], in[2], in[3], in[4]};
        out[i] = lobe_truth_sg_axis(&s, 1e-8);
    }
}
