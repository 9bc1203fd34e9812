/* The rows of the vectors, and those over which bounds are measured. */
#ifndef LOBE_CAPSULE_LIGHT_POINTS_H
#define LOBE_CAPSULE_LIGHT_POINTS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The domain that the tiers state: beside these the middle is at the distance 1, half the segment is no longer than
 * that, its line passes no nearer than 1.5 radii and .2, and the light is not wholly set. */
#define LOBE_CAPSULE_ROUGHNESS_LO 0.22
#define LOBE_CAPSULE_N_DOT_V_LO 0.08
#define LOBE_CAPSULE_RADIUS_HI 0.5

/* The ends of what is measured beyond it: those of the truth; a radius to .9, and a line no nearer than 1.05 radii. */
#define LOBE_CAPSULE_ROUGHNESS_LEAST 0.05
#define LOBE_CAPSULE_N_DOT_V_LEAST 0.001
#define LOBE_CAPSULE_RADIUS_LEAST 0.001

enum { LOBE_CAPSULE_VECTORS = 768, LOBE_CAPSULE_JUDGED = 1 << 15 };

/* A lobe_points_fn: at most LOBE_CAPSULE_VECTORS rows; first corners: grazing views, lights at the mirror direction, in
 * the plane of incidence and across it, upright, nearly end on, through the horizon, thin, and without a length. */
size_t lobe_capsule_points(double domain_lo, int beyond, uint64_t seed, double *points, size_t room);

/* count rows of a Latin hypercube, each second one near the mirror direction. */
void lobe_capsule_judged(bool beyond, double *rows, size_t count);

/* The nearest row of multiples of 2^-24 whose middle has the length 1; false where that is not in the domain (or, if
 * beyond, not beyond it). */
bool lobe_capsule_settle(double row[9], bool beyond);

#endif
