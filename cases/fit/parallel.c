#include "parallel.h"

#include <pthread.h>

/* What is left to do. Entries are taken a few at a time, so that a thread with slow ones keeps nobody waiting. */
typedef struct queue {
    const lobe_parallel *p;
    const double *params;
    double *values;
    size_t count, each, next;
    pthread_mutex_t lock;
} queue;

enum { TURNS = 8 }; /* of each thread, about */

static void *work(void *arg)
{
    queue *q = arg;
    for (;;) {
        size_t first, end;
        pthread_mutex_lock(&q->lock);
        first = q->next;
        end = q->count - first > q->each ? first + q->each : q->count;
        q->next = end;
        pthread_mutex_unlock(&q->lock);
        if (first == end)
            return NULL;
        q->p->f(q->p->ctx, q->params + first * q->p->dim, end - first, q->values + first * q->p->width);
    }
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
    bool started[LOBE_PARALLEL_MAX];
    queue q = {p, params, values, count, count / (TURNS * n) + 1, 0, PTHREAD_MUTEX_INITIALIZER};
    for (size_t i = 1; i < n; i++)
        started[i] = pthread_create(&thread[i], NULL, work, &q) == 0;
    work(&q);
    for (size_t i = 1; i < n; i++) {
        if (started[i])
            pthread_join(thread[i], NULL);
    }
    pthread_mutex_destroy(&q.lock);
}
