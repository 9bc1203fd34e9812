/* The figures that the floors of a spherical Gaussian light are about: any function of the columns (columns.h) on the
 * held-out cells of both sets of positions. Bounds, tests and README quote these. */
#ifndef LOBE_SG_LIGHT_HELD_H
#define LOBE_SG_LIGHT_HELD_H
#include <stdbool.h>
#include "judge.h"

typedef struct lobe_sg_figures {
    double all, smooth, worst, energy; /* as in lobe_sg_score */
} lobe_sg_figures;

typedef struct lobe_sg_held {
    bool ready;
    lobe_sg_cells cells[2]; /* uniform, mixed */
    double *columns[2];     /* the cells' rows as columns, not rounded */
} lobe_sg_held;

/* false after a line on stderr: no memory. Free it either way. */
bool lobe_sg_held_make(lobe_sg_held *held, const lobe_sweep_options *options);
void lobe_sg_held_free(lobe_sg_held *held);

/* Uniform, mixed. */
void lobe_sg_held_judge(const lobe_sg_held *held, double (*call)(const double row[5]), lobe_sg_figures figures[2]);

/* The larger of each. */
lobe_sg_figures lobe_sg_figures_worse(const lobe_sg_figures *a, const lobe_sg_figures *b);

#endif
