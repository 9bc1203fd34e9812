/* Cube maps as files: DDS (DX10 head) and KTX2 with half floats, and raw floats. README.md has the layouts. */
#ifndef LOBE_CUBE_FILE_H
#define LOBE_CUBE_FILE_H
#include "../environment/environment.h"
#include "cube.h"
#include "width.h"
#include <stdint.h>
#include <stdio.h>

typedef enum lobe_cube_format { LOBE_CUBE_DDS, LOBE_CUBE_KTX2, LOBE_CUBE_RAW } lobe_cube_format;

/* The scale goes into the file's head where the format has a place for it. *clamped: how many numbers were larger than
 * a half can hold. Errors of the stream are left for its owner to find. */
void lobe_cube_write(FILE *out, lobe_cube_format format, const lobe_cube *cube, const lobe_prefilter_scale *scale,
                     size_t *clamped);

/* From a file held in memory, alpha dropped: 1 and the cube (free with lobe_cube_free), or 0 and the fault. Only what
 * lobe_cube_write writes is certain to be taken: square cube maps of 16-bit float RGBA, not compressed, finite. */
int lobe_cube_is_file(const unsigned char *bytes, size_t size);
int lobe_cube_parse(const unsigned char *bytes, size_t size, lobe_cube *cube, lobe_environment_fault *fault);
int lobe_cube_from_dds(const unsigned char *bytes, size_t size, lobe_cube *cube, lobe_environment_fault *fault);
int lobe_cube_from_ktx2(const unsigned char *bytes, size_t size, lobe_cube *cube, lobe_environment_fault *fault);

/* What the formats share. Numbers are little endian. */
extern const unsigned char lobe_ktx2_identifier[12];
void lobe_cube_write_dds(FILE *out, const lobe_cube *cube, const lobe_prefilter_scale *scale, size_t *clamped);
void lobe_cube_write_ktx2(FILE *out, const lobe_cube *cube, const lobe_prefilter_scale *scale, size_t *clamped);
void lobe_cube_put32(FILE *out, uint32_t x);
void lobe_cube_put64(FILE *out, uint64_t x);
uint32_t lobe_cube_get32(const unsigned char *p);
uint64_t lobe_cube_get64(const unsigned char *p);
void lobe_cube_write_face(FILE *out, const lobe_cube *cube, int mip, int face, size_t *clamped);
/* Faces [first, end) of a mip from halves at an offset whose room has been checked. */
int lobe_cube_read_faces(const unsigned char *bytes, size_t offset, lobe_cube *cube, int mip, int first, int end,
                         lobe_environment_fault *fault);
/* Side and number of mips in their ranges, else 0 and the fault. */
int lobe_cube_check_size(uint32_t side, size_t side_at, uint32_t mips, size_t mips_at, lobe_environment_fault *fault);

#endif
