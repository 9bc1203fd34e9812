#include "response.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

static double root(double alpha, double c) { return sqrt(c * c + alpha * alpha * (1 - c) * (1 + c)); }

double lobe_response(double alpha, double n_dot_v, const double l[3])
{
    const double x = sqrt((1 - n_dot_v) * (1 + n_dot_v)) + l[0], z = n_dot_v + l[2];
    const double across = x * x + l[1] * l[1], a2 = alpha * alpha;
    double t, d;
    if (!(l[2] > 0))
        return 0;
    /* of h = v + l, not normalised: sine^2 + a^2 cosine^2 */
    t = (across + a2 * z * z) / (across + z * z);
    d = a2 / (pi * t * t);
    return d * 0.5 * l[2] / (l[2] * root(alpha, n_dot_v) + n_dot_v * root(alpha, l[2]));
}

double lobe_response_schlick(double alpha, double n_dot_v, const double l[3])
{
    const double along = sqrt((1 - n_dot_v) * (1 + n_dot_v)) * l[0] + n_dot_v * l[2];
    const double x = 1 - sqrt(fmax(0, 0.5 * (1 + along)));
    return lobe_response(alpha, n_dot_v, l) * (x * x) * (x * x) * x;
}

double lobe_response_shadowing(double alpha, double n_dot_v, double n_dot_l)
{
    const double rv = root(alpha, n_dot_v), rl = root(alpha, n_dot_l);
    return n_dot_l * (rv + n_dot_v) / (n_dot_l * rv + n_dot_v * rl);
}
