/* Stands in for trace_kernels.cpp, so that everything behind it can be tried on other formulas. */
#define LOBE_TRACE 1
#include "../fit/trace.h"

#include "emit_kernels.h"

int lobe_kernel_trace(int i, lobe_graph *g)
{
    static const char *const tiers[] = {"medium", "high", "inverse"};
    if (i < 0 || i > 2)
        return 0;
    lobe_graph_begin(g);
    g->model = "try";
    g->tier = tiers[i];
    g->input_name[0] = "roughness";
    g->input_name[1] = "n_dot_v";
    const lobe_real roughness = lobe_input(0), n_dot_v = lobe_input(1);
    if (i == 2) {
        g->output[0] = lobe_try_inverse(roughness, n_dot_v).id;
        g->output_name[0] = "energy";
        g->outputs = 1;
    } else {
        const lobe_dfg d = i ? lobe_try_high(roughness, n_dot_v) : lobe_try_medium(roughness, n_dot_v);
        g->output[0] = d.scale.id;
        g->output[1] = d.bias.id;
        g->output_name[0] = "scale";
        g->output_name[1] = "bias";
        g->outputs = 2;
    }
    lobe_graph_prune(g);
    return 1;
}
