/* Environments that need no file. Equal seeds give equal maps; every kind has as many as there are seeds, so that what
 * a fit is judged by need not be what it was trained on. */
#ifndef LOBE_ENV_ROOMS_H
#define LOBE_ENV_ROOMS_H
#include "../environment/environment.h"

typedef enum lobe_room {
    LOBE_ROOM_SKY,     /* clear sky over a ground, with the sun's disc in it */
    LOBE_ROOM_LAMPS,   /* a closed room: walls, floor, windows, lamps at the ceiling */
    LOBE_ROOM_CHECKER, /* bright and dark fields, turned at random */
    LOBE_ROOM_TEXEL,   /* black but for one texel */
    LOBE_ROOM_CLOUDS,  /* noise of all sizes, its power falling as a power of the frequency that the seed chooses */
    LOBE_ROOMS
} lobe_room;

extern const char *const lobe_room_name[LOBE_ROOMS];

/* height is half of width. 0 where there is no memory. */
int lobe_room_make(lobe_environment *map, lobe_room room, int width, unsigned seed);

#endif
