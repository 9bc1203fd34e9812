#include "visible_normals.h"
#include <math.h>
#include "gauss.h"
#include "response.h"

static const double pi = 3.14159265358979323846;

void lobe_visible_normal(double alpha, double n_dot_v, double turn, double height, double h[3])
{
    /* the view where the surface is stretched until alpha is 1 */
    const double x = alpha * sqrt((1 - n_dot_v) * (1 + n_dot_v)), length = sqrt(x * x + n_dot_v * n_dot_v);
    const double vx = x / length, vz = n_dot_v / length;
    const double z = 1 - (1 - height) * (1 + vz), sine = sqrt(fmax(0, (1 - z) * (1 + z)));
    const double hx = alpha * (vx + sine * cos(2 * pi * turn)), hy = alpha * sine * sin(2 * pi * turn),
                 hz = fmax(0, vz + z), n = sqrt(hx * hx + hy * hy + hz * hz);
    h[0] = hx / n;
    h[1] = hy / n;
    h[2] = hz / n;
}

void lobe_visible_light(double alpha, double n_dot_v, double turn, double height, double l[3])
{
    const double vx = sqrt((1 - n_dot_v) * (1 + n_dot_v));
    double h[3], along;
    lobe_visible_normal(alpha, n_dot_v, turn, height, h);
    along = 2 * (vx * h[0] + n_dot_v * h[2]);
    l[0] = along * h[0] - vx;
    l[1] = along * h[1];
    l[2] = along * h[2] - n_dot_v;
}

double lobe_visible_light_density(double alpha, double n_dot_v, const double l[3])
{
    const double vx = sqrt((1 - n_dot_v) * (1 + n_dot_v)), x = vx + l[0], z = n_dot_v + l[2];
    const double across = x * x + l[1] * l[1], all = across + z * z, a2 = alpha * alpha;
    const double t = (across + a2 * z * z) / all, rv = sqrt(n_dot_v * n_dot_v + a2 * (1 - n_dot_v) * (1 + n_dot_v));
    if (!(z > 0))
        return 0; /* no normal below the horizon */
    return a2 / (pi * t * t) * 0.5 / (n_dot_v + rv);
}

int lobe_visible_nodes(double alpha, double n_dot_v, int order, double *rows)
{
    double height[LOBE_GAUSS_MOST], weight[LOBE_GAUSS_MOST];
    int i, j, count = 0;
    lobe_gauss(order, height, weight);
    for (i = 0; i < order; i++)
        for (j = 0; j < order; j++) {
            /* cubed: many nodes for the tail, whose light is far from the view of the others */
            const double x = height[i], part = 3 * x * x * weight[i] / order;
            double *row = rows + 5 * count;
            lobe_visible_light(alpha, n_dot_v, 0.5 * (j + 0.5) / order, x * x * x, row);
            if (row[2] > 0) {
                row[3] = part * lobe_response_shadowing(alpha, n_dot_v, row[2]);
                row[4] = 0.5 * part / lobe_visible_light_density(alpha, n_dot_v, row);
                count++;
            }
        }
    return count;
}
