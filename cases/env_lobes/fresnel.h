/* What Schlick's Fresnel adds to the error of a fan of taps, by three ways of giving its taps their part: truth is the
 * response f0 + (1 - f0) (1 - v.h)^5. */
#ifndef LOBE_ENV_FRESNEL_JUDGE_H
#define LOBE_ENV_FRESNEL_JUDGE_H
#include "judge.h"

enum { LOBE_FRESNEL_F0S = 5, LOBE_FRESNEL_MODELS = 16 };
extern const double lobe_fresnel_f0[LOBE_FRESNEL_F0S];

typedef enum lobe_fresnel_way {
    LOBE_FRESNEL_FACTOR,   /* f0 scale + f90 bias over their sum on all taps */
    LOBE_FRESNEL_QUOTIENT, /* Schlick at each tap's own half vector, over the mean of that, times the factor */
    LOBE_FRESNEL_SHIPPED,  /* models/env_fresnel.h */
    LOBE_FRESNEL_WAYS
} lobe_fresnel_way;
extern const char *const lobe_fresnel_name[LOBE_FRESNEL_WAYS];

/* As lobe_judge_environment, but rms is over the same orientations as relative is. At most LOBE_FRESNEL_MODELS models,
 * all of taps: errors[way][f0][model]. */
bool lobe_fresnel_judge(const lobe_environment *map, const lobe_judge_options *options, const lobe_judge_model *models,
                        int count, lobe_judge_error errors[LOBE_FRESNEL_WAYS][LOBE_FRESNEL_F0S][LOBE_FRESNEL_MODELS]);

#endif
