/* Every kernel that ships, recorded. A tier exists where its header of coefficients does. */
#include "trace.h"

#include <string.h>

#define LOBE_TRACE 1
#include "../../models/split_sum.h"
#if __has_include("../../models/coeffs/split_sum_sep_low.h")
#include "../../models/split_sum_sep.h"
#endif
#if __has_include("../../models/coeffs/energy_low.h")
#include "../../models/energy.h"
#endif

typedef lobe_dfg (*dfg_kernel)(lobe_real, lobe_real);
typedef lobe_real (*real_kernel)(lobe_real, lobe_real);

struct kernel {
    const char *model, *tier;
    dfg_kernel dfg;
    real_kernel real;
};

static const kernel kernels[] = {
#ifdef LOBE_SPLIT_SUM_LOW_C0
    {"split_sum", "low", lobe_split_sum_low, 0},
#endif
#ifdef LOBE_SPLIT_SUM_MEDIUM_C0
    {"split_sum", "medium", lobe_split_sum_medium, 0},
#endif
#ifdef LOBE_SPLIT_SUM_HIGH_C0
    {"split_sum", "high", lobe_split_sum_high, 0},
#endif
#ifdef LOBE_SPLIT_SUM_SEP_LOW_C0
    {"split_sum_sep", "low", lobe_split_sum_sep_low, 0},
#endif
#ifdef LOBE_SPLIT_SUM_SEP_MEDIUM_C0
    {"split_sum_sep", "medium", lobe_split_sum_sep_medium, 0},
#endif
#ifdef LOBE_SPLIT_SUM_SEP_HIGH_C0
    {"split_sum_sep", "high", lobe_split_sum_sep_high, 0},
#endif
#ifdef LOBE_ENERGY_LOW_C0
    {"energy", "low", 0, lobe_energy_low},
#endif
#ifdef LOBE_ENERGY_MEDIUM_C0
    {"energy", "medium", 0, lobe_energy_medium},
#endif
#ifdef LOBE_ENERGY_HIGH_C0
    {"energy", "high", 0, lobe_energy_high},
#endif
};

int lobe_kernel_trace(int i, lobe_graph *g)
{
    if (i < 0 || i >= (int)(sizeof kernels / sizeof kernels[0]))
        return 0;
    const kernel *k = &kernels[i];
    lobe_graph_begin(g);
    g->model = k->model;
    g->tier = k->tier;
    g->input_name[0] = "roughness";
    g->input_name[1] = "n_dot_v";
    const lobe_real roughness = lobe_input(0), n_dot_v = lobe_input(1);
    if (k->dfg) {
        const lobe_dfg d = k->dfg(roughness, n_dot_v);
        g->output[0] = d.scale.id;
        g->output[1] = d.bias.id;
        g->output_name[0] = "scale";
        g->output_name[1] = "bias";
        g->outputs = 2;
    } else {
        g->output[0] = k->real(roughness, n_dot_v).id;
        g->output_name[0] = "energy";
        g->outputs = 1;
    }
    lobe_graph_prune(g);
    return 1;
}
