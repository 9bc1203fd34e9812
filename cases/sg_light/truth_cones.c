/* Over sphere lights: exp(-s u) = int over e > u of s exp(-s e) de, u = 1 - l.axis in [0, 2], and {u < e} is a cone of
 * versine e. What is left past e = 2 is the whole sphere. */
#include <math.h>
#include "../sphere_light/quadrature.h"
#include "../sphere_light/truth_sphere.h"
#include "truth_sg.h"

typedef struct cones {
    const lobe_sg_scene *scene;
    double tolerance;
} cones;

static double of_versine(const cones *c, double versine)
{
    const double sigma = fmin(2 * asin(sqrt(.5 * versine)), 3.14159265358979);
    const lobe_sphere_scene s = {c->scene->alpha, c->scene->v_z, c->scene->l_z, c->scene->azimuth, sigma, 1};
    return lobe_truth_sphere_cone(&s, c->tolerance);
}

/* x = 1 - exp(-s e): the weight is even in x. */
static double at(double x, void *context)
{
    const cones *c = context;
    return of_versine(c, fmin(2, -log1p(-x) / c->scene->sharpness));
}

double lobe_truth_sg_cones(const lobe_sg_scene *s, double tolerance)
{
    cones c = {s, .1 * tolerance};
    const double end = -expm1(-2 * s->sharpness);
    double breaks[3] = {.9 * end, .99 * end, .999 * end};
    if (s->l_z < 0) /* the versine at which the light rises */
        breaks[0] = -expm1(-s->sharpness * (1 - sqrt(1 - s->l_z * s->l_z)));
    return lobe_quadrature(at, &c, 0, end, breaks, 3, tolerance, 0) + (1 - end) * of_versine(&c, 2);
}
