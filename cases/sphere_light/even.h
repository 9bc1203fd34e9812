/* Energy as the integral over positions that it stands for. In a cell of 200 random positions one of them can carry
 * 99 % of a narrow lobe's light, and sums over them say what happens there; these are 1000 of a Halton sequence, even
 * over the sphere above -sin(half angle), and agree with 4000 within a point but for the narrowest lobes. */
#ifndef LOBE_SPHERE_LIGHT_EVEN_H
#define LOBE_SPHERE_LIGHT_EVEN_H
#include <stdbool.h>
#include "cells.h"

enum { LOBE_SPHERE_EVEN = 1000 }; /* positions a cell */

typedef struct lobe_sphere_even {
    double *columns, *truth; /* of all cells; the truth to 1e-4 */
} lobe_sphere_even;

/* The cells' alphas, half angles and views. false: no memory. Half a minute of one processor, kept in build/truth. */
bool lobe_sphere_even_make(lobe_sphere_even *even, const lobe_sphere_cells *cells, const lobe_sweep_options *options);
void lobe_sphere_even_free(lobe_sphere_even *even);

/* Sum over sum, less 1, of the cell where that is largest in magnitude; call takes columns. */
double lobe_sphere_even_energy(const lobe_sphere_even *even, double (*call)(const double row[5]));

#endif
