/* The largest and the mean error of what ships, of a light: over rows of columns, a Latin hypercube and the vectors,
 * and a walk uphill from the worst of them. */
#ifndef LOBE_MEASURE_H
#define LOBE_MEASURE_H
#include "../case.h"
#include "sweep.h"
#include <stdbool.h>

enum { LOBE_MEASURE_STARTS = 4 };

/* From a row by so much along a direction; false: that is no light, or not of this side of the domain's edge. */
typedef bool (*lobe_step_fn)(const double *row, const double *direction, double step, bool beyond, double *next);

/* What is measured. */
typedef struct lobe_quantity {
    lobe_case judged;    /* its truth over the columns, fast, under a name of its own */
    lobe_truth_fn truth; /* of the maximum; NULL: the fast one will do */
    const lobe_vector_set *vectors;
    void (*hypercube)(bool beyond, double *rows, size_t count);
    size_t rows[2]; /* of the hypercube: in the domain, and beyond it */
    lobe_step_fn step;
    int starts, halvings; /* of the walk: from so many rows, at most LOBE_MEASURE_STARTS, until its step is so small */
    int ways;             /* both ways of every axis, and any number of random ones */
    bool still;           /* no walk beyond the domain: there the errors reach 1 as they are */
    double gain;          /* a walk goes on while a step gains more than this part */
    const lobe_case *lit; /* with least: nothing is measured where the light gives less than that */
    double least;
} lobe_quantity;

/* One side of the domain's edge: rows, and what is true there. */
typedef struct lobe_region {
    const lobe_quantity *quantity;
    double *rows, *truth;
    size_t judged, count; /* of the hypercube; with the vectors */
    bool beyond;
} lobe_region;

typedef struct lobe_measured {
    double max, at[LOBE_CASE_COLUMNS], rms;
} lobe_measured;

/* Both sides. false after a line on stderr: no memory. Free them either way. */
bool lobe_regions_make(lobe_region regions[2], const lobe_quantity *quantity, const lobe_sweep_options *options);
void lobe_regions_free(lobe_region regions[2]);

lobe_measured lobe_measure(double (*call)(const double *row), const lobe_region *r);

#endif
