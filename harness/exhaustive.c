/* Measures every elementary function of core at every float of its domain, against libm in double.
 *
 * Usage: exhaustive [-j THREADS] [FUNCTION...], all functions if none is named
 * One row a function: name, points, largest error in ulp, the input where it occurs, got, want, stated bound,
 * verdict. The rows do not depend on the number of threads. Progress goes to standard error. Status 1 if a bound
 * does not hold, 2 for a bad command line. */
#include "elementary.h"
#include "../core/q30.h"
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { CHUNKS = 512 };

typedef struct {
    const lobe_elementary *function;
    uint32_t first, last;
    int next; /* chunk to take */
    double start;
    lobe_worst worst[CHUNKS];
    pthread_mutex_t lock;
} job;

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static uint32_t chunk_start(const job *j, int chunk)
{
    return (uint32_t)(j->first + ((uint64_t)j->last + 1 - j->first) * (uint64_t)chunk / CHUNKS);
}

/* q30's reciprocal is specified exactly; its error in units is the distance from that, over all mantissas. */
static void measure_q30(uint32_t first, uint32_t last, lobe_worst *worst)
{
    uint64_t m;
    for (m = first; m <= last; m++) {
        const int32_t got = lobe_q_reciprocal((int32_t)m).mantissa;
        const uint64_t want = (((uint64_t)1 << 60) + m / 2) / m;
        const double error = fabs((double)got - (double)want);
        if (error > worst->ulp) {
            worst->ulp = error;
            worst->input = (uint32_t)m;
        }
        worst->points++;
    }
}

static void *work(void *argument)
{
    job *j = argument;
    for (;;) {
        int chunk;
        uint32_t first, last;
        pthread_mutex_lock(&j->lock);
        chunk = j->next++;
        if (chunk < CHUNKS && chunk % 32 == 31) {
            const double elapsed = seconds() - j->start;
            const double points = (double)(chunk_start(j, chunk) - j->first);
            fprintf(stderr, "\r%-10s %3d %%  %6.1f M/s  %4.0f s left ", j->function ? j->function->name : "q30",
                    100 * chunk / CHUNKS, 1e-6 * points / elapsed, elapsed * (CHUNKS - chunk) / chunk);
        }
        pthread_mutex_unlock(&j->lock);
        if (chunk >= CHUNKS)
            return NULL;
        first = chunk_start(j, chunk);
        last = chunk == CHUNKS - 1 ? j->last : chunk_start(j, chunk + 1) - 1;
        if (j->function)
            lobe_measure(j->function, first, last, 1, &j->worst[chunk]);
        else
            measure_q30(first, last, &j->worst[chunk]);
    }
}

/* One range of bits in parallel, merged in the order of the chunks. */
static int run(const lobe_elementary *function, uint32_t first, uint32_t last, int threads, lobe_worst *worst)
{
    static job j;
    pthread_t id[64];
    int i, started = 0;
    memset(&j, 0, sizeof j);
    j.function = function;
    j.first = first;
    j.last = last;
    j.start = seconds();
    pthread_mutex_init(&j.lock, NULL);
    for (i = 1; i < threads; i++)
        started += pthread_create(&id[started], NULL, work, &j) == 0;
    work(&j);
    for (i = 0; i < started; i++)
        pthread_join(id[i], NULL);
    for (i = 0; i < CHUNKS; i++) {
        if (j.worst[i].ulp > worst->ulp) {
            worst->ulp = j.worst[i].ulp;
            worst->input = j.worst[i].input;
        }
        worst->points += j.worst[i].points;
    }
    return pthread_mutex_destroy(&j.lock);
}

static const char reciprocal_name[] = "q_reciprocal";

/* Whether this function is to be measured: all are, if none is named. */
static int chosen(const char *name, char **names)
{
    char **n;
    for (n = names; *n; n++)
        if (strcmp(*n, name) == 0)
            return 1;
    return *names == NULL;
}

static int known(char **names)
{
    for (; *names; names++) {
        int found = strcmp(*names, reciprocal_name) == 0;
        size_t i;
        for (i = 0; i < LOBE_ELEMENTARIES; i++)
            found += strcmp(*names, lobe_elementaries[i].name) == 0;
        if (!found)
            return 0;
    }
    return 1;
}

int main(int argc, char **argv)
{
    int threads = 2, failed = 0;
    size_t i;
    lobe_worst q30 = {0.0, 1u << 30, 0};
    char date[16];
    const time_t now = time(NULL);
    int names = 1;
    if (argc > 2 && strcmp(argv[1], "-j") == 0) {
        threads = atoi(argv[2]);
        names = 3;
    }
    if (threads < 1 || threads > 64 || !known(argv + names)) {
        fprintf(stderr, "usage: %s [-j THREADS] [FUNCTION...], THREADS in [1, 64]; functions:", argv[0]);
        for (i = 0; i < LOBE_ELEMENTARIES; i++)
            fprintf(stderr, " %s", lobe_elementaries[i].name);
        fprintf(stderr, " %s\n", reciprocal_name);
        return 2;
    }
    strftime(date, sizeof date, "%Y-%m-%d", gmtime(&now));
    printf("# Elementary functions of core/ at every float of their domain, against libm in double.\n");
    printf("# Written by `make exhaustive` on %s.\n", date);
    printf("# function points max_ulp input input_bits got want bound verdict\n");
    for (i = 0; i < LOBE_ELEMENTARIES; i++) {
        const lobe_elementary *f = &lobe_elementaries[i];
        lobe_worst worst = {0.0, f->first, 0};
        float x;
        int good;
        if (!chosen(f->name, argv + names))
            continue;
        run(f, f->first, f->last, threads, &worst);
        if (f->both_signs)
            run(f, f->first | 0x80000000u, f->negative_last, threads, &worst);
        x = lobe_float_of(worst.input);
        good = worst.ulp <= f->bound;
        failed += !good;
        printf("%s %llu %.4f %a 0x%08x %a %a %.2f %s\n", f->name, (unsigned long long)worst.points, worst.ulp,
               (double)x, (unsigned)worst.input, (double)f->got(x), f->want((double)x), f->bound,
               good ? "ok" : "FAILED");
        fflush(stdout);
    }
    if (chosen(reciprocal_name, argv + names)) {
        run(NULL, 1u << 30, 0x7fffffffu, threads, &q30);
        failed += q30.ulp > 0.0;
        printf("# lobe_q_reciprocal against its exact specification, every mantissa; error in units\n");
        printf("%s %llu %.0f - 0x%08x - - 0 %s\n", reciprocal_name, (unsigned long long)q30.points, q30.ulp,
               (unsigned)q30.input, q30.ulp > 0.0 ? "FAILED" : "ok");
    }
    fprintf(stderr, "\n");
    return failed ? 1 : 0;
}
