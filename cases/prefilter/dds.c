/* DirectDraw Surface with the DX10 head: 4 + 124 + 20 bytes, then the faces one after another, each with all its mips.
 */
#include "cube_file.h"
#include <string.h>

enum { HEAD = 148, FORMAT_HALF4 = 10, LEGACY_HALF4 = 113, DIMENSION_2D = 3, MISC_CUBE = 4 };

#define FLAGS (0x1u | 0x2u | 0x4u | 0x8u | 0x1000u | 0x20000u) /* caps height width pitch pixelformat mipmapcount */
#define FOURCC_FLAG 0x4u
#define DX10 0x30315844u
#define CAPS (0x8u | 0x1000u | 0x400000u) /* complex texture mipmap */
#define CUBE_ALL_FACES 0xfe00u

void lobe_cube_write_dds(FILE *out, const lobe_cube *cube, const lobe_prefilter_scale *scale, size_t *clamped)
{
    const uint32_t size = (uint32_t)cube->size;
    const float curve = (float)scale->curve;
    uint32_t head[HEAD / 4] = {0};
    head[0] = 0x20534444u; /* "DDS " */
    head[1] = 124;
    head[2] = FLAGS;
    head[3] = size;
    head[4] = size;
    head[5] = 8 * size;
    head[7] = (uint32_t)cube->mips;
    head[8] = 0x45424f4cu; /* "LOBE", then the kernel and the curve: reserved words, which readers skip */
    head[9] = scale->kernel == LOBE_PREFILTER_SG;
    memcpy(&head[10], &curve, sizeof curve);
    head[19] = 32;
    head[20] = FOURCC_FLAG;
    head[21] = DX10;
    head[27] = CAPS;
    head[28] = CUBE_ALL_FACES;
    head[32] = FORMAT_HALF4;
    head[33] = DIMENSION_2D;
    head[34] = MISC_CUBE;
    head[35] = 1; /* cubes */
    for (int i = 0; i < HEAD / 4; i++)
        lobe_cube_put32(out, head[i]);
    for (int face = 0; face < 6; face++)
        for (int m = 0; m < cube->mips; m++)
            lobe_cube_write_face(out, cube, m, face, clamped);
}

typedef struct field {
    size_t at;
    uint32_t value;
    const char *name;
} field;

static int expect(const unsigned char *bytes, const field *f, lobe_environment_fault *fault)
{
    const uint32_t found = lobe_cube_get32(bytes + f->at);
    return found == f->value || lobe_environment_refuse(fault, f->at, "found %s %lu, expected %lu", f->name,
                                                        (unsigned long)found, (unsigned long)f->value);
}

/* Where the texels start, or 0 after a refusal. */
static size_t head(const unsigned char *bytes, size_t size, lobe_environment_fault *fault)
{
    static const field legacy[] = {{4, 124, "head size"}, {76, 32, "pixel format size"}};
    static const field dx10[] = {
        {128, FORMAT_HALF4, "DXGI format"}, {132, DIMENSION_2D, "resource dimension"}, {140, 1, "array size"}};
    if (size < 128)
        return (size_t)lobe_environment_refuse(fault, size,
                                               "found the end of the file in the head, expected 128 bytes");
    for (int i = 0; i < 2; i++)
        if (!expect(bytes, &legacy[i], fault))
            return 0;
    const uint32_t fourcc = lobe_cube_get32(bytes + 84), caps = lobe_cube_get32(bytes + 112);
    if (!(lobe_cube_get32(bytes + 80) & FOURCC_FLAG) || (fourcc != DX10 && fourcc != LEGACY_HALF4))
        return (size_t)lobe_environment_refuse(
            fault, 84, "found pixel format 0x%08lx, expected DX10 or 113 (half floats)", (unsigned long)fourcc);
    if (fourcc == LEGACY_HALF4) {
        if ((caps & CUBE_ALL_FACES) != CUBE_ALL_FACES)
            return (size_t)lobe_environment_refuse(
                fault, 112, "found caps 0x%lx, expected a cube of six faces (0xfe00)", (unsigned long)caps);
        return 128;
    }
    if (size < HEAD)
        return (size_t)lobe_environment_refuse(fault, size, "found the end of the file in the head, expected %d bytes",
                                               HEAD);
    for (int i = 0; i < 3; i++)
        if (!expect(bytes, &dx10[i], fault))
            return 0;
    if (!(lobe_cube_get32(bytes + 136) & MISC_CUBE))
        return (size_t)lobe_environment_refuse(fault, 136, "found flags 0x%lx, expected a cube (0x4)",
                                               (unsigned long)lobe_cube_get32(bytes + 136));
    return HEAD;
}

int lobe_cube_from_dds(const unsigned char *bytes, size_t size, lobe_cube *cube, lobe_environment_fault *fault)
{
    size_t at = head(bytes, size, fault), needed = 0;
    if (!at)
        return 0;
    const uint32_t height = lobe_cube_get32(bytes + 12), side = lobe_cube_get32(bytes + 16);
    const uint32_t count = lobe_cube_get32(bytes + 28), mips = count ? count : 1;
    if (height != side)
        return lobe_environment_refuse(fault, 12, "found a face of %lu x %lu texels, expected a square",
                                       (unsigned long)side, (unsigned long)height);
    if (!lobe_cube_check_size(side, 16, mips, 28, fault))
        return 0;
    for (int m = 0; m < (int)mips; m++)
        needed += 48 * (size_t)lobe_cube_side((int)side, m) * (size_t)lobe_cube_side((int)side, m);
    if (size - at < needed)
        return lobe_environment_refuse(fault, size, "found %zu bytes of texels, expected %zu", size - at, needed);
    if (!lobe_cube_allocate(cube, (int)side, (int)mips))
        return lobe_environment_refuse(fault, 16, "found a width of %lu texels, expected a cube that fits into memory",
                                       (unsigned long)side);
    for (int face = 0; face < 6; face++)
        for (int m = 0; m < (int)mips; m++) {
            const size_t texels = (size_t)lobe_cube_side((int)side, m) * (size_t)lobe_cube_side((int)side, m);
            if (!lobe_cube_read_faces(bytes, at, cube, m, face, face + 1, fault)) {
                lobe_cube_free(cube);
                return 0;
            }
            at += 8 * texels;
        }
    return 1;
}
