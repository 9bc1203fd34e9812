#include "faces.h"
#include <string.h>

typedef struct layout {
    int across, down;        /* faces that the picture is wide and high */
    signed char place[6][2]; /* of +x -x +y -y +z -z: row and column */
    int turned;              /* a face that stands on its head, or -1 */
} layout;

static const layout layouts[LOBE_FACES_UNKNOWN] = {
    {2, 1, {{0, 0}}, -1},
    {6, 1, {{0, 0}, {0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}, -1},
    {1, 6, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}, -1},
    {4, 3, {{1, 2}, {1, 0}, {0, 1}, {2, 1}, {1, 1}, {1, 3}}, -1},
    {3, 4, {{1, 2}, {1, 0}, {0, 1}, {2, 1}, {1, 1}, {3, 1}}, 5},
};

lobe_faces lobe_faces_of(int width, int height)
{
    for (int i = 0; i < LOBE_FACES_UNKNOWN; i++)
        if ((long)width * layouts[i].down == (long)height * layouts[i].across)
            return (lobe_faces)i;
    return LOBE_FACES_UNKNOWN;
}

int lobe_faces_take(const lobe_environment *picture, lobe_cube *cube, lobe_environment_fault *fault)
{
    const lobe_faces which = lobe_faces_of(picture->width, picture->height);
    if (which == LOBE_FACES_NONE || which == LOBE_FACES_UNKNOWN)
        return lobe_environment_refuse(fault, 0,
                                       "found %d x %d texels, expected sides as 2 : 1 (equirectangular) or, of six "
                                       "faces, 6 : 1, 1 : 6, 4 : 3 or 3 : 4",
                                       picture->width, picture->height);
    const layout *l = &layouts[which];
    const int side = picture->width / l->across;
    if (side > LOBE_CUBE_MAX_SIDE)
        return lobe_environment_refuse(fault, 0, "found faces of %d x %d texels, expected a side in [1, %d]", side,
                                       side, LOBE_CUBE_MAX_SIDE);
    if (!lobe_cube_allocate(cube, side, 1))
        return lobe_environment_refuse(fault, 0, "found faces of %d x %d texels, expected a cube that fits into memory",
                                       side, side);
    for (int face = 0; face < 6; face++)
        for (int i = 0; i < side; i++)
            for (int j = 0; j < side; j++) {
                const int turned = face == l->turned;
                const lobe_cube_texel to = {face, turned ? side - 1 - i : i, turned ? side - 1 - j : j};
                const size_t row = (size_t)(l->place[face][0] * side + i),
                             column = (size_t)(l->place[face][1] * side + j);
                memcpy(lobe_cube_at(cube, 0, to), picture->rgb + 3 * (row * (size_t)picture->width + column),
                       3 * sizeof(float));
            }
    return 1;
}
