#include "emit.h"

#include <string.h>

#include "emit_q30.h"
#include "trace.h"

static lobe_graph graph;

static int find(const char *model, const char *tier)
{
    if (graph.model && !strcmp(graph.model, model) && !strcmp(graph.tier, tier))
        return 1; /* the one recorded last */
    for (int i = 0; lobe_kernel_trace(i, &graph); i++)
        if (!strcmp(graph.model, model) && !strcmp(graph.tier, tier))
            return 1;
    return 0;
}

/* What stands in integers for a case: of diffuse_sh its shape, with the root left to models/q30/diffuse_sh.h. */
static const char *model_q30(const char *model) { return strcmp(model, "diffuse_sh") ? model : "diffuse_shape"; }

int lobe_emit(const char *model, const char *tier, const char *language, FILE *out)
{
    if (!find(model, tier)) {
        fprintf(stderr, "emit: no formula for model %s tier %s; there are:", model, tier);
        for (int i = 0; lobe_kernel_trace(i, &graph); i++)
            fprintf(stderr, " %s:%s", graph.model, graph.tier);
        fprintf(stderr, "\n");
        return 2;
    }
    if (!strcmp(language, "q30") && find(model_q30(model), tier))
        return lobe_q_text(&graph, out);
    if (lobe_graph_text(&graph, language, out)) {
        fprintf(stderr, "emit: unknown language %s; known: c q30 cl glsl es hlsl fpcore\n", language);
        return 2;
    }
    return 0;
}

int lobe_emit_ops(FILE *out)
{
    fprintf(out, "# model tier operations operations_without_fma\n");
    for (int i = 0; lobe_kernel_trace(i, &graph); i++) {
        const lobe_op_count count = lobe_graph_count(&graph);
        fprintf(out, "%s %s %d %d\n", graph.model, graph.tier, count.fused, count.plain);
    }
    return 0;
}

int lobe_emit_count(const char *model, const char *tier, lobe_op_count *count)
{
    if (!find(model, tier))
        return 2;
    *count = lobe_graph_count(&graph);
    return 0;
}

int lobe_emit_value(const char *model, const char *tier, const double *in, double *out)
{
    static double value[LOBE_NODES];
    if (!find(model, tier))
        return 0;
    lobe_graph_eval(&graph, in, value);
    for (int i = 0; i < graph.outputs; i++)
        out[i] = value[graph.output[i]];
    return graph.outputs;
}

int lobe_emit_value_q30(const char *model, const char *tier, const int32_t *in, int32_t *out)
{
    /* Choosing scales takes a second: keep the last program. */
    static lobe_q_program program;
    static lobe_graph compiled;
    if (!compiled.model || strcmp(compiled.model, model) != 0 || strcmp(compiled.tier, tier) != 0) {
        if (!find(model, tier))
            return 0;
        compiled = graph;
        lobe_q_proof proof;
        if (lobe_q_compile(&compiled, &program, &proof)) {
            compiled.model = 0;
            return 0;
        }
    }
    return lobe_q_run(&program, in, out) ? -1 : compiled.outputs;
}

int lobe_emit_list(int i, const char **model, const char **tier)
{
    if (!lobe_kernel_trace(i, &graph))
        return 2;
    *model = graph.model;
    *tier = graph.tier;
    return 0;
}
