/* Bilinear tables of scale and bias with fitted texels: see models/split_sum_table.h for where they lie. */
#ifndef LOBE_TABLE_FIT_H
#define LOBE_TABLE_FIT_H
#include "../fit/fit_command.h"

/* lobe_fit_tier_fn's: write models/tables/MODEL_tableN_f32.c and _u16.c of the case's model. */
bool lobe_table_fit_32(const struct lobe_case *self, const lobe_fit_request *request);
bool lobe_table_fit_64(const struct lobe_case *self, const lobe_fit_request *request);
bool lobe_table_fit_128(const struct lobe_case *self, const lobe_fit_request *request);

#endif
