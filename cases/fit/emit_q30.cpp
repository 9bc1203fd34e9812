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
static lobe_interval range[LOBE_NODES], scaled_range[LOBE_NODES];
static int uses[LOBE_NODES], degree[LOBE_NODES], uses_scale[LOBE_NODES];
static int natural[2][LOBE_NODES]; /* the operation that holds a node at its own scale, plain and magnified */
static const char *trouble;

static int get(int node, int fraction, int scaled);

static int is_const(int node) { return graph->node[node].op == LOBE_OP_CONST; }

/* Most fractional bits that keep the range, and some slack for rounding, inside 32 bits. */
static int cap_of(lobe_interval r)
{
    const double most = (fabs(r.lo) > fabs(r.hi) ? fabs(r.lo) : fabs(r.hi)) * (1.0 + 0x1p-20) + 0x1p-24;
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
    return cap_of(scaled ? scaled_range[node] : range[node]);
}

/* A saturation that the range makes idle, as that of an input already clamped. */
static int skip_idle(int node)
{
    while (graph->node[node].op == LOBE_OP_SATURATE && range[graph->node[node].arg[0]].lo >= 0.0 &&
           range[graph->node[node].arg[0]].hi <= 1.0)
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
    frexp(range[d].lo * (1.0 - 0x1p-10), &k);
    return 29 + k;
}

/* Fractional bits that a node can be computed with. */
static int limit(int node, int scaled)
{
    node = skip_idle(node);
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
    lobe_q_op *o = &program->op[program->ops];
    if (program->ops >= LOBE_NODES - 1) {
        trouble = "the formula is too long";
        return 0;
    }
    memset(o, 0, sizeof *o);
    o->kind = kind;
    o->a = a;
    o->b = b;
    o->imm = imm;
    o->fraction = fraction;
    o->node = node;
    o->degree = scaled ? degree[node] : 0;
    const lobe_q_op *p = a >= 0 ? &program->op[a] : o, *q = b >= 0 ? &program->op[b] : o;
    switch (kind) {
    case LOBE_Q_INPUT:
    case LOBE_Q_SCALED_INPUT:
        o->at_least_0 = o->at_most_1 = 1;
        break;
    case LOBE_Q_LITERAL:
        o->at_least_0 = imm >= 0;
        o->at_most_1 = fraction <= 30 && imm <= 1 << fraction;
        break;
    case LOBE_Q_SCALED_LITERAL:
        o->at_least_0 = imm >= 0;
        break;
    case LOBE_Q_ADD:
        o->at_least_0 = p->at_least_0 && q->at_least_0;
        break;
    case LOBE_Q_SUB:
        o->at_most_1 = p->at_most_1 && q->at_least_0;
        /* a - a b with b in [0, 1], all at one scale, cannot be negative: rounding is monotone. */
        o->at_least_0 = q->kind == LOBE_Q_MUL && q->fraction == p->fraction && p->at_least_0 &&
                        ((q->a == a && program->op[q->b].at_most_1) || (q->b == a && program->op[q->a].at_most_1));
        break;
    case LOBE_Q_MUL:
        o->at_least_0 = p->at_least_0 && q->at_least_0;
        o->at_most_1 = o->at_least_0 && p->at_most_1 && q->at_most_1;
        break;
    case LOBE_Q_SHIFT_RIGHT:
    case LOBE_Q_SHIFT_LEFT:
        o->at_least_0 = p->at_least_0 != 0;
        o->at_most_1 = p->at_most_1 != 0;
        break;
    case LOBE_Q_UNSCALE:
        o->at_least_0 = p->at_least_0 != 0;
        break;
    case LOBE_Q_MIN:
        o->at_least_0 = p->at_least_0 && q->at_least_0;
        o->at_most_1 = p->at_most_1 || q->at_most_1;
        break;
    case LOBE_Q_MAX:
        o->at_least_0 = p->at_least_0 || q->at_least_0;
        o->at_most_1 = p->at_most_1 && q->at_most_1;
        break;
    case LOBE_Q_CLAMP:
        o->at_least_0 = p->at_least_0 || (imm & 1);
        o->at_most_1 = p->at_most_1 || (imm & 2);
        break;
    case LOBE_Q_RATIO:
    case LOBE_Q_QUOTIENT:
        o->at_least_0 = p->at_least_0 != 0;
        break;
    default:
        break;
    }
    /* What the form does not show the range may, with room for rounding; the proof looks at these again. */
    if (!scaled && kind != LOBE_Q_INVERSE && kind != LOBE_Q_LITERAL) {
        if (!o->at_least_0 && range[node].lo > 0x1p-10)
            o->at_least_0 = LOBE_Q_BY_RANGE;
        if (!o->at_most_1 && range[node].hi < 1.0 - 0x1p-10)
            o->at_most_1 = LOBE_Q_BY_RANGE;
    }
    for (int i = 0; i < program->ops; i++)
        if (!memcmp(&program->op[i], o, sizeof *o))
            return i;
    return program->ops++;
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

static int free_to_scale(int node) { return uses[node] == 1 && graph->node[node].op != LOBE_OP_INPUT; }

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
    const int scaled = program->steps && degree[n] == 2 && degree[d] == 2;
    int fd = limit(d, scaled);
    if (fd > 30)
        fd = 30;
    if (is_const(n) && f > reciprocal_limit(d))
        f = reciprocal_limit(d);
    const int b = get(d, fd, scaled);
    const int inverse = push(LOBE_Q_INVERSE, b, -1, 0, 0, d, scaled);
    if (is_const(n) && graph->node[n].value == 1.0)
        return push(LOBE_Q_RECIPROCAL, inverse, -1, fd + f, f, node, 0);
    if (range[node].lo >= 0.0 && range[node].hi <= 1.0 + 0x1p-30) {
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
    case LOBE_OP_SATURATE: {
        const int of = limit(p, 0) < f ? limit(p, 0) : f;
        return clamped(get(p, of, 0), range[p].lo<0x1p-20, range[p].hi> 1.0 - 0x1p-20, node);
    }
    default:
        trouble = "only + - * / min max and saturate have a fixed-point form";
        return 0;
    }
}

