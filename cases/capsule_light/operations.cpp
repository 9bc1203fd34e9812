#include "operations.h"

#include <string.h>

#include "../fit/trace_sphere.h"

#include "../../models/capsule_light_high.h"
#include "peers.h"

static lobe_graph graph;

typedef lobe_real kernel(lobe_real roughness, lobe_capsule light);

static lobe_real point(lobe_real r, lobe_capsule c) { return lobe_peer_capsule_point(r, c); }
static lobe_real karis(lobe_real r, lobe_capsule c) { return lobe_peer_capsule_karis(r, c, lobe_real(1.0 / 3)); }

/* The inputs of a graph that trace_sphere.h begins are as many as a sphere has; the capsule's follow them. */
static int count_of(kernel *k)
{
    const lobe_sphere_inputs in = lobe_sphere_trace_begin(&graph);
    lobe_real x[7];
    for (int i = 0; i < 7; i++)
        x[i] = lobe_input(6 + i);
    const lobe_capsule c = lobe_capsule_of(in.light.n_dot_v, x[0], x[1], x[2], x[3], x[4], x[5], x[6]);
    graph.output[graph.outputs++] = k(in.roughness, c).id;
    return lobe_sphere_trace_end(&graph).fused;
}

static int punctual()
{
    const lobe_sphere_inputs in = lobe_sphere_trace_begin(&graph);
    graph.output[graph.outputs++] = lobe_sphere_light_punctual(in.roughness, in.light).id;
    return lobe_sphere_trace_end(&graph).fused;
}

int lobe_capsule_operations(const char *name)
{
    static const struct {
        const char *name;
        kernel *call;
    } known[] = {{"point", point},
                 {"Karis 1/2", karis},
                 {"Karis 1/3", karis},
                 {"low", lobe_capsule_light_low},
                 {"medium", lobe_capsule_light_medium},
                 {"high", lobe_capsule_light_high}};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        if (strcmp(known[i].name, name) == 0)
            return count_of(known[i].call) - punctual();
    return -1;
}
