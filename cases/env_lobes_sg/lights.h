/* The environments of the fit, as power spectra: rooms that need no file, with other seeds than those of the floors. */
#ifndef LOBE_SG_LIGHTS_H
#define LOBE_SG_LIGHTS_H
#include "radiance.h"

enum { LOBE_SG_TRAINING = 6 };

/* spectra[LOBE_SG_TRAINING]. false: no memory. */
bool lobe_sg_lights_train(lobe_env_spectrum *spectra);

#endif
