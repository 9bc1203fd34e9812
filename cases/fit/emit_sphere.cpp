/* The operations of a sphere light's tiers beyond a punctual light. Clamps of the inputs are left out of both: the
 * punctual light needs fewer, and a caller that knows its inputs pays none. */
#include "emit.h"

#include <string.h>

#include "trace_sphere.h"

#include "../../models/sphere_light_high.h"

typedef lobe_real (*sphere_kernel)(lobe_real, lobe_sphere);

static lobe_graph graph;

/* A minimum or maximum of a constant and an input, or of a constant and such a one. */
static int clamps(const lobe_graph *g)
{
    static int input[LOBE_NODES];
    int count = 0;
    for (int i = 0; i < g->nodes; i++) {
        const lobe_node *n = &g->node[i];
        input[i] = n->op == LOBE_OP_INPUT;
        if (n->op != LOBE_OP_MIN && n->op != LOBE_OP_MAX)
            continue;
        for (int k = 0; k < 2; k++)
            if (input[n->arg[k]] && g->node[n->arg[1 - k]].op == LOBE_OP_CONST)
                input[i] = 1;
        count += input[i];
    }
    return count;
}

lobe_sphere_inputs lobe_sphere_trace_begin(lobe_graph *g)
{
    lobe_sphere_inputs in;
    lobe_graph_begin(g);
    in.roughness = lobe_input(0);
    in.light.n_dot_v = lobe_input(1);
    in.light.n_dot_l = lobe_input(2);
    in.light.tangent2 = lobe_input(3);
    in.light.sine = lobe_input(4);
    in.light.versine = lobe_input(5);
    return in;
}

lobe_op_count lobe_sphere_trace_end(lobe_graph *g)
{
    lobe_graph_prune(g);
    lobe_op_count count = lobe_graph_count(g);
    count.fused -= clamps(g);
    count.plain -= clamps(g);
    return count;
}

static lobe_op_count count_of(sphere_kernel kernel)
{
    const lobe_sphere_inputs in = lobe_sphere_trace_begin(&graph);
    graph.output[graph.outputs++] = kernel(in.roughness, in.light).id;
    return lobe_sphere_trace_end(&graph);
}

int lobe_emit_count_sphere(const char *tier, lobe_op_count *count)
{
    static const struct {
        const char *tier;
        sphere_kernel kernel;
    } tiers[] = {
        {"low", lobe_sphere_light_low}, {"medium", lobe_sphere_light_medium}, {"high", lobe_sphere_light_high}};
    for (size_t i = 0; i < sizeof tiers / sizeof tiers[0]; i++) {
        if (strcmp(tiers[i].tier, tier) != 0)
            continue;
        const lobe_op_count punctual = count_of(lobe_sphere_light_punctual);
        *count = count_of(tiers[i].kernel);
        count->fused -= punctual.fused;
        count->plain -= punctual.plain;
        return 0;
    }
    return 2;
}

static lobe_op_count count_of_lit(void)
{
    const lobe_sphere_inputs in = lobe_sphere_trace_begin(&graph);
    const lobe_sphere_lit lit = lobe_sphere_light_high_lit(in.roughness, in.light);
    graph.output[graph.outputs++] = lit.radiance.id;
    graph.output[graph.outputs++] = lit.schlick.id;
    return lobe_sphere_trace_end(&graph);
}

int lobe_emit_count_sphere_schlick(const char *tier, lobe_op_count *count)
{
    if (strcmp(tier, "low") == 0) {
        *count = count_of(lobe_sphere_light_schlick);
        return 0;
    }
    if (strcmp(tier, "high") == 0) {
        const lobe_op_count alone = count_of(lobe_sphere_light_high);
        *count = count_of_lit();
        count->fused -= alone.fused;
        count->plain -= alone.plain;
        return 0;
    }
    return 2;
}
