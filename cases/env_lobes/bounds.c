#include "bounds.h"
#include <stdlib.h>
#include <string.h>
#include "../../models/lobe.h"
#include "../fit/bounds.h"
#include "operations.h"

/* The sum of the weights, exact in double, and what a furnace divides by. */
#define SUM(name, tap, taps_count, evaluated, weighed)                                                                 \
    static void name(const double *in, double *out)                                                                    \
    {                                                                                                                  \
        tap taps[taps_count];                                                                                          \
        int k;                                                                                                         \
        evaluated;                                                                                                     \
        for (out[0] = 0, k = 0; k < taps_count; k++)                                                                   \
            out[0] += weighed;                                                                                         \
        out[1] = 1 / out[0];                                                                                           \
    }
#define Q30(x) ((int32_t)((x)*1073741824.0))
#define BOTH(model, tier, kernel, n, tap_f32, tap_q30, weight_q16)                                                     \
    SUM(model##_##tier##_f32, tap_f32, n, kernel##_f32((float)in[0], (float)in[1], taps), (double)taps[k].weight)      \
    SUM(model##_##tier##_q30, tap_q30, n, kernel##_q30(Q30(in[0]), Q30(in[1]), taps), taps[k].weight_q16 / 65536.0)
#define ENV(model, tier, bounds, kernel, n) BOTH(model, tier, kernel, n, lobe_env_tap_f32, lobe_env_tap_q30, weight_q16)
#define ENV_SG(model, tier, bounds, kernel, n)                                                                         \
    BOTH(model, tier, kernel, n, lobe_env_sg_tap_f32, lobe_env_sg_tap_q16, weight)
#include "tier_rows.h"
#undef ENV
#undef ENV_SG

#define ENV(model, tier, bounds, kernel, n)                                                                            \
    {#model, #tier, "f32", 1, false, model##_##tier##_f32}, {#model, #tier, "q30", 1, false, model##_##tier##_q30},
#define ENV_SG ENV
static const lobe_shipped shipped[] = {
#include "tier_rows.h"
};

static const lobe_shipped *shipped_at(int i)
{
    return i >= 0 && (size_t)i < sizeof shipped / sizeof shipped[0] ? &shipped[i] : NULL;
}

static int operations(const lobe_shipped *s)
{
#if defined(LOBE_WITH_EMIT)
    const int taps = atoi(s->tier + strlen("lobes"));
    if (strcmp(s->tier, "adaptive") == 0)
        return lobe_env_adaptive_operations();
    return strstr(s->tier, "_table") ? lobe_env_table_operations(taps)
                                     : lobe_env_operations(strcmp(s->model, "env_lobes_sg") == 0, taps);
#else
    fprintf(stderr, "lobefit: bounds %s: operations are counted by a program in C++, which this build has not\n",
            s->model);
    return -1;
#endif
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    const lobe_bounded what = {.truth = lobe_case_find("split_sum"),
                               .shipped = shipped_at,
                               .part = "ENERGY",
                               .note = ". MAX, RMS: of the sum of the weights, E is the albedo; ENERGY: of\n"
                                       " * |E / sum - 1|, which a white furnace shows. OPS: the kernel's in "
                                       "models/env_lobes*.h, the albedo given.",
                               .operations = operations};
    return lobe_bounds_write(self, &what, request);
}

int lobe_env_bounds(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
