/* The line on stderr that says how far the filter is, how fast it goes and when it may end. */
#ifndef LOBE_PREFILTER_CLOCK_H
#define LOBE_PREFILTER_CLOCK_H
#include <stddef.h>

typedef struct lobe_prefilter_clock {
    double started, printed;
} lobe_prefilter_clock;

void lobe_prefilter_start(lobe_prefilter_clock *clock);
/* Prints at most twice a second, and nothing in the first one. */
void lobe_prefilter_report(lobe_prefilter_clock *clock, size_t done, size_t texels);
/* Ends the line, if one stands. */
void lobe_prefilter_finish(const lobe_prefilter_clock *clock, size_t done, size_t texels);

#endif
