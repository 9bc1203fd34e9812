#include "registry.h"
#include "../models/coeffs/capsule_light_bounds.h"
#include "../models/coeffs/diffuse_sh_bounds.h"
#include "../models/coeffs/energy_bounds.h"
#include "../models/coeffs/env_lobes_bounds.h"
#include "../models/coeffs/env_lobes_sg_bounds.h"
#include "../models/coeffs/sg_diffuse_bounds.h"
#include "../models/coeffs/sg_light_bounds.h"
#include "../models/coeffs/sphere_diffuse_bounds.h"
#include "../models/coeffs/sphere_light_bounds.h"
#include "../models/coeffs/sphere_light_schlick_bounds.h"
#include "../models/coeffs/split_sum_bounds.h"
#include "../models/coeffs/split_sum_sep_bounds.h"
#include "../models/lobe.h"

const char *const lobe_format_names[LOBE_FORMATS] = {"f32", "q30"};

/* First reading: one function type for every model. */
#define DFG_CALL(model, tier, format, field)                                                                           \
    static void model##_##tier##_##format(const lobe_value *in, lobe_value *out)                                       \
    {                                                                                                                  \
        const lobe_dfg_##format d = lobe_##model##_##tier##_##format(in[0].field, in[1].field);                        \
        out[0].field = d.scale;                                                                                        \
        out[1].field = d.bias;                                                                                         \
    }
#define DFG_ARRAY(model, tier, format, field)                                                                          \
    static void model##_##tier##_n_##format(const lobe_value *const *in, lobe_value *const *out, size_t n)             \
    {                                                                                                                  \
        lobe_##model##_##tier##_n_##format(&in[0]->field, &in[1]->field, &out[0]->field, &out[1]->field, n);           \
    }
#define DFG_F32(model, tier, bounds) DFG_CALL(model, tier, f32, f) DFG_ARRAY(model, tier, f32, f)
#define DFG_Q30(model, tier, bounds) DFG_CALL(model, tier, q30, q) DFG_ARRAY(model, tier, q30, q)
#define DFG_Q30_SCALAR(model, tier, bounds) DFG_CALL(model, tier, q30, q)
#define ENERGY_CALL(model, tier, format, field)                                                                        \
    static void model##_##tier##_##format(const lobe_value *in, lobe_value *out)                                       \
    {                                                                                                                  \
        out[0].field = lobe_##model##_##tier##_##format(in[0].field, in[1].field);                                     \
    }
#define ENERGY_ARRAY(model, tier, format, field)                                                                       \
    static void model##_##tier##_n_##format(const lobe_value *const *in, lobe_value *const *out, size_t n)             \
    {                                                                                                                  \
        lobe_##model##_##tier##_n_##format(&in[0]->field, &in[1]->field, &out[0]->field, n);                           \
    }
#define ENERGY_F32(model, tier, bounds) ENERGY_CALL(model, tier, f32, f) ENERGY_ARRAY(model, tier, f32, f)
#define ENERGY_Q30(model, tier, bounds) ENERGY_CALL(model, tier, q30, q) ENERGY_ARRAY(model, tier, q30, q)
#define SH9_OUT(out, field, from)                                                                                      \
    do {                                                                                                               \
        int k;                                                                                                         \
        for (k = 0; k < 9; k++)                                                                                        \
            (out)[k].field = (from).c[k];                                                                              \
    } while (0)
#define SH9_CALL(model, tier, format, field)                                                                           \
    static void model##_##tier##_##format(const lobe_value *in, lobe_value *out)                                       \
    {                                                                                                                  \
        const lobe_sh9_##format c = lobe_##model##_##tier##_##format(in[0].field, in[1].field);                        \
        SH9_OUT(out, field, c);                                                                                        \
    }
#define SH9_ARRAY(model, tier, format, field, type)                                                                    \
    static void model##_##tier##_n_##format(const lobe_value *const *in, lobe_value *const *out, size_t n)             \
    {                                                                                                                  \
        type *const c[9] = {&out[0]->field, &out[1]->field, &out[2]->field, &out[3]->field, &out[4]->field,            \
                            &out[5]->field, &out[6]->field, &out[7]->field, &out[8]->field};                           \
        lobe_##model##_##tier##_n_##format(&in[0]->field, &in[1]->field, c, n);                                        \
    }
