/* The interval analysis against plain evaluation: values at random points of random boxes lie inside the enclosures;
 * enclosures have the bounds that algebra gives; the proved error covers every error that is met. */
#include "../fit/emit_q30.h"

#include <math.h>
#include <stdlib.h>

static lobe_graph graph;
static lobe_q_program program;
static lobe_interval range[LOBE_NODES], finer[LOBE_NODES];
static double value[LOBE_NODES];
static int number, failed;
static unsigned state = 123456789u;

static unsigned next()
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state;
}

static void report(int good, const char *tier, const char *what)
{
    printf("%sok %d - try %s: %s\n", good ? "" : "not ", ++number, tier, what);
    failed += !good;
}

/* Anywhere, of any size, so that saturations, the guard and the corner are met. */
static lobe_box random_box()
{
    lobe_box box;
    for (int k = 0; k < 2; k++) {
        const int one = 1 << 30, at = (int)(next() >> 2) >> (next() % 31), size = (int)(next() >> 2) >> (next() % 31);
        box.lo[k] = at;
        box.hi[k] = size > one - at ? one : at + size;
    }
    return box;
}

static void enclosures()
{
    int outside = 0, wider = 0, boxes = 0;
    for (int n = 0; n < 3000; n++) {
        const lobe_box box = random_box();
        if (lobe_range_box(&graph, &box, 1, range))
            continue; /* large boxes may not keep a denominator from 0 */
        boxes++;
        for (int p = 0; p < 16; p++) {
            double in[2];
            for (int k = 0; k < 2; k++) {
                const unsigned span = (unsigned)(box.hi[k] - box.lo[k]) + 1;
                const unsigned step = p < 4 ? ((p >> k) & 1 ? span - 1 : 0) : next() % span;
                in[k] = 0x1p-30 * ((double)box.lo[k] + step);
            }
            lobe_graph_eval(&graph, in, value);
            for (int i = 0; i < graph.nodes; i++) {
                const double slack = 1e-10; /* the evaluation's own rounding, where terms cancel */
                outside += value[i] < range[i].lo - slack || value[i] > range[i].hi + slack;
            }
        }
        if (lobe_range_box(&graph, &box, 4, finer))
            continue;
        for (int i = 0; i < graph.outputs; i++)
            wider += finer[graph.output[i]].lo < range[graph.output[i]].lo - 1e-9 ||
                     finer[graph.output[i]].hi > range[graph.output[i]].hi + 1e-9;
    }
    report(boxes > 1000 && !outside, graph.tier, "every value lies in its enclosure");
    report(!wider, graph.tier, "parts of a box enclose no wider than the box");
}

/* v / (v + k r^2) in [0, 1] over the whole square, whatever plain division says. */
static void quotient()
{
    const lobe_box all = {{0, 0}, {1 << 30, 1 << 30}};
    int found = 0, good = 1;
    if (lobe_range_box(&graph, &all, 1, range) == 0)
        for (int i = 0; i < graph.nodes; i++)
            if (graph.node[i].op == LOBE_OP_DIV && graph.node[graph.node[i].arg[0]].op != LOBE_OP_CONST) {
                found++;
                good &= range[i].lo >= -1e-12 && range[i].hi <= 1.0 + 1e-12 && range[i].hi >= 1.0 - 1e-12;
            }
    report(found == 1 && good, graph.tier, "v / (v + k r^2) is enclosed by [0, 1]");
}

static void proof()
{
    lobe_q_proof proved;
    int worse = 0;
    if (lobe_q_compile(&graph, &program, &proved))
        exit(2);
    for (int n = 0; n < 100000; n++) {
        const int32_t in[2] = {(int32_t)(next() >> 2) >> (n % 31), (int32_t)(next() >> 2) >> (n / 31 % 31)};
        const double x[2] = {in[0] * 0x1p-30, in[1] * 0x1p-30};
        int32_t out[LOBE_OUTPUTS];
        worse += lobe_q_run(&program, in, out);
        lobe_graph_eval(&graph, x, value);
        for (int o = 0; o < graph.outputs; o++)
            worse += fabs(out[o] * 0x1p-30 - value[graph.output[o]]) > proved.error[o];
    }
    report(proved.fits && !worse, graph.tier, "no error exceeds the proved one");
    /* An addition whose scale leaves no room must not be proved. */
    for (int i = 0; i < program.ops; i++)
        if (program.op[i].kind == LOBE_Q_ADD)
            program.op[i].fraction = 32;
    lobe_q_prove(&program, &proved);
    report(!proved.fits, graph.tier, "a program that overflows is not proved");
}

int main()
{
    for (int i = 0; lobe_kernel_trace(i, &graph); i++) {
        enclosures();
        if (i < 2)
            quotient();
        if (i != 1) /* the long one adds seconds and nothing new */
            proof();
    }
    printf("1..%d\n", number);
    return failed != 0;
}
