/* The bits of a float, and whole numbers, named as each language names them. Only core's elementary functions in
 * float use this: a kernel never does. In double (offline) and under the tracer the platform's functions stand in.
 *
 * lobe_int_from_real truncates; the caller keeps its argument inside (-2^31, 2^31). */
#ifndef LOBE_BITS_H
#define LOBE_BITS_H
#include "scalar.h"

#if !defined(LOBE_TRACE) && !defined(LOBE_DOUBLE)

#if defined(LOBE_GLSL)
#define lobe_int highp int
lobe_bits lobe_bits_from_real(lobe_real x) { return floatBitsToUint(x); }
lobe_real lobe_real_from_bits(lobe_bits b) { return uintBitsToFloat(b); }
lobe_int lobe_int_from_real(lobe_real x) { return int(x); }
lobe_real lobe_real_from_int(lobe_int i) { return float(i); }
lobe_bits lobe_bits_from_int(lobe_int i) { return uint(i); }
lobe_int lobe_int_from_bits(lobe_bits b) { return int(b); }

#elif defined(LOBE_HLSL)
#define lobe_int int
uint lobe_bits_from_real(float x) { return asuint(x); }
float lobe_real_from_bits(uint b) { return asfloat(b); }
int lobe_int_from_real(float x) { return int(x); }
float lobe_real_from_int(int i) { return float(i); }
uint lobe_bits_from_int(int i) { return uint(i); }
int lobe_int_from_bits(uint b) { return int(b); }

#elif defined(__METAL_VERSION__)
#define lobe_int int
static inline uint lobe_bits_from_real(float x) { return as_type<uint>(x); }
static inline float lobe_real_from_bits(uint b) { return as_type<float>(b); }
static inline int lobe_int_from_real(float x) { return int(x); }
static inline float lobe_real_from_int(int i) { return float(i); }
static inline uint lobe_bits_from_int(int i) { return uint(i); }
static inline int lobe_int_from_bits(uint b) { return int(b); }

#elif defined(LOBE_OPENCL)
#define lobe_int int
static inline uint lobe_bits_from_real(float x) { return as_uint(x); }
static inline float lobe_real_from_bits(uint b) { return as_float(b); }
static inline int lobe_int_from_real(float x) { return (int)x; }
static inline float lobe_real_from_int(int i) { return (float)i; }
static inline uint lobe_bits_from_int(int i) { return (uint)i; }
static inline int lobe_int_from_bits(uint b) { return (int)b; }

#else /* C99 or C++; C++ does not bless the union, but every compiler this library knows does */
#define lobe_int int32_t
union lobe_float_bits {
    float real;
    uint32_t bits;
};
static inline uint32_t lobe_bits_from_real(float x)
{
    union lobe_float_bits u;
    u.real = x;
    return u.bits;
}
static inline float lobe_real_from_bits(uint32_t b)
{
    union lobe_float_bits u;
    u.bits = b;
    return u.real;
}
static inline int32_t lobe_int_from_real(float x) { return (int32_t)x; }
static inline float lobe_real_from_int(int32_t i) { return (float)i; }
static inline uint32_t lobe_bits_from_int(int32_t i) { return (uint32_t)i; }
static inline int32_t lobe_int_from_bits(uint32_t b) { return (int32_t)b; }
#endif

#endif
#endif
