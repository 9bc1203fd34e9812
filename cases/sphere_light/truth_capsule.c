/* Over the directions in polar coordinates about the segment's axis, where the silhouette of the capsule is known: two
 * discs, and between their points of contact the tangent planes of a cylinder. */
#include "truth_capsule.h"
#include <math.h>
#include "quadrature.h"
#include "truth_sphere.h"

static const double pi = 3.14159265358979323846;

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

typedef struct capsule {
    double a, v[3], e[3], x[3], y[3], d0, x0, x1, r, st, ct, rel, peak;
    int spheres;
} capsule;

static double capsule_psi(double psi, void *ctx)
{
    const capsule *c = ctx;
    double l[3];
    const double p = c->st * cos(psi), q = c->st * sin(psi);
    for (int i = 0; i < 3; i++)
        l[i] = c->ct * c->e[i] + p * c->x[i] + q * c->y[i];
    return lobe_truth_sphere_brdf(c->a, c->v, l, 1);
}

static double disc_psi(const capsule *c, double x)
{
    const double d2 = c->d0 * c->d0 + x * x, d = sqrt(d2), cs = sqrt(1 - c->r * c->r / d2);
    const double q = (cs - c->ct * x / d) / (c->st * c->d0 / d);
    return q >= 1 ? -1 : q <= -1 ? pi : acos(q);
}

static double capsule_tau(double tau, void *ctx)
{
    capsule *c = ctx;
    c->st = sin(tau);
    c->ct = cos(tau);
    double psi = fmax(disc_psi(c, c->x0), disc_psi(c, c->x1));
    if (c->spheres > 1) {
        for (int i = 0; i < c->spheres; i++)
            psi = fmax(psi, disc_psi(c, c->x0 + (c->x1 - c->x0) * i / (c->spheres - 1)));
    } else {
        const double contact = sqrt(c->d0 * c->d0 - c->r * c->r) * c->ct / c->st;
        if (contact > c->x0 && contact < c->x1)
            psi = fmax(psi, asin(c->r / c->d0));
    }
    if (psi <= 0)
        return 0;
    /* horizon: ct e.z + st (x.z cos + y.z sin) > 0 */
    const double amp = c->st * sqrt(c->x[2] * c->x[2] + c->y[2] * c->y[2]), mid = atan2(c->y[2], c->x[2]);
    const double q = -c->ct * c->e[2] / fmax(amp, 1e-300);
    if (q >= 1)
        return 0;
    double b[4], sum = 0;
    int n = 0;
    if (q > -1) {
        b[n++] = remainder(mid - acos(q), 2 * pi);
        b[n++] = remainder(mid + acos(q), 2 * pi);
    }
    b[n++] = c->peak;
    b[n++] = 0;
    sum = lobe_quadrature(capsule_psi, c, -psi, psi, b, n, .1 * c->rel, 0);
    return sum * c->st;
}

double lobe_truth_capsule(double a, double vz, const double p[3], const double q[3], double radius, double tol,
                          int spheres)
{
    capsule c = {.a = a, .v = {sqrt(1 - vz * vz), 0, vz}, .r = radius, .rel = tol, .spheres = spheres};
    double len = 0, n = 0, b[10];
    for (int i = 0; i < 3; i++) {
        c.e[i] = q[i] - p[i];
        len += c.e[i] * c.e[i];
    }
    len = sqrt(len);
    for (int i = 0; i < 3; i++)
        c.e[i] /= len;
    c.x0 = dot(p, c.e);
    c.x1 = dot(q, c.e);
    for (int i = 0; i < 3; i++) {
        c.x[i] = p[i] - c.x0 * c.e[i];
        n += c.x[i] * c.x[i];
    }
    c.d0 = sqrt(n);
    if (c.d0 <= radius)
        return NAN; /* out of domain */
    for (int i = 0; i < 3; i++)
        c.x[i] /= c.d0;
    c.y[0] = c.e[1] * c.x[2] - c.e[2] * c.x[1];
    c.y[1] = c.e[2] * c.x[0] - c.e[0] * c.x[2];
    c.y[2] = c.e[0] * c.x[1] - c.e[1] * c.x[0];
    const double t1 = atan2(c.d0, c.x1), t0 = atan2(c.d0, c.x0); /* t1 < t0 */
    const double s1 = asin(radius / sqrt(c.d0 * c.d0 + c.x1 * c.x1)),
                 s0 = asin(radius / sqrt(c.d0 * c.d0 + c.x0 * c.x0));
    const double w = sqrt(c.d0 * c.d0 - radius * radius);
    const double r[3] = {-c.v[0], 0, c.v[2]};
    c.peak = atan2(dot(r, c.y), dot(r, c.x));
    const double tr = acos(fmax(-1, fmin(1, dot(r, c.e))));
    b[0] = t1;
    b[1] = t0;
    b[2] = atan2(w, c.x1);
    b[3] = atan2(w, c.x0);
    b[4] = tr;
    b[5] = tr - 2 * a;
    b[6] = tr + 2 * a;
    return lobe_quadrature(capsule_tau, &c, fmax(0, t1 - s1), fmin(pi, t0 + s0), b, 7, tol, 0);
}