/* A node at a scale. What several operations use is held once, at its own scale, and shifted from there. */
static int get(int node, int fraction, int scaled)
{
    node = skip_idle(node);
    if (is_const(node))
        return literal(graph->node[node].value, fraction, node);
    if (!scaled && uses_scale[node] && degree[node] == 2 && uses[node] > 1 && graph->node[node].op != LOBE_OP_INPUT)
        get(node, own_scale(node, 1), 1);
    int q;
    if (free_to_scale(node) && natural[scaled][node] < 0) {
        const int most = limit(node, scaled);
        q = compute(node, fraction < most ? fraction : most, scaled);
    } else {
        if (natural[scaled][node] < 0) {
            /* r^2 and the denominator exist magnified: shifting back is cheaper than a product. */
            if (!scaled && program->steps && natural[1][node] >= 0 && degree[node] == 2 &&
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

/* Degrees along (r, v) -> (c r, c^2 v): -1 where a node does not scale. */
static void find_degrees()
{
    for (int i = 0; i < graph->nodes; i++) {
        const lobe_node *n = &graph->node[i];
        const int p = n->arg[0] >= 0 ? degree[n->arg[0]] : -1, q = n->arg[1] >= 0 ? degree[n->arg[1]] : -1;
        const int cp = n->arg[0] >= 0 && is_const(n->arg[0]), cq = n->arg[1] >= 0 && is_const(n->arg[1]);
        degree[i] = -1;
        if (n->op == LOBE_OP_INPUT)
            degree[i] = n->input == 0 ? 1 : 2;
        else if (n->op == LOBE_OP_CONST)
            degree[i] = 0;
        else if (n->op == LOBE_OP_SATURATE && graph->node[n->arg[0]].op == LOBE_OP_INPUT)
            degree[i] = p;
        else if (n->op == LOBE_OP_MUL && p >= 0 && q >= 0)
            degree[i] = p + q;
        else if (n->op == LOBE_OP_ADD || n->op == LOBE_OP_SUB || n->op == LOBE_OP_MAX || n->op == LOBE_OP_MIN) {
            if (p == q || cq)
                degree[i] = p;
            else if (cp)
                degree[i] = q;
            if (degree[i] != 2 && (cp || cq))
                degree[i] = -1;
        }
    }
}

static void mark_scaled(int node)
{
    uses_scale[node] = 1;
    for (int k = 0; k < lobe_op_arity(graph->node[node].op); k++)
        mark_scaled(graph->node[node].arg[k]);
}

int lobe_q_steps(const lobe_q_program *q, int32_t r, int32_t v)
{
    int steps = 0;
    while (steps < q->steps && r < 1 << LOBE_Q_LARGE_R && v < 1 << LOBE_Q_LARGE_V) {
        r <<= LOBE_Q_STEP;
        v <<= 2 * LOBE_Q_STEP;
        steps++;
    }
    return steps;
}

static void unite(lobe_interval *all, double lo, double hi, int first)
{
    if (first || lo < all->lo)
        all->lo = lo;
    if (first || hi > all->hi)
        all->hi = hi;
}

/* The quotients that profit are those whose denominator goes to 0 at the origin; how far to magnify is limited by
 * the constants beside them. */
static void plan_scaling()
{
    const lobe_box origin = {{0, 0}, {0, 0}};
    memset(uses_scale, 0, sizeof uses_scale);
    program->steps = 0;
    if (lobe_range_box(graph, &origin, range))
        return;
    for (int i = 0; i < graph->nodes; i++) {
        const lobe_node *n = &graph->node[i];
        if (n->op == LOBE_OP_DIV && degree[n->arg[0]] == 2 && degree[n->arg[1]] == 2 && range[n->arg[1]].lo < 0x1p-8) {
            mark_scaled(n->arg[0]);
            mark_scaled(n->arg[1]);
            program->steps = 5;
        }
    }
    for (int i = 0; i < graph->nodes; i++) {
        const lobe_node *n = &graph->node[i];
        if (!uses_scale[i] || n->op == LOBE_OP_MUL)
            continue;
        for (int k = 0; k < lobe_op_arity(n->op); k++)
            while (is_const(n->arg[k]) && program->steps &&
                   fabs(graph->node[n->arg[k]].value) * ldexp(1.0, 2 * LOBE_Q_STEP * program->steps) > 1.0)
                program->steps--;
    }
    if (!program->steps)
        memset(uses_scale, 0, sizeof uses_scale);
}

/* Ranges of all nodes, and of the magnified ones, over the whole domain. 1 where a denominator may be 0. */
static int find_ranges()
{
    static lobe_interval now[LOBE_NODES];
    lobe_box box;
    for (int i = 0; lobe_box_at(i, &box); i++) {
        /* A box lies in one octave of each input, so its points are magnified alike. */
        const int steps = lobe_q_steps(program, box.hi[0], box.hi[1]);
        if (lobe_range_box(graph, &box, now))
            return 1;
        for (int k = 0; k < graph->nodes; k++) {
            const int bits = LOBE_Q_STEP * (is_const(k) ? 2 : degree[k]) * steps;
            unite(&range[k], now[k].lo, now[k].hi, !i);
            if (uses_scale[k])
                unite(&scaled_range[k], ldexp(now[k].lo, bits), ldexp(now[k].hi, bits), !i);
        }
    }
    return 0;
}

static void drop_unused()
{
    static int where[LOBE_NODES];
    int kept = 0;
    for (int i = 0; i < program->ops; i++)
        where[i] = -1;
    for (int i = 0; i < graph->outputs; i++)
        where[program->output[i]] = 0;
    for (int i = program->ops - 1; i >= 0; i--) {
        const lobe_q_op *o = &program->op[i];
        if (where[i] == 0 && o->a >= 0)
            where[o->a] = 0;
        if (where[i] == 0 && o->b >= 0)
            where[o->b] = 0;
    }
    for (int i = 0; i < program->ops; i++) {
        lobe_q_op o = program->op[i];
        if (where[i] < 0)
            continue;
        o.a = o.a >= 0 ? where[o.a] : -1;
        o.b = o.b >= 0 ? where[o.b] : -1;
        where[i] = kept;
        program->op[kept++] = o;
    }
    for (int i = 0; i < graph->outputs; i++)
        program->output[i] = where[program->output[i]];
    program->ops = kept;
}

int lobe_q_compile(const lobe_graph *g, lobe_q_program *q)
{
    memset(q, 0, sizeof *q);
    program = q;
    graph = q->graph = g;
    trouble = 0;
    for (int i = 0; i < g->nodes; i++)
        if (g->node[i].op > LOBE_OP_NEGATE)
            trouble = "only + - * / min max and saturate have a fixed-point form";
    if (!trouble) {
        lobe_graph_uses(g, uses);
        find_degrees();
        plan_scaling();
        if (find_ranges())
            trouble = "a denominator may be 0: guard it with lobe_max";
    }
    if (!trouble) {
        for (int i = 0; i < g->nodes; i++)
            natural[0][i] = natural[1][i] = -1;
        for (int i = 0; i < g->outputs; i++)
            q->output[i] = clamped(get(g->output[i], 30, 0), 1, 1, g->output[i]);
        drop_unused();
    }
    if (trouble) {
        fprintf(stderr, "emit: %s %s to q30: %s\n", g->model, g->tier, trouble);
        return 2;
    }
    return 0;
}
