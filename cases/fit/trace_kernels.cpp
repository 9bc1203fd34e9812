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

#if __has_include("../../models/coeffs/diffuse_sh_low.h")
#include "../../models/diffuse_sh.h"
#include "../../models/diffuse_zonal.h"
#endif

typedef lobe_dfg (*dfg_kernel)(lobe_real, lobe_real);
typedef lobe_real (*real_kernel)(lobe_real, lobe_real);
typedef lobe_sh9 (*sh9_kernel)(lobe_real, lobe_real);
typedef lobe_diffuse_shape (*shape_kernel)(lobe_real, lobe_real);
typedef lobe_zonal_shape (*zonal_kernel)(lobe_real, lobe_real);

struct kernel {
    const char *model, *tier;
    dfg_kernel dfg;
    real_kernel real;
    sh9_kernel sh9;
    shape_kernel shape;
    zonal_kernel zonal;
};

static const kernel kernels[] = {
#ifdef LOBE_SPLIT_SUM_LOW_C0
    {"split_sum", "low", lobe_split_sum_low, 0, 0, 0, 0},
#endif
#ifdef LOBE_SPLIT_SUM_MEDIUM_C0
    {"split_sum", "medium", lobe_split_sum_medium, 0, 0, 0, 0},
#endif
#ifdef LOBE_SPLIT_SUM_HIGH_C0
    {"split_sum", "high", lobe_split_sum_high, 0, 0, 0, 0},
#endif
#ifdef LOBE_SPLIT_SUM_SEP_LOW_C0
    {"split_sum_sep", "low", lobe_split_sum_sep_low, 0, 0, 0, 0},
#endif
#ifdef LOBE_SPLIT_SUM_SEP_MEDIUM_C0
    {"split_sum_sep", "medium", lobe_split_sum_sep_medium, 0, 0, 0, 0},
#endif
#ifdef LOBE_SPLIT_SUM_SEP_HIGH_C0
    {"split_sum_sep", "high", lobe_split_sum_sep_high, 0, 0, 0, 0},
#endif
#ifdef LOBE_ENERGY_LOW_C0
    {"energy", "low", 0, lobe_energy_low, 0, 0, 0},
#endif
#ifdef LOBE_ENERGY_MEDIUM_C0
    {"energy", "medium", 0, lobe_energy_medium, 0, 0, 0},
#endif
#ifdef LOBE_ENERGY_HIGH_C0
    {"energy", "high", 0, lobe_energy_high, 0, 0, 0},
#endif
#ifdef LOBE_DIFFUSE_SH_LOW_C0
    {"diffuse_sh", "exact", 0, 0, lobe_diffuse_sh_exact, 0, 0},
    {"diffuse_sh", "medium", 0, 0, lobe_diffuse_sh_medium, 0, 0},
    {"diffuse_sh", "low", 0, 0, lobe_diffuse_sh_low, 0, 0},
    {"diffuse_sh", "zonal", 0, 0, lobe_diffuse_sh_zonal, 0, 0},
    {"diffuse_sh", "zonal_low", 0, 0, lobe_diffuse_sh_zonal_low, 0, 0},
    /* What of these is emitted as integers; the rest of the way is models/q30/diffuse_sh.h. */
    {"diffuse_shape", "exact", 0, 0, 0, lobe_diffuse_shape_exact, 0},
    {"diffuse_shape", "medium", 0, 0, 0, lobe_diffuse_shape_medium, 0},
    {"diffuse_shape", "low", 0, 0, 0, lobe_diffuse_shape_low, 0},
    {"diffuse_shape", "zonal", 0, 0, 0, 0, lobe_diffuse_zonal_shape},
    {"diffuse_shape", "zonal_low", 0, 0, 0, 0, lobe_diffuse_zonal_shape_low},
#endif
};

static void output(lobe_graph *g, const char *name, const lobe_real &x)
{
    g->output[g->outputs] = x.id;
    g->output_name[g->outputs++] = name;
}

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
        output(g, "scale", d.scale);
        output(g, "bias", d.bias);
    } else if (k->real) {
        output(g, "energy", k->real(roughness, n_dot_v));
    } else if (k->sh9) {
        const lobe_sh9 c = k->sh9(roughness, n_dot_v);
        const lobe_real all[9] = {c.c0, c.c1, c.c2, c.c3, c.c4, c.c5, c.c6, c.c7, c.c8};
        static const char *const names[9] = {"c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7", "c8"};
        for (int j = 0; j < 9; j++)
            output(g, names[j], all[j]);
    } else if (k->shape) {
        const lobe_diffuse_shape s = k->shape(roughness, n_dot_v);
        output(g, "c00", s.c00);
        output(g, "c1n", s.c1n);
        output(g, "c1t", s.c1t);
        output(g, "c2n", s.c2n);
        output(g, "c2t", s.c2t);
        output(g, "c2tt", s.c2tt);
    } else {
        const lobe_zonal_shape s = k->zonal(roughness, n_dot_v);
        output(g, "z0", s.z0);
        output(g, "z1", s.z1);
        output(g, "z2", s.z2);
        output(g, "beta", s.beta);
    }
    lobe_graph_prune(g);
    return 1;
}
