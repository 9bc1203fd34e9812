#include "emit_range.h"

#include <math.h>

typedef lobe_interval iv;

/* One rounding of the arithmetic that follows is at most 2^-53 of the result: widen by more. */
static iv widened(double lo, double hi)
{
    iv r = {lo - fabs(lo) * 0x1p-51 - 1e-300, hi + fabs(hi) * 0x1p-51 + 1e-300};
    return r;
}

static iv point(double x)
{
    iv r = {x, x};
    return r;
}

/* Rounding cannot make a sum or product of what is at least 0 negative. */
static iv at_least_0(iv r)
{
    if (r.lo < 0.0)
        r.lo = 0.0;
    return r;
}

static iv add(iv a, iv b)
{
    const iv r = widened(a.lo + b.lo, a.hi + b.hi);
    return a.lo >= 0.0 && b.lo >= 0.0 ? at_least_0(r) : r;
}

static iv sub(iv a, iv b) { return widened(a.lo - b.hi, a.hi - b.lo); }
static iv hull(iv a, iv b)
{
    iv r = {a.lo < b.lo ? a.lo : b.lo, a.hi > b.hi ? a.hi : b.hi};
    return r;
}

static iv cut(iv a, iv b)
{
    iv r = {a.lo > b.lo ? a.lo : b.lo, a.hi < b.hi ? a.hi : b.hi};
    return r.lo <= r.hi ? r : a;
}

static iv mul(iv a, iv b)
{
    const double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    const double l1 = p < q ? p : q, l2 = r < s ? r : s, h1 = p > q ? p : q, h2 = r > s ? r : s;
    const iv w = widened(l1 < l2 ? l1 : l2, h1 > h2 ? h1 : h2);
    return a.lo >= 0.0 && b.lo >= 0.0 ? at_least_0(w) : w;
}

static iv square(iv a)
{
    const double p = a.lo * a.lo, q = a.hi * a.hi;
    if (a.lo <= 0.0 && a.hi >= 0.0)
        return at_least_0(widened(0.0, p > q ? p : q));
    return at_least_0(widened(p < q ? p : q, p < q ? q : p));
}

static iv divide(iv a, iv b) /* b > 0 */ { return mul(a, widened(1.0 / b.hi, 1.0 / b.lo)); }

/* n / (n + rest) with both at least 0 lies in [0, 1] and is monotone in each, which plain division cannot see.
 * Finds n among the terms of d, perhaps below a max(., constant); then rest is what the others add up to, and the
 * result the node of the sum. -1 where d has another form. */
static int sum_with(const lobe_graph *g, const iv *range, int n, int d, iv *rest)
{
    const int a = g->node[d].arg[0], b = g->node[d].arg[1];
    if (d == n) {
        *rest = point(0.0);
        return d;
    }
    if (g->node[d].op == LOBE_OP_MAX && g->node[b].op == LOBE_OP_CONST)
        return sum_with(g, range, n, a, rest);
    if (g->node[d].op == LOBE_OP_MAX && g->node[a].op == LOBE_OP_CONST)
        return sum_with(g, range, n, b, rest);
    if (g->node[d].op != LOBE_OP_ADD)
        return -1;
    for (int k = 0; k < 2; k++) {
        const int term = g->node[d].arg[k], other = g->node[d].arg[1 - k];
        if ((term == n || g->node[term].op == LOBE_OP_ADD) && sum_with(g, range, n, term, rest) >= 0) {
            *rest = add(*rest, range[other]);
            return d;
        }
    }
    return -1;
}

/* Value and slopes along the two inputs. */
struct slopes {
    iv d[2];
};

