/* Where each form fails: its error over a grid of alpha, half angle and view that goes past the stated domain on every
 * side, and the same gathered into the regions where representative points are known to be in trouble. */
#ifndef LOBE_SPHERE_LIGHT_STABILITY_H
#define LOBE_SPHERE_LIGHT_STABILITY_H
#include <stdbool.h>
#include "../../fit/sweep.h"
#include "../candidates.h"

enum { LOBE_STABILITY_ALPHAS = 8, LOBE_STABILITY_SIGMAS = 9, LOBE_STABILITY_VIEWS = 6 };
enum { LOBE_STABILITY_CELLS = LOBE_STABILITY_ALPHAS * LOBE_STABILITY_SIGMAS * LOBE_STABILITY_VIEWS };

typedef enum lobe_stability_region {
    LOBE_STABILITY_GRAZING, /* view >= 75 degrees, alpha <= .1 */
    LOBE_STABILITY_SMALL,   /* sigma / alpha < .5 */
    LOBE_STABILITY_LARGE,   /* sigma / alpha > 2 */
    LOBE_STABILITY_ROUGH,   /* alpha >= .7 */
    LOBE_STABILITY_HORIZON, /* only lights through the horizon */
    LOBE_STABILITY_WIDE,    /* half angle over 60 degrees */
    LOBE_STABILITY_REGIONS
} lobe_stability_region;

extern const char *const lobe_stability_region_name[LOBE_STABILITY_REGIONS];

typedef struct lobe_stability {
    int positions;      /* a cell: half near the mirror direction, half even over what can be lit */
    double *in, *truth; /* rows of roughness, n_dot_v, n_dot_l, azimuth, half angle; to 2e-6 */
} lobe_stability;

/* What a form does in one cell, relative: ||form - truth|| / ||truth||, the sums' difference, and the first over the
 * lights through the horizon alone (negative where the cell has fewer than 8 of them). */
typedef struct lobe_stability_cell {
    double alpha, sigma, view; /* sigma and view in degrees */
    double error, energy, horizon;
} lobe_stability_cell;

/* false: no memory. */
bool lobe_stability_make(lobe_stability *s, int positions, const lobe_sweep_options *options);
void lobe_stability_free(lobe_stability *s);

lobe_stability_cell lobe_stability_judge(const lobe_stability *s, const lobe_sphere_candidate *form, int cell);

/* Over the region's cells in the domain of alpha >= .05 and view <= 85 degrees (of half angles to 45 degrees too, but
 * for WIDE): the root mean square and the largest error. */
typedef struct lobe_stability_sum {
    double rms, worst;
    int cells;
    lobe_stability_cell at; /* the worst */
} lobe_stability_sum;
lobe_stability_sum lobe_stability_over(const lobe_stability *s, const lobe_sphere_candidate *form,
                                       lobe_stability_region region);

#endif
