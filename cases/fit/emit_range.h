/* Rigorous ranges of every node of a formula over [0, 1] x [0, 1] as Q30 inputs can reach it. */
#ifndef LOBE_EMIT_RANGE_H
#define LOBE_EMIT_RANGE_H

#include "trace.h"

struct lobe_interval {
    double lo, hi;
};

/* Inputs from lo to hi, in units of 2^-30, both included. */
struct lobe_box {
    int lo[2], hi[2];
};

/* Box number i of a cover of the domain; 0 past the last. Boxes shrink towards 0 with the input itself, since
 * v / (v + k r^2) varies at every scale; no number is left out and none is in two boxes. */
int lobe_box_at(int i, lobe_box *box);

/* Encloses each node over the box, by the narrower of natural and mean-value forms, and as the union over parts x parts
 * smaller boxes. Returns 0, or 1 where a denominator may be 0 or an operation is not known here. */
int lobe_range_box(const lobe_graph *g, const lobe_box *box, int parts, lobe_interval *range);

/* Where a box does not prove what is wanted, its parts may: up to this many each way. */
enum { LOBE_RANGE_PARTS = 16 };

#endif
