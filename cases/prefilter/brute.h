/* The filter by brute force: every texel of the source, the kernel integrated over it and normalised in closed form.
 * What the tree is held to. */
#ifndef LOBE_PREFILTER_BRUTE_H
#define LOBE_PREFILTER_BRUTE_H
#include "source.h"
#include "width.h"

/* One direction. A texel is divided until its parts are at most `detail` of the kernel's scale there; .05 is converged
 * to 1e-4. */
void lobe_prefilter_brute(const lobe_prefilter_image *image, lobe_prefilter_kernel kernel, double width, double detail,
                          const double d[3], double rgb[3]);

#endif
