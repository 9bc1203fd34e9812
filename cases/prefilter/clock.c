#include "clock.h"
#include <stdio.h>
#include <time.h>

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void lobe_prefilter_start(lobe_prefilter_clock *clock) { clock->started = clock->printed = now(); }

void lobe_prefilter_report(lobe_prefilter_clock *clock, size_t done, size_t texels)
{
    const double t = now();
    if (t - clock->printed > 0.5 && t - clock->started > 1) {
        const double rate = (double)done / (t - clock->started);
        fprintf(stderr, "\rprefilter: %zu of %zu texels, %.0f texels/s, %.0f s left ", done, texels, rate,
                (double)(texels - done) / rate);
        fflush(stderr);
        clock->printed = t;
    }
}

void lobe_prefilter_finish(const lobe_prefilter_clock *clock, size_t done, size_t texels)
{
    if (clock->printed > clock->started)
        fprintf(stderr, "\rprefilter: %zu of %zu texels in %.1f s%20s\n", done, texels, now() - clock->started, "");
}
