/* Writes the .vec files of a case: a head that says what the rows are and how far a model may be from them, then
 * inputs and true outputs. The rows come from the truth alone, never from a model. */
#ifndef LOBE_VECTORS_H
#define LOBE_VECTORS_H
#include <stddef.h>
#include <stdint.h>

struct lobe_case;
struct lobe_sweep_options;

/* Where one tier may be how wrong, from its generated header. */
typedef struct lobe_tier_bounds {
    const char *model, *tier, *format;
    double domain_lo; /* of every input: the bounds hold on [domain_lo, 1] */
    double max, rms;
    double below_max; /* of the absolute error where an input is below domain_lo, down to the truth's domain; 0: no
                         such file is written */
    double furnace, below_furnace; /* of |E_true / E - 1|, inside and below; 0: not stated */
} lobe_tier_bounds;

/* Fills at most `room` rows of inputs, multiples of 2^-24, and returns how many. below is nonzero for the rows that
 * have an input below domain_lo. */
typedef size_t (*lobe_points_fn)(double domain_lo, int below, uint64_t seed, double *points, size_t room);

typedef struct lobe_vector_set {
    uint64_t seed;
    lobe_points_fn points;
    const lobe_tier_bounds *bounds; /* rows of other models are passed over */
    int bound_count;
    /* The rest is for a case whose vectors have other columns than its truth, or a domain that is not [domain_lo, 1]
     * of every input; then what lies outside is .beyond.vec instead of .below.vec. */
    const struct lobe_case *columns; /* NULL: the case itself */
    const char *domain, *beyond;     /* as text */
    size_t rows;                     /* at most; 0: 512 */
} lobe_vector_set;

/* Writes folder/MODEL.TIER.FORMAT.vec, and .below.vec (or .beyond.vec) beside it, for every tier and format; each
 * appears whole or not at all. 0, or 2 with the reason in error. */
int lobe_vectors_write(const struct lobe_case *self, const char *folder, const struct lobe_sweep_options *options,
                       char *error, size_t error_size);

#endif
