/* KTX 2.0, not supercompressed: head, index, data format descriptor, key/values, then the mips from the smallest up,
 * each with its six faces. */
#include "cube_file.h"
#include <string.h>

enum { HEAD = 80, HALF4 = 97, LEVEL = 24, DESCRIPTOR = 4 + 24 + 4 * 16, ALIGN = 8 };

const unsigned char lobe_ktx2_identifier[12] = {0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'};

/* Basic descriptor block, version 2: linear RGBA in Rec. 709 primaries, one texel a block of 8 bytes. */
static void write_descriptor(FILE *out)
{
    static const uint32_t channel[4] = {0, 1, 2, 15};
    lobe_cube_put32(out, DESCRIPTOR);
    lobe_cube_put32(out, 0);
    lobe_cube_put32(out, 2u | (uint32_t)(DESCRIPTOR - 4) << 16);
    lobe_cube_put32(out, 1u | 1u << 8 | 1u << 16); /* RGBSDA, BT709, linear, straight alpha */
    lobe_cube_put32(out, 0);
    lobe_cube_put32(out, 8);
    lobe_cube_put32(out, 0);
    for (uint32_t k = 0; k < 4; k++) {
        lobe_cube_put32(out, 16 * k | 15u << 16 | (0xc0u | channel[k]) << 24); /* signed float of 16 bits */
        lobe_cube_put32(out, 0);
        lobe_cube_put32(out, 0xbf800000u); /* -1 and 1 */
        lobe_cube_put32(out, 0x3f800000u);
    }
}

/* In the order of their names, each padded to 4 bytes. Returns their size; out may be NULL. */
static uint32_t write_pairs(FILE *out, const lobe_prefilter_scale *scale)
{
    char text[3][2][96] = {{"KTXorientation", "rd"}, {"KTXwriter", "Lobe lobefit prefilter"}, {"LobePrefilter", ""}};
    uint32_t size = 0;
    snprintf(text[2][1], sizeof text[2][1], "kernel %s, lod = min(t, t^3), t = %d r (a + (1 - a) r), a = %.9g",
             scale->kernel == LOBE_PREFILTER_SG ? "sg" : "ggx", scale->mips - 1, scale->curve);
    for (int i = 0; i < 3; i++) {
        const uint32_t name = (uint32_t)strlen(text[i][0]) + 1, value = (uint32_t)strlen(text[i][1]) + 1;
        const uint32_t padding = (4 - (name + value) % 4) % 4;
        size += 4 + name + value + padding;
        if (!out)
            continue;
        lobe_cube_put32(out, name + value);
        fwrite(text[i][0], 1, name, out);
        fwrite(text[i][1], 1, value, out);
        for (uint32_t k = 0; k < padding; k++)
            putc(0, out);
    }
    return size;
}

static uint64_t level_size(const lobe_cube *cube, int mip)
{
    const uint64_t side = (uint64_t)lobe_cube_side(cube->size, mip);
    return 48 * side * side;
}

void lobe_cube_write_ktx2(FILE *out, const lobe_cube *cube, const lobe_prefilter_scale *scale, size_t *clamped)
{
    const uint32_t mips = (uint32_t)cube->mips, descriptor = HEAD + LEVEL * mips, pairs = descriptor + DESCRIPTOR;
    const uint32_t pairs_size = write_pairs(NULL, scale);
    const uint64_t end = pairs + pairs_size, start = (end + ALIGN - 1) / ALIGN * ALIGN;
    const uint32_t head[] = {HALF4, 2, (uint32_t)cube->size, (uint32_t)cube->size, 0,     0,         6,
                             mips,  0, descriptor,           DESCRIPTOR,           pairs, pairs_size};
    fwrite(lobe_ktx2_identifier, 1, sizeof lobe_ktx2_identifier, out);
    for (int i = 0; i < 13; i++)
        lobe_cube_put32(out, head[i]);
    lobe_cube_put64(out, 0); /* no supercompression data */
    lobe_cube_put64(out, 0);
    for (int m = 0; m < cube->mips; m++) {
        uint64_t at = start;
        for (int below = m + 1; below < cube->mips; below++)
            at += level_size(cube, below);
        lobe_cube_put64(out, at);
        lobe_cube_put64(out, level_size(cube, m));
        lobe_cube_put64(out, level_size(cube, m));
    }
    write_descriptor(out);
    write_pairs(out, scale);
    for (uint64_t i = end; i < start; i++)
        putc(0, out);
    for (int m = cube->mips - 1; m >= 0; m--)
        for (int face = 0; face < 6; face++)
            lobe_cube_write_face(out, cube, m, face, clamped);
}

typedef struct field {
    size_t at;
    uint32_t low, high;
    const char *name;
} field;

static int head(const unsigned char *bytes, size_t size, lobe_environment_fault *fault)
{
    static const field fields[] = {
        {12, HALF4, HALF4, "Vulkan format"}, {16, 1, 2, "type size"},       {28, 0, 0, "depth"},
        {32, 0, 1, "number of layers"},      {36, 6, 6, "number of faces"}, {44, 0, 0, "supercompression scheme"}};
    if (size < 12 || memcmp(bytes, lobe_ktx2_identifier, 12) != 0)
        return lobe_environment_refuse(fault, 0, "found other bytes, expected the identifier of KTX 2.0");
    if (size < HEAD)
        return lobe_environment_refuse(fault, size, "found the end of the file in the head, expected %d bytes", HEAD);
    for (int i = 0; i < 6; i++) {
        const uint32_t found = lobe_cube_get32(bytes + fields[i].at);
        if (found < fields[i].low || found > fields[i].high)
            return lobe_environment_refuse(fault, fields[i].at, "found %s %lu, expected one in [%lu, %lu]",
                                           fields[i].name, (unsigned long)found, (unsigned long)fields[i].low,
                                           (unsigned long)fields[i].high);
    }
    return 1;
}

static int level(const unsigned char *bytes, size_t size, lobe_cube *cube, int m, lobe_environment_fault *fault)
{
    const size_t index = HEAD + LEVEL * (size_t)m;
    const uint64_t at = lobe_cube_get64(bytes + index), length = lobe_cube_get64(bytes + index + 8),
                   wanted = level_size(cube, m);
    if (length != wanted)
        return lobe_environment_refuse(fault, index + 8, "found %llu bytes for mip %d, expected %llu",
                                       (unsigned long long)length, m, (unsigned long long)wanted);
    if (at > size || size - at < length)
        return lobe_environment_refuse(fault, index, "found mip %d at byte %llu, expected it inside the file of %zu", m,
                                       (unsigned long long)at, size);
    return lobe_cube_read_faces(bytes, (size_t)at, cube, m, 0, 6, fault);
}

int lobe_cube_from_ktx2(const unsigned char *bytes, size_t size, lobe_cube *cube, lobe_environment_fault *fault)
{
    if (!head(bytes, size, fault))
        return 0;
    const uint32_t side = lobe_cube_get32(bytes + 20), height = lobe_cube_get32(bytes + 24);
    const uint32_t count = lobe_cube_get32(bytes + 40), mips = count ? count : 1;
    if (height != side)
        return lobe_environment_refuse(fault, 24, "found a face of %lu x %lu texels, expected a square",
                                       (unsigned long)side, (unsigned long)height);
    if (!lobe_cube_check_size(side, 20, mips, 40, fault))
        return 0;
    if (size < HEAD + LEVEL * (size_t)mips)
        return lobe_environment_refuse(fault, size, "found the end of the file in the index, expected %lu mips",
                                       (unsigned long)mips);
    /* Before there is memory for it: a small file cannot ask for a large cube. */
    if ((size - HEAD) / 48 < (size_t)side * side)
        return lobe_environment_refuse(fault, size,
                                       "found a file of %zu bytes, expected 48 for each of %lu x %lu texels", size,
                                       (unsigned long)side, (unsigned long)side);
    if (!lobe_cube_allocate(cube, (int)side, (int)mips))
        return lobe_environment_refuse(fault, 20, "found a width of %lu texels, expected a cube that fits into memory",
                                       (unsigned long)side);
    for (int m = 0; m < (int)mips; m++)
        if (!level(bytes, size, cube, m, fault)) {
            lobe_cube_free(cube);
            return 0;
        }
    return 1;
}
