#include "operations.h"

#include <string.h>

#include "../fit/trace_sphere.h"

#include "../../models/sg_diffuse.h"
#include "../../models/sg_light_high.h"

#include "peers.h"

static lobe_graph graph;

typedef lobe_real kernel(lobe_real roughness, lobe_sg light);

static lobe_real point(lobe_real roughness, lobe_sg s)
{
    lobe_sphere light;
    light.n_dot_v = s.n_dot_v;
    light.n_dot_l = s.n_dot_l;
    light.tangent2 = s.tangent2;
    light.sine = s.versine;
    light.versine = s.versine;
    return lobe_sphere_light_punctual(roughness, light);
}

static int count_of(kernel *f)
{
    lobe_graph_begin(&graph);
    const lobe_real roughness = lobe_input(0);
    lobe_sg light;
    light.n_dot_v = lobe_input(1);
    light.n_dot_l = lobe_input(2);
    light.tangent2 = lobe_input(3);
    light.versine = lobe_input(4);
    const lobe_real radiance = f(roughness, light);
    graph.output[graph.outputs++] = radiance.id;
    return lobe_sphere_trace_end(&graph).fused;
}

int lobe_sg_operations(const char *name)
{
    static const struct {
        const char *name;
        kernel *f;
    } counted[] = {{"point", point},
                   {"SG warp", lobe_peer_sg_warp},
                   {"ASG warp", lobe_peer_asg_warp},
                   {"ASG warp refitted", lobe_peer_asg_refitted},
                   {"low", lobe_sg_light_low},
                   {"medium", lobe_sg_light_medium},
                   {"high", lobe_sg_light_high}};
    for (size_t i = 0; i < sizeof counted / sizeof counted[0]; i++)
        if (strcmp(counted[i].name, name) == 0)
            return count_of(counted[i].f) - count_of(point);
    return -1;
}

int lobe_sg_diffuse_operations(const char *tier)
{
    lobe_graph_begin(&graph);
    const lobe_real n_dot_l = lobe_input(0), versine = lobe_input(1);
    const lobe_real y =
        strcmp(tier, "high") == 0 ? lobe_sg_diffuse_high(n_dot_l, versine) : lobe_sg_diffuse_inner(n_dot_l, versine);
    graph.output[graph.outputs++] = y.id;
    return lobe_sphere_trace_end(&graph).fused;
}