#define SH9_CONSTANT(model, tier, format, field)                                                                       \
    static void model##_##tier##_##format(const lobe_value *in, lobe_value *out)                                       \
    {                                                                                                                  \
        const lobe_sh9_##format c = lobe_##model##_##tier##_##format();                                                \
        (void)in;                                                                                                      \
        SH9_OUT(out, field, c);                                                                                        \
    }
#define SH9_F32(model, tier, bounds) SH9_CALL(model, tier, f32, f) SH9_ARRAY(model, tier, f32, f, float)
#define SH9_Q30(model, tier, bounds) SH9_CALL(model, tier, q30, q) SH9_ARRAY(model, tier, q30, q, int32_t)
#define SH9_CONSTANT_F32(model, tier, bounds) SH9_CONSTANT(model, tier, f32, f)
#define SH9_CONSTANT_Q30(model, tier, bounds) SH9_CONSTANT(model, tier, q30, q)
#define SPHERE_F32(model, tier, bounds)                                                                                \
    static void model##_##tier##_f32(const lobe_value *in, lobe_value *out)                                            \
    {                                                                                                                  \
        out[0].f = lobe_##model##_##tier##_f32(in[0].f, lobe_sphere_of_f32(in[1].f, in[2].f, in[3].f, in[4].f));       \
    }                                                                                                                  \
    static void model##_##tier##_n_f32(const lobe_value *const *in, lobe_value *const *out, size_t n)                  \
    {                                                                                                                  \
        lobe_##model##_##tier##_n_f32(&in[0]->f, &in[1]->f, &in[2]->f, &in[3]->f, &in[4]->f, &out[0]->f, n);           \
    }
