#include "progress.h"
#include "interrupt.h"

#include <string.h>
#include <time.h>

lobe_progress_line lobe_progress_line_default(void)
{
    lobe_progress_line line = {NULL, 0.5, -1.0, -1.0, NULL, false};
    return line;
}

static double now_s(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

bool lobe_progress_print(void *ctx, const lobe_progress *progress)
{
    lobe_progress_line *line = ctx;
    if (line->out) {
        const double now = now_s();
        if (!line->stage || strcmp(line->stage, progress->stage) != 0) {
            line->stage = progress->stage;
            line->started_s = now;
            line->printed_s = now; /* a stage shorter than the interval prints nothing */
        } else if (now - line->printed_s >= line->interval_s) {
            const double spent = now - line->started_s, rate = (double)progress->evaluations / spent;
            const double left = progress->budget > progress->evaluations && rate > 0.0
                                    ? (double)(progress->budget - progress->evaluations) / rate
                                    : 0.0;
            fprintf(line->out, "\r%s: %zu of at most %zu evaluations, %.0f/s, at most %.0f s left, best %.6g   ",
                    progress->stage, progress->evaluations, progress->budget, rate, left, progress->best);
            fflush(line->out);
            line->printed_s = now;
            line->dirty = true;
        }
    }
    return !lobe_interrupt_requested();
}

void lobe_progress_finish(lobe_progress_line *line)
{
    if (line->out && line->dirty)
        fputc('\n', line->out);
    line->dirty = false;
}
