/* One row of truth a work item: truth_kernel.h stands before this text (embed.awk). table holds the nodes, then their
 * weights; mode is the Smith form, plus 16 for one column with scale + bias. */
#include "truth_kernel.h"

__kernel void lobe_truth_rows(__global const double *in, __global double *out, __global const double *table, int mode)
{
    const size_t i = get_global_id(0);
    const int smith = mode % 16;
    const lobe_real roughness = in[2 * i];
    const lobe_real alpha = roughness * roughness;
    lobe_truth_sum sum =
        lobe_truth_split_sum(smith, alpha, in[2 * i + 1], table, table + LOBE_TRUTH_ORDER, LOBE_TRUTH_ORDER);
    if (mode >= 16) {
        out[i] = sum.scale + sum.bias;
    } else {
        out[2 * i] = sum.scale;
        out[2 * i + 1] = sum.bias;
    }
}
