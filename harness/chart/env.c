/* What every shipped fan of taps costs, as CSV: model, tier, operations, and lookups: the taps whose weight is not 0,
 * in the mean over a uniform (roughness, NdotV) square, so that a tier which leaves some out is charged for what it
 * uses. */
#include <stdio.h>
#include "../registry.h"

enum { SIDE = 64 };

static double lookups(const lobe_entry *e)
{
    long taps = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        lobe_value out[LOBE_MAX_OUTPUTS];
        const lobe_value in[2] = {lobe_value_nearest(e->format, (i / SIDE + .5) / SIDE),
                                  lobe_value_nearest(e->format, (i % SIDE + .5) / SIDE)};
        e->call(in, out);
        for (int k = e->nth - 1; k < e->outputs; k += e->nth)
            taps += out[k].f < 0 || out[k].f > 0;
    }
    return (double)taps / (SIDE * SIDE);
}

int main(int argc, char **argv)
{
    (void)argv;
    if (argc != 1) {
        fprintf(stderr, "usage: env\n");
        return 2;
    }
    for (size_t i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        if (e->prefilter && e->format == LOBE_F32)
            printf("%s,%s,%d,%.3g\n", e->model, e->tier, e->ops, lookups(e));
    }
    return 0;
}
