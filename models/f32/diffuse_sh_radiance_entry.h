/* The public f32 functions of a radiance kernel: from world space and lighting to RGB. */
#ifndef LOBE_DIFFUSE_SH_RADIANCE_ENTRY_H
#define LOBE_DIFFUSE_SH_RADIANCE_ENTRY_H
#include "../diffuse_sh_radiance.h"
#include "sh9_entry.h"

#define LOBE_DIFFUSE_SH_RADIANCE_F32(name)                                                                             \
    lobe_vec3_f32 name##_f32(float roughness, lobe_vec3_f32 normal, lobe_vec3_f32 view,                                \
                             const lobe_lighting_f32 *lighting)                                                        \
    {                                                                                                                  \
        const lobe_vec3 rgb =                                                                                          \
            name(roughness, lobe_vec3_of(normal.x, normal.y, normal.z), lobe_vec3_of(view.x, view.y, view.z),          \
                 lobe_sh9_in(&lighting->red), lobe_sh9_in(&lighting->green), lobe_sh9_in(&lighting->blue));            \
        lobe_vec3_f32 out;                                                                                             \
        out.x = rgb.x;                                                                                                 \
        out.y = rgb.y;                                                                                                 \
        out.z = rgb.z;                                                                                                 \
        return out;                                                                                                    \
    }

#endif
