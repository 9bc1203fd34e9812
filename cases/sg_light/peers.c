#include "peers.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

typedef struct scene {
    double a2, v, s, sharpness; /* s: the view's sine */
    double axis[3];             /* of the light; the view is (s, 0, v) */
} scene;

static scene scene_of(const double row[5])
{
    const double a = row[0] * row[0], sine = sqrt(1 - row[2] * row[2]);
    const scene y = {
        a * a, row[1], sqrt(1 - row[1] * row[1]), row[4], {sine * cos(row[3]), sine * sin(row[3]), row[2]}};
    return y;
}

static double separable(double a2, double z) { return 1 / (z + sqrt(a2 + (1 - a2) * z * z)); }

double lobe_peer_sg_warp(const double row[5])
{
    const scene c = scene_of(row);
    const double sharp = 2 / c.a2 / (4 * fmax(c.v, 1e-4)), light = c.sharpness;
    const double x = light * c.axis[0] - sharp * c.s, y = light * c.axis[1], z = light * c.axis[2] + sharp * c.v;
    const double length = sqrt(x * x + y * y + z * z), both = sharp + light;
    const double product = 2 * pi * exp(length - both) * -expm1(-2 * length) / fmax(length, 1e-12);
    return product / (pi * c.a2) * separable(c.a2, c.v) * separable(c.a2, c.v) * c.v;
}

/* An anisotropic lobe about the direction at that sine and height in the mirror's half of the plane of incidence,
 * folded with the light. */
static double anisotropic(const scene *c, double sharp, double sine, double height, double least)
{
    const double v = fmax(c->v, least), nu = .5 * c->sharpness;
    const double x = sharp / (8 * v * v), y = sharp / 8;
    const double across = c->axis[1], along = c->axis[0] * height + c->axis[2] * sine;
    const double front = fmax(-c->axis[0] * sine + c->axis[2] * height, 0);
    return front * pi / sqrt((nu + x) * (nu + y)) *
           exp(-nu * x / (nu + x) * across * across - nu * y / (nu + y) * along * along);
}

double lobe_peer_asg_warp(const double row[5])
{
    const scene c = scene_of(row);
    return anisotropic(&c, 2 / c.a2, c.s, c.v, 1e-4) / (pi * c.a2) * separable(c.a2, c.v) * separable(c.a2, c.v) * c.v;
}

double lobe_peer_asg_refitted(const double row[5])
{
    const scene c = scene_of(row);
    const double angle = acos(c.v) * (1 - .671 * sqrt(c.a2)), z = cos(angle);
    const double mask = z * sqrt(c.a2 + (1 - c.a2) * c.v * c.v) + c.v * sqrt(c.a2 + (1 - c.a2) * z * z);
    return .933 * anisotropic(&c, 2.116 / c.a2, sin(angle), z, .064) / (pi * c.a2) * .5 * z / mask;
}
