/* Adaptive Gauss-Kronrod quadrature (7 and 15 nodes) with break points. */
#ifndef LOBE_SPHERE_LIGHT_QUADRATURE_H
#define LOBE_SPHERE_LIGHT_QUADRATURE_H

typedef double lobe_quadrature_fn(double x, void *context);

enum { LOBE_QUADRATURE_BREAKS = 16 };

/* The integral over [lo, hi]; 0 where that is empty. The breaks (at most LOBE_QUADRATURE_BREAKS, in any order, also
 * outside) are sorted in place. The estimated error is at most the larger of relative times the first estimate of the
 * integral's magnitude, and absolute. */
double lobe_quadrature(lobe_quadrature_fn *f, void *context, double lo, double hi, double *breaks, int count,
                       double relative, double absolute);

#endif
