#include "half.h"
#include <math.h>
#include <string.h>

uint16_t lobe_half_from_float(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    const uint32_t sign = bits >> 16 & 0x8000u, size = bits & 0x7fffffffu;
    uint32_t half;
    if (size > 0x7f800000u)
        return 0;
    if (size >= 0x477ff000u) /* 65520 would round to infinity */
        return (uint16_t)(sign | 0x7bffu);
    if (size < 0x38800000u) {
        /* Below 2^-14 a half counts in steps of 2^-24: adding 1/2 leaves that step as the last bit of a float. */
        float shifted, positive;
        memcpy(&positive, &size, sizeof positive);
        shifted = positive + 0.5f;
        memcpy(&half, &shifted, sizeof half);
        half -= 0x3f000000u;
    } else {
        const uint32_t even = size >> 13 & 1;
        half = (size - 0x38000000u + 0xfffu + even) >> 13;
    }
    return (uint16_t)(sign | half);
}

float lobe_half_to_float(uint16_t h)
{
    const int exponent = h >> 10 & 31, mantissa = h & 1023;
    float size;
    if (exponent == 31)
        size = mantissa ? (float)NAN : (float)INFINITY;
    else
        size = ldexpf((float)(exponent ? mantissa + 1024 : mantissa), (exponent ? exponent : 1) - 25);
    return h & 0x8000 ? -size : size;
}
