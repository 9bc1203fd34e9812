/* Over the normals. After h = S h' / |S h'|, S = diag(alpha, alpha, 1), the lobe is (u.h') / pi with u = S v, and the
 * exponent is sharpness (l.axis - 1) with l = 2 (v.h) h - v. It is largest at the half vector h0, hence great circles
 * from S^-1 h0, whose directions are spread like the section of the Gaussian there. The horizon is a quadratic along
 * each great circle, as is the place where the view no longer sees the normal. */
#include <math.h>
#include "../sphere_light/quadrature.h"
#include "truth_sg.h"

static const double pi = 3.14159265358979323846;

typedef struct vec {
    double x, y, z;
} vec;

typedef struct normals {
    double alpha, v_z, root_v, sharpness, relative, most;
    vec v, axis, u;        /* u: the stretched view */
    vec e1, e2, e3;        /* about the stretched half vector */
    double width2, width3; /* tangents of the angles where the exponent is about -1 */
    vec direction;         /* of the great circle that is integrated */
} normals;

static double dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static vec sum(double p, vec a, double q, vec b)
{
    const vec y = {p * a.x + q * b.x, p * a.y + q * b.y, p * a.z + q * b.z};
    return y;
}

static vec unit(vec a)
{
    const double n = 1 / sqrt(dot(a, a));
    return sum(n, a, 0, a);
}

static vec cross(vec a, vec b)
{
    const vec y = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return y;
}

static vec stretched(const normals *s, vec a)
{
    const vec y = {s->alpha * a.x, s->alpha * a.y, a.z};
    return y;
}

static double at_angle(double t, void *context)
{
    const normals *s = context;
    const vec x = sum(cos(t), s->e1, sin(t), s->direction), h = unit(stretched(s, x));
    const double ux = dot(s->u, x), a2 = s->alpha * s->alpha;
    const vec l = sum(2 * dot(s->v, h), h, -1, s->v), off = sum(1, l, -1, s->axis);
    const double z = l.z;
    if (z <= 0 || ux <= 0)
        return 0;
    return sin(t) * ux * 2 * z / (z * s->root_v + s->v_z * sqrt(a2 + (1 - a2) * z * z)) *
           exp(-.5 * s->sharpness * dot(off, off)) / pi;
}

/* In [0, pi). */
static double turn(double s, double c)
{
    const double t = atan2(s, c);
    return t < 0 ? t + pi : t;
}

static double at_turn(double psi, void *context)
{
    normals *s = context;
    const double c2 = s->width2 * cos(psi), c3 = s->width3 * sin(psi), r2 = c2 * c2 + c3 * c3, r = sqrt(r2);
    const double jacobian = s->width2 * s->width3 / r2, a2 = s->alpha * s->alpha;
    double breaks[7], w0, w1, w2, discriminant, up, uq, arc, end;
    vec q;
    int n = 0;
    s->direction = q = sum(c2 / r, s->e2, c3 / r, s->e3);
    up = dot(s->u, s->e1);
    uq = dot(s->u, q);
    w0 = 2 * up * s->e1.z - s->v_z * (a2 * (s->e1.x * s->e1.x + s->e1.y * s->e1.y) + s->e1.z * s->e1.z);
    w1 = up * q.z + uq * s->e1.z - s->v_z * (a2 * (s->e1.x * q.x + s->e1.y * q.y) + s->e1.z * q.z);
    w2 = 2 * uq * q.z - s->v_z * (a2 * (q.x * q.x + q.y * q.y) + q.z * q.z);
    discriminant = w1 * w1 - w0 * w2;
    if (discriminant > 0) {
        const double root = -(w1 + (w1 >= 0 ? 1 : -1) * sqrt(discriminant));
        breaks[n++] = turn(root, w2);
        breaks[n++] = turn(w0, root);
    }
    end = turn(-up, uq);
    breaks[n++] = atan(.6 * r);
    breaks[n++] = atan(1.5 * r);
    breaks[n++] = atan(4 * r);
    breaks[n++] = atan(12 * r);
    if (end <= 0 || end > pi)
        end = pi;
    breaks[n++] = end;
    arc = lobe_quadrature(at_angle, s, 0, pi, breaks, n, .1 * s->relative, 1e-3 * s->relative * s->most / jacobian);
    s->most = fmax(s->most, jacobian * arc);
    return jacobian * arc;
}

