#include "cube.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Right, down and outward of each face. */
static const signed char axes[6][3][3] = {
    {{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}}, {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}},  {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
};

int lobe_cube_side(int size, int mip) { return size >> mip > 1 ? size >> mip : 1; }

int lobe_cube_full_chain(int size)
{
    int mips = 1;
    while (size >> mips)
        mips++;
    return mips;
}

int lobe_cube_allocate(lobe_cube *cube, int size, int mips)
{
    memset(cube, 0, sizeof *cube);
    cube->size = size;
    cube->mips = mips;
    for (int m = 0; m < mips; m++) {
        const size_t side = (size_t)lobe_cube_side(size, m);
        cube->rgb[m] = calloc(18 * side * side, sizeof(float));
        if (!cube->rgb[m]) {
            lobe_cube_free(cube);
            return 0;
        }
    }
    return 1;
}

void lobe_cube_free(lobe_cube *cube)
{
    for (int m = 0; m < LOBE_CUBE_MAX_MIPS; m++) {
        free(cube->rgb[m]);
        cube->rgb[m] = NULL;
    }
}

float *lobe_cube_at(const lobe_cube *cube, int mip, lobe_cube_texel t)
{
    const size_t side = (size_t)lobe_cube_side(cube->size, mip);
    return cube->rgb[mip] + 3 * (((size_t)t.face * side + (size_t)t.row) * side + (size_t)t.column);
}

void lobe_cube_direction(int side, int face, double row, double column, double d[3])
{
    const double s = 2 * column / side - 1, t = 2 * row / side - 1, scale = 1 / sqrt(1 + s * s + t * t);
    for (int k = 0; k < 3; k++)
        d[k] = scale * (s * axes[face][0][k] + t * axes[face][1][k] + axes[face][2][k]);
}

static double along(const double d[3], const signed char axis[3])
{
    return d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
}

int lobe_cube_position(int side, const double d[3], double *row, double *column)
{
    const double x = fabs(d[0]), y = fabs(d[1]), z = fabs(d[2]);
    const int k = z >= x && z >= y ? 2 : y >= x ? 1 : 0, face = 2 * k + (d[k] < 0);
    const double length = along(d, axes[face][2]);
    *column = (along(d, axes[face][0]) / length + 1) / 2 * side;
    *row = (along(d, axes[face][1]) / length + 1) / 2 * side;
    return face;
}

/* Of the rectangle between the face's centre and a point of it, with its sign: d omega = ds dt / (1 + s^2 + t^2)^1.5.
 */
static double corner(double s, double t) { return atan2(s * t, sqrt(1 + s * s + t * t)); }

double lobe_cube_solid_angle(int side, double top, double left, double bottom, double right)
{
    const double s0 = 2 * left / side - 1, s1 = 2 * right / side - 1, t0 = 2 * top / side - 1,
                 t1 = 2 * bottom / side - 1;
    return corner(s1, t1) - corner(s0, t1) - corner(s1, t0) + corner(s0, t0);
}

/* In whole numbers: texel centres have odd or even coordinates in units of half a texel, `side` on the face itself. One
 * step beyond the edge becomes the first step down the neighbour. */
lobe_cube_texel lobe_cube_fold(int side, lobe_cube_texel outside)
{
    const int s = 2 * outside.column + 1 - side, t = 2 * outside.row + 1 - side;
    const int beyond_s = abs(s) > side ? (s > 0) - (s < 0) : 0, beyond_t = abs(t) > side ? (t > 0) - (t < 0) : 0;
    const signed char(*a)[3] = axes[outside.face];
    int point[3], k = 0;
    lobe_cube_texel inside = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        const int from_s = beyond_s ? beyond_s * side : s, from_t = beyond_t ? beyond_t * side : t;
        point[i] = a[0][i] * from_s + a[1][i] * from_t + a[2][i] * (side - 1);
        if ((beyond_s ? a[0][i] : a[1][i]) != 0)
            k = i;
    }
    inside.face = 2 * k + (point[k] < 0);
    a = axes[inside.face];
    const int column = a[0][0] * point[0] + a[0][1] * point[1] + a[0][2] * point[2];
    const int row = a[1][0] * point[0] + a[1][1] * point[1] + a[1][2] * point[2];
    inside.column = (column + side - 1) / 2;
    inside.row = (row + side - 1) / 2;
    return inside;
}
