/* From a map to a filtered cube map. */
#ifndef LOBE_PREFILTER_H
#define LOBE_PREFILTER_H
#include "cells.h"
#include "cube.h"
#include "source.h"
#include "width.h"

typedef struct lobe_prefilter_options {
    lobe_prefilter_scale scale; /* its mips are those of the cube */
    int size;
    double detail; /* LOBE_PREFILTER_DETAIL; smaller is finer and slower */
    int threads;   /* 1 .. LOBE_PREFILTER_THREADS; the bytes do not depend on it */
    int opencl;    /* the sums through OpenCL, with the same text */
    int fit;       /* through lobe_prefilter_fit */
    int progress;  /* a line with rate and estimate on stderr, once it takes more than a second */
} lobe_prefilter_options;

enum { LOBE_PREFILTER_THREADS = 64, LOBE_PREFILTER_TILE = 4, LOBE_PREFILTER_FIT_SIDE = 16 };

typedef enum lobe_prefilter_status {
    LOBE_PREFILTER_DONE,
    LOBE_PREFILTER_INTERRUPTED, /* lobe_interrupt_requested() */
    LOBE_PREFILTER_NO_MEMORY,
    LOBE_PREFILTER_NO_OPENCL /* the reason stands in error */
} lobe_prefilter_status;

lobe_prefilter_options lobe_prefilter_options_default(lobe_prefilter_kernel kernel, int size);

/* Fills a cube (free it with lobe_cube_free where DONE): mip 0 is the mirror, each texel the mean of bilinear samples
 * over it, the others hold the kernel at their width in the direction of each texel's centre. */
lobe_prefilter_status lobe_prefilter(const lobe_prefilter_image *image, const lobe_prefilter_options *options,
                                     lobe_cube *cube, char *error, size_t error_size);

/* Changes the texels of the mips of a side of at most LOBE_PREFILTER_FIT_SIDE so that trilinear lookups at all widths
 * that reach them come closest to the kernel, in the mean square over the sphere; the texels themselves then are not
 * the kernel at their centres. 0 where there is no memory, or an interrupt was requested. */
int lobe_prefilter_fit(const lobe_prefilter_source *source, const lobe_prefilter_options *options, lobe_cube *cube);

/* Directions (n x 3) filtered with one kernel, as within a mip: for tests, and widths that no mip has. */
int lobe_prefilter_directions(const lobe_prefilter_source *source, lobe_prefilter_kernel kernel, double width,
                              double detail, const double *d, int n, double *rgb);

/* One rectangle of texels of a mip: a task of the filter. */
typedef struct lobe_prefilter_tile {
    int mip, face, row, column, height, width; /* at most LOBE_PREFILTER_TILE each */
} lobe_prefilter_tile;

void lobe_prefilter_tile_directions(const lobe_prefilter_tile *tile, int cube_side, double *d);
void lobe_prefilter_tile_store(const lobe_prefilter_tile *tile, const double *rgb, lobe_cube *cube);
/* Middle and radius of n directions. */
void lobe_prefilter_bound(const double *d, int n, lobe_prefilter_group *group);
/* At most LOBE_PREFILTER_TILE^2 directions that lie in the group. 0 where there is no memory. */
int lobe_prefilter_group_filter(const lobe_prefilter_source *source, const lobe_prefilter_group *group,
                                lobe_prefilter_cells *cells, const double *d, int n, double *rgb);
/* Mip 0 at one texel. */
void lobe_prefilter_mirror(const lobe_prefilter_image *image, int size, lobe_cube_texel texel, double rgb[3]);
/* Tiles of mips above 0. */
lobe_prefilter_status lobe_prefilter_opencl(const lobe_prefilter_source *source, const lobe_prefilter_options *options,
                                            const lobe_prefilter_tile *tiles, size_t count, lobe_cube *cube,
                                            char *error, size_t error_size);

#endif
