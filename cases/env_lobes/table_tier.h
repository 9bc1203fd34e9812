/* A tier that is a table: fitted from its closed form, and written. */
#ifndef LOBE_ENV_TABLE_TIER_H
#define LOBE_ENV_TABLE_TIER_H
#include "../fit/fit_command.h"
#include "table_training.h"

/* closed: coefficients of the closed form of as many taps (fan.h). True once models/tables/env_lobesN_table16_i16.c is
 * written, false after a line on stderr. */
bool lobe_env_table_tier(const struct lobe_case *self, const lobe_fit_request *request,
                         const lobe_env_table_training *training, int taps, const double *closed);

/* The coefficients of the closed form that ships, as a fit leaves them. */
void lobe_env_table_shipped(int taps, double *p);

#endif
