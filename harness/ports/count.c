/* Instructions an evaluation, for every entry of the registry and every published formula.
 *
 * Counted: the call, the function, its return; over a 16 x 16 grid of the domain, then the mean. Not counted: the
 * loop, loading the arguments, storing the results. A loop over a function that only returns gives what to take
 * off. On a target without a counter the loops run all the same, for a profiler to watch. */
#include "../../models/lobe.h"
#include "../port.h"
#include "../registry.h"
#include "counter.h"

#if defined(LOBE_PEERS)
#include "../peers/diffuse.h"
#include "../peers/energy.h"
#include "../peers/split_sum.h"
#include "../../models/diffuse_sh_radiance.h"
#include "../../models/f32/sh9_entry.h"
#define PEER_DFG(name)                                                                                                 \
    lobe_dfg_f32 peer_##name##_f32(float roughness, float n_dot_v);                                                    \
    lobe_dfg_f32 peer_##name##_f32(float roughness, float n_dot_v)                                                     \
    {                                                                                                                  \
        const lobe_dfg d = peer_##name(roughness, n_dot_v);                                                            \
        lobe_dfg_f32 out;                                                                                              \
        out.scale = d.scale;                                                                                           \
        out.bias = d.bias;                                                                                             \
        return out;                                                                                                    \
    }
#define PEER_ENERGY(name)                                                                                              \
    float peer_##name##_f32(float roughness, float n_dot_v);                                                           \
    float peer_##name##_f32(float roughness, float n_dot_v) { return peer_##name(roughness, n_dot_v); }
