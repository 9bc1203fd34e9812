/* `lobefit search split_sum` and `split_sum_sep`: the front of cost against error. */
#ifndef LOBE_FRONT_H
#define LOBE_FRONT_H
#include "../case.h"

/* A lobe_command_fn. Fits every form of front_corr.h or front_sep.h from scratch, judges it on a denser grid, and
 * writes a table to stdout, or as CSV with --csv FILE. */
int lobe_front_search(const lobe_case *self, int argc, char **argv);

#endif
