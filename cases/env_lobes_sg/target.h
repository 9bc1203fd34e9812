/* The response at one (alpha, n_dot_v) as something to approximate: nodes that follow it wherever it is, so that a
 * quadrature of thousands of them resolves a mirror as well as a matt surface; and the distance of lobes from it. */
#ifndef LOBE_SG_TARGET_H
#define LOBE_SG_TARGET_H
#include <stdbool.h>
#include <stddef.h>
#include "fan.h"

typedef struct lobe_sg_target {
    double alpha, n_dot_v;
    size_t count;
    double *nodes;        /* rows of x y z weight: sum weight f = integral of response f, for f even in y */
    double albedo, power; /* integrals of the response and of its square */
} lobe_sg_target;

/* order^2 / 2 nodes; order is even, at most 2048. false: no memory. Free it either way. */
bool lobe_sg_target_make(lobe_sg_target *t, double alpha, double n_dot_v, int order);
void lobe_sg_target_free(lobe_sg_target *t);

double lobe_sg_at(const lobe_sg *lobe, const double l[3]);
/* The integral over the sphere of the product of two lobes in the plane of incidence. */
double lobe_sg_product(const lobe_sg *a, const lobe_sg *b);
/* The integral of response times lobe. */
double lobe_sg_target_product(const lobe_sg_target *t, const lobe_sg *lobe);

/* Relative L2 distance over the whole sphere: what spills below the horizon counts. */
double lobe_sg_target_error(const lobe_sg_target *t, const lobe_sg *lobes, int count);

/* The factor on all weights that makes that distance smallest, and with it the distance: amplitude left free. */
double lobe_sg_target_amplitude(const lobe_sg_target *t, const lobe_sg *lobes, int count, double *error);

#endif
