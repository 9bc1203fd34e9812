#include "measure.h"
#include <math.h>
#include "columns.h"
#include "points.h"
#include "tiers.h"

const lobe_quantity lobe_sphere_radiance = {.judged = {.name = "sphere_light_judged",
                                                       .input_count = 5,
                                                       .output_count = 1,
                                                       .truth = lobe_truth_sphere_columns_fast},
                                            .truth = lobe_truth_sphere_columns,
                                            .vectors = &lobe_sphere_vectors,
                                            .hypercube = lobe_sphere_judged,
                                            .rows = {LOBE_SPHERE_JUDGED, LOBE_SPHERE_JUDGED / 2},
                                            .step = lobe_sphere_step,
                                            .starts = 4,
                                            .halvings = 12,
                                            .ways = 24};

static const double edge = 3e-8; /* half a unit of the rows, so that an edge rounds into the domain */

bool lobe_sphere_step(const double *row, const double *direction, double step, bool beyond, double *next)
{
    double at[5] = {row[0], row[1], row[2], lobe_sphere_azimuth(row), row[4]};
    int k;
    for (k = 0; k < 5; k++)
        at[k] += step * direction[k];
    at[0] = fmax(at[0], beyond ? LOBE_SPHERE_ROUGHNESS_LEAST : LOBE_SPHERE_ROUGHNESS_LO);
    at[1] = fmax(at[1], beyond ? LOBE_SPHERE_N_DOT_V_LEAST : LOBE_SPHERE_N_DOT_V_LO);
    at[4] = fmin(fmax(at[4], LOBE_SPHERE_SINE_LEAST), beyond ? 1 : LOBE_SPHERE_SINE_HI);
    if (!lobe_sphere_place(next, at[0] + edge, at[1] + edge, at[2], at[3], beyond ? at[4] : at[4] - edge))
        return false;
    return lobe_sphere_inside(next) == !beyond && lobe_sphere_taken(next);
}
