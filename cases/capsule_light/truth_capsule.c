#include "truth_capsule.h"
#include <math.h>
#include <stdbool.h>
#include "../sphere_light/quadrature.h"
#include "../sphere_light/truth_sphere.h"

static const double pi = 3.14159265358979323846;

/* e: the axis; x: from the origin to the axis, at the distance d0; the ends stand at x0 < x1 on it. */
typedef struct capsule {
    double alpha, f0, v[3], e[3], x[3], y[3], d0, x0, x1, r, sine, cosine, relative, peak;
    int spheres; /* 0: the silhouette */
} capsule;

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static double at_psi(double psi, void *context)
{
    const capsule *c = context;
    const double p = c->sine * cos(psi), q = c->sine * sin(psi);
    double l[3];
    int i;
    for (i = 0; i < 3; i++)
        l[i] = c->cosine * c->e[i] + p * c->x[i] + q * c->y[i];
    return lobe_truth_sphere_brdf(c->alpha, c->v, l, c->f0);
}

/* How far to either side the sphere at x of the axis reaches, at this angle from the axis; -1 where it does not. */
static double reach(const capsule *c, double x)
{
    const double d2 = c->d0 * c->d0 + x * x, d = sqrt(d2), edge = sqrt(1 - c->r * c->r / d2);
    const double q = (edge - c->cosine * x / d) / (c->sine * c->d0 / d);
    return q >= 1 ? -1 : q <= -1 ? pi : acos(q);
}

static double silhouette(const capsule *c)
{
    double psi = fmax(reach(c, c->x0), reach(c, c->x1));
    int i;
    if (c->spheres > 1) {
        for (i = 1; i < c->spheres - 1; i++)
            psi = fmax(psi, reach(c, c->x0 + (c->x1 - c->x0) * i / (c->spheres - 1)));
    } else {
        const double contact = sqrt(c->d0 * c->d0 - c->r * c->r) * c->cosine / c->sine;
        if (contact > c->x0 && contact < c->x1)
            psi = fmax(psi, asin(c->r / c->d0));
    }
    return psi;
}

static double at_theta(double theta, void *context)
{
    capsule *c = context;
    double psi, amplitude, middle, q, breaks[6];
    int count = 0;
    c->sine = sin(theta);
    c->cosine = cos(theta);
    psi = silhouette(c);
    /* the height is cosine e.z + sine (x.z cos psi + y.z sin psi) */
    amplitude = c->sine * sqrt(c->x[2] * c->x[2] + c->y[2] * c->y[2]);
    middle = atan2(c->y[2], c->x[2]);
    q = -c->cosine * c->e[2] / fmax(amplitude, 1e-300);
    if (psi <= 0 || q >= 1)
        return 0;
    if (q > -1) {
        breaks[count++] = remainder(middle - acos(q), 2 * pi);
        breaks[count++] = remainder(middle + acos(q), 2 * pi);
    }
    breaks[count++] = c->peak;
    breaks[count++] = c->peak - 2 * c->alpha;
    breaks[count++] = c->peak + 2 * c->alpha;
    breaks[count++] = 0;
    return c->sine * lobe_quadrature(at_psi, c, -psi, psi, breaks, count, .1 * c->relative, 1e-14);
}

static double sphere_at(const lobe_capsule_scene *s, const double p[3], double tolerance)
{
    const double d = sqrt(dot(p, p));
    const lobe_sphere_scene scene = {.alpha = s->alpha,
                                     .v_z = s->v_z,
                                     .l_z = fmax(-1, fmin(1, p[2] / d)),
                                     .azimuth = fabs(atan2(p[1], p[0])),
                                     .sigma = asin(s->radius / d),
                                     .f0 = s->f0};
    return lobe_truth_sphere_cone(&scene, tolerance);
}

/* From the segment's nearest point to the origin. */
static double distance(const lobe_capsule_scene *s)
{
    const double ee = dot(s->half, s->half), t = ee > 0 ? fmax(-1, fmin(1, -dot(s->middle, s->half) / ee)) : 0;
    double p[3];
    int i;
    for (i = 0; i < 3; i++)
        p[i] = s->middle[i] + t * s->half[i];
    return sqrt(dot(p, p));
}

