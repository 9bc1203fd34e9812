/* `lobefit bounds CASE`: measures what ships, the public functions of liblobe.a in both formats, against the truth on
 * a finer set of points than any fit has seen, and writes models/coeffs/MODEL_bounds.h. */
#ifndef LOBE_BOUNDS_H
#define LOBE_BOUNDS_H
#include "../case.h"

/* A lobe_command_fn. */
int lobe_bounds_command(const lobe_case *self, int argc, char **argv);

#endif
