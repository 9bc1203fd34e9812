#include "operations.h"

#include "../fit/trace.h"

#define LOBE_TRACE 1
#include "../../models/env_lobes_table.h"
#include "../../models/env_taps.h"

static lobe_graph graph;

static void put(lobe_env_tap t)
{
    graph.output[graph.outputs++] = t.angle.id;
    graph.output[graph.outputs++] = t.width.id;
    graph.output[graph.outputs++] = t.weight.id;
}
template <class fan> static void put2(const fan &f) { put(f.t0), put(f.t1); }
template <class fan> static void put4(const fan &f) { put2(f), put(f.t2), put(f.t3); }
template <class fan> static void put8(const fan &f) { put4(f), put(f.t4), put(f.t5), put(f.t6), put(f.t7); }

static bool record(int gaussian, int lobes, lobe_real r, lobe_real v, lobe_real e)
{
    switch (lobes + (gaussian ? 100 : 0)) {
    case 1:
        return put(lobe_env_lobes_lobes1(r, v, e)), true;
    case 2:
        return put2(lobe_env_lobes_lobes2(r, v, e)), true;
    case 4:
        return put4(lobe_env_lobes_lobes4(r, v, e)), true;
    case 8:
        return put8(lobe_env_lobes_lobes8(r, v, e)), true;
    case 101:
        return put(lobe_env_lobes_sg_lobes1(r, v, e)), true;
    case 102:
        return put2(lobe_env_lobes_sg_lobes2(r, v, e)), true;
    case 104:
        return put4(lobe_env_lobes_sg_lobes4(r, v, e)), true;
    case 108:
        return put8(lobe_env_lobes_sg_lobes8(r, v, e)), true;
    default:
        return false;
    }
}

int lobe_env_operations(int gaussian, int lobes)
{
    lobe_graph_begin(&graph);
    const lobe_real r = lobe_input(0), v = lobe_input(1), e = lobe_input(2);
    if (!record(gaussian, lobes, r, v, e))
        return -1;
    lobe_graph_prune(&graph);
    return lobe_graph_count(&graph).fused;
}

int lobe_env_adaptive_operations(void)
{
    lobe_graph_begin(&graph);
    const lobe_real r = lobe_input(0), v = lobe_input(1), e = lobe_input(2);
    const lobe_env_fan6 fan = lobe_env_adaptive_fan(r, v, e);
    put4(fan), put(fan.t4), put(fan.t5);
    graph.output[graph.outputs++] = lobe_env_adaptive_count(r, v).id;
    lobe_graph_prune(&graph);
    return lobe_graph_count(&graph).fused;
}

int lobe_env_table_operations(int lobes)
{
    int input = 3;
    lobe_graph_begin(&graph);
    const lobe_real r = lobe_input(0), v = lobe_input(1), e = lobe_input(2);
    const lobe_table_uv at = lobe_split_sum_table_texel(r, v, 15.0);
    const lobe_real row = lobe_input(input++), column = lobe_input(input++); /* whole parts of what stands above */
    const lobe_env_table_parts parts = lobe_env_table_parts_of(at.v - row, at.u - column);
    const lobe_env_table_scales scales = lobe_env_table_scales_of(r, v, e, 1.0);
    lobe_real rest = e;
    for (int i = 0; i < lobes; i++) {
        lobe_real number[3], weight = rest;
        for (int k = 0; k < (i < lobes - 1 ? 3 : 2); k++, input += 4)
            number[k] = lobe_env_table_between(parts, lobe_input(input), lobe_input(input + 1), lobe_input(input + 2),
                                               lobe_input(input + 3));
        if (i < lobes - 1) {
            weight = scales.weight * number[2];
            rest = rest - weight;
        }
        put(lobe_env_table_tap(scales, number[0], number[1], weight));
    }
    lobe_graph_prune(&graph);
    return lobe_graph_count(&graph).fused;
}
