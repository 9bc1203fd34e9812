/* One direction a work item: in holds x, y, z, the first cell and the number of cells; out red, green, blue. table is the
 * kernel's parameter, then the cells. kernel.h and core/dialect.h stand before this text (embed.awk). */
#include "kernel.h"

__kernel void lobe_prefilter_rows(__global const double *in, __global double *out, __global const double *table,
                                  int mode)
{
    const size_t i = get_global_id(0);
    const lobe_real x = in[5 * i];
    const lobe_real y = in[5 * i + 1];
    const lobe_real z = in[5 * i + 2];
    const lobe_real parameter = table[0];
    const long count = (long)in[5 * i + 4];
    __global const double *cell = table + 1 + LOBE_PREFILTER_ROW * (long)in[5 * i + 3];
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double mass = 0.0;
    for (long n = 0; n < count; n++) {
        const double s = lobe_prefilter_below(x - cell[0], y - cell[1], z - cell[2]);
        const double t = lobe_prefilter_below(x - cell[3], y - cell[4], z - cell[5]);
        const double w = mode == 0 ? lobe_prefilter_ggx(s, parameter) : lobe_prefilter_sg(s, parameter);
        const double v = mode == 0 ? lobe_prefilter_ggx(t, parameter) : lobe_prefilter_sg(t, parameter);
        mass += v * cell[6];
        red += w * cell[7];
        green += w * cell[8];
        blue += w * cell[9];
        cell += LOBE_PREFILTER_ROW;
    }
    out[3 * i] = red / mass;
    out[3 * i + 1] = green / mass;
    out[3 * i + 2] = blue / mass;
}
