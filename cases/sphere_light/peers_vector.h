/* The representative points of peers.h in vectors, as an engine has them: where that is cheaper than from the heights,
 * it is the price on the chart. The tests hold that both spellings give the same. */
#ifndef LOBE_SPHERE_LIGHT_PEERS_VECTOR_H
#define LOBE_SPHERE_LIGHT_PEERS_VECTOR_H
#include "../../core/vec3.h"
#include "peers.h"

/* Unit vectors, the light's to its centre. */
LOBE_STRUCT(lobe_peer_scene)
{
    lobe_vec3 normal, view, light;
    lobe_real sine, versine;
};

/* A punctual light of that size, with all dot products. */
LOBE_FN lobe_sphere lobe_peer_seen(lobe_peer_scene s)
{
    const lobe_vec3 h = lobe_vec3_add(s.view, s.light);
    LOBE_LET v = lobe_vec3_dot(s.normal, s.view);
    LOBE_LET l = lobe_vec3_dot(s.normal, s.light);
    LOBE_LET up = v + l;
    const lobe_vec3 along = lobe_vec3_add(h, lobe_vec3_scale(s.normal, -up));
    LOBE_LET t2 = LOBE_R(0.25) * lobe_vec3_dot(along, along);
    lobe_sphere y;
    y.n_dot_v = v;
    y.n_dot_l = l;
    y.tangent2 = t2;
    y.sine = s.sine;
    y.versine = s.versine;
    return y;
}

/* From the light's centre to the mirror ray, and how far that is. */
LOBE_STRUCT(lobe_peer_ray)
{
    lobe_vec3 across;
    lobe_real out;
};

LOBE_FN lobe_peer_ray lobe_peer_ray_of(lobe_peer_scene s)
{
    const lobe_vec3 r = lobe_vec3_reflect(s.view, s.normal);
    LOBE_LET along = lobe_vec3_dot(r, s.light);
    const lobe_vec3 c = lobe_vec3_add(lobe_vec3_scale(r, along), lobe_vec3_scale(s.light, LOBE_R(-1.0)));
    LOBE_LET out = lobe_sqrt(lobe_max(lobe_vec3_dot(c, c), LOBE_R(1e-14)));
    lobe_peer_ray y;
    y.across = c;
    y.out = out;
    return y;
}

LOBE_FN lobe_real lobe_peer_lit_from(lobe_real roughness, lobe_peer_scene s, lobe_peer_ray ray, lobe_real part)
{
    lobe_peer_scene moved = s;
    moved.light = lobe_vec3_normalize(lobe_vec3_add(s.light, lobe_vec3_scale(ray.across, part)));
    return lobe_sphere_light_punctual(roughness, lobe_peer_seen(moved));
}

LOBE_FN lobe_real lobe_peer_karis_vector(lobe_real roughness, lobe_peer_scene s, lobe_real widening)
{
    const lobe_peer_ray ray = lobe_peer_ray_of(s);
    LOBE_LET part = lobe_saturate(s.sine / ray.out);
    LOBE_LET f = lobe_peer_lit_from(roughness, s, ray, part);
    LOBE_LET y = lobe_peer_karis_scale(roughness, s.sine, widening) * f;
    return y;
}

LOBE_FN lobe_real lobe_peer_smooth_point_vector(lobe_real roughness, lobe_peer_scene s, lobe_real nx, lobe_real ny,
                                                lobe_real nz)
{
    const lobe_peer_ray ray = lobe_peer_ray_of(s);
    LOBE_LET part = lobe_peer_smooth_part(s.sine / ray.out);
    LOBE_LET f = lobe_peer_lit_from(roughness, s, ray, part);
    LOBE_LET y = lobe_peer_smooth_scale(roughness, lobe_peer_seen(s), nx, ny, nz) * f;
    return y;
}

LOBE_FN lobe_real lobe_peer_capped_point_vector(lobe_real roughness, lobe_peer_scene s, lobe_real q, lobe_real cap)
{
    const lobe_peer_ray ray = lobe_peer_ray_of(s);
    LOBE_LET part = lobe_saturate(lobe_peer_capped_radius(roughness, s.sine, q) / ray.out);
    LOBE_LET f = lobe_peer_lit_from(roughness, s, ray, part);
    LOBE_LET y = f * cap / (cap + f);
    return y;
}

#endif
