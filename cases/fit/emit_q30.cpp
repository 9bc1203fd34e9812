/* From formula to integer program: a binary point for every value.
 *
 * A value may have as many fractional bits as its proved range leaves in 32 bits. A product that only one
 * operation uses is rounded straight to that operation's scale, so that additions need no shifts, and literals
 * take the scale that keeps the product's shift in [17, 31], the cheap case on a chip without a long multiply. */
#include "emit_q30.h"

#include <math.h>
#include <string.h>

#include "../../core/q30.h"

static lobe_q_program *program;
static const lobe_graph *graph;
static lobe_q_plan *plan;
static int natural[2][LOBE_NODES]; /* the operation that holds a node at its own scale, plain and magnified */
static const char *trouble;
static double slack; /* room for rounding, relative to the range */

static int get(int node, int fraction, int scaled);

static int is_const(int node) { return graph->node[node].op == LOBE_OP_CONST; }

/* Most fractional bits that keep the range, and some slack for rounding, inside 32 bits. */
static int cap_of(lobe_interval r)
{
    const double most = (fabs(r.lo) > fabs(r.hi) ? fabs(r.lo) : fabs(r.hi)) * (1.0 + slack) + slack * 0x1p-4;
    int f = 46;
    while (f > 0 && most * ldexp(1.0, f) > 2147483647.0)
        f--;
    return f;
}

static int literal_cap(double x)
{
    int f = 46;
    while (f > 0 && fabs(x) * ldexp(1.0, f) > 2147483647.0)
        f--;
    return f;
}

static int cap(int node, int scaled)
{
    if (is_const(node) && !scaled)
        return literal_cap(graph->node[node].value);
    return cap_of(scaled ? plan->scaled_range[node] : plan->range[node]);
}

/* A saturation that the range makes idle, as that of an input already clamped. */
static int skip_idle(int node)
{
    while (graph->node[node].op == LOBE_OP_SATURATE && plan->range[graph->node[node].arg[0]].lo >= 0.0 &&
           plan->range[graph->node[node].arg[0]].hi <= 1.0)
        node = graph->node[node].arg[0];
    return node;
}

/* k where one factor of a product is the constant 2^k, and x the other factor; else -1. */
static int doubling(int node, int *x)
{
    const lobe_node *n = &graph->node[node];
    for (int i = 0; n->op == LOBE_OP_MUL && i < 2; i++) {
        int k;
        if (is_const(n->arg[i]) && frexp(graph->node[n->arg[i]].value, &k) == 0.5 && k >= 1 && k <= 8 &&
            !is_const(n->arg[1 - i])) {
            *x = skip_idle(n->arg[1 - i]);
            return k - 1;
        }
    }
    return -1;
}

static int limit(int node, int scaled);

/* 1/d comes as a mantissa that is only ever shifted right: d's least value says how far it still is to. */
static int reciprocal_limit(int d)
{
    int k;
    frexp(plan->range[d].lo * (1.0 - 0x1p-10), &k);
    return 29 + k;
}

/* Fractional bits that a node can be computed with. */
static int limit(int node, int scaled)
{
    node = skip_idle(node);
    scaled = scaled && plan->uses_scale[node];
    const lobe_node *n = &graph->node[node];
    int most = cap(node, scaled), f, x;
    if (!scaled && doubling(node, &x) >= 0) {
        f = limit(x, 0) - doubling(node, &x);
        return f < most ? f : most;
    }
    switch (n->op) {
    case LOBE_OP_INPUT:
        return 30;
    case LOBE_OP_ADD:
    case LOBE_OP_SUB:
    case LOBE_OP_MIN:
    case LOBE_OP_MAX:
        for (int k = 0; k < 2; k++) {
            f = limit(n->arg[k], scaled);
            if (is_const(n->arg[k]) && scaled)
                f = cap(n->arg[k], 1);
            most = f < most ? f : most;
        }
        return most;
    case LOBE_OP_SATURATE:
    case LOBE_OP_NEGATE:
        f = limit(n->arg[0], scaled);
        f = f > 30 ? 30 : f;
        return f < most ? f : most;
    case LOBE_OP_LOG2:
        return most > 26 ? 26 : most;
    case LOBE_OP_DIV:
        if (is_const(n->arg[0])) {
            f = reciprocal_limit(n->arg[1]);
            most = f < most ? f : most;
        }
        return most > 30 ? 30 : most;
    default:
        return most;
    }
}

static int push(int kind, int a, int b, int imm, int fraction, int node, int scaled)
{
    const int i = lobe_q_push(program, kind, a, b, imm, fraction, node, scaled);
    if (i < 0)
        trouble = "the formula is too long";
    return i < 0 ? 0 : i;
}

static int literal(double x, int fraction, int node)
{
    return push(LOBE_Q_LITERAL, -1, -1, (int)floor(x * ldexp(1.0, fraction) + 0.5), fraction, node, 0);
}

