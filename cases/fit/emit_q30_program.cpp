/* Appending to an integer program, with what the form of each operation proves about its sign and size. */
#include "emit_q30.h"

#include <string.h>

int lobe_q_push(lobe_q_program *program, int kind, int a, int b, int imm, int fraction, int node, int scaled)
{
    lobe_q_op *o = &program->op[program->ops];
    if (program->ops >= LOBE_NODES - 1) {
        return -1;
    }
    memset(o, 0, sizeof *o);
    o->kind = kind;
    o->a = a;
    o->b = b;
    o->imm = imm;
    o->fraction = fraction;
    o->node = node;
    o->degree = scaled ? program->plan.degree[node] : 0;
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
        if (!o->at_least_0 && program->plan.range[node].lo > 0x1p-10)
            o->at_least_0 = LOBE_Q_BY_RANGE;
        if (!o->at_most_1 && program->plan.range[node].hi < 1.0 - 0x1p-10)
            o->at_most_1 = LOBE_Q_BY_RANGE;
    }
    for (int i = 0; i < program->ops; i++)
        if (!memcmp(&program->op[i], o, sizeof *o))
            return i;
    return program->ops++;
}

void lobe_q_drop_unused(lobe_q_program *program)
{
    static int where[LOBE_NODES];
    int kept = 0;
    for (int i = 0; i < program->ops; i++)
        where[i] = -1;
    for (int i = 0; i < program->graph->outputs; i++)
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
    for (int i = 0; i < program->graph->outputs; i++)
        program->output[i] = where[program->output[i]];
    program->ops = kept;
}
