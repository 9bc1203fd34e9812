/* A formula as a program of 32-bit integer operations: what is emitted, simulated and proved is this. */
#ifndef LOBE_EMIT_Q30_H
#define LOBE_EMIT_Q30_H

#include <stdint.h>

#include "emit_range.h"

enum lobe_q_kind {
    LOBE_Q_INPUT,       /* clamped to [0, 1], Q30 */
    LOBE_Q_LITERAL,     /* imm */
    LOBE_Q_ADD,         /* a + b */
    LOBE_Q_SUB,         /* a - b */
    LOBE_Q_MUL,         /* a * b / 2^imm */
    LOBE_Q_SHIFT_RIGHT, /* a / 2^imm */
    LOBE_Q_SHIFT_LEFT,  /* a * 2^imm */
    LOBE_Q_MIN,         /* of a and b */
    LOBE_Q_MAX,
    LOBE_Q_CLAMP,          /* imm bit 0: to at least 0; bit 1: to at most 1 */
    LOBE_Q_INVERSE,        /* of a: a lobe_q_inverse */
    LOBE_Q_RATIO,          /* a times the inverse b, |a| at most what b inverts */
    LOBE_Q_QUOTIENT,       /* the same without that condition; imm: the fraction of the result */
    LOBE_Q_LOG2,           /* of a, Q26 */
    LOBE_Q_RECIPROCAL,     /* the inverse a as a number: its mantissa shifted right by its shift - imm >= 0 */
    LOBE_Q_RESCALE,        /* a, read with another scale: a product with a power of two */
    LOBE_Q_SCALED_INPUT,   /* input magnified along the self-similar direction, see below */
    LOBE_Q_SCALED_LITERAL, /* imm at the largest magnification, shifted to the current one */
    LOBE_Q_UNSCALE         /* a without its magnification */
};

/* v / (v + k r^2) does not change when r grows by 8 and v by 64. So such quotients are computed after the pair has
 * been magnified until one of the two is large: that keeps their relative precision at any scale. A step
 * multiplies what is of degree 2 (r^2, v) by 2^6. */
enum { LOBE_Q_STEP = 3, LOBE_Q_LARGE_R = 27, LOBE_Q_LARGE_V = 24 };

enum { LOBE_Q_BY_RANGE = 2 };

struct lobe_q_op {
    int kind, a, b, imm;
    int fraction;   /* fractional bits of the result */
    int node;       /* the node of the formula it stands for */
    int degree;     /* magnified by 2^(3 degree) a step; 0 where not */
    int at_least_0; /* 1: by the form of the operation; LOBE_Q_BY_RANGE: by its range */
    int at_most_1;
};

/* What the choice of scales rests on. */
struct lobe_q_plan {
    lobe_interval range[LOBE_NODES];        /* of each node over the whole domain */
    lobe_interval scaled_range[LOBE_NODES]; /* and of those that are computed magnified */
    int uses_scale[LOBE_NODES];             /* whether it is */
    int degree[LOBE_NODES];                 /* then along (r, v) -> (c r, c^2 v); else 0 */
    int uses[LOBE_NODES];
    int steps; /* at most this many magnifications; 0 where there are none */
};

struct lobe_q_program {
    const lobe_graph *graph;
    lobe_q_plan plan;
    lobe_q_op op[LOBE_NODES];
    int ops;
    int output[LOBE_OUTPUTS];
    int steps; /* at most this many magnifications; 0 where there are none */
};

struct lobe_q_proof {
    double error[LOBE_OUTPUTS];        /* bound on |integer program - formula| over all of [0, 1]^2 */
    double error_domain[LOBE_OUTPUTS]; /* over [.02, 1]^2 */
    int fits;                          /* no value leaves 32 bits */
    int worst;                         /* else the first operation that may */
};

/* Chooses scales and proves them. 0, or 2 after a line on standard error that says what cannot be done. */
int lobe_q_compile(const lobe_graph *g, lobe_q_program *q, lobe_q_proof *proof);

/* Runs it; values are kept in 64 bits. Returns 0, or 1 where some value needs more than 32. */
int lobe_q_run(const lobe_q_program *q, const int32_t *in, int32_t *out);

void lobe_q_prove(const lobe_q_program *q, lobe_q_proof *proof);

/* How often the pair (r, v) is magnified, at most `most` times. */
int lobe_q_steps(int most, int32_t r, int32_t v);

/* Fills the plan; 1 where a denominator may be 0. */
int lobe_q_make_plan(const lobe_graph *g, lobe_q_plan *plan);

/* Appends an operation, or finds an equal one: its index, or -1 where the program is full. */
int lobe_q_push(lobe_q_program *q, int kind, int a, int b, int imm, int fraction, int node, int scaled);

/* Forgets what no output needs. */
void lobe_q_drop_unused(lobe_q_program *q);

int lobe_q_text(const lobe_graph *g, FILE *out);

#endif
