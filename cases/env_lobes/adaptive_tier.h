/* The tier whose number of taps follows a need: fitted and written. */
#ifndef LOBE_ENV_ADAPTIVE_TIER_H
#define LOBE_ENV_ADAPTIVE_TIER_H
#include "../fit/fit_command.h"
#include "adaptive_fit.h"
#include "table_training.h"

/* Fitted on what tables are. tiers: closed forms that there are (fan.h). True once models/coeffs/env_lobes_adaptive.h
 * is written, false after a line on stderr. */
bool lobe_env_adaptive_tier(const struct lobe_case *self, const lobe_fit_request *request,
                            lobe_env_table_training *training, const lobe_adaptive_tiers *tiers);

#endif
