/* A closed form of the split sum, and how its coefficients are found: scale, bias and E together, towards the
 * smallest maximum of the three, from scratch: many starts on a coarse grid, the best few polished on a fine one. */
#ifndef LOBE_FORM_H
#define LOBE_FORM_H
#include <stdbool.h>
#include <stdint.h>
#include "../../models/dfg.h"
#include "../case.h"
#include "../fit/fit_grid.h"

enum { LOBE_FORM_COEFFICIENTS = 96, LOBE_FORM_CHANNELS = 3 };

typedef struct lobe_form {
    const char *name, *kernel;
    /* The kernel in double, with its coefficients as parameters. */
    lobe_dfg (*call)(const double *p, double roughness, double n_dot_v);
    size_t count;
    double lo, ridge;
    int coarse, fine; /* sides of the grids */
    /* Where a fit starts. A straight-line program: `starts` random vectors, each coefficient in [-1.5, 1.5]. Else
     * all zero but the `bends` coefficients of w, from a short list, the first of E, and the constant of U, which is
     * 1. first_of_e has the sign that makes E less than 1: at E = 1 sharp, saturation hides the slope. */
    size_t starts, bends, constant_of_u;
    double first_of_e;
} lobe_form;

/* The errors of scale, bias and E at one point of a grid. */
void lobe_form_errors(const lobe_form *f, const double *c, const lobe_fit_grid *g, size_t row,
                      double errors[LOBE_FORM_CHANNELS]);

/* c: f->count coefficients out, rounded as they are written. False after a line on stderr. */
bool lobe_form_solve(const lobe_form *f, const lobe_fit_grid *coarse, const lobe_fit_grid *fine, uint64_t seed,
                     bool progress, double *c);

#endif
