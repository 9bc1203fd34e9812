/* The integral of truth_stretched.c: adaptive Gauss-Kronrod (7 and 15 nodes) in two nested loops. One text for C and
 * OpenCL C, in double. Only + - * / and sqrt are used, which both round correctly: the two give the same bits, so that
 * they also halve the same panels. Hence stacks for recursion, and every angle t in [0, pi] as y in [0, 1] with
 * tan(t / 2) = y / (1 - y): cos t and sin t are ratios of polynomials, dt = 2 dy / (y^2 + (1 - y)^2). */
#ifndef LOBE_SPHERE_LIGHT_TRUTH_STRETCHED_H
#define LOBE_SPHERE_LIGHT_TRUTH_STRETCHED_H
#include "../../core/dialect.h"

#if defined(LOBE_OPENCL)
#define LOBE_TABLE __constant double
#else
#include <math.h>
#define LOBE_TABLE static const double
#endif

#define LOBE_STRETCHED_HALVINGS 18
#define LOBE_STRETCHED_BREAKS 15

/* The light as an elliptic cone about e1 in the space of stretched normals, with the tangents of its short and its long
 * half axis along e2 and e3; u is the stretched view. Rows of LOBE_STRETCHED_ROW numbers. */
typedef struct lobe_stretched {
    double alpha, v_z, root_v, f0, relative;
    double outside; /* 1: the light is what the cone leaves out */
    double tan2, tan3, u_x, u_z;
    double e1[3], e2[3], e3[3];
} lobe_stretched;
#define LOBE_STRETCHED_ROW 19

/* A great circle from the axis; most is the largest part of the integral that was seen so far. */
typedef struct lobe_stretched_arc {
    double direction[3], most;
} lobe_stretched_arc;

LOBE_TABLE lobe_gk_node[8] = {.991455371120812639206854697526329, .949107912342758524526189684047851,
                              .864864423359769072789712788640926, .741531185599394439863864773280788,
                              .586087235467691130294144691693013, .405845151377397166906606412076961,
                              .207784955007898467600689403773245, 0};
LOBE_TABLE lobe_gk_kronrod[8] = {.022935322010529224963732008058970, .063092092629978553290700663189204,
                                 .104790010322250183839876322541518, .140653259715525918745189590510238,
                                 .169004726639267902826583426598550, .190350578064785409913256402421014,
                                 .204432940075298892414161999234649, .209482141084727828012999174891714};
LOBE_TABLE lobe_gk_gauss[4] = {.129484966168869693270611432679082, .279705391489276667901467771423780,
                               .381830050505118944950369775488975, .417959183673469387755102040816327};

LOBE_FN double lobe_stretched_larger(double a, double b) { return a > b ? a : b; }
LOBE_FN double lobe_stretched_magnitude(double a) { return a < 0 ? -a : a; }

/* y of the angle in [0, pi) whose tangent is s / c */
LOBE_FN double lobe_stretched_turn(double s, double c)
{
    const double r = sqrt(s * s + c * c), up = s < 0 ? -s : s, along = s < 0 ? -c : c;
    double half_sine, half_cosine; /* times a common factor; no cancellation on either side */
    if (r == 0)
        return 0;
    half_sine = along > 0 ? up : r - along;
    half_cosine = along > 0 ? r + along : up;
    return half_sine / (half_sine + half_cosine);
}

/* Times dt / dy, at the angle of y from the axis along the arc. */
LOBE_FN double lobe_stretched_value(const lobe_stretched *s, const lobe_stretched_arc *arc, double y)
{
    const double w = 1 - y, norm = y * y + w * w, sine = 2 * y * w / norm, cosine = (w - y) / norm;
    const double a2 = s->alpha * s->alpha;
    const double x0 = cosine * s->e1[0] + sine * arc->direction[0], x1 = cosine * s->e1[1] + sine * arc->direction[1];
    const double x2 = cosine * s->e1[2] + sine * arc->direction[2];
    const double ux = s->u_x * x0 + s->u_z * x2, n2 = a2 * (x0 * x0 + x1 * x1) + x2 * x2;
    const double z = 2 * ux * x2 / n2 - s->v_z; /* the light direction's height */
    double rest, rest2, fresnel;
    if (z <= 0 || ux <= 0)
        return 0;
    rest = lobe_stretched_larger(0, 1 - ux / sqrt(n2));
    rest2 = rest * rest;
    fresnel = s->f0 + (1 - s->f0) * (rest2 * rest2 * rest);
    return sine * ux * fresnel * 2 * z / (z * s->root_v + s->v_z * sqrt(a2 + (1 - a2) * z * z)) * (2 / norm) *
           .318309886183790671537767526745029;
}

typedef struct lobe_stretched_panel {
    double a, b, whole, error, tolerance;
    int halvings;
} lobe_stretched_panel;

LOBE_FN lobe_stretched_panel lobe_stretched_ended(double a, double b, double k, double g)
{
    const double h = .5 * (b - a);
    lobe_stretched_panel p;
    p.a = a;
    p.b = b;
    p.whole = k * h;
    p.error = lobe_stretched_magnitude(k - g) * h;
    p.tolerance = 0;
    p.halvings = LOBE_STRETCHED_HALVINGS;
    return p;
}

