#include "sweep.h"
#include <pthread.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

#define BLOCK 16 /* rows a thread takes at a time: short enough that all end together */

typedef struct sweep {
    lobe_sweep_fn f;
    const double *in;
    double *out;
    size_t in_columns, out_columns, n;
    size_t next; /* first row that no thread has taken; touched atomically */
    size_t done;
    const lobe_sweep_options *options;
    double started, printed;
} sweep;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

lobe_sweep_options lobe_sweep_options_default(void)
{
    lobe_sweep_options options = {1, 0, "truth"};
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    if (processors > 1)
        options.threads = processors < LOBE_SWEEP_THREADS ? (int)processors : LOBE_SWEEP_THREADS;
    options.progress = isatty(STDERR_FILENO);
    return options;
}

static void report(sweep *s, size_t done)
{
    const double t = now();
    if (t - s->printed > 0.5 && t - s->started > 1.0) {
        const double rate = (double)done / (t - s->started);
        fprintf(stderr, "\r%s: %zu of %zu rows, %.0f rows/s, %.0f s left ", s->options->label, done, s->n, rate,
                (double)(s->n - done) / rate);
        s->printed = t;
    }
}

/* Takes blocks until none is left; `talks` is set for the one thread that reports. */
static void work(sweep *s, int talks)
{
    for (;;) {
        const size_t first = __atomic_fetch_add(&s->next, BLOCK, __ATOMIC_RELAXED);
        size_t count, done;
        if (first >= s->n)
            return;
        count = s->n - first < BLOCK ? s->n - first : BLOCK;
        s->f(s->in + first * s->in_columns, s->out + first * s->out_columns, count);
        done = __atomic_add_fetch(&s->done, count, __ATOMIC_RELAXED);
        if (talks)
            report(s, done);
    }
}

static void *helper(void *arg)
{
    work(arg, 0);
    return NULL;
}

void lobe_sweep(lobe_sweep_fn f, const double *in, int in_columns, double *out, int out_columns, size_t n,
                const lobe_sweep_options *options)
{
    sweep s = {f, in, out, (size_t)in_columns, (size_t)out_columns, n, 0, 0, options, 0, 0};
    pthread_t threads[LOBE_SWEEP_THREADS];
    int wanted = options->threads < LOBE_SWEEP_THREADS ? options->threads : LOBE_SWEEP_THREADS;
    int started = 0, i;
    s.started = s.printed = now();
    /* A thread that cannot be started is no error: this one takes what is left. */
    while (started + 1 < wanted && (size_t)(started + 1) * BLOCK < n &&
           pthread_create(&threads[started], NULL, helper, &s) == 0)
        started++;
    work(&s, options->progress);
    for (i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
    if (s.printed > s.started)
        fprintf(stderr, "\r%s: %zu rows in %.1f s%40s\n", options->label, n, now() - s.started, "");
}
