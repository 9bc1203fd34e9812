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
#include "../peers/energy.h"
#include "../peers/split_sum.h"
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
#include "peer_rows.h"
#undef PEER_DFG
#undef PEER_ENERGY
#endif

enum { SIDE = 16, EVALUATIONS = SIDE * SIDE };

/* One loop for each type of function; the calls cannot be inlined, since the pointer is volatile. */
typedef lobe_dfg_f32 dfg_f32(float, float);
typedef lobe_dfg_q30 dfg_q30(int32_t, int32_t);
typedef float energy_f32(float, float);
typedef int32_t energy_q30(int32_t, int32_t);

typedef struct function {
    const char *model, *tier;
    lobe_format format;
    dfg_f32 *as_dfg_f32;
    dfg_q30 *as_dfg_q30;
    energy_f32 *as_energy_f32;
    energy_q30 *as_energy_q30;
} function;

static lobe_value roughness[EVALUATIONS], n_dot_v[EVALUATIONS];

#define LOOP(type, field, result)                                                                                      \
    static uint32_t loop_##type(type *f)                                                                               \
    {                                                                                                                  \
        type *volatile pointer = f;                                                                                    \
        type *const called = pointer;                                                                                  \
        volatile result sink;                                                                                          \
        int i;                                                                                                         \
        lobe_count_from_here();                                                                                        \
        for (i = 0; i < EVALUATIONS; i++)                                                                              \
            sink = called(roughness[i].field, n_dot_v[i].field);                                                       \
        (void)sink;                                                                                                    \
        return lobe_counted();                                                                                         \
    }
LOOP(dfg_f32, f, lobe_dfg_f32)
LOOP(dfg_q30, q, lobe_dfg_q30)
LOOP(energy_f32, f, float)
LOOP(energy_q30, q, int32_t)

static uint32_t loop(const function *f)
{
    if (f->as_dfg_f32)
        return loop_dfg_f32(f->as_dfg_f32);
    if (f->as_dfg_q30)
        return loop_dfg_q30(f->as_dfg_q30);
    if (f->as_energy_f32)
        return loop_energy_f32(f->as_energy_f32);
    return loop_energy_q30(f->as_energy_q30);
}

/* Returns at once, whatever it is called as. One instruction; with its call two. */
void nothing(void);
#if defined(__arm__)
__attribute__((naked, noinline)) void nothing(void) { __asm__("bx lr"); }
#else
__attribute__((noinline)) void nothing(void) { __asm__ volatile(""); }
#endif
enum { CALL_AND_RETURN = 2 };

#define DFG_F32(model, tier, bounds) {#model, #tier, LOBE_F32, lobe_##model##_##tier##_f32, 0, 0, 0},
#define DFG_Q30(model, tier, bounds) {#model, #tier, LOBE_Q30, 0, lobe_##model##_##tier##_q30, 0, 0},
#define DFG_Q30_SCALAR(model, tier, bounds) DFG_Q30(model, tier, bounds)
#define ENERGY_F32(model, tier, bounds)                                                                                \
    {#model, #tier, LOBE_F32, 0, 0, lobe_##model##_##tier##_f32, 0},                                                   \
        {#model "_inverse", #tier, LOBE_F32, 0, 0, lobe_##model##_inverse_##tier##_f32, 0},
#define ENERGY_Q30(model, tier, bounds) {#model, #tier, LOBE_Q30, 0, 0, 0, lobe_##model##_##tier##_q30},
#define PEER_DFG(name) {"peer", #name, LOBE_F32, peer_##name##_f32, 0, 0, 0},
#define PEER_ENERGY(name) {"peer", #name, LOBE_F32, 0, 0, peer_##name##_f32, 0},
static const function functions[] = {
#include "../registry_rows.h"
#if defined(LOBE_PEERS)
#include "peer_rows.h"
#endif
};

static uint32_t instructions(const function *f)
{
    function baseline = *f;
    baseline.as_dfg_f32 = f->as_dfg_f32 ? (dfg_f32 *)nothing : 0;
    baseline.as_dfg_q30 = f->as_dfg_q30 ? (dfg_q30 *)nothing : 0;
    baseline.as_energy_f32 = f->as_energy_f32 ? (energy_f32 *)nothing : 0;
    baseline.as_energy_q30 = f->as_energy_q30 ? (energy_q30 *)nothing : 0;
    return (loop(f) - loop(&baseline) + EVALUATIONS / 2) / EVALUATIONS + CALL_AND_RETURN;
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
    static const function f = {"known", "known", LOBE_Q30, 0, 0, 0, (energy_q30 *)known};
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