/* Constants beside something magnified are magnified with it. */
static int operand(int node, int fraction, int scaled)
{
    if (!scaled || !is_const(node))
        return get(node, fraction, scaled);
    const double most = graph->node[node].value * ldexp(1.0, 2 * LOBE_Q_STEP * program->steps);
    return push(LOBE_Q_SCALED_LITERAL, -1, -1, (int)floor(most * ldexp(1.0, fraction) + 0.5), fraction, node, 1);
}

static int clamped(int q, int low, int high, int node)
{
    const lobe_q_op *o = &program->op[q];
    const int imm = (low && !o->at_least_0 ? 1 : 0) | (high && !o->at_most_1 ? 2 : 0);
    return imm ? push(LOBE_Q_CLAMP, q, -1, imm, o->fraction, node, 0) : q;
}

static int own_scale(int node, int scaled)
{
    const int f = limit(node, scaled);
    return f > 30 ? 30 : f;
}

static int free_to_scale(int node) { return plan->uses[node] == 1 && graph->node[node].op != LOBE_OP_INPUT; }

static int product(int node, int f, int scaled)
{
    int x;
    const int k = scaled ? -1 : doubling(node, &x);
    if (k >= 0)
        return push(LOBE_Q_RESCALE, get(x, f + k, 0), -1, 0, f, node, 0);
    const int p = skip_idle(graph->node[node].arg[0]), q = skip_idle(graph->node[node].arg[1]);
    const int first = is_const(p) || (free_to_scale(p) && !is_const(q)) ? q : p; /* its scale is given */
    const int second = first == p ? q : p;
    int ff = own_scale(first, scaled), most, a, b;
    if (is_const(second)) {
        most = literal_cap(graph->node[second].value);
        if (most > f + 31 - ff)
            most = f + 31 - ff;
        a = get(first, ff, scaled);
        b = literal(graph->node[second].value, most, second);
    } else {
        most = own_scale(second, scaled);
        if (free_to_scale(second)) {
            most = limit(second, scaled);
            if (most > f + 31 - ff)
                most = f + 31 - ff;
        }
        a = get(first, ff, scaled);
        b = get(second, most, scaled);
    }
    const int shift = program->op[a].fraction + program->op[b].fraction - f;
    if (shift < 0)
        trouble = "a product has too few bits";
    return push(LOBE_Q_MUL, a, b, shift, f, node, scaled);
}

/* Whether integer a is a term of the sum d, whose other terms are at least 0, so that a <= d. */
static int part_of(int a, int d)
{
    const lobe_q_op *o = &program->op[d];
    if (a == d)
        return 1;
    if (o->kind == LOBE_Q_MAX)
        return part_of(a, o->a) || part_of(a, o->b);
    return o->kind == LOBE_Q_ADD &&
           ((part_of(a, o->a) && program->op[o->b].at_least_0) || (part_of(a, o->b) && program->op[o->a].at_least_0));
}

static int quotient(int node, int f)
{
    const int n = skip_idle(graph->node[node].arg[0]), d = skip_idle(graph->node[node].arg[1]);
    const int scaled = plan->uses_scale[n] && plan->uses_scale[d];
    int fd = limit(d, scaled);
    if (fd > 30)
        fd = 30;
    if (is_const(n) && f > reciprocal_limit(d))
        f = reciprocal_limit(d);
    const int b = get(d, fd, scaled);
    const int inverse = push(LOBE_Q_INVERSE, b, -1, 0, 0, d, scaled);
    if (is_const(n) && graph->node[n].value == 1.0)
        return push(LOBE_Q_RECIPROCAL, inverse, -1, fd + f, f, node, 0);
    if (plan->range[node].lo >= 0.0 && plan->range[node].hi <= 1.0 + 0x1p-30) {
        /* The numerator must be a part of the denominator in integers, too. */
        const int a = operand(n, fd, scaled);
        if (program->op[a].fraction == program->op[b].fraction && part_of(a, b)) {
            const int r = push(LOBE_Q_RATIO, a, inverse, 30, 30, node, 0);
            return f < 30 ? push(LOBE_Q_SHIFT_RIGHT, r, -1, 30 - f, f, node, 0) : r;
        }
    }
    int fn = limit(n, scaled);
    if (fn > 30)
        fn = 30;
    if (f + fd - fn > 30)
        f = 30 - fd + fn;
    const int a = operand(n, fn, scaled);
    return push(LOBE_Q_QUOTIENT, a, inverse, f + fd - fn, f, node, 0);
}

static int is_zero(int node, int op)
{
    return is_const(node) && program->op[op].imm == 0 && fabs(graph->node[node].value) < 0x1p-62;
}

