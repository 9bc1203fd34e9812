/* `lobefit bounds CASE`: measures what ships, the public functions of liblobe.a in both formats, against the truth on
 * a finer set of points than any fit has seen, and writes models/coeffs/MODEL_bounds.h. */
#ifndef LOBE_BOUNDS_H
#define LOBE_BOUNDS_H
#include "../case.h"
#include "../split_sum/shipped.h"
#include "fit_command.h"

/* A lobe_command_fn: for models of roughness and NdotV. */
int lobe_bounds_command(const lobe_case *self, int argc, char **argv);

/* What of such a model is measured, where that is not the split sum or 1/E. */
typedef struct lobe_bounded {
    const lobe_case *truth;                   /* scale and bias; their sum is E */
    const lobe_shipped *(*shipped)(int);      /* those of other models are passed over */
    const char *part;                         /* suffix of the macros of |E_true / E - 1| */
    const char *note;                         /* last lines of the head's comment */
    int (*operations)(const lobe_shipped *s); /* of a kernel's own text; negative after a line on stderr */
} lobe_bounded;

/* false after a line on stderr, and the old bounds stand. */
bool lobe_bounds_write(const lobe_case *self, const lobe_bounded *what, const lobe_fit_request *request);

#endif
