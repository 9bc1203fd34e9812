/* Spherical harmonics of a map to a high band: what a prefiltered environment is made of, since a round kernel scales
 * every band by a number. Real, normalised, all basis polynomials with positive sign. */
#ifndef LOBE_ENV_HARMONICS_H
#define LOBE_ENV_HARMONICS_H
#include "../environment/environment.h"

enum { LOBE_ENV_BANDS = 257 };

/* Coefficients of one colour channel or of all: index (m LOBE_ENV_BANDS + l) 2 + part, part 0 with cos(m phi), 1 with
 * sin(m phi); m <= l. */
typedef struct lobe_harmonics {
    double *coefficient;
    double *recurrence; /* of the associated Legendre functions */
} lobe_harmonics;

/* Of channel 0, 1 or 2, or of their mean (-1). The sum over texels is the midpoint rule. 0 where there is no memory. */
int lobe_harmonics_of(const lobe_environment *map, int channel, lobe_harmonics *harmonics);
void lobe_harmonics_free(lobe_harmonics *harmonics);

/* Band l is multiplied with factor[l]. */
void lobe_harmonics_scale(lobe_harmonics *harmonics, const double *factor);

enum { LOBE_HARMONICS_TOGETHER = 8 };

/* out[l][i]: the part of band l in the direction d[i], for several directions at once. */
void lobe_harmonics_bands_at(const lobe_harmonics *harmonics, double d[LOBE_HARMONICS_TOGETHER][3],
                             double out[LOBE_ENV_BANDS][LOBE_HARMONICS_TOGETHER]);

/* The function itself at the middles of the texels of a map of height rows and 2 height columns, from its first `bands`
 * bands. */
void lobe_harmonics_synthesise(const lobe_harmonics *harmonics, int bands, int height, float *out);

#endif
