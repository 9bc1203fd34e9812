/* Grids of points under a set of environments: what the fit trains on, and what the floors are judged by. */
#ifndef LOBE_SG_SCENES_H
#define LOBE_SG_SCENES_H
#include "../fit/sweep.h"
#include "radiance.h"

typedef struct lobe_sg_scenes {
    size_t count;
    lobe_sg_scene *scene;
} lobe_sg_scenes;

enum { LOBE_SG_FIT_POINTS = 81, LOBE_SG_FLOOR_POINTS = 30 };

/* alpha .04 to 1 and n_dot_v .05 to 1: 9 x 9 for the fit, 5 x 6 for the floors, with so many nodes that
 * the sum over pairs of them has converged for a single bright texel too.
 * shape as in lobe_sg_scene_make. false: no memory. Free it either way. */
bool lobe_sg_scenes_make(lobe_sg_scenes *s, bool floors, const lobe_env_spectrum *spectra, int lights, double shape,
                         int threads);
void lobe_sg_scenes_free(lobe_sg_scenes *s);

/* Any model of the response at a point: writes lobes, returns how many; 0 stands for the split sum itself, the ordinary
 * prefilter in the mirror direction. */
typedef int (*lobe_sg_model)(const void *ctx, double alpha, double n_dot_v, double energy, lobe_sg *lobes);
int lobe_sg_split_sum(const void *ctx, double alpha, double n_dot_v, double energy, lobe_sg *lobes);

/* Root mean square over points and environments of the relative error of radiance. by_light[lights] and shape (rms
 * relative L2 of the lobe, not of the split sum) may be NULL. Negative where there is no memory. */
double lobe_sg_scenes_error(const lobe_sg_scenes *s, const lobe_env_spectrum *spectra, int lights, lobe_sg_model model,
                            const void *ctx, double *by_light, double *shape);

#endif
