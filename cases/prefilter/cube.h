/* A cube map of linear radiance with its mips, and where its texels look.
 *
 * Faces stand in the order +x -x +y -y +z -z with the axes of Direct3D, OpenGL and Vulkan, so that a texture lookup
 * with direction d answers with the radiance from d, whatever the world calls up:
 *
 *     face   to the right (column)   down (row)
 *     +x     -z                      -y
 *     -x     +z                      -y
 *     +y     +x                      +z
 *     -y     +x                      -z
 *     +z     +x                      -y
 *     -z     -x                      -y */
#ifndef LOBE_CUBE_H
#define LOBE_CUBE_H
#include <stddef.h>

enum { LOBE_CUBE_MAX_SIDE = 8192, LOBE_CUBE_MAX_MIPS = 14 };

typedef struct lobe_cube {
    int size, mips;                 /* texels along an edge of mip 0 */
    float *rgb[LOBE_CUBE_MAX_MIPS]; /* a mip: 6 faces x side x side x 3, row 0 of a face on top */
} lobe_cube;

/* A texel: face, row, column. */
typedef struct lobe_cube_texel {
    int face, row, column;
} lobe_cube_texel;

int lobe_cube_side(int size, int mip); /* size / 2^mip, at least 1 */
int lobe_cube_full_chain(int size);    /* the number of mips down to a side of 1 */
/* Black. 0 where there is no memory. */
int lobe_cube_allocate(lobe_cube *cube, int size, int mips);
void lobe_cube_free(lobe_cube *cube);
float *lobe_cube_at(const lobe_cube *cube, int mip, lobe_cube_texel texel);

/* Of unit length; row and column may be any position on the face, in texels from its top left corner. */
void lobe_cube_direction(int side, int face, double row, double column, double d[3]);
/* The face that d (of any length but 0) meets, and where, in texels from its top left corner. */
int lobe_cube_position(int side, const double d[3], double *row, double *column);
/* Of the rectangle between two positions of a face; the six faces make 4 pi. */
double lobe_cube_solid_angle(int side, double top, double left, double bottom, double right);
/* The texel beyond an edge: row or column (one of them) is -1 or side. */
lobe_cube_texel lobe_cube_fold(int side, lobe_cube_texel outside);

#endif
