#include "lights.h"
#include "../env_lobes/harmonics.h"
#include "../env_lobes/rooms.h"

bool lobe_sg_lights_train(lobe_env_spectrum *spectra)
{
    static const struct {
        lobe_room room;
        unsigned seed;
    } lights[LOBE_SG_TRAINING] = {{LOBE_ROOM_SKY, 11},     {LOBE_ROOM_LAMPS, 12},  {LOBE_ROOM_LAMPS, 13},
                                  {LOBE_ROOM_CHECKER, 14}, {LOBE_ROOM_CLOUDS, 15}, {LOBE_ROOM_CLOUDS, 16}};
    int i;
    for (i = 0; i < LOBE_SG_TRAINING; i++) {
        lobe_environment map;
        lobe_harmonics harmonics;
        bool good;
        if (!lobe_room_make(&map, lights[i].room, 512, lights[i].seed))
            return false;
        good = lobe_harmonics_of(&map, -1, &harmonics);
        lobe_environment_free(&map);
        if (!good)
            return false;
        lobe_env_spectrum_of(&harmonics, &spectra[i]);
        lobe_harmonics_free(&harmonics);
    }
    return true;
}
