/* One line on a stream that says how far a fit is, how fast it goes and when it may end.
 *
 *     lobe_progress_line line = lobe_progress_line_default();
 *     line.out = stderr;
 *     options.progress = lobe_progress_print;
 *     options.progress_ctx = &line;
 *
 * The same callback stops a fit on Ctrl-C once lobe_interrupt_install was called; with out = NULL it does only
 * that. It never touches the numbers of a fit. */
#ifndef LOBE_PROGRESS_H
#define LOBE_PROGRESS_H

#include "objective.h"
#include <stdio.h>

typedef struct lobe_progress_line {
    FILE *out;         /* NULL: silent */
    double interval_s; /* at least this long between two lines */
    double started_s, printed_s;
    const char *stage; /* of the line before: rate and estimate start afresh with a stage */
    bool dirty;        /* a line stands without its newline */
} lobe_progress_line;

lobe_progress_line lobe_progress_line_default(void); /* out NULL, 0.5 s */
/* A lobe_progress_fn; ctx is a lobe_progress_line. */
bool lobe_progress_print(void *ctx, const lobe_progress *progress);
/* Ends the line, if one stands. */
void lobe_progress_finish(lobe_progress_line *line);

#endif
