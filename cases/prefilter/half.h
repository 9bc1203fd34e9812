/* IEEE 754 half floats. */
#ifndef LOBE_HALF_H
#define LOBE_HALF_H
#include <stdint.h>

#define LOBE_HALF_MAX 65504.0f

/* To nearest, ties to even. What rounds beyond 65504 becomes 65504 with its sign (a texture with an infinite texel
 * poisons every filter that touches it); NaN becomes 0. */
uint16_t lobe_half_from_float(float x);
float lobe_half_to_float(uint16_t h);

#endif
