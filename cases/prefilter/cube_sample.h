/* A reference sampler of cube maps: what seamless hardware filtering with trilinear interpolation gives, in double.
 * Beyond an edge the neighbouring face's texels are taken; at a corner, where only three texels meet, their mean stands
 * for the fourth. */
#ifndef LOBE_CUBE_SAMPLE_H
#define LOBE_CUBE_SAMPLE_H
#include "cube.h"
#include "width.h"

/* Which texels of a mip a bilinear lookup takes, and how much of each. */
typedef struct lobe_cube_footprint {
    int count;
    lobe_cube_texel texel[6];
    double weight[6];
} lobe_cube_footprint;

void lobe_cube_footprint_of(int side, const double d[3], lobe_cube_footprint *footprint);

/* Bilinear within one mip; d of any length but 0. */
void lobe_cube_sample_mip(const lobe_cube *cube, int mip, const double d[3], double rgb[3]);
/* Trilinear; lod counts as the nearest of [0, mips - 1]. */
void lobe_cube_sample_lod(const lobe_cube *cube, const double d[3], double lod, double rgb[3]);
/* At a width: roughness for a ggx cube, sharpness for an sg cube. What a lobe of a model is evaluated with. */
void lobe_cube_sample(const lobe_cube *cube, const lobe_prefilter_scale *scale, const double d[3], double width,
                      double rgb[3]);

#endif
