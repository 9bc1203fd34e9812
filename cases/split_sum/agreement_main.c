/* Measures how far the integrators of the split sum are from each other, over dense grids, and prints what README.md
 * quotes. Usage: truth_sweep DATE > agreement.txt; `make truth-sweep` runs it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "../energy/truth_energy.h"
#include "../fit/sweep.h"
#include "truth_half.h"
#include "truth_qmc.h"
#include "truth_split_sum.h"

static const char *const forms[3] = {"correlated", "separable", "Schlick-Smith k = alpha/2"};

/* What a sweep compares is set here before it starts; the threads only read. */
static int smith, order_a, order_b;

/* Rows: alpha, NdotV -> the largest difference of scale, bias and E. Order 0 stands for the half vector. */
static void evaluate(double alpha, double v, int order, double *out)
{
    if (order == 0)
        lobe_truth_half(smith, alpha, v, 1.0 / 24, out);
    else
        lobe_truth_split_sum_order(smith, alpha, v, order, out);
}

static void difference(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        double a[2], b[2];
        evaluate(in[2 * i], in[2 * i + 1], order_a, a);
        evaluate(in[2 * i], in[2 * i + 1], order_b, b);
        out[i] = fmax(fabs(a[0] + a[1] - b[0] - b[1]), fmax(fabs(a[0] - b[0]), fabs(a[1] - b[1])));
        if (!isfinite(a[0] + a[1] + b[0] + b[1])) /* fmax would hide it */
            out[i] = INFINITY;
    }
}

static void energy_difference(const double *in, double *out, size_t n)
{
    size_t i, count;
    for (i = 0; i < n; i++) {
        double b[2];
        lobe_truth_split_sum_order(smith, in[2 * i], in[2 * i + 1], 64, b);
        out[i] = fabs(lobe_truth_energy(smith, in[2 * i], in[2 * i + 1], order_a, &count) - b[0] - b[1]);
    }
}

/* Grid of side^2: alpha logarithmic in [lo, hi]; NdotV half logarithmic in [.001, .5], half in [.5, 1] as 1 minus a
 * logarithmic distance, so that both ends are dense. Prints the maximum and where it is. */
static void sweep(const char *what, lobe_sweep_fn f, double lo, double hi, int side)
{
    lobe_sweep_options options = lobe_sweep_options_default();
    const size_t n = (size_t)side * (size_t)side;
    double *in = malloc(2 * n * sizeof *in), *out = malloc(n * sizeof *out), sum = 0;
    size_t i, worst = 0;
    if (!in || !out) {
        fputs("truth_sweep: not enough memory\n", stderr);
        exit(2);
    }
    for (i = 0; i < n; i++) {
        const double x = (double)(i / (size_t)side) / (side - 1), y = (double)(i % (size_t)side) / (side - 1);
        in[2 * i] = fmin(hi, lo * pow(hi / lo, x));
        in[2 * i + 1] = y < 0.5 ? 0.001 * pow(500, 2 * y) : 1 - 0.5 * pow(1e-6, 2 * y - 1);
        if (i % (size_t)side == (size_t)side - 1)
            in[2 * i + 1] = 1;
    }
    options.label = what;
    lobe_sweep(f, in, 2, out, 1, n, &options);
    for (i = 0; i < n; i++) {
        sum += out[i] * out[i];
        if (out[i] > out[worst])
            worst = i;
    }
    printf("  %-26s %-26s %4d^2  max %8.1e at alpha %.6g v %.9g, rms %7.1e\n", what, forms[smith], side, out[worst],
           in[2 * worst], in[2 * worst + 1], sqrt(sum / (double)n));
    fflush(stdout);
    free(in);
    free(out);
}

static void compare(const char *what, int a, int b, double lo, double hi, int side)
{
    order_a = a;
    order_b = b;
    for (smith = 0; smith < 3; smith++)
        sweep(what, difference, lo, hi, side);
}

static void quasi_monte_carlo(void)
{
    static const double at[4][2] = {{0.0025, 0.3}, {0.04, 0.05}, {0.25, 0.5}, {1, 0.9}};
    static const size_t samples[4] = {64, 4096, 65536, 262144};
    int point, k, sequence;
    for (point = 0; point < 4; point++) {
        double truth[2];
        lobe_truth_split_sum_order(0, at[point][0], at[point][1], 64, truth);
        for (sequence = 0; sequence < 2; sequence++) {
            printf("  alpha %-7g v %-5g %-10s", at[point][0], at[point][1], sequence ? "Halton" : "Hammersley");
            for (k = 0; k < 4; k++) {
                lobe_qmc_options options = lobe_qmc_options_default();
                double out[2], error[2];
                options.sequence = (lobe_qmc_sequence)sequence;
                options.samples = samples[k];
                lobe_truth_qmc(0, at[point][0], at[point][1], &options, out, error);
                printf("  %zu: %.1e", options.samples * (size_t)options.shifts,
                       fabs(out[0] + out[1] - truth[0] - truth[1]));
            }
            puts("");
        }
    }
}

int main(int argc, char **argv)
{
    int order;
    if (argc != 2) {
        fputs("usage: truth_sweep DATE > agreement.txt\n", stderr);
        return 2;
    }
    printf("Agreement of the integrators of the split sum, measured %s by `make truth-sweep`.\n"
           "Differences are the largest of scale, bias and E, absolute.\n\n",
           argv[1]);
    puts("Half vector (tanh-sinh, step 1/24) against light direction (Gauss, 3*64^2), alpha in [.002, 1], v in "
         "[.001, 1]");
    compare("half - order 64", 0, 64, 0.002, 1, 40);
    puts("\nThe same against the production rule (3*28^2)");
    compare("half - order 28", 0, 28, 0.002, 1, 40);
    puts("\nBelow: alpha in [1e-6, .002], which is roughness in [.001, .0447]");
    compare("half - order 64", 0, 64, 1e-6, 0.002, 24);
    compare("half - order 28", 0, 28, 1e-6, 0.002, 24);
    puts("\nProduction rule against order 64, dense");
    compare("order 28 - order 64", 28, 64, 0.002, 1, 256);
    compare("order 28 - order 64", 28, 64, 1e-6, 0.002, 128);
    puts("\nConvergence: order n against order 64, alpha in [1e-6, 1]");
    for (order = 8; order <= 32; order += 4) {
        char what[32];
        snprintf(what, sizeof what, "order %d, %d evaluations", order, 3 * order * order);
        order_a = order;
        order_b = 64;
        smith = 0;
        sweep(what, difference, 1e-6, 1, 64);
    }
    puts("\nE by the elementary azimuth integral against order 64, alpha in [.002, 1]");
    for (order_a = 16; order_a <= 32; order_a += 4) {
        char what[32];
        snprintf(what, sizeof what, "E, %d evaluations", 3 * order_a);
        smith = 0;
        sweep(what, energy_difference, 0.002, 1, 64);
    }
    puts("\nQuasi-Monte Carlo (visible normals, 16 random shifts) against order 64: |E| error by number of samples");
    quasi_monte_carlo();
    return 0;
}
