/* What the dialect uses of Metal's own names, so that clang can read the Metal text as the C++14 that it is.
 * Not a Metal compiler: it proves syntax and types, not address spaces. */
#ifndef LOBE_METAL_SHIM_H
#define LOBE_METAL_SHIM_H

typedef unsigned int uint;

template <typename To, typename From> static inline To as_type(From from)
{
    static_assert(sizeof(To) == sizeof(From), "as_type keeps the size");
    To to;
    __builtin_memcpy(&to, &from, sizeof to);
    return to;
}

namespace metal
{
static inline float sqrt(float x) { return __builtin_sqrtf(x); }
static inline float abs(float x) { return __builtin_fabsf(x); }
static inline float floor(float x) { return __builtin_floorf(x); }
namespace precise
{
static inline float sqrt(float x) { return __builtin_sqrtf(x); }
} // namespace precise
} // namespace metal
using namespace metal;

#endif