LOBE_FN lobe_stretched_panel lobe_stretched_inner_panel(const lobe_stretched *s, const lobe_stretched_arc *arc,
                                                        double a, double b)
{
    const double c = .5 * (a + b), h = .5 * (b - a), middle = lobe_stretched_value(s, arc, c);
    double k = middle * lobe_gk_kronrod[7], g = middle * lobe_gk_gauss[3];
    int i;
    for (i = 0; i < 7; i++) {
        const double x = h * lobe_gk_node[i];
        const double sum = lobe_stretched_value(s, arc, c - x) + lobe_stretched_value(s, arc, c + x);
        k += lobe_gk_kronrod[i] * sum;
        if (i & 1)
            g += lobe_gk_gauss[i / 2] * sum;
    }
    return lobe_stretched_ended(a, b, k, g);
}

/* Of two halves; the whole and its rules can agree by chance, which was once an error of 4e-4: the halves give it away.
 */
LOBE_FN double lobe_stretched_doubt(double whole, double left, double right, double errors)
{
    const double off = lobe_stretched_magnitude(whole - left - right);
    return off > errors ? .5 * off : 0;
}

/* Sorted, in [lo, hi], with both ends, none nearly twice; the number of panels between them. */
LOBE_FN int lobe_stretched_cut(double *x, double lo, double hi, int count)
{
    int i, j, panels = 0;
    for (i = 2; i <= count; i++) {
        for (j = i; j > 1 && x[j] < x[j - 1]; j--) {
            const double t = x[j];
            x[j] = x[j - 1];
            x[j - 1] = t;
        }
    }
    x[0] = lo;
    for (i = 1; i <= count; i++) {
        if (x[i] > x[panels] + 1e-12 * (hi - lo) && x[i] < hi - 1e-12 * (hi - lo))
            x[++panels] = x[i];
    }
    x[++panels] = hi;
    return panels;
}

/* x[1] to x[count] hold breaks; needs two places more. */
LOBE_FN double lobe_stretched_inner(const lobe_stretched *s, const lobe_stretched_arc *arc, double lo, double hi,
                                    double *x, int count, double relative, double absolute)
{
    lobe_stretched_panel stack[4 + LOBE_STRETCHED_HALVINGS + 2];
    double magnitude = 0, sum = 0, tolerance;
    int panels, i, top;
    if (!(hi > lo))
        return 0;
    panels = lobe_stretched_cut(x, lo, hi, count);
    for (i = 0; i < panels; i++) {
        stack[panels - 1 - i] = lobe_stretched_inner_panel(s, arc, x[i], x[i + 1]);
        magnitude += lobe_stretched_magnitude(stack[panels - 1 - i].whole);
    }
    tolerance = lobe_stretched_larger(relative * magnitude, absolute) / panels;
    for (i = 0; i < panels; i++)
        stack[i].tolerance = tolerance;
    for (top = panels; top > 0;) {
        const lobe_stretched_panel p = stack[--top];
        if (p.error <= p.tolerance || p.halvings == 0) {
            sum += p.whole;
        } else {
            const double m = .5 * (p.a + p.b);
            lobe_stretched_panel left = lobe_stretched_inner_panel(s, arc, p.a, m);
            lobe_stretched_panel right = lobe_stretched_inner_panel(s, arc, m, p.b);
            const double doubt = lobe_stretched_doubt(p.whole, left.whole, right.whole, left.error + right.error);
            left.error = lobe_stretched_larger(left.error, doubt);
            right.error = lobe_stretched_larger(right.error, doubt);
            left.tolerance = right.tolerance = .6 * p.tolerance;
            left.halvings = right.halvings = p.halvings - 1;
            stack[top++] = right;
            stack[top++] = left;
        }
    }
    return sum;
}

