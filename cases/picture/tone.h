/* How radiance and its differences become colours, and the colours that sheets are drawn with. */
#ifndef LOBE_PICTURE_TONE_H
#define LOBE_PICTURE_TONE_H
#include <stddef.h>

extern const unsigned char lobe_tone_background[3], lobe_tone_white[3], lobe_tone_grey[3];
/* Too bright and too dark. */
extern const unsigned char lobe_tone_orange[3], lobe_tone_blue[3];

double lobe_tone_luminance(const double rgb[3]);

/* The sRGB curve; what is not in [0, 1] is cut. */
unsigned char lobe_tone_srgb(double x);
void lobe_tone_colour(const double rgb[3], double exposure, unsigned char out[3]);

/* Of a difference of luminances, linear: 0 black, 1 and more orange, -1 and less blue. */
void lobe_tone_difference(double d, unsigned char out[3]);

/* The exposure by which one luminance in `part` is brighter than .9. Sorts them. */
double lobe_tone_exposure(double *luminance, size_t count, size_t part);

#endif
