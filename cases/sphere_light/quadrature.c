#include "quadrature.h"
#include <math.h>

enum { HALVINGS = 18 };

static const double node[8] = {.991455371120812639206854697526329, .949107912342758524526189684047851,
                               .864864423359769072789712788640926, .741531185599394439863864773280788,
                               .586087235467691130294144691693013, .405845151377397166906606412076961,
                               .207784955007898467600689403773245, 0};
static const double kronrod[8] = {.022935322010529224963732008058970, .063092092629978553290700663189204,
                                  .104790010322250183839876322541518, .140653259715525918745189590510238,
                                  .169004726639267902826583426598550, .190350578064785409913256402421014,
                                  .204432940075298892414161999234649, .209482141084727828012999174891714};
static const double gauss[4] = {.129484966168869693270611432679082, .279705391489276667901467771423780,
                                .381830050505118944950369775488975, .417959183673469387755102040816327};

static double panel(lobe_quadrature_fn *f, void *context, double a, double b, double *error)
{
    const double c = .5 * (a + b), h = .5 * (b - a), middle = f(c, context);
    double k = middle * kronrod[7], g = middle * gauss[3];
    int i;
    for (i = 0; i < 7; i++) {
        const double s = f(c - h * node[i], context) + f(c + h * node[i], context);
        k += kronrod[i] * s;
        if (i & 1)
            g += gauss[i / 2] * s;
    }
    *error = fabs(k - g) * h;
    return k * h;
}

static double adapt(lobe_quadrature_fn *f, void *context, double a, double b, double whole, double error,
                    double tolerance, int halvings)
{
    const double m = .5 * (a + b);
    double left, right, error_left, error_right, off;
    if (error <= tolerance || halvings == 0)
        return whole;
    left = panel(f, context, a, m, &error_left);
    right = panel(f, context, m, b, &error_right);
    off = fabs(whole - left - right);
    /* the two rules can agree by chance, which was once an error of 4e-4; the halves then give it away */
    if (off > error_left + error_right) {
        error_left = fmax(error_left, .5 * off);
        error_right = fmax(error_right, .5 * off);
    }
    return adapt(f, context, a, m, left, error_left, .6 * tolerance, halvings - 1) +
           adapt(f, context, m, b, right, error_right, .6 * tolerance, halvings - 1);
}

static void sort(double *x, int n)
{
    int i, j;
    for (i = 1; i < n; i++) {
        for (j = i; j > 0 && x[j] < x[j - 1]; j--) {
            const double t = x[j];
            x[j] = x[j - 1];
            x[j - 1] = t;
        }
    }
}

double lobe_quadrature(lobe_quadrature_fn *f, void *context, double lo, double hi, double *breaks, int count,
                       double relative, double absolute)
{
    double part[LOBE_QUADRATURE_BREAKS + 1], error[LOBE_QUADRATURE_BREAKS + 1], x[LOBE_QUADRATURE_BREAKS + 2];
    double magnitude = 0, sum = 0, tolerance;
    int i, panels = 0;
    if (!(hi > lo))
        return 0;
    sort(breaks, count);
    x[0] = lo;
    for (i = 0; i < count; i++) {
        if (breaks[i] > x[panels] + 1e-12 * (hi - lo) && breaks[i] < hi - 1e-12 * (hi - lo))
            x[++panels] = breaks[i];
    }
    x[++panels] = hi;
    for (i = 0; i < panels; i++) {
        part[i] = panel(f, context, x[i], x[i + 1], &error[i]);
        magnitude += fabs(part[i]);
    }
    tolerance = fmax(relative * magnitude, absolute) / panels;
    for (i = 0; i < panels; i++)
        sum += adapt(f, context, x[i], x[i + 1], part[i], error[i], tolerance, HALVINGS);
    return sum;
}
