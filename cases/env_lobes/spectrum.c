#include "spectrum.h"

void lobe_env_spectrum_of(const lobe_harmonics *harmonics, lobe_env_spectrum *spectrum)
{
    for (int l = 0; l < LOBE_ENV_BANDS; l++) {
        double sum = 0;
        for (int m = 0; m <= l; m++) {
            const double *c = harmonics->coefficient + 2 * (m * LOBE_ENV_BANDS + l);
            sum += c[0] * c[0] + c[1] * c[1];
        }
        spectrum->power[l] = sum / (2 * l + 1);
    }
}
