/* The figures that the floors of a sphere light are about: any function of the columns (columns.h) on the held-out
 * cells of both sets of positions. Bounds, tests and README quote these. */
#ifndef LOBE_SPHERE_LIGHT_HELD_H
#define LOBE_SPHERE_LIGHT_HELD_H
#include <stdbool.h>
#include "cells.h"
#include "even.h"

typedef struct lobe_sphere_figures {
    double all, view60, view75, worst, energy; /* as in lobe_sphere_score */
    double excess;                             /* over the punctual light, lobe_sphere_excess */
    double integral;                           /* energy over even positions, lobe_sphere_even_energy */
} lobe_sphere_figures;

typedef struct lobe_sphere_held {
    bool ready;
    lobe_sphere_cells cells[2]; /* uniform, mixed */
    double *columns[2];         /* the cells' rows as columns, not rounded */
    lobe_sphere_even even;
} lobe_sphere_held;

/* false after a line on stderr: no memory. Free it either way. */
bool lobe_sphere_held_make(lobe_sphere_held *held, const lobe_sweep_options *options);
void lobe_sphere_held_free(lobe_sphere_held *held);

/* Uniform, mixed. */
void lobe_sphere_held_judge(const lobe_sphere_held *held, double (*call)(const double row[5]),
                            lobe_sphere_figures figures[2]);

/* The larger of each. */
lobe_sphere_figures lobe_sphere_figures_worse(const lobe_sphere_figures *a, const lobe_sphere_figures *b);

#endif
