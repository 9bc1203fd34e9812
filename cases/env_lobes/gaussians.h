/* The tiers of env_lobes_sg as lobe_judge_models, so that both kernels stand in one table. */
#ifndef LOBE_ENV_GAUSSIANS_H
#define LOBE_ENV_GAUSSIANS_H
#include "judge.h"

enum { LOBE_GAUSSIANS = 4 };
extern const lobe_judge_model lobe_gaussian[LOBE_GAUSSIANS];

/* A lobe of weight 1 as nodes, order^2 rows as of lobe_visible_nodes. */
int lobe_gaussian_nodes(double angle, double sharpness, int order, double *rows);

#endif
