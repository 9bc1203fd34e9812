/* Hand-made formulas whose cost is plain to a reader: the counting convention, one rule a formula. */
#define LOBE_TRACE 1
#include "../fit/trace.h"

#include <math.h>

static lobe_graph graph;
static int number, failed;

static lobe_real a, b, c, d;

static void begin()
{
    lobe_graph_begin(&graph);
    graph.input_name[0] = "a";
    graph.input_name[1] = "b";
    a = lobe_input(0);
    b = lobe_input(1);
    c = lobe_input(2);
    d = lobe_input(3);
}

static void check(const char *name, const lobe_real &x, const lobe_real &y, int fused, int plain)
{
    graph.output[0] = x.id;
    graph.output[1] = y.id;
    graph.outputs = y.id == x.id ? 1 : 2;
    lobe_graph_prune(&graph);
    const lobe_op_count n = lobe_graph_count(&graph);
    const int good = n.fused == fused && n.plain == plain;
    printf("%sok %d - %s\n", good ? "" : "not ", ++number, name);
    if (!good)
        printf("# counted %d fused and %d plain, expected %d and %d\n", n.fused, n.plain, fused, plain);
    failed += !good;
    begin();
}

static void check(const char *name, const lobe_real &x, int fused, int plain) { check(name, x, x, fused, plain); }

int main()
{
    begin();
    check("an addition", a + b, 1, 1);
    check("a product and an addition fuse", a * b + c, 1, 2);
    check("one minus a product fuses", lobe_real(1.0) - a * b, 1, 2);
    check("of two products one fuses", a * b + c * d, 2, 3);
    lobe_real p = a * b;
    check("a product that is used twice does not fuse", (p + c) * (p + d), 4, 4);
    p = a * b;
    check("a product that is also a result does not fuse", p, p + c, 2, 2);
    check("equal subexpressions count once, in either order", (a + b) * (b + a), 2, 2);
    check("saturate is free", lobe_saturate(a * b + c), 1, 2);
    check("a saturated product does not fuse", lobe_saturate(a * b) + c, 2, 2);
    check("clamp to other bounds is a max and a min", lobe_clamp(a, lobe_real(0.1), lobe_real(0.9)), 2, 2);
    check("negation is free", -(a + b), 1, 1);
    check("a division", a / b, 4, 4);
    check("a reciprocal", lobe_reciprocal(b), 4, 4);
    check("a reciprocal written as a division", lobe_real(1.0) / b, 4, 4);
    check("two divisions share the reciprocal", a / c, b / c, 6, 6);
    check("a reciprocal that a division shares", lobe_real(1.0) / c, b / c, 5, 5);
    check("division by a constant is a product", a / lobe_real(3.0), 1, 1);
    check("what is constant is free", a * (lobe_real(2.0) + lobe_real(3.0) * lobe_real(4.0)), 1, 1);
    check("exp2, log2 and sqrt", lobe_exp2(a) + lobe_log2(b) * lobe_sqrt(c), 13, 14);
    check("select", lobe_select(a, b, c), 1, 1);
    check("Horner", a * (a * (a * lobe_real(2.0) + lobe_real(3.0)) + lobe_real(4.0)) + lobe_real(5.0), 3, 6);
    (a + b) * c; /* recorded, then needed by nothing */
    check("what no result needs is free", c + d, 1, 1);

    const double in[4] = {0.3, 0.7, 1.9, -0.2};
    double value[64];
    lobe_real y = lobe_min(lobe_saturate(a / b - c * d), lobe_max(lobe_sqrt(a), -d)) + lobe_select(d, a, b);
    graph.output[0] = y.id;
    graph.outputs = 1;
    lobe_graph_prune(&graph);
    lobe_graph_eval(&graph, in, value);
    const double want = fmin(fmin(fmax(0.3 / 0.7 + 1.9 * 0.2, 0.0), 1.0), fmax(sqrt(0.3), 0.2)) + 0.7;
    const int good = fabs(value[graph.output[0]] - want) < 1e-15;
    printf("%sok %d - a recorded formula gives its value\n", good ? "" : "not ", ++number);
    failed += !good;
    printf("1..%d\n", number);
    return failed != 0;
}
