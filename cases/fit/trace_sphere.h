/* Operations of a kernel of a sphere light: its graph, the clamps of its inputs left out. */
#ifndef LOBE_TRACE_SPHERE_H
#define LOBE_TRACE_SPHERE_H
#include "trace.h"

#define LOBE_TRACE 1
#include "../../models/sphere_light.h"

/* roughness and the light's five numbers as inputs of a graph that begins; it is the one that is recorded into. */
struct lobe_sphere_inputs {
    lobe_real roughness;
    lobe_sphere light;
};
lobe_sphere_inputs lobe_sphere_trace_begin(lobe_graph *g);

/* Ends it and counts. */
lobe_op_count lobe_sphere_trace_end(lobe_graph *g);

#endif
