/* The compiled q30 functions of every tier against two references at the same inputs: the emitter's simulation in 64
 * bits, bit for bit, which also sees whether a value leaves 32 bits; and the formula in double, within the bound that
 * the project states. Built with trapping signed overflow. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../fit/emit.h"
#include "test_emit_q30_rows.h"

static int number, failed;

static void report(int good, const char *model, const char *tier, const char *what)
{
    printf("%sok %d - %s %s: %s\n", good ? "" : "not ", ++number, model, tier, what);
    failed += !good;
}

typedef struct tally {
    long different, wide, outside;
    double worst;
    int32_t at[2];
} tally;

static void at(const row *f, int32_t r, int32_t v, tally *t)
{
    const int32_t in[2] = {r, v};
    int32_t got[9] = {0}, simulated[9] = {0};
    double x[2], want[9];
    int i, n;
    for (i = 0; i < 2; i++)
        x[i] = (in[i] < 0 ? 0 : in[i] > 1 << 30 ? 1 << 30 : in[i]) / 1073741824.0;
    f->call(r, v, got);
    n = lobe_emit_value_q30(f->model, f->tier, in, simulated);
    if (n <= 0) {
        t->wide++;
        return;
    }
    lobe_emit_value(f->model, f->tier, x, want);
    for (i = 0; i < n; i++) {
        const double e = fabs(got[i] / 1073741824.0 - want[i]);
        t->different += got[i] != simulated[i];
        t->outside += got[i] < 0 || got[i] > 1 << 30;
        if (e > t->worst) {
            t->worst = e;
            t->at[0] = r;
            t->at[1] = v;
        }
    }
}

static void sweep(const row *f)
{
    static const int32_t odd[] = {-2147483647 - 1,
                                  -1,
                                  0,
                                  1,
                                  2,
                                  3,
                                  1 << 12,
                                  1 << 20,
                                  (1 << 24) - 1,
                                  1 << 24,
                                  (1 << 27) - 1,
                                  1 << 27,
                                  (1 << 29) + 1,
                                  (1 << 30) - 1,
                                  1 << 30,
                                  (1 << 30) + 1,
                                  2147483647};
    const int odds = (int)(sizeof odd / sizeof odd[0]);
    tally t;
    uint32_t state = 2463534242u;
    char text[120];
    int i, k, part;
    memset(&t, 0, sizeof t);
    for (i = 0; i < odds; i++)
        for (k = 0; k < odds; k++)
            at(f, odd[i], odd[k], &t);
    for (i = 0; i <= 192; i++)
        for (k = 0; k <= 192; k++)
            at(f, (int32_t)((double)i / 192 * 1073741824.0), (int32_t)((double)k / 192 * 1073741824.0), &t);
    /* Random at every scale, so that the corner at 0 is met from all sides. */
    for (i = 0; i < 30000; i++) {
        int32_t in[2];
        for (part = 0; part < 2; part++) {
            state ^= state << 13, state ^= state >> 17, state ^= state << 5;
            in[part] = (int32_t)((state >> 2) >> (i / 7 * (part + 1) % 31));
        }
        at(f, in[0], in[1], &t);
    }
    report(!t.wide, f->model, f->tier, "no value needs more than 32 bits");
    report(!t.different, f->model, f->tier, "compiled code has the bits of the simulation");
    report(!t.outside, f->model, f->tier, "results in [0, 1]");
    sprintf(text, "within %.2g of the formula in double", f->bound);
    report(t.worst <= f->bound, f->model, f->tier, text);
    printf("# %.3g at 0x%08x 0x%08x\n", t.worst, (unsigned)t.at[0], (unsigned)t.at[1]);
}

int main(void)
{
    size_t i;
    for (i = 0; i < sizeof rows / sizeof rows[0]; i++)
        sweep(&rows[i]);
    printf("1..%d\n", number);
    return failed != 0;
}