#define PEER_SH9(name)                                                                                                 \
    lobe_sh9_f32 peer_##name##_f32(float roughness, float n_dot_v);                                                    \
    lobe_sh9_f32 peer_##name##_f32(float roughness, float n_dot_v)                                                     \
    {                                                                                                                  \
        return lobe_sh9_out(peer_##name(roughness, n_dot_v));                                                          \
    }
#include "peer_rows.h"
#undef PEER_DFG
#undef PEER_ENERGY
#undef PEER_SH9

/* World space to RGB, as lobe_diffuse_sh_radiance_low_f32 does it. */
lobe_vec3_f32 peer_zonal_2015_radiance_f32(float roughness, lobe_vec3_f32 normal, lobe_vec3_f32 view,
                                           const lobe_lighting_f32 *lighting);
lobe_vec3_f32 peer_zonal_2015_radiance_f32(float roughness, lobe_vec3_f32 normal, lobe_vec3_f32 view,
                                           const lobe_lighting_f32 *lighting)
{
    const lobe_vec3 n = lobe_diffuse_sh_direction(lobe_vec3_of(normal.x, normal.y, normal.z));
    const lobe_vec3 w = lobe_diffuse_sh_direction(lobe_vec3_of(view.x, view.y, view.z));
    const float v = lobe_saturate(lobe_vec3_dot(n, w));
    const lobe_vec3 rgb = lobe_diffuse_sh_light(peer_zonal_2015_turned(roughness, n, w, v), lobe_sh9_in(&lighting->red),
                                                lobe_sh9_in(&lighting->green), lobe_sh9_in(&lighting->blue));
    lobe_vec3_f32 out;
    out.x = rgb.x;
    out.y = rgb.y;
    out.z = rgb.z;
    return out;
}
#endif

enum { SIDE = 16, EVALUATIONS = SIDE * SIDE };

/* One loop for each type of function; the calls cannot be inlined, since the pointer is volatile. */
typedef void any_function(void);
typedef lobe_dfg_f32 dfg_f32(float, float);
typedef lobe_dfg_q30 dfg_q30(int32_t, int32_t);
typedef float energy_f32(float, float);
typedef int32_t energy_q30(int32_t, int32_t);
typedef lobe_sh9_f32 sh9_f32(float, float);
typedef lobe_sh9_q30 sh9_q30(int32_t, int32_t);
typedef lobe_vec3_f32 radiance_f32(float, lobe_vec3_f32, lobe_vec3_f32, const lobe_lighting_f32 *);
typedef lobe_vec3_q16 radiance_q30(int32_t, lobe_vec3_q30, lobe_vec3_q30, const lobe_lighting_q16 *);
typedef float sphere_f32(float, lobe_sphere_f32);
typedef lobe_scaled_q30 sphere_q30(int32_t, lobe_sphere_q30);
typedef lobe_sphere_lit_f32 lit_f32(float, lobe_sphere_f32);
typedef lobe_sphere_lit_q30 lit_q30(int32_t, lobe_sphere_q30);
typedef int32_t schlick_q30(int32_t, lobe_sphere_q30);
typedef float sg_f32(float, lobe_sg_f32);
typedef lobe_scaled_q30 sg_q30(int32_t, lobe_sg_q30);
typedef float capsule_f32(float, lobe_capsule_f32);
typedef lobe_scaled_q30 capsule_q30(int32_t, lobe_capsule_q30);
typedef lobe_scaled_q30 sphere_diffuse_q30(int32_t, int32_t);
typedef void env_f32(float, float, lobe_env_tap_f32 *);
typedef void env_q30(int32_t, int32_t, lobe_env_tap_q30 *);
typedef int env_counted_f32(float, float, lobe_env_tap_f32 *);
typedef int env_counted_q30(int32_t, int32_t, lobe_env_tap_q30 *);
typedef void env_sg_f32(float, float, lobe_env_sg_tap_f32 *);
typedef void env_sg_q30(int32_t, int32_t, lobe_env_sg_tap_q16 *);

typedef struct function {
    const char *model, *tier;
    lobe_format format;
    uint32_t (*loop)(any_function *);
    any_function *called;
} function;

static lobe_value roughness[EVALUATIONS], n_dot_v[EVALUATIONS];
static lobe_lighting_f32 lighting_f32;
static lobe_lighting_q16 lighting_q30;

#define LOOP(type, result, call)                                                                                       \
    static uint32_t loop_##type(any_function *f)                                                                       \
    {                                                                                                                  \
        type *volatile pointer = (type *)f;                                                                            \
        type *const called = pointer;                                                                                  \
        volatile result sink;                                                                                          \
        int i;                                                                                                         \
        lobe_count_from_here();                                                                                        \
        for (i = 0; i < EVALUATIONS; i++)                                                                              \
            sink = call;                                                                                               \
        (void)sink;                                                                                                    \
        return lobe_counted();                                                                                         \
    }
#define AT(field) called(roughness[i].field, n_dot_v[i].field)
LOOP(dfg_f32, lobe_dfg_f32, AT(f))
LOOP(dfg_q30, lobe_dfg_q30, AT(q))
LOOP(energy_f32, float, AT(f))
LOOP(energy_q30, int32_t, AT(q))
LOOP(sh9_f32, float, AT(f).c[8])
LOOP(sh9_q30, int32_t, AT(q).c[8])
/* The view leans in the plane of x, whose length does not matter to the count. */
#define RADIANCE(field, one, format)                                                                                   \
    called(roughness[i].field, (lobe_vec3_##format){0, 0, one}, (lobe_vec3_##format){one / 2, 0, n_dot_v[i].field},    \
           &lighting_##format)                                                                                         \
        .x
LOOP(radiance_f32, float, RADIANCE(f, 1.0f, f32))
LOOP(radiance_q30, int32_t, RADIANCE(q, LOBE_ONE_Q30, q30))
/* Half a radian, the light's centre 45 degrees up. */
#define SPHERE_LIGHT_F32                                                                                               \
    (lobe_sphere_f32) { n_dot_v[i].f, 0.70710678f, 0.1f, 0.47942554f, 0.12241744f }
#define SPHERE_LIGHT_Q30                                                                                               \
    (lobe_sphere_q30) { n_dot_v[i].q, 759250125, 107374182, 514780862 }
LOOP(sphere_f32, float, called(roughness[i].f, SPHERE_LIGHT_F32))
LOOP(sphere_q30, int32_t, called(roughness[i].q, SPHERE_LIGHT_Q30).mantissa)
LOOP(lit_f32, float, called(roughness[i].f, SPHERE_LIGHT_F32).schlick)
LOOP(lit_q30, int32_t, called(roughness[i].q, SPHERE_LIGHT_Q30).schlick)
LOOP(schlick_q30, int32_t, called(roughness[i].q, SPHERE_LIGHT_Q30))
/* A tube of radius a tenth across the mirror's side, at the distance 1. */
/* Sharpness 32, the axis 45 degrees up. */
LOOP(sg_f32, float, called(roughness[i].f, (lobe_sg_f32){n_dot_v[i].f, 0.70710678f, 0.1f, 0.03125f}))
LOOP(sg_q30, int32_t,
     called(roughness[i].q, (lobe_sg_q30){n_dot_v[i].q, 759250125, 107374182, 33554432}).mantissa)
LOOP(capsule_f32, float,
     called(roughness[i].f, (lobe_capsule_f32){n_dot_v[i].f, {-0.8f, 0.0f, 0.6f}, {0.1f, 0.5f, 0.0f}, 0.1f}))
LOOP(capsule_q30, int32_t,
     called(roughness[i].q,
            (lobe_capsule_q30){n_dot_v[i].q, {-858993459, 0, 644245094}, {107374182, 536870912, 0}, 107374182})
         .mantissa)
LOOP(sphere_diffuse_q30, int32_t, called(roughness[i].q, n_dot_v[i].q).mantissa)

static lobe_env_tap_f32 taps_f32[8];
static lobe_env_tap_q30 taps_q30[8];
static lobe_env_sg_tap_f32 sg_taps_f32[8];
static lobe_env_sg_tap_q16 sg_taps_q30[8];
LOOP(env_f32, float, (called(roughness[i].f, n_dot_v[i].f, taps_f32), 0.0f))
LOOP(env_q30, int32_t, (called(roughness[i].q, n_dot_v[i].q, taps_q30), 0))
LOOP(env_counted_f32, int, called(roughness[i].f, n_dot_v[i].f, taps_f32))
LOOP(env_counted_q30, int, called(roughness[i].q, n_dot_v[i].q, taps_q30))
LOOP(env_sg_f32, float, (called(roughness[i].f, n_dot_v[i].f, sg_taps_f32), 0.0f))
LOOP(env_sg_q30, int32_t, (called(roughness[i].q, n_dot_v[i].q, sg_taps_q30), 0))

/* Returns at once, whatever it is called as. One instruction; with its call two. */
void nothing(void);
#if defined(__arm__)
__attribute__((naked, noinline)) void nothing(void) { __asm__("bx lr"); }
#else
__attribute__((noinline)) void nothing(void) { __asm__ volatile(""); }
#endif
enum { CALL_AND_RETURN = 2 };

#define FUNCTION(model, tier, FORMAT, type, f) {model, #tier, LOBE_##FORMAT, loop_##type, (any_function *)f},
#define DFG_F32(model, tier, bounds) FUNCTION(#model, tier, F32, dfg_f32, lobe_##model##_##tier##_f32)
#define DFG_Q30(model, tier, bounds) FUNCTION(#model, tier, Q30, dfg_q30, lobe_##model##_##tier##_q30)
#define DFG_Q30_SCALAR(model, tier, bounds) DFG_Q30(model, tier, bounds)
#define ENERGY_F32(model, tier, bounds)                                                                                \
    FUNCTION(#model, tier, F32, energy_f32, lobe_##model##_##tier##_f32)                                               \
    FUNCTION(#model "_inverse", tier, F32, energy_f32, lobe_##model##_inverse_##tier##_f32)
#define ENERGY_Q30(model, tier, bounds) FUNCTION(#model, tier, Q30, energy_q30, lobe_##model##_##tier##_q30)
#define SH9_F32(model, tier, bounds) FUNCTION(#model, tier, F32, sh9_f32, lobe_##model##_##tier##_f32)
#define SH9_Q30(model, tier, bounds) FUNCTION(#model, tier, Q30, sh9_q30, lobe_##model##_##tier##_q30)
#define SH9_CONSTANT_F32(model, tier, bounds) SH9_F32(model, tier, bounds)
#define SH9_CONSTANT_Q30(model, tier, bounds) SH9_Q30(model, tier, bounds)
#define SPHERE_F32(model, tier, bounds) FUNCTION(#model, tier, F32, sphere_f32, lobe_##model##_##tier##_f32)
#define SPHERE_Q30(model, tier, bounds) FUNCTION(#model, tier, Q30, sphere_q30, lobe_##model##_##tier##_q30)
#define SG_F32(model, tier, bounds) FUNCTION(#model, tier, F32, sg_f32, lobe_##model##_##tier##_f32)
#define SG_Q30(model, tier, bounds) FUNCTION(#model, tier, Q30, sg_q30, lobe_##model##_##tier##_q30)
#define SCHLICK_F32(model, tier, bounds, kernel) FUNCTION(#model, tier, F32, sphere_f32, kernel##_f32)
#define SCHLICK_Q30(model, tier, bounds, kernel) FUNCTION(#model, tier, Q30, schlick_q30, kernel##_q30)
#define LIT_F32(model, tier, bounds, kernel) FUNCTION(#model, tier, F32, lit_f32, kernel##_f32)
#define LIT_Q30(model, tier, bounds, kernel) FUNCTION(#model, tier, Q30, lit_q30, kernel##_q30)
#define CAPSULE_F32(model, tier, bounds) FUNCTION(#model, tier, F32, capsule_f32, lobe_##model##_##tier##_f32)
#define CAPSULE_Q30(model, tier, bounds) FUNCTION(#model, tier, Q30, capsule_q30, lobe_##model##_##tier##_q30)
#define SPHERE_DIFFUSE_F32(model, tier, bounds) FUNCTION(#model, tier, F32, energy_f32, lobe_##model##_##tier##_f32)
#define SPHERE_DIFFUSE_Q30(model, tier, bounds)                                                                        \
    FUNCTION(#model, tier, Q30, sphere_diffuse_q30, lobe_##model##_##tier##_q30)
#define SG_DIFFUSE_F32 SPHERE_DIFFUSE_F32
#define SG_DIFFUSE_Q30 SPHERE_DIFFUSE_Q30
#define ENV_F32(model, tier, bounds, kernel, n) FUNCTION(#model, tier, F32, env_f32, kernel##_f32)
#define ENV_Q30(model, tier, bounds, kernel, n) FUNCTION(#model, tier, Q30, env_q30, kernel##_q30)
#define ENV_COUNTED_F32(model, tier, bounds, kernel, n) FUNCTION(#model, tier, F32, env_counted_f32, kernel##_f32)
#define ENV_COUNTED_Q30(model, tier, bounds, kernel, n) FUNCTION(#model, tier, Q30, env_counted_q30, kernel##_q30)
#define ENV_SG_F32(model, tier, bounds, kernel, n) FUNCTION(#model, tier, F32, env_sg_f32, kernel##_f32)
#define ENV_SG_Q30(model, tier, bounds, kernel, n) FUNCTION(#model, tier, Q30, env_sg_q30, kernel##_q30)
#define SH9_RADIANCE(tier)                                                                                             \
    FUNCTION("diffuse_sh_radiance", tier, F32, radiance_f32, lobe_diffuse_sh_radiance_##tier##_f32)                    \
    FUNCTION("diffuse_sh_radiance", tier, Q30, radiance_q30, lobe_diffuse_sh_radiance_##tier##_q30)
#define PEER_DFG(name) FUNCTION("peer", name, F32, dfg_f32, peer_##name##_f32)
#define PEER_ENERGY(name) FUNCTION("peer", name, F32, energy_f32, peer_##name##_f32)
#define PEER_SH9(name) FUNCTION("peer", name, F32, sh9_f32, peer_##name##_f32)
static const function functions[] = {
#include "../registry_rows.h"
    FUNCTION("sphere_light", punctual, F32, sphere_f32, lobe_sphere_light_punctual_f32)
        FUNCTION("sphere_light", punctual, Q30, sphere_q30, lobe_sphere_light_punctual_q30) SH9_RADIANCE(exact)
            SH9_RADIANCE(medium) SH9_RADIANCE(low)
#if defined(LOBE_PEERS)
#include "peer_rows.h"
                FUNCTION("peer", zonal_2015_radiance, F32, radiance_f32, peer_zonal_2015_radiance_f32)
#endif
};

static uint32_t instructions(const function *f)
{
#if defined(__arm__)
    return (f->loop(f->called) - f->loop(nothing) + EVALUATIONS / 2) / EVALUATIONS + CALL_AND_RETURN;
#else
    return f->loop(f->called);
#endif
}

static void print_count(uint32_t n)
{
    char text[11];
    int at = 10;
    text[at] = 0;
    do
        text[--at] = (char)('0' + n % 10);
    while (n /= 10);
    lobe_port_print(text + at);
}

static void fill(lobe_format format)
{
    int i;
    for (i = 0; i < EVALUATIONS; i++) {
        roughness[i] = lobe_value_nearest(format, (i / SIDE + 1) / (double)SIDE);
        n_dot_v[i] = lobe_value_nearest(format, (i % SIDE + 1) / (double)SIDE);
    }
}

#if defined(__arm__)
/* The proof of the counter: 30 instructions and the return, so 32 with the call. */
void known(void);
__attribute__((naked, noinline)) void known(void) { __asm__(".rept 30\n nop\n .endr\n bx lr"); }

static int counter_works(void)
{
    static const function f = {"known", "known", LOBE_Q30, loop_energy_q30, known};
    return instructions(&f) == 32;
}
#else
static int counter_works(void) { return 1; }
#endif

int main(void)
{
    size_t i;
    if (!counter_works()) {
        lobe_port_print("the counter miscounts: is this qemu -icount shift=6 on a 25 MHz board?\n");
        return 1;
    }
    lobe_port_print("model,tier,format,instructions\n");
    for (i = 0; i < sizeof functions / sizeof functions[0]; i++) {
        const function *f = &functions[i];
        fill(f->format);
        lobe_port_print(f->model);
        lobe_port_print(",");
        lobe_port_print(f->tier);
        lobe_port_print(",");
        lobe_port_print(lobe_format_names[f->format]);
        lobe_port_print(",");
        print_count(instructions(f));
        lobe_port_print("\n");
    }
    return 0;
}
