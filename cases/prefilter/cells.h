/* The cells that a group of neighbouring directions is filtered with. */
#ifndef LOBE_PREFILTER_CELLS_H
#define LOBE_PREFILTER_CELLS_H
#include "source.h"
#include "width.h"

/* Cell size over the kernel's own scale at the cell, where it is accepted. README.md measures what it costs. */
#define LOBE_PREFILTER_DETAIL 0.15

typedef struct lobe_prefilter_cells {
    double *rows; /* count x LOBE_PREFILTER_ROW */
    size_t count, room;
} lobe_prefilter_cells;

typedef struct lobe_prefilter_group {
    lobe_prefilter_kernel kernel;
    double parameter, detail;
    double middle[3], radius; /* of the directions; a chord */
} lobe_prefilter_group;

/* The kernel's scale at its peak, at most 1. */
double lobe_prefilter_peak(lobe_prefilter_kernel kernel, double parameter);
/* Replaces what is in cells. 0 where there is no memory. */
int lobe_prefilter_gather(const lobe_prefilter_source *source, const lobe_prefilter_group *group,
                          lobe_prefilter_cells *cells);
void lobe_prefilter_cells_free(lobe_prefilter_cells *cells);

#endif
