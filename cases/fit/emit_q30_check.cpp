/* What an integer program does: run on numbers, and bounded over the whole domain. */
#include "emit_q30.h"

#include <math.h>

#include "../../core/q30_log2.h"

static int64_t rounded_shift(int64_t x, int n) { return n > 0 ? (x + ((int64_t)1 << (n - 1))) >> n : x; }

static int32_t held(int32_t x) { return lobe_q_saturate(x); }

int lobe_q_run(const lobe_q_program *q, const int32_t *in, int32_t *out)
{
    static int64_t v[LOBE_NODES];
    static lobe_q_inverse inverse[LOBE_NODES];
    int wide = 0;
    const int32_t r0 = held(in[0]), v0 = held(in[1]);
    const int steps = lobe_q_steps(q->steps, r0, v0);
    for (int i = 0; i < q->ops; i++) {
        const lobe_q_op *o = &q->op[i];
        const int64_t a = o->a >= 0 ? v[o->a] : 0, b = o->b >= 0 ? v[o->b] : 0;
        int64_t r = 0;
        switch (o->kind) {
        case LOBE_Q_INPUT:
            r = o->imm ? v0 : r0;
            break;
        case LOBE_Q_SCALED_INPUT:
            r = o->imm ? (int64_t)v0 << (2 * LOBE_Q_STEP * steps) : (int64_t)r0 << (LOBE_Q_STEP * steps);
            break;
        case LOBE_Q_LITERAL:
            r = o->imm;
            break;
        case LOBE_Q_SCALED_LITERAL:
            r = o->imm >> (2 * LOBE_Q_STEP * (q->steps - steps));
            break;
        case LOBE_Q_ADD:
            r = a + b;
            break;
        case LOBE_Q_SUB:
            r = a - b;
            break;
        case LOBE_Q_MUL:
            r = rounded_shift(a * b, o->imm);
            break;
        case LOBE_Q_SHIFT_RIGHT:
            r = rounded_shift(a, o->imm);
            break;
        case LOBE_Q_SHIFT_LEFT:
            r = a * ((int64_t)1 << o->imm);
            break;
        case LOBE_Q_MIN:
            r = a < b ? a : b;
            break;
        case LOBE_Q_MAX:
            r = a > b ? a : b;
            break;
        case LOBE_Q_CLAMP:
            r = a;
            if ((o->imm & 1) && r < 0)
                r = 0;
            if ((o->imm & 2) && r > (int64_t)1 << o->fraction)
                r = (int64_t)1 << o->fraction;
            break;
        case LOBE_Q_INVERSE:
            inverse[i] = lobe_q_reciprocal((int32_t)a);
            break;
        case LOBE_Q_RATIO:
            wide |= a << (60 - inverse[o->b].shift) > 0x7fffffff;
            r = lobe_q_ratio((int32_t)a, inverse[o->b]);
            break;
        case LOBE_Q_QUOTIENT:
            r = lobe_q_quotient((int32_t)a, inverse[o->b], o->imm);
            break;
        case LOBE_Q_RESCALE:
            r = a;
            break;
        case LOBE_Q_LOG2:
            r = (int64_t)lobe_q_log2((int32_t)a) - ((int64_t)q->op[o->a].fraction << 26);
            break;
        case LOBE_Q_RECIPROCAL:
            wide |= inverse[o->a].shift < o->imm;
            r = rounded_shift(inverse[o->a].mantissa, inverse[o->a].shift - o->imm);
            break;
        default:
            r = rounded_shift(a, 2 * LOBE_Q_STEP * steps);
        }
        wide |= r != (int32_t)r;
        v[i] = r;
    }
    for (int i = 0; i < q->graph->outputs; i++)
        out[i] = (int32_t)v[q->output[i]];
    return wide;
}

static double magnitude(lobe_interval r) { return fabs(r.lo) > fabs(r.hi) ? fabs(r.lo) : fabs(r.hi); }

/* Each value is the real one, inside its range over the box, plus an error: the errors of its operands carried
 * along, plus its own rounding. Widened by a millionth for the doubles used here. Returns the first operation that
 * may leave 32 bits or breaks what was assumed of it, or -1. */
