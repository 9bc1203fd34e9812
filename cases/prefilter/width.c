#include "width.h"
#include "../environment/environment.h"
#include <math.h>

lobe_prefilter_scale lobe_prefilter_scale_default(lobe_prefilter_kernel kernel, int mips)
{
    const lobe_prefilter_scale scale = {
        kernel, mips, kernel == LOBE_PREFILTER_GGX ? LOBE_PREFILTER_CURVE_GGX : LOBE_PREFILTER_CURVE_SG};
    return scale;
}

double lobe_prefilter_lod(const lobe_prefilter_scale *scale, double width)
{
    const double a = scale->curve;
    double r = width;
    if (scale->kernel == LOBE_PREFILTER_SG)
        r = width > 1 ? sqrt(sqrt(1 / width)) : 1;
    r = r < 0 ? 0 : r <= 1 ? r : 1;
    const double t = (scale->mips - 1) * r * (a + (1 - a) * r);
    return t < 1 ? t * t * t : t;
}

double lobe_prefilter_width(const lobe_prefilter_scale *scale, double lod)
{
    const double a = scale->curve, last = scale->mips - 1;
    const double t = lod > 0 ? (lod < 1 ? cbrt(lod) : lod) : 0, x = last > 0 ? fmin(t / last, 1) : 0;
    const double b = a * a + 4 * (1 - a) * x, r = 2 * x / (a + sqrt(b > 0 ? b : 0));
    return scale->kernel == LOBE_PREFILTER_SG ? 1 / (r * r * r * r) : r;
}

double lobe_prefilter_parameter(lobe_prefilter_kernel kernel, double width)
{
    return kernel == LOBE_PREFILTER_SG ? width : (1 / (width * width * width * width) - 1) / 2;
}

/* With s = 1 - c: the integral of (1 - s) / (1 + k s)^2 over s in [0, 1] is (k - ln(1 + k)) / k^2, which cancels for
 * small k. */
static double ggx_mass(double k)
{
    if (k < 0.01)
        return 0.5 + k * (-1 / 3.0 + k * (0.25 + k * (-0.2 + k * (1 / 6.0 - k / 7))));
    return (k - log1p(k)) / (k * k);
}

double lobe_prefilter_density(lobe_prefilter_kernel kernel, double parameter, double c)
{
    const double s = 1 - c, p = parameter;
    if (kernel == LOBE_PREFILTER_SG)
        return p > 0 ? p * exp(-p * s) / (-expm1(-2 * p) * 2 * LOBE_PI) : 1 / (4 * LOBE_PI);
    return c > 0 ? c / ((1 + p * s) * (1 + p * s) * ggx_mass(p) * 2 * LOBE_PI) : 0;
}
