#include "trace.h"

#include <math.h>
#include <string.h>

lobe_graph *lobe_tracing;

void lobe_graph_begin(lobe_graph *g)
{
    memset(g, 0, sizeof *g);
    lobe_tracing = g;
}

int lobe_op_arity(int op)
{
    switch (op) {
    case LOBE_OP_INPUT:
    case LOBE_OP_CONST:
        return 0;
    case LOBE_OP_SATURATE:
    case LOBE_OP_NEGATE:
    case LOBE_OP_EXP2:
    case LOBE_OP_LOG2:
    case LOBE_OP_SQRT:
        return 1;
    case LOBE_OP_SELECT:
        return 3;
    default:
        return 2;
    }
}

int lobe_graph_add(int op, int a, int b, int c, double value, int input)
{
    lobe_graph *g = lobe_tracing;
    /* a + b and b + a are one node: IEEE addition and multiplication commute. */
    if ((op == LOBE_OP_ADD || op == LOBE_OP_MUL) && a > b) {
        const int t = a;
        a = b;
        b = t;
    }
    for (int i = 0; i < g->nodes; i++) {
        const lobe_node *n = &g->node[i];
        if (n->op == op && n->arg[0] == a && n->arg[1] == b && n->arg[2] == c && n->input == input &&
            memcmp(&n->value, &value, sizeof value) == 0)
            return i;
    }
    if (g->nodes == LOBE_NODES) {
        fprintf(stderr, "trace: a formula has more than %d operations\n", (int)LOBE_NODES);
        return 0;
    }
    lobe_node *n = &g->node[g->nodes];
    n->op = op;
    n->arg[0] = a;
    n->arg[1] = b;
    n->arg[2] = c;
    n->value = value;
    n->input = input;
    return g->nodes++;
}

void lobe_graph_uses(const lobe_graph *g, int *uses)
{
    for (int i = 0; i < g->nodes; i++)
        uses[i] = 0;
    for (int i = 0; i < g->outputs; i++)
        uses[g->output[i]]++;
    for (int i = 0; i < g->nodes; i++)
        for (int k = 0; k < lobe_op_arity(g->node[i].op); k++)
            uses[g->node[i].arg[k]]++;
}

void lobe_graph_prune(lobe_graph *g)
{
    static int where[LOBE_NODES];
    int kept = 0;
    for (int i = 0; i < g->nodes; i++)
        where[i] = -1;
    for (int i = 0; i < g->outputs; i++)
        where[g->output[i]] = 0;
    for (int i = g->nodes - 1; i >= 0; i--)
        for (int k = 0; where[i] >= 0 && k < lobe_op_arity(g->node[i].op); k++)
            where[g->node[i].arg[k]] = 0;
    for (int i = 0; i < g->nodes; i++) {
        if (where[i] < 0)
            continue;
        lobe_node n = g->node[i];
        for (int k = 0; k < lobe_op_arity(n.op); k++)
            n.arg[k] = where[n.arg[k]];
        where[i] = kept;
        g->node[kept++] = n;
    }
    for (int i = 0; i < g->outputs; i++)
        g->output[i] = where[g->output[i]];
    g->nodes = kept;
}

void lobe_graph_eval(const lobe_graph *g, const double *in, double *v)
{
    for (int i = 0; i < g->nodes; i++) {
        const lobe_node *n = &g->node[i];
        const double a = n->arg[0] >= 0 ? v[n->arg[0]] : 0.0;
        const double b = n->arg[1] >= 0 ? v[n->arg[1]] : 0.0;
        switch (n->op) {
        case LOBE_OP_INPUT:
            v[i] = in[n->input];
            break;
        case LOBE_OP_CONST:
            v[i] = n->value;
            break;
        case LOBE_OP_ADD:
            v[i] = a + b;
            break;
        case LOBE_OP_SUB:
            v[i] = a - b;
            break;
        case LOBE_OP_MUL:
            v[i] = a * b;
            break;
        case LOBE_OP_DIV:
            v[i] = a / b;
            break;
        case LOBE_OP_MIN:
            v[i] = a < b ? a : b;
            break;
        case LOBE_OP_MAX:
            v[i] = a > b ? a : b;
            break;
        case LOBE_OP_SATURATE:
            v[i] = a > 0.0 ? (a < 1.0 ? a : 1.0) : 0.0;
            break;
        case LOBE_OP_NEGATE:
            v[i] = -a;
            break;
        case LOBE_OP_SELECT:
            v[i] = a > 0.0 ? b : v[n->arg[2]];
            break;
        case LOBE_OP_EXP2:
            v[i] = exp2(a);
            break;
        case LOBE_OP_LOG2:
            v[i] = log2(a);
            break;
        default:
            v[i] = sqrt(a);
        }
    }
}

/* The convention: add, subtract, multiply, fused multiply-add, min, max and select cost 1; exp2, log2, sqrt and
 * reciprocal 4; saturate and negation are modifiers and cost nothing. Divisions by one denominator share its
 * reciprocal, so each further one costs its multiplication. What has only constants in it costs nothing. */
lobe_op_count lobe_graph_count(const lobe_graph *g)
{
    static int uses[LOBE_NODES], constant[LOBE_NODES], divided[LOBE_NODES];
    lobe_op_count count = {0, 0};
    lobe_graph_uses(g, uses);
    for (int i = 0; i < g->nodes; i++) {
        const lobe_node *n = &g->node[i];
        constant[i] = n->op != LOBE_OP_INPUT;
        divided[i] = 0;
        for (int k = 0; k < lobe_op_arity(n->op); k++)
            constant[i] &= constant[n->arg[k]];
        if (n->op == LOBE_OP_DIV && !constant[n->arg[1]])
            divided[n->arg[1]]++;
    }
    for (int i = 0; i < g->nodes; i++) {
        const lobe_node *n = &g->node[i];
        if (constant[i])
            continue;
        switch (n->op) {
        case LOBE_OP_INPUT:
        case LOBE_OP_SATURATE:
        case LOBE_OP_NEGATE:
            break;
        case LOBE_OP_EXP2:
        case LOBE_OP_LOG2:
        case LOBE_OP_SQRT:
            count.plain += 4;
            count.fused += 4;
            break;
        case LOBE_OP_DIV: {
            const int d = n->arg[1];
            const int unit = g->node[n->arg[0]].op == LOBE_OP_CONST && g->node[n->arg[0]].value == 1.0;
            int cost = unit ? 0 : 1; /* the product with a reciprocal that is there */
            if (divided[d] == 1)
                cost = 4;
            else if (divided[d] > 1) {
                cost += 4;
                divided[d] = -1;
            }
            count.plain += cost;
            count.fused += cost;
            break;
        }
        case LOBE_OP_ADD:
        case LOBE_OP_SUB: {
            count.plain++;
            count.fused++;
            /* One product of the two may disappear into this addition. */
            for (int k = 0; k < 2; k++) {
                const int m = n->arg[k];
                if (g->node[m].op == LOBE_OP_MUL && uses[m] == 1 && !constant[m]) {
                    count.fused--;
                    break;
                }
            }
            break;
        }
        default:
            count.plain++;
            count.fused++;
        }
    }
    return count;
}
