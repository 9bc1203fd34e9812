/* lobecheck bench: nanoseconds an evaluation on this machine. Numbers to read, without a verdict. */
#include "bench_table.h"
#include "command.h"
#include "hash.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { POINTS = 1024, REPETITIONS = 41 };
#define REPETITION_NS 100000.0

typedef struct columns {
    lobe_value in[LOBE_MAX_INPUTS][POINTS], out[LOBE_MAX_OUTPUTS][POINTS];
    const lobe_value *in_at[LOBE_MAX_INPUTS];
    lobe_value *out_at[LOBE_MAX_OUTPUTS];
} columns;

typedef struct timing {
    double median, min, max;
} timing;

static double now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

static void scalar_pass(const lobe_entry *e, columns *c)
{
    int i, k;
    for (i = 0; i < POINTS; i++) {
        lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
        for (k = 0; k < e->inputs; k++)
            in[k] = c->in[k][i];
        e->call(in, out);
        for (k = 0; k < e->outputs; k++)
            c->out[k][i] = out[k];
    }
}

/* Nanoseconds an evaluation over passes of the points, which stay in the first-level cache. */
static double measure(const lobe_entry *e, columns *c, int array, long passes)
{
    const double start = now_ns();
    long p;
    for (p = 0; p < passes; p++) {
        if (array)
            e->array(c->in_at, c->out_at, POINTS);
        else
            scalar_pass(e, c);
    }
    return (now_ns() - start) / ((double)passes * POINTS);
}

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static timing summarise(double *samples)
{
    timing t;
    qsort(samples, REPETITIONS, sizeof *samples, by_value);
    t.median = samples[REPETITIONS / 2];
    t.min = samples[0];
    t.max = samples[REPETITIONS - 1];
    return t;
}

/* The three measurements alternate, so that a slow moment of the machine falls on all of them. */
static void bench_entry(const lobe_entry *e, columns *c)
{
    const lobe_entry *entries[3];
    double samples[3][REPETITIONS];
    timing t[3];
    int i, k, r;
    entries[0] = e;                   /* scalar */
    entries[1] = e->array ? e : NULL; /* array */
    entries[2] = e->format == LOBE_F32 && e->inputs == 2 && e->sums ? &lobe_bench_table64 : NULL;
    for (i = 0; i < POINTS; i++) {
        lobe_value in[LOBE_MAX_INPUTS];
        /* even indices past the special values: inputs on [0, 1] */
        lobe_hash_inputs(e, 256u + 16u * ((uint32_t)i / 14u) + (uint32_t)i % 14u, in);
        for (k = 0; k < e->inputs; k++)
            c->in[k][i] = in[k];
    }
    for (r = 0; r < REPETITIONS; r++) {
        for (k = 0; k < 3; k++) {
            if (entries[k]) {
                const double once = measure(entries[k], c, k > 0, 1);
                samples[k][r] = measure(entries[k], c, k > 0, 1 + (long)(REPETITION_NS / (once * POINTS + 1.0)));
            }
        }
    }
    for (k = 0; k < 3; k++)
        if (entries[k])
            t[k] = summarise(samples[k]);
    printf("%-14s %-9s %-6s %4d %8.3f (%.3f..%.3f)", e->model, e->tier, lobe_format_names[e->format], e->ops,
           t[0].median, t[0].min, t[0].max);
    if (entries[1])
        printf("  %8.3f (%.3f..%.3f) %6.2f", t[1].median, t[1].min, t[1].max, t[0].median / t[1].median);
    else
        printf("  %8s %17s %6s", "-", "", "-");
    if (entries[1] && entries[2])
        printf("  %8.3f (%.3f..%.3f) %6.2f\n", t[2].median, t[2].min, t[2].max, t[2].median / t[1].median);
    else
        printf("  %8s %17s %6s\n", "-", "", "-");
}

int lobe_command_bench(int argc, char **argv)
{
    columns *c;
    size_t i;
    int k;
    if (argc > 1 || (argc == 1 && argv[0][0] == '-')) {
        fprintf(stderr, "lobecheck bench: unexpected '%s'; it takes one model at most\n", argv[argc - 1]);
        return 2;
    }
    if (argc == 1 && lobe_refuse_names(argv[0], NULL, NULL))
        return 2;
    c = calloc(1, sizeof *c);
    if (!c) {
        fprintf(stderr, "lobecheck bench: out of memory\n");
        return 2;
    }
    for (k = 0; k < LOBE_MAX_INPUTS; k++)
        c->in_at[k] = c->in[k];
    for (k = 0; k < LOBE_MAX_OUTPUTS; k++)
        c->out_at[k] = c->out[k];
    printf("# nanoseconds an evaluation, median (least..most) of %d repetitions over %d points in cache\n",
           (int)REPETITIONS, (int)POINTS);
    printf("# gain: scalar / array; ratio: a plain bilinear 64 x 64 table over the array / array, same inputs\n");
    printf("# %-12s %-9s %-6s %4s %8s %17s  %8s %17s %6s  %8s %17s %6s\n", "model", "tier", "format", "ops", "scalar",
           "", "array", "", "gain", "plain64", "", "ratio");
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        if (argc == 0 || lobe_same(e->model, argv[0]))
            bench_entry(e, c);
    }
    free(c);
    return 0;
}
