/* A scalar that records: compiled with it, a kernel leaves its formula behind as a graph in which equal
 * subexpressions are one node. No exceptions, no library beyond libc. */
#ifndef LOBE_TRACE_H
#define LOBE_TRACE_H

#include <stdio.h>

#include "emit.h"

enum lobe_op {
    LOBE_OP_INPUT,
    LOBE_OP_CONST,
    LOBE_OP_ADD,
    LOBE_OP_SUB,
    LOBE_OP_MUL,
    LOBE_OP_DIV,
    LOBE_OP_MIN,
    LOBE_OP_MAX,
    LOBE_OP_SATURATE,
    LOBE_OP_NEGATE,
    LOBE_OP_SELECT,
    LOBE_OP_EXP2,
    LOBE_OP_LOG2,
    LOBE_OP_SQRT
};

struct lobe_node {
    int op;
    int arg[3]; /* indices of earlier nodes, -1 where unused */
    int input;
    double value;
};

enum { LOBE_NODES = 2048, LOBE_OUTPUTS = 24 };

/* A formula: nodes in an order in which every argument comes first. */
struct lobe_graph {
    lobe_node node[LOBE_NODES];
    int nodes;
    int output[LOBE_OUTPUTS];
    int outputs;
    const char *input_name[2];
    const char *output_name[LOBE_OUTPUTS];
    const char *model, *tier;
};

/* Recording goes into this graph; the constructor functions below add to it. */
extern lobe_graph *lobe_tracing;

void lobe_graph_begin(lobe_graph *g);
int lobe_graph_add(int op, int a, int b, int c, double value, int input);

/* Forgets what no output needs. */
void lobe_graph_prune(lobe_graph *g);

/* How often each node is used, an output being a use. */
void lobe_graph_uses(const lobe_graph *g, int *uses);

int lobe_op_arity(int op);
void lobe_graph_eval(const lobe_graph *g, const double *in, double *value);
lobe_op_count lobe_graph_count(const lobe_graph *g);

/* Formulas as text. Returns 2 for an unknown language. */
int lobe_graph_text(const lobe_graph *g, const char *language, FILE *out);

/* The recorded tiers: number i into g. Returns 0 past the last. */
int lobe_kernel_trace(int i, lobe_graph *g);

struct lobe_real {
    int id;
    lobe_real() : id(-1) {}
    lobe_real(double x) : id(lobe_graph_add(LOBE_OP_CONST, -1, -1, -1, x, -1)) {}
    lobe_real(int op, const lobe_real &a, const lobe_real &b) : id(lobe_graph_add(op, a.id, b.id, -1, 0.0, -1)) {}
    lobe_real(int op, const lobe_real &a) : id(lobe_graph_add(op, a.id, -1, -1, 0.0, -1)) {}
};

static inline lobe_real lobe_input(int i)
{
    lobe_real r;
    r.id = lobe_graph_add(LOBE_OP_INPUT, -1, -1, -1, 0.0, i);
    return r;
}

static inline lobe_real operator+(const lobe_real &a, const lobe_real &b) { return lobe_real(LOBE_OP_ADD, a, b); }
static inline lobe_real operator-(const lobe_real &a, const lobe_real &b) { return lobe_real(LOBE_OP_SUB, a, b); }
static inline lobe_real operator*(const lobe_real &a, const lobe_real &b) { return lobe_real(LOBE_OP_MUL, a, b); }
static inline lobe_real operator/(const lobe_real &a, const lobe_real &b) { return lobe_real(LOBE_OP_DIV, a, b); }
static inline lobe_real operator-(const lobe_real &a) { return lobe_real(LOBE_OP_NEGATE, a); }

static inline lobe_real lobe_min(const lobe_real &a, const lobe_real &b) { return lobe_real(LOBE_OP_MIN, a, b); }
static inline lobe_real lobe_max(const lobe_real &a, const lobe_real &b) { return lobe_real(LOBE_OP_MAX, a, b); }
static inline lobe_real lobe_saturate(const lobe_real &x) { return lobe_real(LOBE_OP_SATURATE, x); }
static inline lobe_real lobe_clamp(const lobe_real &x, const lobe_real &lo, const lobe_real &hi)
{
    return lobe_min(lobe_max(x, lo), hi);
}
static inline lobe_real lobe_select(const lobe_real &test, const lobe_real &yes, const lobe_real &no)
{
    lobe_real r;
    r.id = lobe_graph_add(LOBE_OP_SELECT, test.id, yes.id, no.id, 0.0, -1);
    return r;
}
static inline lobe_real lobe_exp2(const lobe_real &x) { return lobe_real(LOBE_OP_EXP2, x); }
static inline lobe_real lobe_log2(const lobe_real &x) { return lobe_real(LOBE_OP_LOG2, x); }
static inline lobe_real lobe_sqrt(const lobe_real &x) { return lobe_real(LOBE_OP_SQRT, x); }
static inline lobe_real lobe_reciprocal(const lobe_real &x) { return lobe_real(LOBE_OP_DIV, lobe_real(1.0), x); }

#endif
