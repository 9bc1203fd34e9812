/* Six faces of a cube in one picture, as tools for environments write them. Which picture it is, its sides tell:
 *
 *     6 : 1   +x -x +y -y +z -z from the left        4 : 3      +y             3 : 4      +y
 *     1 : 6   the same from the top                          -x +z +x -z               -x +z +x
 *     2 : 1   equirectangular                                   -y                        -y
 *                                                                                         -z turned by half a turn
 *
 * Each face as in cube.h, row 0 on top. What a cross shows beside its faces is not looked at. */
#ifndef LOBE_FACES_H
#define LOBE_FACES_H
#include "../environment/environment.h"
#include "cube.h"

typedef enum lobe_faces {
    LOBE_FACES_NONE, /* equirectangular */
    LOBE_FACES_ACROSS,
    LOBE_FACES_DOWN,
    LOBE_FACES_WIDE,
    LOBE_FACES_TALL,
    LOBE_FACES_UNKNOWN
} lobe_faces;

lobe_faces lobe_faces_of(int width, int height);

/* Mip 0 alone: 1 and the cube (free with lobe_cube_free); or 0 and the fault where the sides are none of a picture of
 * six faces, or there is no memory. */
int lobe_faces_take(const lobe_environment *picture, lobe_cube *cube, lobe_environment_fault *fault);

#endif
