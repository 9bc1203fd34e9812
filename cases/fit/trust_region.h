/* The step that minimises a linear least-squares problem inside |scale * step| <= radius. */
#ifndef LOBE_TRUST_REGION_H
#define LOBE_TRUST_REGION_H

#include "triangle.h"

/* Doubles of scratch that lobe_trust_step needs. */
size_t lobe_trust_scratch(size_t dim);
/* damping: a first guess in (0: none), the one used out. Within a tenth of the radius, as in MINPACK's lmpar. */
void lobe_trust_step(const lobe_triangle *t, const double *scale, double radius, double *damping, double *scratch,
                     double *step);

#endif
