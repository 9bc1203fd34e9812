#include "cube_file.h"
#include "half.h"
#include <math.h>
#include <string.h>

void lobe_cube_put32(FILE *out, uint32_t x)
{
    for (int i = 0; i < 4; i++)
        putc((int)(x >> 8 * i & 255), out);
}

void lobe_cube_put64(FILE *out, uint64_t x)
{
    lobe_cube_put32(out, (uint32_t)x);
    lobe_cube_put32(out, (uint32_t)(x >> 32));
}

uint32_t lobe_cube_get32(const unsigned char *p)
{
    return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

uint64_t lobe_cube_get64(const unsigned char *p)
{
    return (uint64_t)lobe_cube_get32(p) | (uint64_t)lobe_cube_get32(p + 4) << 32;
}

static void put_half(FILE *out, float x, size_t *clamped)
{
    const uint16_t h = lobe_half_from_float(x);
    *clamped += fabsf(x) > LOBE_HALF_MAX;
    putc(h & 255, out);
    putc(h >> 8, out);
}

void lobe_cube_write_face(FILE *out, const lobe_cube *cube, int mip, int face, size_t *clamped)
{
    const int side = lobe_cube_side(cube->size, mip);
    const lobe_cube_texel first = {face, 0, 0};
    const float *rgb = lobe_cube_at(cube, mip, first);
    for (int i = 0; i < side * side; i++, rgb += 3) {
        for (int k = 0; k < 3; k++)
            put_half(out, rgb[k], clamped);
        put_half(out, 1, clamped);
    }
}

static void write_raw(FILE *out, const lobe_cube *cube)
{
    for (int m = 0; m < cube->mips; m++) {
        const size_t side = (size_t)lobe_cube_side(cube->size, m);
        for (size_t i = 0; i < 18 * side * side; i++) {
            uint32_t bits;
            memcpy(&bits, &cube->rgb[m][i], sizeof bits);
            lobe_cube_put32(out, bits);
        }
    }
}

void lobe_cube_write(FILE *out, lobe_cube_format format, const lobe_cube *cube, const lobe_prefilter_scale *scale,
                     size_t *clamped)
{
    *clamped = 0;
    if (format == LOBE_CUBE_DDS)
        lobe_cube_write_dds(out, cube, scale, clamped);
    else if (format == LOBE_CUBE_KTX2)
        lobe_cube_write_ktx2(out, cube, scale, clamped);
    else
        write_raw(out, cube);
}

int lobe_cube_is_file(const unsigned char *bytes, size_t size)
{
    return (size >= 4 && memcmp(bytes, "DDS ", 4) == 0) || (size >= 12 && memcmp(bytes, lobe_ktx2_identifier, 12) == 0);
}

int lobe_cube_parse(const unsigned char *bytes, size_t size, lobe_cube *cube, lobe_environment_fault *fault)
{
    if (size >= 4 && memcmp(bytes, "DDS ", 4) == 0)
        return lobe_cube_from_dds(bytes, size, cube, fault);
    return lobe_cube_from_ktx2(bytes, size, cube, fault);
}

int lobe_cube_check_size(uint32_t side, size_t side_at, uint32_t mips, size_t mips_at, lobe_environment_fault *fault)
{
    if (side < 1 || side > LOBE_CUBE_MAX_SIDE)
        return lobe_environment_refuse(fault, side_at,
                                       "found a width of %lu texels, expected a whole number in [1, %d]",
                                       (unsigned long)side, LOBE_CUBE_MAX_SIDE);
    if (mips < 1 || mips > (uint32_t)lobe_cube_full_chain((int)side))
        return lobe_environment_refuse(fault, mips_at, "found %lu mips, expected a whole number in [1, %d]",
                                       (unsigned long)mips, lobe_cube_full_chain((int)side));
    return 1;
}

int lobe_cube_read_faces(const unsigned char *bytes, size_t offset, lobe_cube *cube, int mip, int first, int end,
                         lobe_environment_fault *fault)
{
    const size_t side = (size_t)lobe_cube_side(cube->size, mip), texels = side * side * (size_t)(end - first);
    const lobe_cube_texel start = {first, 0, 0};
    float *rgb = lobe_cube_at(cube, mip, start);
    for (size_t i = 0; i < texels; i++)
        for (size_t k = 0; k < 3; k++, rgb++) {
            const size_t at = offset + 8 * i + 2 * k;
            *rgb = lobe_half_to_float((uint16_t)(bytes[at] | bytes[at + 1] << 8));
            if (!isfinite(*rgb))
                return lobe_environment_refuse(fault, at, "found the half 0x%04x (%g), expected a finite number",
                                               (unsigned)(bytes[at] | bytes[at + 1] << 8), (double)*rgb);
        }
    return 1;
}