/* The section of the Gaussian at e1: the exponent there is -sharpness x' M x / |S e1|^2, M = S (p p' + k m m') S with p
 * along v - axis, m along v x axis and k = (v.h0)^2, times 2. */
static void place(normals *s)
{
    const vec both = sum(1, s->v, 1, s->axis), apart = sum(1, s->v, -1, s->axis);
    const double g = .5 * dot(both, both);
    /* on either side of a view that looks along the axis, any frame is one of the section's */
    const vec any = fabs(s->v.z) < .9 ? (vec){0, 0, 1} : (vec){1, 0, 0};
    const vec h0 = g > 1e-12 ? unit(both) : unit(cross(s->v, any));
    const vec p = unit(sum(1, apart, -dot(apart, h0), h0));
    const vec d = dot(apart, apart) > 1e-16 ? p : unit(cross(h0, any)), m = cross(h0, d);
    const vec ds = stretched(s, d), ms = stretched(s, m);
    const vec back = {h0.x / s->alpha, h0.y / s->alpha, h0.z};
    vec t2, t3, n;
    double a, b, c, angle, q2, q3, base, k;
    s->e1 = unit(back);
    t2 = unit(cross(s->e1, fabs(s->e1.z) < .9 ? (vec){0, 0, 1} : (vec){1, 0, 0}));
    t3 = cross(s->e1, t2);
    k = .5 * g;
    a = dot(ds, t2) * dot(ds, t2) + k * dot(ms, t2) * dot(ms, t2);
    b = dot(ds, t2) * dot(ds, t3) + k * dot(ms, t2) * dot(ms, t3);
    c = dot(ds, t3) * dot(ds, t3) + k * dot(ms, t3) * dot(ms, t3);
    angle = .5 * atan2(2 * b, a - c);
    s->e2 = sum(cos(angle), t2, sin(angle), t3);
    s->e3 = cross(s->e1, s->e2);
    q2 = .5 * (a + c) + .5 * hypot(a - c, 2 * b);
    q3 = fmax((a * c - b * b) / q2, 1e-14 * q2);
    n = stretched(s, s->e1);
    base = dot(n, n) / (2 * s->sharpness);
    s->width2 = fmin(sqrt(base / q2), 1);
    s->width3 = fmin(sqrt(base / q3), 1);
}

double lobe_truth_sg_stretched(const lobe_sg_scene *scene, double tolerance)
{
    const double a2 = scene->alpha * scene->alpha, sine = sqrt(1 - scene->l_z * scene->l_z);
    normals s = {.alpha = scene->alpha, .v_z = scene->v_z, .sharpness = scene->sharpness, .relative = tolerance};
    double breaks[14], long_axis;
    int i, n = 0;
    s.root_v = sqrt(a2 + (1 - a2) * scene->v_z * scene->v_z);
    s.v = (vec){sqrt(1 - scene->v_z * scene->v_z), 0, scene->v_z};
    s.axis = (vec){sine * cos(scene->azimuth), sine * sin(scene->azimuth), scene->l_z};
    s.u = stretched(&s, s.v);
    place(&s);
    /* A long section sweeps through its short axis within the ratio of the two: breaks, or the nodes step over it. */
    long_axis = atan2(s.width2, s.width3);
    for (i = 0; i < 4; i++) {
        breaks[n++] = i * .5 * pi;
        breaks[n++] = i < 2 ? .5 * pi - long_axis + i * pi : .5 * pi + long_axis + (i - 2) * pi;
    }
    return lobe_quadrature(at_turn, &s, 0, 2 * pi, breaks, n, tolerance, 0);
}
