/* Judges vectors against the library: the part of the runner that is the same on a workstation and on a
 * bare chip. No allocation, no stdio, no libm. */
#ifndef LOBE_CONFORM_CORE_H
#define LOBE_CONFORM_CORE_H
#include "registry.h"

/* The rows of one .vec file; embed_vectors writes these for targets without files. */
typedef struct lobe_vectors {
    const char *model, *tier;
    lobe_format format;
    int inputs, outputs;
    uint32_t rows;
    const uint32_t *in;   /* bits in the format, rows x inputs */
    const double *truth;  /* rows x outputs */
    double bound_max;     /* of the absolute error of every output, and of E where that is a sum */
    double bound_rms;     /* 0: not stated */
    double bound_furnace; /* of |true E / E - 1| where E is the one output; 0: not stated */
} lobe_vectors;

/* A committed hash. */
typedef struct lobe_known_hash {
    const char *model, *tier;
    lobe_format format;
    uint64_t hash;
} lobe_known_hash;

/* What embed_vectors defines. */
extern const lobe_vectors lobe_embedded[];
extern const size_t lobe_embedded_count;
extern const lobe_known_hash lobe_embedded_hashes[];
extern const size_t lobe_embedded_hash_count;

/* The rows on one side of the edge of the domain. */
typedef struct lobe_part {
    double bound; /* what every error here is held to */
    uint32_t rows, passed;
    double worst; /* largest error, -1 without rows; LOBE_NOT_FINITE where an output is NaN or infinite */
    uint32_t row; /* where that is */
    int output;   /* of which output; the number of outputs means their sum, E */
    double squares[LOBE_MAX_OUTPUTS + 1]; /* sum of squared errors an output, E last */
    double furnace;                       /* largest |true E / E - 1|, -1 where no bound on it is stated */
} lobe_part;

#define LOBE_NOT_FINITE 1e300

typedef struct lobe_verdict {
    lobe_part inside, below; /* below: rows with an input out of its domain, above it too */
} lobe_verdict;

/* Evaluates every row. A row must keep the vectors' bound and the library's, which is max inside the domain
 * and below_max outside. The vectors must have the entry's inputs and outputs. */
lobe_verdict lobe_judge(const lobe_entry *entry, const lobe_vectors *vectors);

/* The entry's inputs and outputs at a row. */
void lobe_evaluate_row(const lobe_entry *entry, const lobe_vectors *vectors, uint32_t row, lobe_value *in,
                       lobe_value *out);

#endif