#define SPHERE_Q30(model, tier, bounds)                                                                                \
    static void model##_##tier##_q30(const lobe_value *in, lobe_value *out)                                            \
    {                                                                                                                  \
        const lobe_sphere_q30 light = {in[1].q, in[2].q, in[3].q, in[4].q};                                            \
        out[0].q = lobe_scaled_to_q30(lobe_##model##_##tier##_q30(in[0].q, light));                                    \
    }
#define SCHLICK_CALL_F32(model, tier, function, member)                                                                \
    static void model##_##tier##_f32(const lobe_value *in, lobe_value *out)                                            \
    {                                                                                                                  \
        out[0].f = function(in[0].f, lobe_sphere_of_f32(in[1].f, in[2].f, in[3].f, in[4].f)) member;                   \
    }
#define SCHLICK_CALL_Q30(model, tier, function, member)                                                                \
    static void model##_##tier##_q30(const lobe_value *in, lobe_value *out)                                            \
    {                                                                                                                  \
        const lobe_sphere_q30 light = {in[1].q, in[2].q, in[3].q, in[4].q};                                            \
        out[0].q = function(in[0].q, light) member;                                                                    \
    }
#define SCHLICK_F32(model, tier, bounds, kernel) SCHLICK_CALL_F32(model, tier, kernel##_f32, )
#define SCHLICK_Q30(model, tier, bounds, kernel) SCHLICK_CALL_Q30(model, tier, kernel##_q30, )
#define LIT_F32(model, tier, bounds, kernel) SCHLICK_CALL_F32(model, tier, kernel##_f32, .schlick)
#define LIT_Q30(model, tier, bounds, kernel) SCHLICK_CALL_Q30(model, tier, kernel##_q30, .schlick)
#define CAPSULE_CALL(model, tier, format, value, real)                                                                 \
    static void model##_##tier##_##format(const lobe_value *in, lobe_value *out)                                       \
    {                                                                                                                  \
        lobe_capsule_##format light;                                                                                   \
        light.n_dot_v = in[1].value;                                                                                   \
        light.middle.x = in[2].value;                                                                                  \
        light.middle.y = in[3].value;                                                                                  \
        light.middle.z = in[4].value;                                                                                  \
        light.arm.x = in[5].value;                                                                                     \
        light.arm.y = in[6].value;                                                                                     \
        light.arm.z = in[7].value;                                                                                     \
        light.radius = in[8].value;                                                                                    \
        out[0].value = real(lobe_##model##_##tier##_##format(in[0].value, light));                                     \
    }
#define CAPSULE_F32(model, tier, bounds) CAPSULE_CALL(model, tier, f32, f, )
#define CAPSULE_Q30(model, tier, bounds) CAPSULE_CALL(model, tier, q30, q, lobe_scaled_to_q30)
#define SG_CALL(model, tier, format, value, real)                                                                      \
    static void model##_##tier##_##format(const lobe_value *in, lobe_value *out)                                       \
    {                                                                                                                  \
        const lobe_sg_##format light = {in[1].value, in[2].value, in[3].value, in[4].value};                           \
        out[0].value = real(lobe_##model##_##tier##_##format(in[0].value, light));                                     \
    }
#define SG_F32(model, tier, bounds)                                                                                    \
    SG_CALL(model, tier, f32, f, )                                                                                     \
    static void model##_##tier##_n_f32(const lobe_value *const *in, lobe_value *const *out, size_t n)                  \
    {                                                                                                                  \
        lobe_##model##_##tier##_n_f32(&in[0]->f, &in[1]->f, &in[2]->f, &in[3]->f, &in[4]->f, &out[0]->f, n);           \
    }
#define SG_Q30(model, tier, bounds) SG_CALL(model, tier, q30, q, lobe_scaled_to_q30)
#define SPHERE_DIFFUSE_F32(model, tier, bounds)                                                                        \
    static void model##_##tier##_f32(const lobe_value *in, lobe_value *out)                                            \
    {                                                                                                                  \
        out[0].f = lobe_##model##_##tier##_f32(in[0].f, in[1].f);                                                      \
    }                                                                                                                  \
    static void model##_##tier##_n_f32(const lobe_value *const *in, lobe_value *const *out, size_t n)                  \
    {                                                                                                                  \
        lobe_##model##_##tier##_n_f32(&in[0]->f, &in[1]->f, &out[0]->f, n);                                            \
    }
#define SPHERE_DIFFUSE_Q30(model, tier, bounds)                                                                        \
    static void model##_##tier##_q30(const lobe_value *in, lobe_value *out)                                            \
    {                                                                                                                  \
        out[0].q = lobe_scaled_to_q30(lobe_##model##_##tier##_q30(in[0].q, in[1].q));                                  \
    }
#define SG_DIFFUSE_F32 SPHERE_DIFFUSE_F32
#define SG_DIFFUSE_Q30 SPHERE_DIFFUSE_Q30
#define ENV_OUT(field, wide, weigh, n)                                                                                 \
    do {                                                                                                               \
        int k;                                                                                                         \
        for (k = 0; k < (n); k++) {                                                                                    \
            out[3 * k].field = taps[k].angle;                                                                          \
            out[3 * k + 1].field = taps[k].wide;                                                                       \
            out[3 * k + 2].field = taps[k].weigh;                                                                      \
        }                                                                                                              \
    } while (0)
#define ENV_CALL(model, tier, kernel, n, tap, wide, weigh, format, field)                                              \
    static void model##_##tier##_##format(const lobe_value *in, lobe_value *out)                                       \
    {                                                                                                                  \
        tap taps[n];                                                                                                   \
        kernel##_##format(in[0].field, in[1].field, taps);                                                             \
        ENV_OUT(field, wide, weigh, n);                                                                                \
    }
#define ENV_F32(model, tier, bounds, kernel, n)                                                                        \
    ENV_CALL(model, tier, kernel, n, lobe_env_tap_f32, width, weight, f32, f)
#define ENV_Q30(model, tier, bounds, kernel, n)                                                                        \
    ENV_CALL(model, tier, kernel, n, lobe_env_tap_q30, width, weight_q16, q30, q)
#define ENV_COUNTED_F32 ENV_F32
#define ENV_COUNTED_Q30 ENV_Q30
#define ENV_SG_F32(model, tier, bounds, kernel, n)                                                                     \
    ENV_CALL(model, tier, kernel, n, lobe_env_sg_tap_f32, sharpness, weight, f32, f)
#define ENV_SG_Q30(model, tier, bounds, kernel, n)                                                                     \
    ENV_CALL(model, tier, kernel, n, lobe_env_sg_tap_q16, sharpness, weight, q30, q)
#include "registry_rows.h"
#undef DFG_F32
#undef DFG_Q30
#undef DFG_Q30_SCALAR
#undef ENERGY_F32
#undef ENERGY_Q30
#undef SH9_F32
#undef SH9_Q30
#undef SH9_CONSTANT_F32
#undef SH9_CONSTANT_Q30
#undef SPHERE_F32
#undef SPHERE_Q30
#undef SCHLICK_F32
#undef SCHLICK_Q30
#undef LIT_F32
#undef LIT_Q30
#undef CAPSULE_F32
#undef CAPSULE_Q30
#undef SG_F32
#undef SG_Q30
#undef SPHERE_DIFFUSE_F32
#undef SPHERE_DIFFUSE_Q30
#undef SG_DIFFUSE_F32
#undef SG_DIFFUSE_Q30
#undef ENV_F32
#undef ENV_Q30
#undef ENV_COUNTED_F32
#undef ENV_COUNTED_Q30
#undef ENV_SG_F32
#undef ENV_SG_Q30

/* Ranges that are the same for every tier of a model. */
static const lobe_range sphere_light_ranges[] = {{0.22, 1.0, 0.0, 1.0},
                                                 {0.08, 1.0, 0.0, 1.0},
                                                 {-1.0, 1.0, -1.0, 1.0},
                                                 {0.0, 1.0, 0.0, 1.0},
                                                 {0.0, 0.7072, 0.0, 1.0}};
/* Its middle is at the distance 1, which no range says. Beyond: any length, in q30 any integer. */
#define CAPSULE_RANGES(most)                                                                                           \
    {                                                                                                                  \
        {0.22, 1.0, 0.0, 1.0}, {0.08, 1.0, 0.0, 1.0}, {-1.0, 1.0, -most, most}, {-1.0, 1.0, -most, most},              \
            {-1.0, 1.0, -most, most}, {-1.0, 1.0, -most, most}, {-1.0, 1.0, -most, most}, {-1.0, 1.0, -most, most},    \
        {                                                                                                              \
            0.0, 0.5, 0.0, most                                                                                        \
        }                                                                                                              \
    }
static const lobe_range capsule_light_ranges_f32[] = CAPSULE_RANGES(1e15);
static const lobe_range capsule_light_ranges_q30[] = CAPSULE_RANGES(2.0);
static const lobe_range sg_light_ranges[] = {{0.22, 1.0, 0.0, 1.0},
                                             {0.05, 1.0, 0.0, 1.0},
                                             {-1.0, 1.0, -1.0, 1.0},
                                             {0.0, 1.0, 0.0, 1.0},
                                             {0.000244140625, 0.25, 0.0, 1.0}};
static const lobe_range sg_diffuse_ranges[] = {{-1.0, 1.0, -1.0, 1.0}, {0.000244140625, 1.0, 0.0, 2.0}};
static const lobe_range sphere_diffuse_ranges[] = {{-1.0, 1.0, -1.0, 1.0}, {0.0, 1.0, 0.0, 1.0}};

/* Second reading: the table. ROW_OF has everything, the others what their models have in common. */
#define ROW(model, tier, format, FORMAT, outputs, names, sums, array, bounds)                                          \
    ROW_BELOW(model, tier, format, FORMAT, outputs, names, sums, array, bounds, bounds##_##FORMAT##_BELOW_MAX)
#define ROW_BELOW(model, tier, format, FORMAT, outputs, names, sums, array, bounds, below)                             \
    ROW_OF(model, tier, format, FORMAT, 2, "roughness n_dot_v", UNIT_FROM(bounds##_DOMAIN_LO), outputs, names, sums,   \
           array, bounds, below)
#define ROW_OF(model, tier, format, FORMAT, inputs, input_names, ranges, outputs, output_names, sums, array, bounds,   \
               below)                                                                                                  \
    ROW_NAMED(model, tier, "lobe_" #model "_" #tier "_" #format, format, FORMAT, inputs, input_names, ranges, outputs, \
              output_names, sums, array, bounds, below)
#define ROW_NAMED(model, tier, name, format, FORMAT, inputs, input_names, ranges, outputs, output_names, sums, array,  \
                  bounds, below)                                                                                       \
    {#model,                                                                                                           \
     #tier,                                                                                                            \
     name,                                                                                                             \
     LOBE_##FORMAT,                                                                                                    \
     inputs,                                                                                                           \
     outputs,                                                                                                          \
     input_names,                                                                                                      \
     output_names,                                                                                                     \
     sums,                                                                                                             \
     model##_##tier##_##format,                                                                                        \
     array,                                                                                                            \
     bounds##_OPS,                                                                                                     \
     bounds##_##FORMAT##_MAX,                                                                                          \
     bounds##_##FORMAT##_RMS,                                                                                          \
     below,                                                                                                            \
     ranges,                                                                                                           \
     NULL,                                                                                                             \
     0,                                                                                                                \
     0},
/* Two inputs whose domain is [lo, 1]. */
#define UNIT_FROM(lo) ((const lobe_range[]){{lo, 1.0, 0.0, 1.0}, {lo, 1.0, 0.0, 1.0}})
#define DFG_F32(model, tier, bounds) ROW(model, tier, f32, F32, 2, "scale bias", 1, model##_##tier##_n_f32, bounds)
#define DFG_Q30(model, tier, bounds) ROW(model, tier, q30, Q30, 2, "scale bias", 1, model##_##tier##_n_q30, bounds)
#define DFG_Q30_SCALAR(model, tier, bounds) ROW(model, tier, q30, Q30, 2, "scale bias", 1, NULL, bounds)
#define ENERGY_F32(model, tier, bounds) ROW(model, tier, f32, F32, 1, "E", 0, model##_##tier##_n_f32, bounds)
#define ENERGY_Q30(model, tier, bounds) ROW(model, tier, q30, Q30, 1, "E", 0, model##_##tier##_n_q30, bounds)
/* Nothing is below a domain that starts at 0. */
#define ROW_SH9(model, tier, format, FORMAT, array, bounds)                                                            \
    ROW_BELOW(model, tier, format, FORMAT, 9, "c0 c1 c2 c3 c4 c5 c6 c7 c8", 0, array, bounds, bounds##_##FORMAT##_MAX)
#define SH9_F32(model, tier, bounds) ROW_SH9(model, tier, f32, F32, model##_##tier##_n_f32, bounds)
#define SH9_Q30(model, tier, bounds) ROW_SH9(model, tier, q30, Q30, model##_##tier##_n_q30, bounds)
#define SH9_CONSTANT_F32(model, tier, bounds) ROW_SH9(model, tier, f32, F32, NULL, bounds)
#define SH9_CONSTANT_Q30(model, tier, bounds) ROW_SH9(model, tier, q30, Q30, NULL, bounds)
#define ROW_SPHERE(model, tier, format, FORMAT, array, bounds)                                                         \
    ROW_OF(model, tier, format, FORMAT, 5, "roughness n_dot_v n_dot_l tangent2 sine", sphere_light_ranges, 1,          \
           "radiance", 0, array, bounds, bounds##_##FORMAT##_BELOW_MAX)
#define SPHERE_F32(model, tier, bounds) ROW_SPHERE(model, tier, f32, F32, model##_##tier##_n_f32, bounds)
#define SPHERE_Q30(model, tier, bounds) ROW_SPHERE(model, tier, q30, Q30, NULL, bounds)
#define ROW_SCHLICK(model, tier, format, FORMAT, bounds, kernel)                                                       \
    ROW_NAMED(model, tier, #kernel "_" #format, format, FORMAT, 5, "roughness n_dot_v n_dot_l tangent2 sine",          \
              sphere_light_ranges, 1, "schlick", 0, NULL, bounds, bounds##_##FORMAT##_BELOW_MAX)
#define SCHLICK_F32(model, tier, bounds, kernel) ROW_SCHLICK(model, tier, f32, F32, bounds, kernel)
#define SCHLICK_Q30(model, tier, bounds, kernel) ROW_SCHLICK(model, tier, q30, Q30, bounds, kernel)
#define LIT_F32(model, tier, bounds, kernel) ROW_SCHLICK(model, tier, f32, F32, bounds, kernel)
#define LIT_Q30(model, tier, bounds, kernel) ROW_SCHLICK(model, tier, q30, Q30, bounds, kernel)
#define ROW_CAPSULE(model, tier, format, FORMAT, bounds)                                                               \
    ROW_OF(model, tier, format, FORMAT, 9, "roughness n_dot_v mx my mz ex ey ez radius",                               \
           capsule_light_ranges_##format, 1, "radiance", 0, NULL, bounds, bounds##_##FORMAT##_BELOW_MAX)
#define CAPSULE_F32(model, tier, bounds) ROW_CAPSULE(model, tier, f32, F32, bounds)
#define CAPSULE_Q30(model, tier, bounds) ROW_CAPSULE(model, tier, q30, Q30, bounds)
#define ROW_SG(model, tier, format, FORMAT, array, bounds)                                                             \
    ROW_OF(model, tier, format, FORMAT, 5, "roughness n_dot_v n_dot_l tangent2 versine", sg_light_ranges, 1,           \
           "radiance", 0, array, bounds, bounds##_##FORMAT##_BELOW_MAX)
#define SG_F32(model, tier, bounds) ROW_SG(model, tier, f32, F32, model##_##tier##_n_f32, bounds)
#define SG_Q30(model, tier, bounds) ROW_SG(model, tier, q30, Q30, NULL, bounds)
#define ROW_DIFFUSE(model, tier, size, format, FORMAT, array, bounds, beyond)                                          \
    ROW_OF(model, tier, format, FORMAT, 2, "n_dot_l " size, model##_ranges, 1, "irradiance", 0, array, bounds,         \
           bounds##_##FORMAT##_##beyond)
#define SPHERE_DIFFUSE_F32(model, tier, bounds)                                                                        \
    ROW_DIFFUSE(model, tier, "sine", f32, F32, model##_##tier##_n_f32, bounds, MAX)
#define SPHERE_DIFFUSE_Q30(model, tier, bounds) ROW_DIFFUSE(model, tier, "sine", q30, Q30, NULL, bounds, MAX)
#define SG_DIFFUSE_F32(model, tier, bounds)                                                                            \
    ROW_DIFFUSE(model, tier, "versine", f32, F32, model##_##tier##_n_f32, bounds, BEYOND_MAX)
#define SG_DIFFUSE_Q30(model, tier, bounds) ROW_DIFFUSE(model, tier, "versine", q30, Q30, NULL, bounds, BEYOND_MAX)
/* Errors are those of the weights' sum, against the albedo. */
#define TAPS_1 "angle0 width0 weight0"
#define TAPS_2 TAPS_1 " angle1 width1 weight1"
#define TAPS_4 TAPS_2 " angle2 width2 weight2 angle3 width3 weight3"
#define TAPS_6 TAPS_4 " angle4 width4 weight4 angle5 width5 weight5"
#define TAPS_8 TAPS_6 " angle6 width6 weight6 angle7 width7 weight7"
#define ROW_ENV(model, tier, format, FORMAT, bounds, kernel, n, prefilter, q16)                                        \
    {#model,                                                                                                           \
     #tier,                                                                                                            \
     #kernel "_" #format,                                                                                              \
     LOBE_##FORMAT,                                                                                                    \
     2,                                                                                                                \
     3 * n,                                                                                                            \
     "roughness n_dot_v",                                                                                              \
     TAPS_##n,                                                                                                         \
     0,                                                                                                                \
     model##_##tier##_##format,                                                                                        \
     NULL,                                                                                                             \
     bounds##_OPS + LOBE_ENERGY_HIGH_OPS,                                                                              \
     bounds##_##FORMAT##_MAX,                                                                                          \
     bounds##_##FORMAT##_RMS,                                                                                          \
     bounds##_##FORMAT##_BELOW_MAX,                                                                                    \
     UNIT_FROM(bounds##_DOMAIN_LO),                                                                                    \
     prefilter,                                                                                                        \
     3,                                                                                                                \
     q16},
#define ENV_F32(model, tier, bounds, kernel, n) ROW_ENV(model, tier, f32, F32, bounds, kernel, n, "prefilter", 0)
#define ENV_Q30(model, tier, bounds, kernel, n)                                                                        \
    ROW_ENV(model, tier, q30, Q30, bounds, kernel, n, "prefilter", 044444444)
#define ENV_COUNTED_F32 ENV_F32
#define ENV_COUNTED_Q30 ENV_Q30
#define ENV_SG_F32(model, tier, bounds, kernel, n) ROW_ENV(model, tier, f32, F32, bounds, kernel, n, "sg", 0)
#define ENV_SG_Q30(model, tier, bounds, kernel, n) ROW_ENV(model, tier, q30, Q30, bounds, kernel, n, "sg", 0xffffff)
const lobe_entry lobe_entries[] = {
#include "registry_rows.h"
};
const size_t lobe_entry_count = sizeof lobe_entries / sizeof lobe_entries[0];

int lobe_same(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}

lobe_format lobe_format_named(const char *name)
{
    if (lobe_same(name, "f32"))
        return LOBE_F32;
    return lobe_same(name, "q30") ? LOBE_Q30 : LOBE_FORMATS;
}

const lobe_entry *lobe_find_entry(const char *model, const char *tier, lobe_format format)
{
    size_t i;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        if (e->format == format && lobe_same(e->model, model) && lobe_same(e->tier, tier))
            return e;
    }
    return NULL;
}

int lobe_in_domain(const lobe_entry *entry, const lobe_value *in)
{
    int k;
    for (k = 0; k < entry->inputs; k++) {
        const double x = lobe_value_real(entry->format, in[k]);
        if (!(x >= entry->ranges[k].lo && x <= entry->ranges[k].hi))
            return 0;
    }
    return 1;
}

double lobe_value_real(lobe_format format, lobe_value value)
{
    return format == LOBE_F32 ? (double)value.f : (double)value.q / 1073741824.0;
}

double lobe_output_real(const lobe_entry *entry, int k, lobe_value value)
{
    const double real = lobe_value_real(entry->format, value);
    return entry->q16 >> k & 1u ? real * 16384.0 : real;
}

int lobe_truth_count(const lobe_entry *entry) { return entry->nth ? 1 : entry->outputs; }

const char *lobe_truth_names(const lobe_entry *entry) { return entry->nth ? "E" : entry->output_names; }

double lobe_answer(const lobe_entry *entry, int k, const lobe_value *out)
{
    double sum = 0.0;
    if (!entry->nth)
        return lobe_output_real(entry, k, out[k]);
    for (k = entry->nth - 1; k < entry->outputs; k += entry->nth)
        sum += lobe_output_real(entry, k, out[k]);
    return sum;
}

lobe_value lobe_value_nearest(lobe_format format, double real)
{
    lobe_value value;
    value.q = 0;
    if (format == LOBE_F32) {
        value.f = (float)real;
    } else {
        const double scaled = real * 1073741824.0;
        if (scaled >= 2147483647.0)
            value.q = INT32_MAX;
        else if (scaled <= -2147483648.0)
            value.q = INT32_MIN;
        else if (scaled == scaled)
            value.q = (int32_t)(scaled < 0.0 ? scaled - 0.5 : scaled + 0.5);
    }
    return value;
}
