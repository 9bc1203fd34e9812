/* Fits the closed forms of models/split_sum.h and models/split_sum_sep.h. */
#ifndef LOBE_FORM_FIT_H
#define LOBE_FORM_FIT_H
#include "../fit/fit_command.h"

/* Each a lobe_fit_tier_fn. */
bool lobe_fit_split_sum_low(const struct lobe_case *self, const lobe_fit_request *request);
bool lobe_fit_split_sum_medium(const struct lobe_case *self, const lobe_fit_request *request);
bool lobe_fit_split_sum_high(const struct lobe_case *self, const lobe_fit_request *request);
bool lobe_fit_split_sum_sep_low(const struct lobe_case *self, const lobe_fit_request *request);
bool lobe_fit_split_sum_sep_medium(const struct lobe_case *self, const lobe_fit_request *request);
bool lobe_fit_split_sum_sep_high(const struct lobe_case *self, const lobe_fit_request *request);

#endif
