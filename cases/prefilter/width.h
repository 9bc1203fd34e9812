/* The kernels a cube map is filtered with, and which mip holds which width.
 *
 * ggx: max(0, c) / (1 + k (1 - c))^2, k = (1/alpha^2 - 1)/2: GGX about the normal seen from the mirror direction, what
 * engines call the split sum's prefilter. Its width is the perceptual roughness r = sqrt(alpha).
 *
 * sg: exp(lambda (c - 1)). Its width is the sharpness lambda; r = lambda^(-1/4) has the ggx kernel's curvature at the
 * peak, 1 + 2k = 1/r^4 = lambda, so that both share one scale.
 *
 * Both are normalised to 1 over the sphere. Mip m of M + 1 holds the r with m = t = M r (a + (1 - a) r), and between
 * two mips
 *     lod = min(t, t^3),    r = 2 x / (a + sqrt(a^2 + 4 (1 - a) x)),  x = max(lod, lod^(1/3)) / M.
 * The cube is for mip 0, the mirror, which the cube's own texels make as wide as a kernel some way towards mip 1: a
 * kernel between the two has less of mip 1 than in proportion. */
#ifndef LOBE_PREFILTER_WIDTH_H
#define LOBE_PREFILTER_WIDTH_H

typedef enum lobe_prefilter_kernel { LOBE_PREFILTER_GGX, LOBE_PREFILTER_SG } lobe_prefilter_kernel;

typedef struct lobe_prefilter_scale {
    lobe_prefilter_kernel kernel;
    int mips;     /* M + 1 */
    double curve; /* a, in [LOBE_PREFILTER_CURVE_MIN, LOBE_PREFILTER_CURVE_MAX] */
} lobe_prefilter_scale;

#define LOBE_PREFILTER_CURVE_MIN 1.0
#define LOBE_PREFILTER_CURVE_MAX 2.0
/* Little trilinear error over all widths for 7 mips of a 256 cube, in rooms and under suns; README.md has the
 * measurement.
 */
#define LOBE_PREFILTER_CURVE_GGX 1.8
#define LOBE_PREFILTER_CURVE_SG 1.9

lobe_prefilter_scale lobe_prefilter_scale_default(lobe_prefilter_kernel kernel, int mips);
/* Roughness or sharpness to a mip in [0, M]; NaN and widths beyond the last mip's count as the last mip's. */
double lobe_prefilter_lod(const lobe_prefilter_scale *scale, double width);
/* And back: roughness 0 or infinite sharpness at mip 0. */
double lobe_prefilter_width(const lobe_prefilter_scale *scale, double lod);
/* The kernel's parameter: k, or lambda. Infinite for a mirror. */
double lobe_prefilter_parameter(lobe_prefilter_kernel kernel, double width);
/* The kernel's value at cosine c, normalised. */
double lobe_prefilter_density(lobe_prefilter_kernel kernel, double parameter, double c);

#endif
