/* What C99, C++, OpenCL C 1.2, GLSL 450 / ES 310, HLSL and Metal must agree on.
 *
 * Every kernel in core/ and models/ is one text for all of them. This header names the few
 * things that differ. A kernel keeps to these rules, so that no language needs a second text:
 *   - LOBE_FN starts a function, LOBE_LET a local that is assigned once, LOBE_STRUCT(name) a struct;
 *   - results are returned, also as structs: no pointers, no arrays, no casts, no recursion;
 *   - LOBE_R(0.5) is a literal of the scalar type lobe_real;
 *   - only + - * / and core's own functions; a choice is lobe_select, lobe_min or lobe_max;
 *   - arithmetic stands in the initialiser of a LOBE_LET and nowhere else: `return`, with its arguments, and
 *     struct members take names or calls. A shader's `precise` covers just those initialisers, and what it does
 *     not cover is fused or reassociated: other bits (harness/test/test_shaders.sh looks at every operation);
 *   - inputs are saturated first, and no NaN or infinity arises after that: shading languages need not carry
 *     them (lavapipe folds NaN * 0.0 to 0 even where it is precise);
 *   - coefficients are #defines of a generated header (models/coeffs). */
#ifndef LOBE_DIALECT_H
#define LOBE_DIALECT_H

#if defined(LOBE_HLSL)
#define LOBE_SHADER 1
#define LOBE_FN
#define LOBE_STRUCT(name) struct name
#define LOBE_LET precise float
#define lobe_real float
#define lobe_bits uint
#define LOBE_R(x) x
#define LOBE_U(x) uint(x)

#elif defined(__METAL_VERSION__)
#define LOBE_SHADER 1
#define LOBE_FN static inline
#define LOBE_STRUCT(name) struct name
#define LOBE_LET const float
#define lobe_real float
#define lobe_bits uint
#define LOBE_R(x) x##f
#define LOBE_U(x) uint(x)

#elif defined(GL_core_profile) || defined(GL_ES)
#define LOBE_SHADER 1
#define LOBE_GLSL 1
#define LOBE_FN
#define LOBE_STRUCT(name) struct name
/* `precise` keeps the bits: without it a compiler may fuse a multiply and an add. ES has it from 320. */
#if defined(GL_ES) && __VERSION__ < 320
#define LOBE_LET highp float
#define lobe_real highp float
#else
#define LOBE_LET precise float
#define lobe_real float
#endif
#define lobe_bits highp uint
#define LOBE_R(x) x
#define LOBE_U(x) uint(x)

#elif defined(__OPENCL_C_VERSION__) || defined(__OPENCL_VERSION__)
#define LOBE_OPENCL 1
#define LOBE_FN static inline
#define LOBE_STRUCT(name)                                                                                              \
    typedef struct name name;                                                                                          \
    struct name
#pragma OPENCL FP_CONTRACT OFF
#if defined(LOBE_DOUBLE)
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
typedef double lobe_real;
typedef ulong lobe_bits;
#define LOBE_R(x) x
#else
typedef float lobe_real;
typedef uint lobe_bits;
#define LOBE_R(x) x##f
#endif
#define LOBE_LET const lobe_real
#define LOBE_U(x) x##u

#elif defined(LOBE_TRACE)
/* C++ with a scalar that records what is done to it: counts operations, bounds ranges, writes other
 * languages. It defines lobe_real before it includes a kernel. */
#define LOBE_FN static inline
#define LOBE_STRUCT(name) struct name
#define LOBE_LET const lobe_real
#define LOBE_R(x) lobe_real(x)

#else /* C99 or C++ */
#define LOBE_HOST 1
#include <stdint.h>
/* gcc 12 ignores this pragma, and warns: it needs -ffp-contract=off wherever the target has fused multiply-add. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif
#define LOBE_FN static inline
#if defined(__cplusplus)
#define LOBE_STRUCT(name) struct name
#else
#define LOBE_STRUCT(name)                                                                                              \
    typedef struct name name;                                                                                          \
    struct name
#endif
#if defined(LOBE_DOUBLE)
typedef double lobe_real;
typedef uint64_t lobe_bits;
#define LOBE_R(x) x
#else
typedef float lobe_real;
typedef uint32_t lobe_bits;
#define LOBE_R(x) x##f
/* 16: _Float16 has arithmetic of its own (AVX512-FP16), float is float. */
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#warning "lobe: this target computes float in a wider type; results stay in bound but the hashes will differ"
#endif
#endif
#define LOBE_LET const lobe_real
#define LOBE_U(x) x##u
#endif

/* The fitter compiles a kernel with LOBE_FIT: each coefficient is then p[i], a parameter it is trying.
 * LOBE_COEFFS stands first among the parameters of every kernel that has coefficients, LOBE_COEFFS_HERE first in a
 * call from one such kernel to another. */
#if defined(LOBE_FIT)
#define LOBE_COEFFS const lobe_real *p,
#define LOBE_COEFFS_HERE p,
#else
#define LOBE_COEFFS
#define LOBE_COEFFS_HERE
#endif

#endif