/* The arc at y in [0, 2]: the eccentric angle of the section, of which 1 is half a turn. Times dt / dy. */
LOBE_FN double lobe_stretched_arc_value(const lobe_stretched *s, lobe_stretched_arc *arc, double y)
{
    const double side = y > 1 ? -1 : 1, f = y > 1 ? y - 1 : y, w = 1 - f, norm = f * f + w * w;
    const double c2 = s->tan2 * side * (w - f) / norm, c3 = s->tan3 * side * (2 * f * w) / norm;
    const double r = sqrt(c2 * c2 + c3 * c3), jacobian = s->tan2 * s->tan3 / (r * r);
    const double edge = lobe_stretched_turn(r, 1), a2 = s->alpha * s->alpha;
    double up, uq, w0, w1, w2, discriminant, inner, x[5];
    double pq, pp, qq, pz, qz;
    int i, n = 0;
    for (i = 0; i < 3; i++)
        arc->direction[i] = (c2 * s->e2[i] + c3 * s->e3[i]) / r;
    /* the horizon: 2 (u.x) x.z - v_z |S x|^2 = 0 along the great circle */
    pz = s->e1[2];
    qz = arc->direction[2];
    pp = s->e1[0] * s->e1[0] + s->e1[1] * s->e1[1];
    pq = s->e1[0] * arc->direction[0] + s->e1[1] * arc->direction[1];
    qq = arc->direction[0] * arc->direction[0] + arc->direction[1] * arc->direction[1];
    up = s->u_x * s->e1[0] + s->u_z * pz;
    uq = s->u_x * arc->direction[0] + s->u_z * qz;
    w0 = 2 * up * pz - s->v_z * (a2 * pp + pz * pz);
    w1 = up * qz + uq * pz - s->v_z * (a2 * pq + pz * qz);
    w2 = 2 * uq * qz - s->v_z * (a2 * qq + qz * qz);
    discriminant = w1 * w1 - w0 * w2;
    if (discriminant > 0) {
        const double root = -(w1 + (w1 >= 0 ? 1 : -1) * sqrt(discriminant));
        x[++n] = lobe_stretched_turn(root, w2);
        x[++n] = lobe_stretched_turn(w0, root);
    }
    x[++n] = lobe_stretched_turn(-up, uq); /* where the view no longer sees the normal */
    /* Where the light is all but set along this circle, the height is rounding: what is far below the largest part so
     * far need not be relative to itself. */
    inner = lobe_stretched_inner(s, arc, s->outside > 0 ? edge : 0, s->outside > 0 ? 1 : edge, x, n, .1 * s->relative,
                                 1e-4 * s->relative * arc->most / jacobian);
    arc->most = lobe_stretched_larger(arc->most, lobe_stretched_magnitude(jacobian * inner));
    return jacobian * inner * (2 / norm);
}

LOBE_FN lobe_stretched_panel lobe_stretched_outer_panel(const lobe_stretched *s, lobe_stretched_arc *arc, double a,
                                                        double b)
{
    const double c = .5 * (a + b), h = .5 * (b - a), middle = lobe_stretched_arc_value(s, arc, c);
    double k = middle * lobe_gk_kronrod[7], g = middle * lobe_gk_gauss[3];
    int i;
    for (i = 0; i < 7; i++) {
        const double x = h * lobe_gk_node[i];
        const double below = lobe_stretched_arc_value(s, arc, c - x), above = lobe_stretched_arc_value(s, arc, c + x);
        const double sum = below + above;
        k += lobe_gk_kronrod[i] * sum;
        if (i & 1)
            g += lobe_gk_gauss[i / 2] * sum;
    }
    return lobe_stretched_ended(a, b, k, g);
}

LOBE_FN double lobe_stretched_integral(const lobe_stretched *s)
{
    lobe_stretched_panel stack[LOBE_STRETCHED_BREAKS + 1 + LOBE_STRETCHED_HALVINGS + 2];
    lobe_stretched_arc arc;
    double x[LOBE_STRETCHED_BREAKS + 2], magnitude = 0, sum = 0;
    /* A long section sweeps through its short axis within the ratio of the two: breaks, or the nodes step over it. */
    const double ratio = lobe_stretched_turn(s->tan2, s->tan3);
    const double root = lobe_stretched_turn(sqrt(s->tan2), sqrt(s->tan3));
    const double eighth = .292893218813452475599155637895151; /* y of pi / 4 */
    int panels, i, top, n = 0;
    for (i = 0; i < 2; i++) {
        x[++n] = i + ratio;
        x[++n] = i + root;
        x[++n] = i + eighth;
        x[++n] = i + .5;
        x[++n] = i + 1 - eighth;
        x[++n] = i + 1 - root;
        x[++n] = i + 1 - ratio;
    }
    x[++n] = 1;
    arc.most = 0;
    panels = lobe_stretched_cut(x, 0, 2, n);
    for (i = 0; i < panels; i++) {
        stack[panels - 1 - i] = lobe_stretched_outer_panel(s, &arc, x[i], x[i + 1]);
        magnitude += lobe_stretched_magnitude(stack[panels - 1 - i].whole);
    }
    for (i = 0; i < panels; i++)
        stack[i].tolerance = s->relative * magnitude / panels;
    for (top = panels; top > 0;) {
        const lobe_stretched_panel p = stack[--top];
        if (p.error <= p.tolerance || p.halvings == 0) {
            sum += p.whole;
        } else {
            const double m = .5 * (p.a + p.b);
            lobe_stretched_panel left = lobe_stretched_outer_panel(s, &arc, p.a, m);
            lobe_stretched_panel right = lobe_stretched_outer_panel(s, &arc, m, p.b);
            const double doubt = lobe_stretched_doubt(p.whole, left.whole, right.whole, left.error + right.error);
            left.error = lobe_stretched_larger(left.error, doubt);
            right.error = lobe_stretched_larger(right.error, doubt);
            left.tolerance = right.tolerance = .6 * p.tolerance;
            left.halvings = right.halvings = p.halvings - 1;
            stack[top++] = right;
            stack[top++] = left;
        }
    }
    return sum;
}

#endif
