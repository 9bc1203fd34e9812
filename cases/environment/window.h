/* Windows: bands 1 and 2 scaled so that nine coefficients ring less. Band 0 stays. */
#ifndef LOBE_ENVIRONMENT_WINDOW_H
#define LOBE_ENVIRONMENT_WINDOW_H

/* The least value over the sphere, exact: no sampling. */
double lobe_sh9_minimum(const double c[9]);

/* The least smoothing 1 / (1 + k l^2 (l + 1)^2), one k for all channels, with which the irradiance is negative for no
 * channel and no normal. Returns k: 0 where nothing had to be done, negative where band 0 itself is negative, so that
 * no window helps. Reflected diffuse light needs no more than this: its lobe damps bands 1 and 2 by itself. */
double lobe_sh9_window_positive(double sh[3][9]);

/* Bands times (1 + cos(pi l / width)) / 2, width > 2. */
void lobe_sh9_window_hanning(double c[9], double width);

#endif
