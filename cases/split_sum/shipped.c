#include "shipped.h"
#include <stddef.h>
#include <stdint.h>
#include "../../models/lobe.h"

static int32_t q30(double x) { return (int32_t)(x * 1073741824.0); }
static double real(int32_t x) { return x / 1073741824.0; }

#define DFG(model, tier, bounds)                                                                                       \
    static void model##_##tier##_f32(const double *in, double *out)                                                    \
    {                                                                                                                  \
        const lobe_dfg_f32 d = lobe_##model##_##tier##_f32((float)in[0], (float)in[1]);                                \
        out[0] = (double)d.scale;                                                                                      \
        out[1] = (double)d.bias;                                                                                       \
        out[2] = out[0] + out[1];                                                                                      \
    }                                                                                                                  \
    static void model##_##tier##_q30(const double *in, double *out)                                                    \
    {                                                                                                                  \
        const lobe_dfg_q30 d = lobe_##model##_##tier##_q30(q30(in[0]), q30(in[1]));                                    \
        out[0] = real(d.scale);                                                                                        \
        out[1] = real(d.bias);                                                                                         \
        out[2] = out[0] + out[1];                                                                                      \
    }
#define ENERGY(model, tier, bounds)                                                                                    \
    static void model##_##tier##_f32(const double *in, double *out)                                                    \
    {                                                                                                                  \
        out[0] = (double)lobe_##model##_##tier##_f32((float)in[0], (float)in[1]);                                      \
        out[1] = (double)lobe_##model##_inverse_##tier##_f32((float)in[0], (float)in[1]);                              \
    }                                                                                                                  \
    static void model##_##tier##_q30(const double *in, double *out)                                                    \
    {                                                                                                                  \
        out[0] = real(lobe_##model##_##tier##_q30(q30(in[0]), q30(in[1])));                                            \
        out[1] = 2.0 * real(lobe_##model##_inverse_##tier##_q29(q30(in[0]), q30(in[1])));                              \
    }
#include "tier_rows.h"
#undef DFG
#undef ENERGY

#define DFG(model, tier, bounds)                                                                                       \
    {#model, #tier, "f32", 3, false, model##_##tier##_f32}, {#model, #tier, "q30", 3, false, model##_##tier##_q30},
#define ENERGY(model, tier, bounds)                                                                                    \
    {#model, #tier, "f32", 1, true, model##_##tier##_f32}, {#model, #tier, "q30", 1, true, model##_##tier##_q30},
static const lobe_shipped shipped[] = {
#include "tier_rows.h"
};

const lobe_shipped *lobe_shipped_at(int i)
{
    return i >= 0 && (size_t)i < sizeof shipped / sizeof shipped[0] ? &shipped[i] : NULL;
}
