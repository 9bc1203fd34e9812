/* The largest and the mean error of what ships over the columns of columns.h: a Latin hypercube and the vectors, and a
 * walk uphill from the worst of them. */
#ifndef LOBE_SPHERE_LIGHT_MEASURE_H
#define LOBE_SPHERE_LIGHT_MEASURE_H
#include "../case.h"
#include "../fit/sweep.h"
#include <stdbool.h>

enum { LOBE_SPHERE_STARTS = 4 };

/* What is measured. */
typedef struct lobe_sphere_quantity {
    lobe_case judged; /* its truth over the columns, fast, under a name of its own */
    lobe_truth_fn truth;
    const lobe_vector_set *vectors;
    double least; /* where the light gives less than this, nothing is measured */
    double gain;  /* a walk goes on while a step gains more than this part */
} lobe_sphere_quantity;

extern const lobe_sphere_quantity lobe_sphere_radiance;

/* One side of the domain's edge: rows, and what is true there. */
typedef struct lobe_sphere_region {
    const lobe_sphere_quantity *quantity;
    double *rows, *truth;
    size_t judged, count; /* of the hypercube; with the vectors */
    bool beyond;
} lobe_sphere_region;

typedef struct lobe_sphere_measured {
    double max, at[5], rms;
} lobe_sphere_measured;

/* false after a line on stderr: no memory. Free it either way. */
bool lobe_sphere_region_make(lobe_sphere_region *r, bool beyond, const lobe_sphere_quantity *quantity,
                             const lobe_sweep_options *options);
void lobe_sphere_region_free(lobe_sphere_region *r);

lobe_sphere_measured lobe_sphere_measure(double (*call)(const double row[5]), const lobe_sphere_region *r);

/* Three significant digits, never less than x. */
double lobe_sphere_rounded_up(double x);

#endif
