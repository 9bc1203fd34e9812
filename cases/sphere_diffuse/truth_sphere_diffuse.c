/* The closed form, and the quadrature that it is held to. */
#include "truth_sphere_diffuse.h"
#include <math.h>
#include "../sphere_light/quadrature.h"

static const double pi = 3.14159265358979323846;

/* t - sin t cos t for t in [0, pi / 2]: by its series where that difference would lose digits. */
static double segment(double t)
{
    double term = 4 * t * t * t / 6, sum = 0;
    int k;
    if (t > 0.5)
        return t - sin(t) * cos(t);
    for (k = 2; k < 30; k++) { /* (2 t - sin 2 t) / 2 */
        sum += term;
        term *= -4 * t * t / ((2 * k) * (2 * k + 1));
    }
    return sum;
}

/* The part of the light that is up is a spherical cap without a lune. With C = cos sigma, q the half chord that the
 * horizon cuts off the light and A its angle as seen from the origin, E = c s^2 acos(-c C / (s sqrt(1 - c^2))) + A - q
 * C; the arc cosine is pi/2 + atan(c C / q), and q = sqrt(1 - c^2) sin A, C = sqrt(1 - c^2) cos A. */
double lobe_truth_sphere_diffuse(double c, double s)
{
    const double big = sqrt((1 - s) * (1 + s));
    double q, a;
    if (!(s > 0) || c <= -s)
        return 0;
    if (c >= s)
        return c * s * s;
    q = sqrt((s - c) * (s + c));
    a = atan2(q, big);
    return fmax(0, c * s * s * (0.5 + atan2(c * big, q) / pi) + (segment(a) + c * c * sin(a) * cos(a)) / pi);
}

void lobe_truth_sphere_diffuse_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++)
        out[i] = lobe_truth_sphere_diffuse(in[2 * i], in[2 * i + 1]);
}

/* Directions by their elevation: at the elevation e the light holds azimuths up to w, (light).(direction) = C there.
 * With u = e - elevation of the centre, C - cos u = versine(u) - versine(sigma) does not cancel for a small light. */
typedef struct heights {
    double centre, sigma, cos_centre, middle, half;
} heights;

static double versine(double x)
{
    const double s = sin(x / 2);
    return 2 * s * s;
}

/* sin e cos e times twice the half azimuth. t in [-pi / 2, pi / 2], e = middle + half sin t: square roots at the ends
 * become smooth. */
static double at_height(double t, void *context)
{
    const heights *h = context;
    const double e = h->middle + h->half * sin(t), across = h->cos_centre * cos(e);
    /* cos w = (C - sin c sin e) / (cos c cos e), so versine(w) = (versine(sigma) - versine(u)) / (cos c cos e) */
    const double room = versine(h->sigma) - versine(e - h->centre);
    const double w = room <= 0 ? 0 : room >= 2 * across ? pi : 2 * asin(sqrt(room / (2 * across)));
    return sin(e) * cos(e) * 2 * w * h->half * cos(t);
}

double lobe_truth_sphere_diffuse_heights(double c, double s, double tolerance)
{
    heights h;
    double lo, hi, pole, breaks[2];
    h.centre = asin(c);
    h.sigma = asin(s);
    h.cos_centre = cos(h.centre);
    lo = fmax(0, h.centre - h.sigma);
    hi = fmin(pi / 2, h.centre + h.sigma);
    if (!(hi > lo))
        return 0;
    h.middle = (lo + hi) / 2;
    h.half = (hi - lo) / 2;
    /* Where the light holds the pole, all azimuths are in from here up. */
    pole = pi - h.centre - h.sigma;
    breaks[0] = fabs(pole - h.middle) < h.half ? asin((pole - h.middle) / h.half) : 0;
    breaks[1] = 0;
    return lobe_quadrature(at_height, &h, -pi / 2, pi / 2, breaks, 2, 0, tolerance * pi * s * s) / pi;
}
