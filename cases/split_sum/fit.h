/* Fits the tiers of the split sum, for either form of Smith's visibility. */
#ifndef LOBE_SPLIT_SUM_FIT_H
#define LOBE_SPLIT_SUM_FIT_H
#include "../case.h"

/* lobe_command_fn's. */
int lobe_split_sum_fit(const lobe_case *self, int argc, char **argv);
int lobe_split_sum_sep_fit(const lobe_case *self, int argc, char **argv);

#endif
