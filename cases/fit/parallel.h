/* A batch function spread over threads, each of which takes a few entries at a time; an entry is computed exactly as
 * it would be alone, so the bytes are the same for any number of threads. */
#ifndef LOBE_PARALLEL_H
#define LOBE_PARALLEL_H

#include "objective.h"

#define LOBE_PARALLEL_MAX 64

typedef struct lobe_parallel {
    lobe_batch_fn f; /* must be safe to call from several threads */
    void *ctx;
    size_t dim, width; /* parameters in and values out for each entry: width is 1 or the number of rows */
    size_t threads;    /* 1 .. LOBE_PARALLEL_MAX */
} lobe_parallel;

/* A lobe_batch_fn; ctx is a lobe_parallel. Where a thread cannot be started, the caller does its share. */
void lobe_parallel_eval(void *ctx, const double *params, size_t count, double *values);

#endif
