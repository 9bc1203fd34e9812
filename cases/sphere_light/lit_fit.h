/* The tiers of lit_tiers.h, from scratch. */
#ifndef LOBE_SPHERE_LIGHT_LIT_FIT_H
#define LOBE_SPHERE_LIGHT_LIT_FIT_H
#include "../fit/fit_command.h"

/* lobe_fit_tier_fn's. */
bool lobe_sphere_fit_high(const struct lobe_case *self, const lobe_fit_request *request);
bool lobe_sphere_fit_schlick(const struct lobe_case *self, const lobe_fit_request *request);

#endif