const char *lobe_capsule_refusal(const lobe_capsule_scene *s)
{
    const double d = distance(s);
    if (!(s->radius > 0))
        return "the radius is not above 0";
    if (!(d >= 1.0001 * s->radius))
        return "the shading point is inside the capsule, or on it";
    if (!(s->radius >= 1e-4 * d))
        return "the radius is below 1e-4 of the distance";
    if (!(sqrt(dot(s->half, s->half)) <= 1e3 * d))
        return "the segment is longer than 2000 times the distance";
    return NULL;
}

/* Axis and frame; false where the capsule looks like the sphere at its near end: from a point on the prolonged
 * cylinder, which is inside it or near enough for the frame to have no digits, or for a segment of no length. */
static bool frame(capsule *c, const lobe_capsule_scene *s)
{
    const double length = sqrt(dot(s->half, s->half)), d = sqrt(dot(s->middle, s->middle));
    double middle;
    int i;
    if (length <= 1e-9 * d)
        return false;
    for (i = 0; i < 3; i++)
        c->e[i] = s->half[i] / length;
    middle = dot(s->middle, c->e);
    for (i = 0; i < 3; i++)
        c->x[i] = s->middle[i] - middle * c->e[i];
    c->d0 = sqrt(dot(c->x, c->x));
    if (c->d0 <= (1 + 1e-9) * s->radius)
        return false;
    for (i = 0; i < 3; i++)
        c->x[i] /= c->d0;
    c->y[0] = c->e[1] * c->x[2] - c->e[2] * c->x[1];
    c->y[1] = c->e[2] * c->x[0] - c->e[0] * c->x[2];
    c->y[2] = c->e[0] * c->x[1] - c->e[1] * c->x[0];
    c->x0 = middle - length;
    c->x1 = middle + length;
    return true;
}

static double near_end(const lobe_capsule_scene *s, double tolerance)
{
    const double sign = dot(s->middle, s->half) > 0 ? -1 : 1;
    double p[3];
    int i;
    for (i = 0; i < 3; i++)
        p[i] = s->middle[i] + sign * s->half[i];
    return sphere_at(s, p, tolerance);
}

double lobe_truth_capsule_spheres(const lobe_capsule_scene *s, double tolerance, int spheres)
{
    capsule c = {.alpha = s->alpha,
                 .f0 = s->f0,
                 .v = {sqrt(1 - s->v_z * s->v_z), 0, s->v_z},
                 .r = s->radius,
                 .relative = tolerance,
                 .spheres = spheres};
    const double mirror[3] = {-c.v[0], 0, c.v[2]};
    double t0, t1, s0, s1, side, to_mirror, breaks[7];
    if (lobe_capsule_refusal(s))
        return NAN;
    if (!frame(&c, s))
        return near_end(s, tolerance);
    t0 = atan2(c.d0, c.x0); /* the far side: t1 < t0 */
    t1 = atan2(c.d0, c.x1);
    s0 = asin(c.r / sqrt(c.d0 * c.d0 + c.x0 * c.x0));
    s1 = asin(c.r / sqrt(c.d0 * c.d0 + c.x1 * c.x1));
    side = sqrt(c.d0 * c.d0 - c.r * c.r);
    c.peak = atan2(dot(mirror, c.y), dot(mirror, c.x));
    to_mirror = acos(fmax(-1, fmin(1, dot(mirror, c.e))));
    breaks[0] = t1;
    breaks[1] = t0;
    breaks[2] = atan2(side, c.x1);
    breaks[3] = atan2(side, c.x0);
    breaks[4] = to_mirror;
    breaks[5] = to_mirror - 2 * c.alpha;
    breaks[6] = to_mirror + 2 * c.alpha;
    return lobe_quadrature(at_theta, &c, fmax(0, t1 - s1), fmin(pi, t0 + s0), breaks, 7, tolerance, 1e-13);
}

double lobe_truth_capsule(const lobe_capsule_scene *s, double tolerance)
{
    return lobe_truth_capsule_spheres(s, tolerance, 0);
}

static lobe_capsule_scene scene_of(const double *row)
{
    const lobe_capsule_scene s = {row[0] * row[0],          row[1], 1, {row[2], row[3], row[4]},
                                  {row[5], row[6], row[7]}, row[8]};
    return s;
}

void lobe_truth_capsule_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        const lobe_capsule_scene s = scene_of(in + 9 * i);
        out[i] = lobe_truth_capsule(&s, 1e-7);
    }
}

const char *lobe_truth_capsule_row_refusal(const double *row)
{
    const lobe_capsule_scene s = scene_of(row);
    return lobe_capsule_refusal(&s);
}
