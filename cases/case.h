/* A case study: what is integrated, over which domain, and what can be asked of it. cases.c holds the table of all;
 * a new case is a folder with a truth and one entry there. A hook that is NULL is answered by lobefit with "not
 * available for this case yet" and status 2. */
#ifndef LOBE_CASE_H
#define LOBE_CASE_H
#include <stddef.h>
#include "fit/rows.h"
#include "fit/vectors.h"

#define LOBE_CASE_COLUMNS 12

typedef struct lobe_case lobe_case;

/* Reads n rows of inputs, writes n rows of outputs. Reentrant, and no row depends on another. */
typedef void (*lobe_truth_fn)(const double *in, double *out, size_t n);

/* NULL, or why there is no truth for this row, whose columns are in their ranges: static text. */
typedef const char *(*lobe_refuse_fn)(const double *in);

/* The truth through OpenCL. 0, or 2 with the reason in error. */
typedef int (*lobe_truth_opencl_fn)(const double *in, double *out, size_t n, char *error, size_t error_size);

/* A command of lobefit; argv holds what follows the case's name. Returns the exit status. */
typedef int (*lobe_command_fn)(const lobe_case *self, int argc, char **argv);

struct lobe_case {
    const char *name;
    const char *integral; /* the truth in one line of mathematics */
    const char *brdf;
    const char *accuracy; /* of the truth, over the domain of the inputs */
    int input_count, output_count;
    lobe_column inputs[LOBE_CASE_COLUMNS]; /* with the domain of the truth */
    const char *outputs[LOBE_CASE_COLUMNS];
    lobe_truth_fn truth;
    lobe_refuse_fn refuse; /* NULL: the columns' ranges are the domain */
    lobe_truth_opencl_fn truth_opencl;
    const lobe_vector_set *vectors; /* tiers, formats and bounds; NULL: no vectors */
    lobe_command_fn fit;
    lobe_command_fn bounds; /* NULL: lobe_bounds_command, for models of roughness and NdotV on [.02, 1] */
    lobe_command_fn search;
    lobe_command_fn scene;
};

/* The case of that name, or NULL. */
const lobe_case *lobe_case_find(const char *name);

/* The i-th case, or NULL past the end. */
const lobe_case *lobe_case_at(int i);

#endif
