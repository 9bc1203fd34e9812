#define LOBE_DOUBLE
#include "truth_kernel.h"
#include "truth_split_sum.h"
#include "truth_nodes.h"

/* columns: 2 for scale and bias, 1 for their sum */
static void rows(int smith, int columns, const double *in, double *out, size_t n)
{
    double u[LOBE_TRUTH_ORDER], weight[LOBE_TRUTH_ORDER];
    size_t i;
    lobe_truth_nodes(u, weight, LOBE_TRUTH_ORDER);
    for (i = 0; i < n; i++) {
        const double alpha = in[2 * i] * in[2 * i];
        const lobe_truth_sum sum = lobe_truth_split_sum(smith, alpha, in[2 * i + 1], u, weight, LOBE_TRUTH_ORDER);
        if (columns == 2) {
            out[2 * i] = sum.scale;
            out[2 * i + 1] = sum.bias;
        } else {
            out[i] = sum.scale + sum.bias;
        }
    }
}

void lobe_truth_split_sum_rows(const double *in, double *out, size_t n) { rows(LOBE_TRUTH_CORRELATED, 2, in, out, n); }

void lobe_truth_split_sum_sep_rows(const double *in, double *out, size_t n)
{
    rows(LOBE_TRUTH_SEPARABLE, 2, in, out, n);
}

void lobe_truth_split_sum_kibl_rows(const double *in, double *out, size_t n) { rows(LOBE_TRUTH_KIBL, 2, in, out, n); }

void lobe_truth_energy_rows(const double *in, double *out, size_t n) { rows(LOBE_TRUTH_CORRELATED, 1, in, out, n); }

size_t lobe_truth_split_sum_order(int smith, double alpha, double n_dot_v, int order, double *out)
{
    double u[LOBE_TRUTH_NODES_MAX], weight[LOBE_TRUTH_NODES_MAX];
    lobe_truth_sum sum;
    lobe_truth_nodes(u, weight, order);
    sum = lobe_truth_split_sum(smith, alpha, n_dot_v, u, weight, order);
    out[0] = sum.scale;
    out[1] = sum.bias;
    return (size_t)(n_dot_v < 1.0 ? 3 : 2) * (size_t)order * (size_t)order;
}
