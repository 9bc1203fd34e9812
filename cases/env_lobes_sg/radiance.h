/* What lobes lose in radiance, over every orientation of an environment at once. The mean square over orientations is a
 * norm of the difference of two lobes that weighs each band l of spherical harmonics with the environment's power
 * (cases/env_lobes/spectrum.h). Summed over bands it is one function of the angle between two directions, an SG damps
 * it by its own bands, and what is left is a sum over the target's nodes: no noise, and smooth in every parameter. */
#ifndef LOBE_SG_RADIANCE_H
#define LOBE_SG_RADIANCE_H
#include "../env_lobes/spectrum.h"
#include "target.h"

enum { LOBE_SG_LIGHTS = 16 };

/* A target under several environments, each weighed by the mean square radiance that the target shows of it. */
typedef struct lobe_sg_scene {
    lobe_sg_target target;
    double power[LOBE_ENV_BANDS]; /* of the mean environment; the target's own mean square under it is 1 + shape */
    double light_square[LOBE_SG_LIGHTS]; /* mean square radiance under each */
    float *once, *twice; /* by sharpness and angle: the correlation, seen through one SG and through two */
    double shape;        /* see lobe_sg_scene_make */
} lobe_sg_scene;

/* shape: this part of the relative square error of the lobe itself is added, as white light. lights: at most
 * LOBE_SG_LIGHTS. false: no memory. Free it either way. */
bool lobe_sg_scene_make(lobe_sg_scene *s, double alpha, double n_dot_v, int order, const lobe_env_spectrum *spectra,
                        int lights, double shape);
void lobe_sg_scene_free(lobe_sg_scene *s);

/* Mean over the environments of mean square error over mean square radiance, and the part of shape. Sharpness .14 to
 * 40000. Lobes of two sharpnesses meet as if both had one between them; 1e-3 of the product at most. */
double lobe_sg_scene_error(const lobe_sg_scene *s, const lobe_sg *lobes, int count);

/* The same without shape and for each environment, for lobes or, where count is 0, for one round kernel of any kind
 * by the factors with which it damps the bands: the split sum, for one. false: no memory. */
bool lobe_sg_scene_errors(const lobe_sg_scene *s, const lobe_env_spectrum *spectra, int lights, const lobe_sg *lobes,
                          int count, const double *factor, double *square);

/* Factors by which an SG damps bands 0 .. bands - 1. */
void lobe_sg_bands(double sharpness, int bands, double *factor);

#endif