static int compute(int node, int f, int scaled)
{
    const lobe_node *n = &graph->node[node];
    const int p = n->arg[0] >= 0 ? skip_idle(n->arg[0]) : -1, q = n->arg[1] >= 0 ? skip_idle(n->arg[1]) : -1;
    int a, b;
    switch (n->op) {
    case LOBE_OP_INPUT:
        return push(scaled ? LOBE_Q_SCALED_INPUT : LOBE_Q_INPUT, -1, -1, n->input, 30, node, scaled);
    case LOBE_OP_CONST:
        return literal(n->value, f, node);
    case LOBE_OP_ADD:
    case LOBE_OP_SUB:
    case LOBE_OP_MIN:
    case LOBE_OP_MAX:
        a = operand(p, f, scaled);
        b = operand(q, f, scaled);
        /* A guard so small that it rounds to 0 does nothing: core's reciprocal of 0 is finite. */
        if (n->op == LOBE_OP_ADD && is_zero(q, b))
            return a;
        if (n->op == LOBE_OP_ADD && is_zero(p, a))
            return b;
        return push(n->op == LOBE_OP_ADD   ? LOBE_Q_ADD
                    : n->op == LOBE_OP_SUB ? LOBE_Q_SUB
                    : n->op == LOBE_OP_MIN ? LOBE_Q_MIN
                                           : LOBE_Q_MAX,
                    a, b, 0, f, node, scaled);
    case LOBE_OP_NEGATE:
        a = literal(0.0, f, node);
        return push(LOBE_Q_SUB, a, get(p, f, scaled), 0, f, node, scaled);
    case LOBE_OP_MUL:
        return product(node, f, scaled);
    case LOBE_OP_DIV:
        return quotient(node, f);
    case LOBE_OP_LOG2:
        return push(LOBE_Q_LOG2, get(p, own_scale(p, 0), 0), -1, 0, 26, node, 0);
    case LOBE_OP_SATURATE: {
        const int of = limit(p, 0) < f ? limit(p, 0) : f;
        return clamped(get(p, of, 0), plan->range[p].lo<0x1p-20, plan->range[p].hi> 1.0 - 0x1p-20, node);
    }
    default:
        trouble = "only + - * / min max saturate and log2 have a fixed-point form";
        return 0;
    }
}

/* A node at a scale. What several operations use is held once, at its own scale, and shifted from there. */
static int get(int node, int fraction, int scaled)
{
    node = skip_idle(node);
    if (is_const(node))
        return literal(graph->node[node].value, fraction, node);
    scaled = scaled && plan->uses_scale[node];
    if (!scaled && plan->uses_scale[node] && plan->degree[node] == 2 && plan->uses[node] > 1 &&
        graph->node[node].op != LOBE_OP_INPUT)
        get(node, own_scale(node, 1), 1);
    int q;
    if (free_to_scale(node) && natural[scaled][node] < 0) {
        const int most = limit(node, scaled);
        q = compute(node, fraction < most ? fraction : most, scaled);
    } else {
        if (natural[scaled][node] < 0) {
            /* r^2 and the denominator exist magnified: shifting back is cheaper than a product. */
            if (!scaled && program->steps && natural[1][node] >= 0 && plan->degree[node] == 2 &&
                graph->node[node].op != LOBE_OP_INPUT) {
                const lobe_q_op *o = &program->op[natural[1][node]];
                natural[0][node] = push(LOBE_Q_UNSCALE, natural[1][node], -1, 0, o->fraction, node, 0);
            } else {
                natural[scaled][node] = compute(node, own_scale(node, scaled), scaled);
            }
        }
        q = natural[scaled][node];
    }
    const int have = program->op[q].fraction;
    if (have > fraction)
        return push(LOBE_Q_SHIFT_RIGHT, q, -1, have - fraction, fraction, node, scaled);
    if (have < fraction)
        return push(LOBE_Q_SHIFT_LEFT, q, -1, fraction - have, fraction, node, scaled);
    return q;
}

static int compile(const lobe_graph *g, lobe_q_program *q)
{
    memset(q, 0, sizeof *q);
    program = q;
    graph = q->graph = g;
    plan = &q->plan;
    trouble = 0;
    for (int i = 0; i < g->nodes; i++)
        if (g->node[i].op > LOBE_OP_NEGATE && g->node[i].op != LOBE_OP_LOG2)
            trouble = "only + - * / min max saturate and log2 have a fixed-point form";
    if (!trouble && lobe_q_make_plan(g, plan))
        trouble = "a denominator may be 0: guard it with lobe_max";
    q->steps = plan->steps;
    if (!trouble) {
        for (int i = 0; i < g->nodes; i++)
            natural[0][i] = natural[1][i] = -1;
        for (int i = 0; i < g->outputs; i++)
            q->output[i] = clamped(get(g->output[i], 30, 0), 1, 1, g->output[i]);
        lobe_q_drop_unused(q);
    }
    if (trouble) {
        fprintf(stderr, "emit: %s %s to q30: %s\n", g->model, g->tier, trouble);
        return 2;
    }
    return 0;
}

/* Where the room for rounding does not suffice for the proof, more of it will. */
int lobe_q_compile(const lobe_graph *g, lobe_q_program *q, lobe_q_proof *proof)
{
    const double slacks[] = {0x1p-20, 0x1p-14, 0x1p-9};
    for (int i = 0; i < 3; i++) {
        slack = slacks[i];
        if (compile(g, q))
            return 2;
        lobe_q_prove(q, proof);
        if (proof->fits)
            return 0;
    }
    fprintf(stderr, "emit: %s %s to q30: operation %d is not proved to fit in 32 bits (kind %d, Q%d)\n", g->model,
            g->tier, proof->worst, q->op[proof->worst].kind, q->op[proof->worst].fraction);
    return 2;
}