static int prove_box(const lobe_q_program *q, const lobe_box *box, const lobe_interval *node, double *error)
{
    static lobe_interval range[LOBE_NODES];
    static double relative[LOBE_NODES];
    const int steps = lobe_q_steps(q->steps, box->hi[0], box->hi[1]);
    int worst = -1;
    for (int i = 0; i < q->ops; i++) {
        const lobe_q_op *o = &q->op[i];
        const int a = o->a, b = o->b, is_const = q->graph->node[o->node].op == LOBE_OP_CONST;
        const double half = ldexp(0.5, -o->fraction);
        const int bits = o->kind == LOBE_Q_SCALED_LITERAL ? 2 * LOBE_Q_STEP * steps : LOBE_Q_STEP * o->degree * steps;
        const double ea = a >= 0 ? error[a] : 0.0, eb = b >= 0 ? error[b] : 0.0;
        double e = 0.0;
        range[i].lo = ldexp(node[o->node].lo, bits);
        range[i].hi = ldexp(node[o->node].hi, bits);
        switch (o->kind) {
        case LOBE_Q_LITERAL:
            e = fabs(ldexp((double)o->imm, -o->fraction) - node[o->node].lo);
            if (!is_const)
                e = 0.0; /* the zero of a negation */
            range[i].lo = range[i].hi = ldexp((double)o->imm, -o->fraction);
            break;
        case LOBE_Q_SCALED_LITERAL:
            e = 3.0 * half;
            break;
        case LOBE_Q_ADD:
        case LOBE_Q_SUB:
            e = ea + eb;
            break;
        case LOBE_Q_MUL:
            e = magnitude(range[a]) * eb + magnitude(range[b]) * ea + ea * eb + half;
            break;
        case LOBE_Q_SHIFT_RIGHT:
            e = ea + half;
            break;
        case LOBE_Q_MIN:
        case LOBE_Q_MAX:
            e = ea > eb ? ea : eb;
            break;
        case LOBE_Q_SHIFT_LEFT:
        case LOBE_Q_CLAMP:
            e = ea;
            break;
        case LOBE_Q_INVERSE:
            /* The relative error of the denominator, and of the reciprocal itself. Integers are at least 1. */
            relative[i] = range[a].lo - ea > 0.0 ? ea / (range[a].lo - ea) + 0x1p-30 : HUGE_VAL;
            error[i] = 0.0;
            continue;
        case LOBE_Q_RATIO:
        case LOBE_Q_QUOTIENT: {
            const lobe_q_op *inv = &q->op[b];
            const double d = range[inv->a].lo - error[inv->a];
            const double most = magnitude(node[o->node]);
            e = most * relative[b] + (o->kind == LOBE_Q_RATIO ? 0x1.8p-30 : half);
            if (range[a].hi == 0.0 && ea == 0.0)
                e = 0.0; /* 0 over anything, as core has it */
            else if (ea > 0.0)
                e += d > 0.0 ? ea / d : 1.0;
            if (o->kind == LOBE_Q_RATIO && e > 1.0)
                e = 1.0; /* both lie in [0, 1] */
            break;
        }
        case LOBE_Q_RESCALE:
            e = ldexp(ea, q->op[a].fraction - o->fraction);
            break;
        case LOBE_Q_LOG2:
            e = range[a].lo - ea > 0.0 ? 1.4427 * ea / (range[a].lo - ea) + LOBE_Q_LOG2_ERROR : HUGE_VAL;
            break;
        case LOBE_Q_RECIPROCAL: {
            /* shift = 30 + floor(log2 of the integer that is inverted), and must be at least imm. */
            const int d = q->op[a].a;
            e = magnitude(node[o->node]) * relative[a] + half;
            if ((range[d].lo - error[d]) * ldexp(1.0, q->op[d].fraction) < ldexp(1.0, o->imm - 30)) {
                worst = i;
            }
            break;
        }
        case LOBE_Q_UNSCALE:
            e = ldexp(ea, -2 * LOBE_Q_STEP * steps) + (steps ? half : 0.0);
            break;
        default:
            break;
        }
        /* 0 times or shifted by anything is 0 without an error. */
        if ((o->kind == LOBE_Q_MUL || o->kind == LOBE_Q_SHIFT_RIGHT) &&
            ((ea == 0.0 && range[a].lo == 0.0 && range[a].hi == 0.0) ||
             (b >= 0 && eb == 0.0 && range[b].lo == 0.0 && range[b].hi == 0.0)))
            e = 0.0;
        error[i] = e * (1.0 + 1e-6);
        if ((magnitude(range[i]) + error[i]) * ldexp(1.0, o->fraction) >= 2147483647.0) {
            worst = i;
        }
        if ((o->at_least_0 == LOBE_Q_BY_RANGE && range[i].lo < error[i]) ||
            (o->at_most_1 == LOBE_Q_BY_RANGE && range[i].hi + error[i] > 1.0)) {
            worst = i;
        }
    }
    return worst;
}

void lobe_q_prove(const lobe_q_program *q, lobe_q_proof *proof)
{
    static lobe_interval node[LOBE_NODES];
    static double error[LOBE_NODES];
    const double edge = 0.02 * 0x1p30;
    lobe_box box;
    proof->fits = 1;
    proof->worst = -1;
    for (int i = 0; i < q->graph->outputs; i++)
        proof->error[i] = proof->error_domain[i] = 0.0;
    for (int n = 0; lobe_box_at(n, &box); n++) {
        int worst = 0;
        for (int parts = 1; worst >= 0 && parts <= LOBE_RANGE_PARTS; parts *= 2)
            worst = lobe_range_box(q->graph, &box, parts, node) ? 0 : prove_box(q, &box, node, error);
        if (worst >= 0) {
            proof->fits = 0;
            proof->worst = worst;
            return;
        }
        for (int i = 0; i < q->graph->outputs; i++) {
            const double e = error[q->output[i]];
            if (e > proof->error[i])
                proof->error[i] = e;
            if (box.hi[0] >= edge && box.hi[1] >= edge && e > proof->error_domain[i])
                proof->error_domain[i] = e;
        }
    }
}
