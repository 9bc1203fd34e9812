/* A function of rows, evaluated over many rows by several threads. No row depends on another, so the results have the
 * same bytes for any number of threads. */
#ifndef LOBE_SWEEP_H
#define LOBE_SWEEP_H
#include <stddef.h>

#define LOBE_SWEEP_THREADS 64

typedef void (*lobe_sweep_fn)(const double *in, double *out, size_t n);

typedef struct lobe_sweep_options {
    int threads;       /* 1 .. LOBE_SWEEP_THREADS */
    int progress;      /* nonzero: a line with rate and estimate on stderr, once a sweep lasts longer than a second */
    const char *label; /* what the line says is being done */
} lobe_sweep_options;

/* All processors; progress if stderr is a terminal. */
lobe_sweep_options lobe_sweep_options_default(void);

void lobe_sweep(lobe_sweep_fn f, const double *in, int in_columns, double *out, int out_columns, size_t n,
                const lobe_sweep_options *options);

#endif
