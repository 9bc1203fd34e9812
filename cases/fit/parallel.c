#include "parallel.h"

#include <pthread.h>

typedef struct share {
    const lobe_parallel *p;
    const double *params;
    double *values;
    size_t first, end;
} share;

static void *work(void *arg)
{
    const share *s = arg;
    if (s->end > s->first)
        s->p->f(s->p->ctx, s->params + s->first * s->p->dim, s->end - s->first, s->values + s->first * s->p->width);
    return NULL;
}

void lobe_parallel_eval(void *ctx, const double *params, size_t count, double *values)
{
    const lobe_parallel *p = ctx;
    size_t n = p->threads < LOBE_PARALLEL_MAX ? p->threads : LOBE_PARALLEL_MAX;
    if (n > count)
        n = count;
    if (n <= 1) {
        p->f(p->ctx, params, count, values);
        return;
    }
    pthread_t thread[LOBE_PARALLEL_MAX];
    share shares[LOBE_PARALLEL_MAX];
    bool started[LOBE_PARALLEL_MAX];
    for (size_t i = 0; i < n; i++) {
        const share s = {p, params, values, count * i / n, count * (i + 1) / n};
        shares[i] = s;
    }
    for (size_t i = 1; i < n; i++)
        started[i] = pthread_create(&thread[i], NULL, work, &shares[i]) == 0;
    work(&shares[0]);
    for (size_t i = 1; i < n; i++) {
        if (started[i])
            pthread_join(thread[i], NULL);
        else
            work(&shares[i]);
    }
}
