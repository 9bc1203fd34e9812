/* What the tiers of sphere_diffuse cost. They are not in the list of what is emitted: their integers are by hand. */
#include "trace.h"

#include <string.h>

#define LOBE_TRACE 1
#include "../../models/sphere_diffuse.h"

int lobe_emit_count_sphere_diffuse(const char *tier, lobe_op_count *count)
{
    static const struct {
        const char *tier;
        lobe_real (*call)(lobe_real, lobe_real);
    } kernels[] = {
        {"low", lobe_sphere_diffuse_low}, {"medium", lobe_sphere_diffuse_medium}, {"exact", lobe_sphere_diffuse_exact}};
    static lobe_graph graph;
    for (unsigned i = 0; i < sizeof kernels / sizeof kernels[0]; i++) {
        if (strcmp(kernels[i].tier, tier) != 0)
            continue;
        lobe_graph_begin(&graph);
        const lobe_real n_dot_l = lobe_input(0), sine = lobe_input(1);
        graph.output[0] = kernels[i].call(n_dot_l, sine).id;
        graph.outputs = 1;
        lobe_graph_prune(&graph);
        *count = lobe_graph_count(&graph);
        return 0;
    }
    return 2;
}
