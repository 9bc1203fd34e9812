/* The environments of the fit, as power spectra: rooms that need no file, with other seeds than those of the floors. */
#ifndef LOBE_SG_LIGHTS_H
#define LOBE_SG_LIGHTS_H
#include "radiance.h"

enum { LOBE_SG_TRAINING = 6, LOBE_SG_HELD = 5 };

/* spectra[LOBE_SG_TRAINING]. false: no memory. */
bool lobe_sg_lights_train(lobe_env_spectrum *spectra);

/* Those of the floors, spectra[LOBE_SG_HELD]: a sky with its sun, a room with lamps, a checker, clouds, one texel. */
bool lobe_sg_lights_held(lobe_env_spectrum *spectra);

/* The spectrum of a map. */
bool lobe_sg_light_of(const lobe_environment *map, lobe_env_spectrum *spectrum);

#endif
