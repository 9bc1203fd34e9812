/* The seed paper's model in two layers. The outer one is a handful of numbers for a (roughness, n_dot_v); the inner one
 * is what a shader samples: lobes of one sharpness, evenly spaced along a fan in the plane of incidence, with weights
 * that are Gaussian in the place along the fan and sum to the albedo.
 *
 * Angles are from the normal, positive away from the view. */
#ifndef LOBE_SG_FAN_H
#define LOBE_SG_FAN_H

enum { LOBE_SG_MOST = 8 };

/* weight times sharpness / (2 pi (1 - exp(-2 sharpness))) exp(sharpness (cosine to the axis - 1)) */
typedef struct lobe_sg {
    double angle, sharpness, weight;
} lobe_sg;

typedef struct lobe_sg_fan {
    double centre, spread; /* the lobes' angles are centre - spread .. centre + spread */
    double sharpness;
    double taper; /* logarithm of the inmost over the outmost weight of an endless number of lobes; may be < 0 */
    double tilt;  /* logarithm by which the far end's weight is above the middle's; 0 in the seed paper */
    double flare; /* logarithm by which the outmost lobes are wider than the middle; 0 in the seed paper */
} lobe_sg_fan;

/* count 1 .. LOBE_SG_MOST lobes in order of their angle; the weights sum to energy. A single one has the centre's
 * angle. */
void lobe_sg_fan_lobes(const lobe_sg_fan *fan, int count, double energy, lobe_sg *lobes);

/* The amplitude formula as it is printed, exp(-(spread / 3) D^2) with D the square of the lobe's number from the
 * middle: quartic in the number, and without a width of its own. A star on the charts. */
void lobe_sg_fan_printed(const lobe_sg_fan *fan, int count, double energy, lobe_sg *lobes);

/* Those weights for lobes that have their places already, evenly spaced. */
void lobe_sg_weigh_printed(lobe_sg *lobes, int count, double energy);

/* Where every fit starts: the mirror direction, the curvature of GGX at its peak, and a fan as wide as alpha. */
lobe_sg_fan lobe_sg_fan_start(double alpha, double n_dot_v);

#endif
