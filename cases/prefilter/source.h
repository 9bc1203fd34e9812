/* What is filtered: a map that is constant on each texel, as a tree of ever larger cells.
 *
 * A cell knows its solid angle, the integral of the radiance over it, its middle, and where the radiance's weight lies:
 * a kernel that varies slowly over a cell is integrated over it by one product at that point, and the error is of
 * second order however uneven the cell is. */
#ifndef LOBE_PREFILTER_SOURCE_H
#define LOBE_PREFILTER_SOURCE_H
#include "../environment/environment.h"
#include "cube.h"

/* An equirectangular map or mip 0 of a cube; the other is NULL. */
typedef struct lobe_prefilter_image {
    const lobe_environment *map;
    const lobe_cube *cube;
    int y_up; /* of the map alone: directions are in a world with y up */
} lobe_prefilter_image;

typedef struct lobe_prefilter_cell {
    float middle[3], weight[3]; /* unit directions */
    float energy[3];            /* integral of the radiance */
    float solid_angle;
    float radius; /* largest distance from the middle, as a chord */
} lobe_prefilter_cell;

typedef struct lobe_prefilter_level {
    int rows, columns; /* a chart */
    lobe_prefilter_cell *cells;
} lobe_prefilter_level;

enum { LOBE_PREFILTER_LEVELS = 17 };

typedef struct lobe_prefilter_source {
    lobe_prefilter_image image;
    int charts, rows, columns; /* 1 or 6, and the texels of one */
    int block;                 /* a cell of level 0 holds block x block texels */
    int levels;
    lobe_prefilter_level level[LOBE_PREFILTER_LEVELS];
} lobe_prefilter_source;

/* Cells need not be smaller than `finest` (a chord, in radians for small ones). 0 where there is no memory. */
int lobe_prefilter_source_build(lobe_prefilter_source *source, lobe_prefilter_image image, double finest);
void lobe_prefilter_source_free(lobe_prefilter_source *source);
const lobe_prefilter_cell *lobe_prefilter_source_cell(const lobe_prefilter_source *source, int level, int chart,
                                                      int row, int column);

/* The texel's colour. */
const float *lobe_prefilter_image_texel(const lobe_prefilter_image *image, int chart, int row, int column);
void lobe_prefilter_image_size(const lobe_prefilter_image *image, int *charts, int *rows, int *columns);
/* The direction of a position of a chart, in texels from its top left corner. */
void lobe_prefilter_image_direction(const lobe_prefilter_image *image, int chart, double row, double column,
                                    double d[3]);
/* Solid angle of a rectangle of a chart, and the integral of the direction over it (exact for a map; a cube's is that
 * of a small rectangle). */
double lobe_prefilter_image_moment(const lobe_prefilter_image *image, int chart, double top, double left, double bottom,
                                   double right, double moment[3]);
/* Bilinear, across edges and poles. */
void lobe_prefilter_image_sample(const lobe_prefilter_image *image, const double d[3], double rgb[3]);

#endif
