#include "truth_half.h"
#include <math.h>

#define PI 3.14159265358979323846
#define RANGE 3.6 /* of the tanh-sinh variable: the ends are then within 1e-24 of the interval's length */

#define NODES_MAX 512

/* A node in [0, 1]: its distances from both ends, each with all its digits, and its weight. */
typedef struct node {
    double left, right, weight;
} node;

typedef struct rule {
    int count;
    node nodes[NODES_MAX];
} rule;

static void tanh_sinh(rule *r, double step)
{
    const int half = (int)fmin(floor(RANGE / step), NODES_MAX / 2 - 1);
    int i;
    r->count = 2 * half + 1;
    for (i = 0; i < r->count; i++) {
        const double t = (i - half) * step, e = exp(PI * sinh(t));
        node *x = &r->nodes[i];
        x->left = e / (1 + e);
        x->right = 1 / (1 + e);
        x->weight = step * PI * cosh(t) * x->left * x->right;
    }
}

/* An angle tau with tan theta = a tan tau. tau may be within 1e-9 of pi/2, so it is never itself: only its sine and
 * cosine, each with all digits. */
typedef struct tilt {
    double sin_tau, cos_tau, tan_theta;
} tilt;

typedef struct view {
    int smith;
    double a, cos_v, sin_v;
    tilt first, last; /* where the horizon begins and ends to cut the azimuth */
} view;

/* Smith's masking; G1 of GGX as in Walter et al. 2007, G2 correlated as in Heitz 2014, or Karis 2013 */
static double g1(const view *w, double c)
{
    const double tan2 = (1 - c) * (1 + c) / (c * c);
    if (w->smith == 2)
        return c / (c * (1 - 0.5 * w->a) + 0.5 * w->a);
    return 2 / (1 + sqrt(1 + w->a * w->a * tan2));
}

static double g2(const view *w, double l)
{
    const double gv = g1(w, w->cos_v), gl = g1(w, l);
    return w->smith == 0 ? gv * gl / (gv + gl - gv * gl) : gv * gl;
}

static tilt tilt_of(const view *w, double tan_theta)
{
    const double t = tan_theta / w->a, cos_tau = 1 / sqrt(1 + t * t);
    const tilt out = {t * cos_tau, cos_tau, tan_theta};
    return out;
}

/* The tilt at tau = tau_end - d */
static tilt tilt_before(const view *w, const tilt *end, double d)
{
    const double sin_tau = end->sin_tau * cos(d) - end->cos_tau * sin(d);
    const double cos_tau = end->cos_tau * cos(d) + end->sin_tau * sin(d);
    const tilt out = {sin_tau, cos_tau, w->a * sin_tau / cos_tau};
    return out;
}

/* theta of `to` less theta of `from`, which are d apart in tau */
static double angle_between(const view *w, const tilt *from, const tilt *to, double d)
{
    return atan(w->a * sin(d) / (from->cos_tau * to->cos_tau) / (1 + from->tan_theta * to->tan_theta));
}

/* The azimuth integral at one tau. before = theta1 - theta, after = theta2 - theta; the horizon cuts the azimuth where
 * before < 0. Adds weight times the integral to out. */
static size_t azimuth(const view *w, const tilt *at, double before, double after, const rule *r, double weight,
                      double *out)
{
    const double c = 1 / sqrt(1 + at->tan_theta * at->tan_theta), s = at->tan_theta * c;
    const double reach = 2 * s * c * w->sin_v; /* of l over the azimuth, halved */
    /* cos of the limit is -cot(2 theta) cot(theta_v); half-angle forms keep its digits at both ends */
    const double limit = before < 0 ? 2 * atan2(sqrt(sin(2 * after)), sqrt(sin(-2 * before))) : PI;
    const double lowest = before < 0 ? 0 : sin(2 * before); /* NdotL at phi = limit */
    const double jacobian = weight * 2 * limit * at->sin_tau * at->cos_tau / (PI * c * w->cos_v);
    double scale = 0, bias = 0;
    int i;
    for (i = 0; i < r->count; i++) {
        const node *x = &r->nodes[i];
        const double phi = limit * x->left, gap = limit * x->right;
        const double l = lowest + reach * 2 * sin(0.5 * gap) * sin(limit - 0.5 * gap);
        const double v_dot_h = s * w->sin_v * cos(phi) + c * w->cos_v;
        if (l > 0) {
            const double k = x->weight * g2(w, l < 1 ? l : 1) * v_dot_h;
            const double x1 = 1 - (v_dot_h < 1 ? v_dot_h : 1), f = x1 * x1 * x1 * x1 * x1;
            scale += k * (1 - f);
            bias += k * f;
        }
    }
    out[0] += jacobian * scale;
    out[1] += jacobian * bias;
    return (size_t)r->count;
}

size_t lobe_truth_half(int smith, double alpha, double n_dot_v, double step, double *out)
{
    view w = {smith, alpha, n_dot_v, sqrt((1 - n_dot_v) * (1 + n_dot_v)), {0, 0, 0}, {0, 0, 0}};
    double tau1, span;
    rule r;
    size_t count = 0;
    int i;
    /* theta1 = (pi/2 - theta_v) / 2 and theta2 = pi/2 - theta1 */
    w.first = tilt_of(&w, n_dot_v / (1 + w.sin_v));
    w.last = tilt_of(&w, (1 + w.sin_v) / n_dot_v);
    tau1 = atan(w.first.tan_theta / alpha);
    span = atan(alpha * (w.last.tan_theta - w.first.tan_theta) / (alpha * alpha + 1));
    out[0] = out[1] = 0;
    tanh_sinh(&r, step);
    for (i = 0; i < r.count; i++) {
        const node x = r.nodes[i];
        /* no horizon: tau in [0, tau1] */
        tilt at = tilt_before(&w, &w.first, tau1 * x.right);
        count += azimuth(&w, &at, angle_between(&w, &at, &w.first, tau1 * x.right), 0, &r, x.weight * tau1, out);
        /* horizon: tau in [tau1, tau2] */
        if (w.sin_v > 0) {
            at = tilt_before(&w, &w.last, span * x.right);
            count += azimuth(&w, &at, -angle_between(&w, &w.first, &at, span * x.left),
                             angle_between(&w, &at, &w.last, span * x.right), &r, x.weight * span, out);
        }
    }
    return count;
}
