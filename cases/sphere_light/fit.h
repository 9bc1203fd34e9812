/* lobefit fit sphere_light: the constants of every tier, from scratch. */
#ifndef LOBE_SPHERE_LIGHT_FIT_H
#define LOBE_SPHERE_LIGHT_FIT_H
#include "../case.h"
#include "../fit/fit_command.h"
#include "fit_tiers.h"
#include "judge.h"

/* A lobe_command_fn. */
int lobe_sphere_fit(const lobe_case *self, int argc, char **argv);

/* The rest is what tiers share. */

/* The truth of both sets of fit cells; false after a line on stderr, and free them either way. */
bool lobe_sphere_fit_cells(lobe_sphere_cells cells[2], const lobe_fit_request *request);

/* The constants of a tier of fit_tiers.h, as they are written; false after a line on stderr. */
bool lobe_sphere_tier_solve(const lobe_sphere_tier *tier, const lobe_sphere_cells cells[2],
                            const lobe_fit_request *request, double *c);

/* Scores of uniform and mixed positions for a generated header; returns the length. */
int lobe_sphere_score_text(const lobe_sphere_score score[2], char *text, size_t size);

typedef struct lobe_sphere_fitted {
    const char *tier, *kernel, *source;
    const char *tiers; /* the header that says what was made small */
    uint64_t seed;
    const double *values;
    size_t count;
    char error[600];
} lobe_sphere_fitted;

/* The generated header; false after a line on stderr. */
bool lobe_sphere_fitted_write(const lobe_case *self, const lobe_fit_request *request, const lobe_sphere_fitted *fitted);

#endif
