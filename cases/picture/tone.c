#include "tone.h"
#include <math.h>
#include <stdlib.h>

const unsigned char lobe_tone_background[3] = {20, 20, 22}, lobe_tone_white[3] = {236, 236, 236};
const unsigned char lobe_tone_grey[3] = {150, 150, 154};
const unsigned char lobe_tone_orange[3] = {255, 150, 40}, lobe_tone_blue[3] = {80, 160, 255};

double lobe_tone_luminance(const double rgb[3]) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

unsigned char lobe_tone_srgb(double x)
{
    const double c = fmin(1, fmax(0, x)), v = c < 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055;
    return (unsigned char)(255 * v + 0.5);
}

void lobe_tone_colour(const double rgb[3], double exposure, unsigned char out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = lobe_tone_srgb(exposure * rgb[k]);
}

void lobe_tone_difference(double d, unsigned char out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (unsigned char)(fmin(1, fabs(d)) * (d > 0 ? lobe_tone_orange[k] : lobe_tone_blue[k]) + 0.5);
}

static int rising(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double lobe_tone_exposure(double *luminance, size_t count, size_t part)
{
    qsort(luminance, count, sizeof *luminance, rising);
    return .9 / fmax(1e-9, luminance[count - 1 - count / part]);
}
