/* Differential evolution over every tenth position finds a basin, Levenberg-Marquardt over all of them its bottom; the
 * lowest of a few such searches is taken, since the kernels' maxima make small basins of their own. */
#ifndef LOBE_SPHERE_LIGHT_SOLVE_H
#define LOBE_SPHERE_LIGHT_SOLVE_H
#include <stddef.h>
#include <stdint.h>
#include "../fit/fit_command.h"
#include "../fit/objective.h"

enum { LOBE_SPHERE_THINNED = 10, LOBE_SPHERE_SOLVED_MOST = 20 };

typedef struct lobe_sphere_task {
    const char *name; /* of the tier, for messages */
    size_t count;
    const double (*box)[2];
    size_t searches, generations;
    uint64_t seed;
    lobe_batch_fn sum, residuals;
    void *thinned, *whole; /* their contexts: every LOBE_SPHERE_THINNED-th position; all of them */
    size_t rows;           /* of the residuals */
} lobe_sphere_task;

/* Rounded as they will be written. false after a line on stderr. */
bool lobe_sphere_solve(const lobe_sphere_task *task, const lobe_fit_request *request, double *c);

#endif
