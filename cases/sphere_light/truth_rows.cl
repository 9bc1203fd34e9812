/* One row of lobe_stretched a work item; the light is set where alpha is 0. truth_stretched.h stands before this text
 * (embed.awk). */
#include "truth_stretched.h"

__kernel void lobe_truth_rows(__global const double *in, __global double *out, __global const double *table, int mode)
{
    const size_t i = get_global_id(0);
    __global const double *row = in + LOBE_STRETCHED_ROW * i;
    lobe_stretched s;
    int k;
    s.alpha = row[0];
    s.v_z = row[1];
    s.root_v = row[2];
    s.f0 = row[3];
    s.relative = row[4];
    s.outside = row[5];
    s.tan2 = row[6];
    s.tan3 = row[7];
    s.u_x = row[8];
    s.u_z = row[9];
    for (k = 0; k < 3; k++) {
        s.e1[k] = row[10 + k];
        s.e2[k] = row[13 + k];
        s.e3[k] = row[16 + k];
    }
    out[i] = s.alpha > 0 ? lobe_stretched_integral(&s) : 0;
}
