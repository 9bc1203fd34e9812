/* What a kernel's own text tells about itself: its operations, its ranges, and its spelling in other
 * languages. The kernels are compiled once as C++ with a scalar that records (trace.h); everything here reads
 * that record. Plain C linkage, so that lobefit stays a C program. */
#ifndef LOBE_EMIT_H
#define LOBE_EMIT_H

#include <stdint.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct lobe_op_count {
    int fused; /* a product used once, by an addition, is free: the number that `operations` means everywhere */
    int plain; /* every product counts */
} lobe_op_count;

/* Writes one tier in one language: c, cl, glsl, es, hlsl, fpcore or q30. Returns 0, or 2 after one line on
 * standard error that names what is unknown and what is known. */
int lobe_emit(const char *model, const char *tier, const char *language, FILE *out);

/* A row a model and tier: fused and plain operations. Returns 0. */
int lobe_emit_ops(FILE *out);

/* Operations of one tier; 0, or 2 where there is no such model or tier. */
int lobe_emit_count(const char *model, const char *tier, lobe_op_count *count);

/* Operations of a tier of sphere_light beyond a punctual light; 0, or 2 where there is no such tier. */
int lobe_emit_count_sphere(const char *tier, lobe_op_count *count);

/* Operations of Schlick inside a sphere light: low from scratch, high beyond its radiance. 0, or 2. */
int lobe_emit_count_sphere_schlick(const char *tier, lobe_op_count *count);

/* Operations of a tier of sphere_diffuse; 0, or 2 where there is no such tier. */
int lobe_emit_count_sphere_diffuse(const char *tier, lobe_op_count *count);

/* The formula at one point in double: outputs are scale and bias, or E, or nine coefficients. Returns how many, or 0
 * where unknown. The model diffuse_shape is what of diffuse_sh is emitted as q30. */
int lobe_emit_value(const char *model, const char *tier, const double *in, double *out);

/* The same through the integer program of the q30 tier: in and out are Q30. 0 where unknown, -1 where a value on the
 * way needs more than 32 bits. */
int lobe_emit_value_q30(const char *model, const char *tier, const int32_t *in, int32_t *out);

/* The name of the i-th model and tier that exist; 0, or 2 past the end. */
int lobe_emit_list(int i, const char **model, const char **tier);

#ifdef __cplusplus
}
#endif
#endif
