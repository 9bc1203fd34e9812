#include "lights.h"
#include "../env_lobes/harmonics.h"
#include "../env_lobes/rooms.h"

typedef struct chosen {
    lobe_room room;
    unsigned seed;
} chosen;

bool lobe_sg_light_of(const lobe_environment *map, lobe_env_spectrum *spectrum)
{
    lobe_harmonics harmonics;
    if (!lobe_harmonics_of(map, -1, &harmonics))
        return false;
    lobe_env_spectrum_of(&harmonics, spectrum);
    lobe_harmonics_free(&harmonics);
    return true;
}

static bool make(const chosen *lights, int count, lobe_env_spectrum *spectra)
{
    int i;
    for (i = 0; i < count; i++) {
        lobe_environment map;
        bool good;
        if (!lobe_room_make(&map, lights[i].room, 512, lights[i].seed))
            return false;
        good = lobe_sg_light_of(&map, &spectra[i]);
        lobe_environment_free(&map);
        if (!good)
            return false;
    }
    return true;
}

bool lobe_sg_lights_train(lobe_env_spectrum *spectra)
{
    static const chosen lights[LOBE_SG_TRAINING] = {{LOBE_ROOM_SKY, 11},    {LOBE_ROOM_LAMPS, 12},
                                                    {LOBE_ROOM_LAMPS, 13},  {LOBE_ROOM_CHECKER, 14},
                                                    {LOBE_ROOM_CLOUDS, 15}, {LOBE_ROOM_CLOUDS, 16}};
    return make(lights, LOBE_SG_TRAINING, spectra);
}

bool lobe_sg_lights_held(lobe_env_spectrum *spectra)
{
    static const chosen lights[LOBE_SG_HELD] = {{LOBE_ROOM_SKY, 102},
                                                {LOBE_ROOM_LAMPS, 103},
                                                {LOBE_ROOM_CHECKER, 104},
                                                {LOBE_ROOM_CLOUDS, 105},
                                                {LOBE_ROOM_TEXEL, 106}};
    return make(lights, LOBE_SG_HELD, spectra);
}
