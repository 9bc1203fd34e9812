/* The two kernels as sums over cells, for one direction: one text for C and OpenCL C, in double, with + - * / alone, so
 * that both give the same bits.
 *
 * A cell is LOBE_PREFILTER_ROW numbers: where its radiance lies (unit), its middle (unit), solid angle, energy. The
 * radiance is weighted with the kernel at the first, the solid angle with the kernel at the second; their ratio is the
 * filtered radiance, and a constant map stays constant whatever the cells are. */
#ifndef LOBE_PREFILTER_KERNEL_H
#define LOBE_PREFILTER_KERNEL_H
#include "../../core/dialect.h"

#define LOBE_PREFILTER_ROW 10
/* exp(-40): what is farther down an sg kernel counts as that. */
#define LOBE_PREFILTER_FARTHEST 40.0

/* 1 - cosine, as half the square of the chord: it keeps its digits near the kernel's peak. */
LOBE_FN lobe_real lobe_prefilter_below(lobe_real x, lobe_real y, lobe_real z)
{
    LOBE_LET s = (x * x + y * y + z * z) * LOBE_R(0.5);
    return s;
}

/* max(0, c) / (1 + k s)^2, s = 1 - c */
LOBE_FN lobe_real lobe_prefilter_ggx(lobe_real s, lobe_real k)
{
    LOBE_LET c = LOBE_R(1.0) - s;
    LOBE_LET over = c > LOBE_R(0.0) ? c : LOBE_R(0.0);
    LOBE_LET b = LOBE_R(1.0) + k * s;
    LOBE_LET w = over / (b * b);
    return w;
}

/* exp(-lambda s) as the 64th power of a polynomial: at most 2e-9 off where it is above e^-12, 4e-5 at e^-40. */
LOBE_FN lobe_real lobe_prefilter_sg(lobe_real s, lobe_real lambda)
{
    LOBE_LET x = lambda * s;
    LOBE_LET t = (x < LOBE_R(40.0) ? x : LOBE_R(40.0)) * LOBE_R(0.015625);
    LOBE_LET p5 = LOBE_R(1.0) / LOBE_R(720.0) - t * (LOBE_R(1.0) / LOBE_R(5040.0));
    LOBE_LET p4 = LOBE_R(1.0) / LOBE_R(120.0) - t * p5;
    LOBE_LET p3 = LOBE_R(1.0) / LOBE_R(24.0) - t * p4;
    LOBE_LET p2 = LOBE_R(1.0) / LOBE_R(6.0) - t * p3;
    LOBE_LET p1 = LOBE_R(0.5) - t * p2;
    LOBE_LET p0 = LOBE_R(1.0) - t * p1;
    LOBE_LET y = LOBE_R(1.0) - t * p0;
    LOBE_LET y2 = y * y;
    LOBE_LET y4 = y2 * y2;
    LOBE_LET y8 = y4 * y4;
    LOBE_LET y16 = y8 * y8;
    LOBE_LET y32 = y16 * y16;
    LOBE_LET y64 = y32 * y32;
    return y64;
}

#endif
