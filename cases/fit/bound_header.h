/* Headers of bounds, models/coeffs/MODEL_bounds.h: a macro a figure, rounded up. */
#ifndef LOBE_BOUND_HEADER_H
#define LOBE_BOUND_HEADER_H
#include <stdio.h>

/* Three significant digits, never less than x. */
double lobe_rounded_up(double x);

/* #define LOBE_MODEL_TIER_FORMAT_SUFFIX x, three digits; format NULL: of all formats. */
void lobe_put_bound(FILE *f, const char *model, const char *tier, const char *format, const char *suffix, double x);

#endif
