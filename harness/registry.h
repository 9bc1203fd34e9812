/* What can be checked: one entry a model, tier and format, with what it costs and what it promises.
 * Constant data without allocation, libc or stdio, so that the same table serves a bare chip. */
#ifndef LOBE_REGISTRY_H
#define LOBE_REGISTRY_H
#include <stddef.h>
#include <stdint.h>

enum { LOBE_MAX_INPUTS = 10, LOBE_MAX_OUTPUTS = 24 };

typedef enum lobe_format { LOBE_F32, LOBE_Q30, LOBE_FORMATS } lobe_format;

/* One number in an entry's format. */
typedef union lobe_value {
    float f;
    int32_t q;
    uint32_t bits;
} lobe_value;

/* One input: its domain, where max and rms are promised, and what else may be asked for, where below_max is. Outside of
 * that too a function is finite. */
typedef struct lobe_range {
    double lo, hi;
    double least, most;
} lobe_range;

typedef struct lobe_entry {
    const char *model, *tier;
    const char *kernel; /* the public function */
    lobe_format format;
    int inputs, outputs;
    const char *input_names, *output_names; /* separated by one space, in the order of the columns */
    int sums;                               /* 1: the sum of the outputs is E, and held to the bound too */
    void (*call)(const lobe_value *in, lobe_value *out);
    /* The same over columns of n values; NULL where the library has no array version. */
    void (*array)(const lobe_value *const *in, lobe_value *const *out, size_t n);
    int ops;                  /* as design.md counts them */
    double max, rms;          /* stated error where every input is in its domain */
    double below_max;         /* stated maximum where an input is below, or above, its domain */
    const lobe_range *ranges; /* one an input */
    /* Fans of taps. Otherwise NULL, 0 and 0. */
    const char *prefilter; /* the kernel that an environment is to be prefiltered with */
    int nth;      /* no output has a truth, but the sum of every nth, from nth - 1 on, is E: what vectors hold */
    unsigned q16; /* bit k: in q30 output k is Q16.16 */
} lobe_entry;

extern const lobe_entry lobe_entries[];
extern const size_t lobe_entry_count;

extern const char *const lobe_format_names[LOBE_FORMATS];

/* 1 where the two texts are equal. */
int lobe_same(const char *a, const char *b);

/* The format of that name; LOBE_FORMATS where there is none. */
lobe_format lobe_format_named(const char *name);

/* The entry of that name; NULL where there is none. */
const lobe_entry *lobe_find_entry(const char *model, const char *tier, lobe_format format);

/* 1 where every input is in its domain. */
int lobe_in_domain(const lobe_entry *entry, const lobe_value *in);

/* The number that a value stands for. */
double lobe_value_real(lobe_format format, lobe_value value);

/* The number that output k of the entry stands for. */
double lobe_output_real(const lobe_entry *entry, int k, lobe_value value);

/* What the vectors of the entry hold: how many columns of truth, what they are called, and column k of an answer. */
int lobe_truth_count(const lobe_entry *entry);
const char *lobe_truth_names(const lobe_entry *entry);
double lobe_answer(const lobe_entry *entry, int k, const lobe_value *out);

/* The nearest value. q30 saturates, NaN gives 0; f32 keeps NaN and overflows to infinity. */
lobe_value lobe_value_nearest(lobe_format format, double real);

#endif
