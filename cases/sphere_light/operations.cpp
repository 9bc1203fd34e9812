#include "operations.h"

#include <string.h>

#include "../fit/trace_sphere.h"

#include "peers.h"
#include "peers_fitted.h"
#include "peers_ltc.h"
#include "peers_vector.h"

static lobe_graph graph;

typedef lobe_real kernel(const lobe_real &roughness, const lobe_sphere &light);

static lobe_real point(const lobe_real &r, const lobe_sphere &s) { return lobe_sphere_light_punctual(r, s); }
static lobe_real karis(const lobe_real &r, const lobe_sphere &s) { return lobe_peer_karis(r, s, 1.0 / 3); }
static lobe_real smooth_printed(const lobe_real &r, const lobe_sphere &s)
{
    return lobe_peer_smooth_point(r, s, .962406, .375892, .962406);
}
static lobe_real smooth_refitted(const lobe_real &r, const lobe_sphere &s)
{
    return lobe_peer_smooth_point(r, s, LOBE_PEER_SMOOTH_POINT);
}
static lobe_real wider(const lobe_real &r, const lobe_sphere &s) { return lobe_peer_wider(r, s, LOBE_PEER_WIDER); }
static lobe_real wider_capped(const lobe_real &r, const lobe_sphere &s)
{
    return lobe_peer_wider_capped(r, s, LOBE_PEER_WIDER_CAPPED);
}
static lobe_real capped_point(const lobe_real &r, const lobe_sphere &s)
{
    return lobe_peer_capped_point(r, s, LOBE_PEER_CAPPED_POINT);
}

/* What the fetches return is input; where they go is output. The last one's answer is a factor. */
static lobe_real ltc(const lobe_real &r, const lobe_sphere &s)
{
    const lobe_peer_ltc_place place = lobe_peer_ltc_place_of(r, s);
    graph.output[graph.outputs++] = place.x.id;
    graph.output[graph.outputs++] = place.y.id;
    lobe_peer_ltc_cell cell;
    cell.inv11 = lobe_input(6);
    cell.inv13 = lobe_input(7);
    cell.inv31 = lobe_input(8);
    cell.inv33 = lobe_input(9);
    cell.albedo = lobe_input(10);
    const lobe_peer_ltc_factor factor = lobe_peer_ltc_factor_of(cell, s);
    graph.output[graph.outputs++] = factor.length.id;
    graph.output[graph.outputs++] = factor.height.id;
    return factor.radiance * lobe_input(11);
}

static int count_of(kernel *f)
{
    const lobe_sphere_inputs in = lobe_sphere_trace_begin(&graph);
    const lobe_real radiance = f(in.roughness, in.light);
    graph.output[graph.outputs++] = radiance.id;
    return lobe_sphere_trace_end(&graph).fused;
}

/* The same from vectors. */
typedef lobe_real vector_kernel(const lobe_real &roughness, const lobe_peer_scene &scene);

static lobe_real point_vector(const lobe_real &r, const lobe_peer_scene &s)
{
    return lobe_sphere_light_punctual(r, lobe_peer_seen(s));
}
static lobe_real karis_vector(const lobe_real &r, const lobe_peer_scene &s)
{
    return lobe_peer_karis_vector(r, s, 1.0 / 3);
}
static lobe_real smooth_printed_vector(const lobe_real &r, const lobe_peer_scene &s)
{
    return lobe_peer_smooth_point_vector(r, s, .962406, .375892, .962406);
}
static lobe_real smooth_refitted_vector(const lobe_real &r, const lobe_peer_scene &s)
{
    return lobe_peer_smooth_point_vector(r, s, LOBE_PEER_SMOOTH_POINT);
}
static lobe_real capped_point_vector(const lobe_real &r, const lobe_peer_scene &s)
{
    return lobe_peer_capped_point_vector(r, s, LOBE_PEER_CAPPED_POINT);
}

static lobe_vec3 vector_input(int i)
{
    lobe_vec3 v;
    v.x = lobe_input(i);
    v.y = lobe_input(i + 1);
    v.z = lobe_input(i + 2);
    return v;
}

static int count_of_vector(vector_kernel *f)
{
    lobe_graph_begin(&graph);
    const lobe_real roughness = lobe_input(0);
    lobe_peer_scene s;
    s.normal = vector_input(1);
    s.view = vector_input(4);
    s.light = vector_input(7);
    s.sine = lobe_input(10);
    s.versine = lobe_input(11);
    const lobe_real radiance = f(roughness, s);
    graph.output[graph.outputs++] = radiance.id;
    return lobe_sphere_trace_end(&graph).fused;
}

int lobe_sphere_operations(const char *name)
{
    static const struct {
        const char *name;
        kernel *f;
        vector_kernel *vector; /* null: not in vectors */
    } counted[] = {
        {"point", point, 0},
        {"Karis 1/2", karis, karis_vector},
        {"Karis 1/3", karis, karis_vector},
        {"smoothed point as printed", smooth_printed, smooth_printed_vector},
        {"smoothed point refitted", smooth_refitted, smooth_refitted_vector},
        {"wider lobe", wider, 0},
        {"wider lobe capped", wider_capped, 0},
        {"capped point", capped_point, capped_point_vector},
        {"LTC round cone clip", ltc, 0},
    };
    lobe_op_count tier;
    if (lobe_emit_count_sphere(name, &tier) == 0)
        return tier.fused;
    for (size_t i = 0; i < sizeof counted / sizeof counted[0]; i++) {
        if (strcmp(counted[i].name, name) != 0)
            continue;
        const int heights = count_of(counted[i].f) - count_of(point);
        const int vectors =
            counted[i].vector ? count_of_vector(counted[i].vector) - count_of_vector(point_vector) : heights;
        return vectors < heights ? vectors : heights;
    }
    return -1;
}