static int evaluate(const lobe_graph *g, const iv *in, const iv *centre, const double *mid, iv *range, slopes *slope)
{
    const iv zero = {0.0, 0.0}, unit = {0.0, 1.0};
    const int ways = centre ? 2 : 0; /* at a point nobody asks for slopes */
    for (int i = 0; i < g->nodes; i++) {
        const lobe_node *n = &g->node[i];
        const int p = n->arg[0], q = n->arg[1];
        const iv a = p >= 0 ? range[p] : zero, b = q >= 0 ? range[q] : zero;
        iv r = zero;
        slopes s = {{zero, zero}};
        switch (n->op) {
        case LOBE_OP_INPUT:
            r = in[n->input];
            s.d[n->input] = point(1.0);
            break;
        case LOBE_OP_CONST:
            r = point(n->value);
            break;
        case LOBE_OP_ADD:
            r = add(a, b);
            for (int k = 0; k < ways; k++)
                s.d[k] = add(slope[p].d[k], slope[q].d[k]);
            break;
        case LOBE_OP_SUB:
            r = sub(a, b);
            for (int k = 0; k < ways; k++)
                s.d[k] = sub(slope[p].d[k], slope[q].d[k]);
            break;
        case LOBE_OP_NEGATE:
            r = sub(zero, a);
            for (int k = 0; k < ways; k++)
                s.d[k] = sub(zero, slope[p].d[k]);
            break;
        case LOBE_OP_MUL:
            r = p == q ? square(a) : mul(a, b);
            for (int k = 0; k < ways; k++)
                s.d[k] = add(mul(slope[p].d[k], b), mul(a, slope[q].d[k]));
            break;
        case LOBE_OP_DIV: {
            if (b.lo <= 0.0)
                return 1;
            r = divide(a, b);
            iv c;
            const int sum = sum_with(g, range, p, q, &c);
            if (sum >= 0 && a.lo >= 0.0 && c.lo >= 0.0) {
                const double lo = a.lo + c.hi > 0.0 ? a.lo / (a.lo + c.hi) : 0.0;
                const double hi = a.hi + c.lo > 0.0 ? a.hi / (a.hi + c.lo) : 1.0;
                /* Where a max takes effect the quotient is smaller. */
                r = cut(r, cut(unit, widened(range[sum].lo < b.lo ? 0.0 : lo, hi)));
            }
            for (int k = 0; k < ways; k++)
                s.d[k] = divide(sub(slope[p].d[k], mul(r, slope[q].d[k])), b);
            break;
        }
        case LOBE_OP_MIN:
        case LOBE_OP_MAX: {
            const int low = n->op == LOBE_OP_MIN;
            r.lo = (a.lo < b.lo) == low ? a.lo : b.lo;
            r.hi = (a.hi < b.hi) == low ? a.hi : b.hi;
            for (int k = 0; k < ways; k++) {
                const iv da = slope[p].d[k], db = slope[q].d[k];
                if (a.hi < b.lo)
                    s.d[k] = low ? da : db;
                else if (b.hi < a.lo)
                    s.d[k] = low ? db : da;
                else
                    s.d[k] = hull(da, db);
            }
            break;
        }
        case LOBE_OP_SATURATE:
            r.lo = a.lo < 0.0 ? 0.0 : a.lo > 1.0 ? 1.0 : a.lo;
            r.hi = a.hi < 0.0 ? 0.0 : a.hi > 1.0 ? 1.0 : a.hi;
            for (int k = 0; k < ways; k++) {
                if (a.lo >= 0.0 && a.hi <= 1.0)
                    s.d[k] = slope[p].d[k];
                else if (a.hi < 0.0 || a.lo > 1.0)
                    s.d[k] = zero;
                else
                    s.d[k] = hull(zero, slope[p].d[k]);
            }
            break;
        case LOBE_OP_LOG2: {
            if (a.lo <= 0.0)
                return 1;
            /* log2 of libm is good to an ulp; it is 0 at 1, so widen by what the size of 1 needs. */
            const iv l = {log2(a.lo) - 0x1p-50, log2(a.hi) + 0x1p-50};
            r = widened(l.lo, l.hi);
            const iv scale = {1.4426950408889634, 1.4426950408889636};
            for (int k = 0; k < ways; k++)
                s.d[k] = divide(mul(slope[p].d[k], scale), a);
            break;
        }
        default:
            return 1;
        }
        if (centre && n->op != LOBE_OP_INPUT && n->op != LOBE_OP_CONST) {
            iv m = centre[i];
            for (int k = 0; k < ways; k++) {
                const iv width = {in[k].lo - mid[k], in[k].hi - mid[k]};
                m = add(m, mul(s.d[k], width));
            }
            r = cut(r, m);
        }
        range[i] = r;
        slope[i] = s;
    }
    return 0;
}

static int one_box(const lobe_graph *g, const lobe_box *box, lobe_interval *range)
{
    static iv centre[LOBE_NODES];
    static slopes slope[LOBE_NODES];
    iv in[2], at[2];
    double mid[2];
    for (int k = 0; k < 2; k++) {
        in[k].lo = box->lo[k] * 0x1p-30;
        in[k].hi = box->hi[k] * 0x1p-30;
        mid[k] = 0.5 * (in[k].lo + in[k].hi);
        at[k] = point(mid[k]);
    }
    if (evaluate(g, at, 0, 0, centre, slope))
        return 1;
    return evaluate(g, in, centre, mid, range, slope);
}

int lobe_range_box(const lobe_graph *g, const lobe_box *box, int parts, lobe_interval *range)
{
    static iv now[LOBE_NODES];
    if (parts == 1)
        return one_box(g, box, range);
    int first = 1;
    for (int i = 0; i < parts * parts; i++) {
        const int at[2] = {i / parts, i % parts};
        lobe_box part;
        int empty = 0;
        for (int k = 0; k < 2; k++) {
            const int64_t size = (int64_t)box->hi[k] - box->lo[k] + 1;
            part.lo[k] = box->lo[k] + (int)(size * at[k] / parts);
            part.hi[k] = box->lo[k] + (int)(size * (at[k] + 1) / parts) - 1;
            empty |= part.hi[k] < part.lo[k];
        }
        if (empty)
            continue;
        if (one_box(g, &part, now))
            return 1;
        for (int k = 0; k < g->nodes; k++)
            range[k] = first ? now[k] : hull(range[k], now[k]);
        first = 0;
    }
    return 0;
}

/* One axis: 0 alone, then each octave in equal parts, more of them near 1. */
static int axis(int i, int *lo, int *hi)
{
    if (i == 0) {
        *lo = *hi = 0;
        return 1;
    }
    i--;
    for (int octave = 0; octave < 30; octave++) {
        const int size = 1 << octave;
        int parts = octave >= 27 ? 32 : octave >= 18 ? 8 : 2;
        if (parts > size)
            parts = size;
        if (i < parts) {
            *lo = size + size / parts * i;
            *hi = size + size / parts * (i + 1) - (octave == 29 && i == parts - 1 ? 0 : 1);
            return 1;
        }
        i -= parts;
    }
    return 0;
}

int lobe_box_at(int i, lobe_box *box)
{
    static int count;
    int lo, hi;
    if (!count)
        while (axis(count, &lo, &hi))
            count++;
    if (i >= count * count)
        return 0;
    axis(i / count, &box->lo[0], &box->hi[0]);
    axis(i % count, &box->lo[1], &box->hi[1]);
    return 1;
}
