/* The public f32 functions of a sphere light's kernel: at one point; and over arrays, in a loop that compilers
 * vectorise, in an object of its own, compiled with LOBE_ARRAYS. */
#ifndef LOBE_SPHERE_LIGHT_ENTRY_H
#define LOBE_SPHERE_LIGHT_ENTRY_H
#include "../lobe.h"

LOBE_FN lobe_sphere lobe_sphere_in(lobe_sphere_f32 a)
{
    lobe_sphere light;
    light.n_dot_v = a.n_dot_v;
    light.n_dot_l = a.n_dot_l;
    light.tangent2 = a.tangent2;
    light.sine = a.sine;
    light.versine = a.versine;
    return light;
}

LOBE_FN lobe_sphere_f32 lobe_sphere_out(lobe_sphere a)
{
    lobe_sphere_f32 light;
    light.n_dot_v = a.n_dot_v;
    light.n_dot_l = a.n_dot_l;
    light.tangent2 = a.tangent2;
    light.sine = a.sine;
    light.versine = a.versine;
    return light;
}

#define LOBE_SPHERE_LIGHT_F32(name)                                                                                    \
    float name##_f32(float roughness, lobe_sphere_f32 light) { return name(roughness, lobe_sphere_in(light)); }

#define LOBE_SPHERE_LIGHT_N_F32(name)                                                                                  \
    void name##_n_f32(const float *roughness, const float *n_dot_v, const float *n_dot_l, const float *tangent2,       \
                      const float *sine, float *radiance, size_t n)                                                    \
    {                                                                                                                  \
        size_t i;                                                                                                      \
        for (i = 0; i < n; i++)                                                                                        \
            radiance[i] = name(roughness[i], lobe_sphere_of(n_dot_v[i], n_dot_l[i], tangent2[i], sine[i]));            \
    }

#endif
