/* What the choice of scales rests on: ranges, uses, and which quotients are computed magnified. */
#include "emit_q30.h"

#include <math.h>
#include <string.h>

static const lobe_graph *graph;
static lobe_q_plan *plan;

static int is_const(int node) { return graph->node[node].op == LOBE_OP_CONST; }

/* Whether a node can be had magnified by degree d along (r, v) -> (c r, c^2 v). Degree 0 is the plain value, which any
 * node has: a (k0 + k1 r) is of degree 2 with the second factor as it is. */
static int scales(int node, int d)
{
    const lobe_node *n = &graph->node[node];
    const int p = n->arg[0], q = n->arg[1];
    if (d == 0)
        return 1;
    switch (n->op) {
    case LOBE_OP_INPUT:
        return d == (n->input == 0 ? 1 : 2);
    case LOBE_OP_SATURATE:
        return graph->node[p].op == LOBE_OP_INPUT && scales(p, d);
    case LOBE_OP_MUL:
        return scales(p, d) || scales(q, d) || (d == 2 && scales(p, 1) && scales(q, 1));
    case LOBE_OP_ADD:
    case LOBE_OP_SUB:
    case LOBE_OP_MIN:
    case LOBE_OP_MAX: /* a constant term is magnified with the rest, as far as it has room */
        return d == 2 && (is_const(p) || scales(p, d)) && (is_const(q) || scales(q, d)) &&
               !(is_const(p) && is_const(q));
    default:
        return 0;
    }
}

/* 0, or 1 where a node would have to be of two degrees. */
static int mark_scaled(int node, int d)
{
    const lobe_node *n = &graph->node[node];
    const int p = n->arg[0], q = n->arg[1];
    if (d == 0)
        return 0;
    if (plan->uses_scale[node] && plan->degree[node] != d)
        return 1;
    plan->uses_scale[node] = 1;
    plan->degree[node] = d;
    switch (n->op) {
    case LOBE_OP_INPUT:
    case LOBE_OP_CONST:
        return 0;
    case LOBE_OP_SATURATE:
        return mark_scaled(p, d);
    case LOBE_OP_MUL:
        if (scales(p, d))
            return mark_scaled(p, d);
        if (scales(q, d))
            return mark_scaled(q, d);
        return mark_scaled(p, 1) || mark_scaled(q, 1);
    default:
        return mark_scaled(p, d) || mark_scaled(q, d);
    }
}

int lobe_q_steps(int most, int32_t r, int32_t v)
{
    int steps = 0;
    while (steps < most && r < 1 << LOBE_Q_LARGE_R && v < 1 << LOBE_Q_LARGE_V) {
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
    int conflict = 0;
    memset(plan->uses_scale, 0, sizeof plan->uses_scale);
    memset(plan->degree, 0, sizeof plan->degree);
    plan->steps = 0;
    if (lobe_range_box(graph, &origin, 1, plan->range))
        return;
    for (int i = 0; i < graph->nodes; i++) {
        const lobe_node *n = &graph->node[i];
        if (n->op == LOBE_OP_DIV && scales(n->arg[0], 2) && scales(n->arg[1], 2) &&
            plan->range[n->arg[1]].lo < 0x1p-8) {
            conflict |= mark_scaled(n->arg[0], 2) || mark_scaled(n->arg[1], 2);
            plan->steps = 5;
        }
    }
    if (conflict)
        plan->steps = 0;
    for (int i = 0; i < graph->nodes; i++) {
        const lobe_node *n = &graph->node[i];
        if (!plan->uses_scale[i] || n->op == LOBE_OP_MUL)
            continue;
        for (int k = 0; k < lobe_op_arity(n->op); k++)
            while (is_const(n->arg[k]) && plan->steps &&
                   fabs(graph->node[n->arg[k]].value) * ldexp(1.0, 2 * LOBE_Q_STEP * plan->steps) > 1.0)
                plan->steps--;
    }
    if (!plan->steps) {
        memset(plan->uses_scale, 0, sizeof plan->uses_scale);
        memset(plan->degree, 0, sizeof plan->degree);
    }
}

/* What the formula reaches at the middle of each box: no enclosure can be narrower. */
static void find_samples(lobe_interval *sample)
{
    static double value[LOBE_NODES];
    lobe_box box;
    for (int i = 0; lobe_box_at(i, &box); i++) {
        const double in[2] = {0x1p-31 * ((double)box.lo[0] + box.hi[0]), 0x1p-31 * ((double)box.lo[1] + box.hi[1])};
        lobe_graph_eval(graph, in, value);
        for (int k = 0; k < graph->nodes; k++)
            unite(&sample[k], value[k], value[k], !i);
    }
}

static int exponent(double x)
{
    int e;
    frexp(x, &e);
    return e;
}

/* Whether an enclosure costs bits that the samples do not need: in size, or in a denominator's least value. */
static int too_wide(const lobe_interval *now, const lobe_interval *sample)
{
    for (int k = 0; k < graph->nodes; k++) {
        const double most = fabs(now[k].lo) > fabs(now[k].hi) ? fabs(now[k].lo) : fabs(now[k].hi);
        const double need = fabs(sample[k].lo) > fabs(sample[k].hi) ? fabs(sample[k].lo) : fabs(sample[k].hi);
        if (most > need && exponent(most) > exponent(need * (1.0 + 0x1p-12)))
            return 1;
        if (graph->node[k].op == LOBE_OP_DIV && is_const(graph->node[k].arg[0])) {
            const int d = graph->node[k].arg[1];
            if (exponent(now[d].lo * (1.0 - 0x1p-10)) < exponent(sample[d].lo * (1.0 - 0x1p-10)) || now[d].lo <= 0.0)
                return 1;
        }
    }
    return 0;
}

/* Ranges of all nodes, and of the magnified ones, over the whole domain. 1 where a denominator may be 0. */
static int find_ranges()
{
    static lobe_interval now[LOBE_NODES], sample[LOBE_NODES];
    lobe_box box;
    find_samples(sample);
    for (int i = 0; lobe_box_at(i, &box); i++) {
        /* A box lies in one octave of each input, so its points are magnified alike. */
        const int steps = lobe_q_steps(plan->steps, box.hi[0], box.hi[1]);
        int failed = 1;
        for (int parts = 1; parts <= LOBE_RANGE_PARTS; parts *= 2) {
            failed = lobe_range_box(graph, &box, parts, now);
            if (!failed && !too_wide(now, sample))
                break;
        }
        if (failed)
            return 1;
        for (int k = 0; k < graph->nodes; k++) {
            const int bits = LOBE_Q_STEP * plan->degree[k] * steps;
            unite(&plan->range[k], now[k].lo, now[k].hi, !i);
            if (plan->uses_scale[k])
                unite(&plan->scaled_range[k], ldexp(now[k].lo, bits), ldexp(now[k].hi, bits), !i);
        }
    }
    return 0;
}

int lobe_q_make_plan(const lobe_graph *g, lobe_q_plan *p)
{
    graph = g;
    plan = p;
    lobe_graph_uses(g, p->uses);
    plan_scaling();
    return find_ranges();
}
