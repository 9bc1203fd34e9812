/* Cube files: the heads hold what the specifications say, what was written is read back, every single wrong byte of a
 * head and every cut is refused or harmless, and refusals say where, what was found and what was expected. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../prefilter/cube_file.h"
#include "../prefilter/half.h"

enum { SIZE = 8, MIPS = 3, TEXELS = 6 * (64 + 16 + 4) };

typedef struct file {
    unsigned char *bytes;
    size_t size;
} file;

/* Every number differs from all others, and each is a half. */
static lobe_cube counted(void)
{
    lobe_cube cube;
    float x = -700;
    assert_true(lobe_cube_allocate(&cube, SIZE, MIPS));
    for (int m = 0; m < MIPS; m++)
        for (int i = 0; i < 18 * lobe_cube_side(SIZE, m) * lobe_cube_side(SIZE, m); i++)
            cube.rgb[m][i] = x++;
    return cube;
}

static file written(const lobe_cube *cube, lobe_cube_format format, size_t *clamped)
{
    const lobe_prefilter_scale scale = {LOBE_PREFILTER_SG, MIPS, 1.5};
    file f;
    char *text;
    FILE *stream = open_memstream(&text, &f.size);
    assert_non_null(stream);
    lobe_cube_write(stream, format, cube, &scale, clamped);
    assert_int_equal(fclose(stream), 0);
    f.bytes = (unsigned char *)text;
    return f;
}

static uint32_t word(const file *f, size_t at) { return lobe_cube_get32(f->bytes + at); }

static float half_at(const file *f, size_t at)
{
    return lobe_half_to_float((uint16_t)(f->bytes[at] | f->bytes[at + 1] << 8));
}

static void dds_head(void **state)
{
    (void)state;
    lobe_cube cube = counted();
    size_t clamped = 9;
    const file f = written(&cube, LOBE_CUBE_DDS, &clamped);
    assert_int_equal(clamped, 0);
    assert_int_equal(f.size, 148 + 8 * TEXELS);
    assert_memory_equal(f.bytes, "DDS ", 4);
    assert_int_equal(word(&f, 4), 124);
    assert_int_equal(word(&f, 8), 0x2100f); /* CAPS HEIGHT WIDTH PITCH PIXELFORMAT MIPMAPCOUNT */
    assert_int_equal(word(&f, 12), SIZE);
    assert_int_equal(word(&f, 16), SIZE);
    assert_int_equal(word(&f, 20), SIZE * 8);
    assert_int_equal(word(&f, 28), MIPS);
    assert_int_equal(word(&f, 76), 32);
    assert_int_equal(word(&f, 80), 4); /* FOURCC */
    assert_memory_equal(f.bytes + 84, "DX10", 4);
    assert_int_equal(word(&f, 108), 0x401008); /* COMPLEX TEXTURE MIPMAP */
    assert_int_equal(word(&f, 112), 0xfe00);   /* CUBEMAP and its six faces */
    assert_int_equal(word(&f, 128), 10);       /* DXGI_FORMAT_R16G16B16A16_FLOAT */
    assert_int_equal(word(&f, 132), 3);        /* D3D10_RESOURCE_DIMENSION_TEXTURE2D */
    assert_int_equal(word(&f, 136), 4);        /* D3D10_RESOURCE_MISC_TEXTURECUBE */
    assert_int_equal(word(&f, 140), 1);
    /* Face 1 begins after the whole chain of face 0; alpha is 1. */
    const lobe_cube_texel first = {1, 0, 0}, second = {0, 0, 1};
    assert_true(half_at(&f, 148 + 8 * 84) == lobe_cube_at(&cube, 0, first)[0]);
    assert_true(half_at(&f, 148 + 8 * 64 + 8) == lobe_cube_at(&cube, 1, second)[0]);
    assert_true(half_at(&f, 148 + 6) == 1);
    free(f.bytes);
    lobe_cube_free(&cube);
}

static void ktx2_head(void **state)
{
    (void)state;
    static const unsigned char identifier[12] = {0xab, 0x4b, 0x54, 0x58, 0x20, 0x32,
                                                 0x30, 0xbb, 0x0d, 0x0a, 0x1a, 0x0a};
    /* Format, type size, width, height, depth, layers, faces, levels, supercompression. */
    static const uint32_t head[9] = {97, 2, SIZE, SIZE, 0, 0, 6, MIPS, 0};
    lobe_cube cube = counted();
    size_t clamped;
    const file f = written(&cube, LOBE_CUBE_KTX2, &clamped);
    assert_memory_equal(f.bytes, identifier, 12);
    for (size_t i = 0; i < 9; i++)
        assert_int_equal(word(&f, 12 + 4 * i), head[i]);
    const size_t descriptor = word(&f, 48), pairs = word(&f, 56), pairs_size = word(&f, 60);
    assert_int_equal(descriptor, 80 + 24 * MIPS);
    assert_int_equal(word(&f, 52), 92);
    assert_int_equal(pairs, descriptor + 92);
    /* The descriptor of a format of four signed 16-bit floats. */
    assert_int_equal(word(&f, descriptor), 92);
    assert_int_equal(word(&f, descriptor + 4), 0);
    assert_int_equal(word(&f, descriptor + 8), 2 | 88 << 16);
    assert_int_equal(word(&f, descriptor + 12), 0x010101); /* RGBSDA, BT.709, linear */
    assert_int_equal(word(&f, descriptor + 20), 8);
    for (size_t k = 0; k < 4; k++) {
        const size_t sample = descriptor + 28 + 16 * k;
        assert_int_equal(word(&f, sample) & 0xffff, 16 * k);
        assert_int_equal(f.bytes[sample + 2], 15);
        assert_int_equal(f.bytes[sample + 3], 0xc0 | (k < 3 ? k : 15));
        assert_int_equal(word(&f, sample + 8), 0xbf800000u);
        assert_int_equal(word(&f, sample + 12), 0x3f800000u);
    }
    /* Keys in the order of their bytes, all inside their block. */
    size_t at = pairs;
    const char *before = "";
    while (at < pairs + pairs_size) {
        const size_t length = word(&f, at);
        const char *key = (const char *)f.bytes + at + 4;
        assert_true(strcmp(before, key) < 0);
        assert_int_equal(key[length - 1], 0);
        before = key;
        at += 4 + (length + 3) / 4 * 4;
    }
    assert_int_equal(at, pairs + pairs_size);
    /* The smallest mip stands first, all are aligned to a texel, the last ends the file. */
    for (int m = 0; m < MIPS; m++) {
        const size_t start = word(&f, 80 + 24 * (size_t)m), length = word(&f, 88 + 24 * (size_t)m);
        const int side = lobe_cube_side(SIZE, m);
        assert_int_equal(start % 8, 0);
        assert_int_equal(length, 48 * side * side);
        assert_int_equal(word(&f, 96 + 24 * (size_t)m), length);
        assert_int_equal(start + length, m == 0 ? f.size : word(&f, 80 + 24 * (size_t)(m - 1)));
        assert_true(half_at(&f, start) == cube.rgb[m][0]);
    }
    free(f.bytes);
    lobe_cube_free(&cube);
}

static void raw_layout(void **state)
{
    (void)state;
    lobe_cube cube = counted();
    size_t clamped, at = 0;
    const file f = written(&cube, LOBE_CUBE_RAW, &clamped);
    assert_int_equal(f.size, 12 * TEXELS);
    for (int m = 0; m < MIPS; m++)
        for (int i = 0; i < 18 * lobe_cube_side(SIZE, m) * lobe_cube_side(SIZE, m); i++, at += 4) {
            const uint32_t bits = word(&f, at);
            float x;
            memcpy(&x, &bits, sizeof x);
            assert_true(x == cube.rgb[m][i]);
        }
    free(f.bytes);
    lobe_cube_free(&cube);
}

static void read_back(void **state)
{
    (void)state;
    for (int format = 0; format < 2; format++) {
        lobe_cube cube = counted(), again;
        lobe_environment_fault fault;
        size_t clamped;
        const file f = written(&cube, (lobe_cube_format)format, &clamped);
        assert_true(lobe_cube_is_file(f.bytes, f.size));
        assert_true(lobe_cube_parse(f.bytes, f.size, &again, &fault));
        assert_int_equal(again.size, SIZE);
        assert_int_equal(again.mips, MIPS);
        for (int m = 0; m < MIPS; m++) {
            const size_t side = (size_t)lobe_cube_side(SIZE, m);
            assert_memory_equal(again.rgb[m], cube.rgb[m], 18 * side * side * sizeof(float));
        }
        lobe_cube_free(&again);
        lobe_cube_free(&cube);
        free(f.bytes);
    }
}

static void too_bright_is_counted(void **state)
{
    (void)state;
    lobe_cube cube = counted(), again;
    lobe_environment_fault fault;
    size_t clamped;
    cube.rgb[0][5] = 1e6f;
    cube.rgb[2][7] = -70000;
    cube.rgb[1][7] = 65504;
    const file f = written(&cube, LOBE_CUBE_DDS, &clamped);
    assert_int_equal(clamped, 2);
    assert_true(lobe_cube_parse(f.bytes, f.size, &again, &fault));
    assert_true(again.rgb[0][5] == 65504 && again.rgb[2][7] == -65504);
    lobe_cube_free(&again);
    lobe_cube_free(&cube);
    free(f.bytes);
}

/* A word of the head is changed: refused there, with words that say what it is. */
static void refused(lobe_cube_format format, size_t at, uint32_t value, const char *found, const char *expected)
{
    lobe_cube cube = counted(), again;
    lobe_environment_fault fault = {0, ""};
    size_t clamped;
    const file f = written(&cube, format, &clamped);
    for (int i = 0; i < 4; i++)
        f.bytes[at + (size_t)i] = (unsigned char)(value >> 8 * i);
    const int good = lobe_cube_parse(f.bytes, f.size, &again, &fault);
    if (!good && (fault.offset != at || !strstr(fault.reason, found) || !strstr(fault.reason, expected)))
        printf("# byte %zu: %s\n", fault.offset, fault.reason);
    assert_false(good);
    assert_int_equal(fault.offset, at);
    assert_non_null(strstr(fault.reason, found));
    assert_non_null(strstr(fault.reason, expected));
    lobe_cube_free(&cube);
    free(f.bytes);
}

static void dds_refused(void **state)
{
    (void)state;
    refused(LOBE_CUBE_DDS, 4, 125, "head size 125", "expected 124");
    refused(LOBE_CUBE_DDS, 12, 9, "8 x 9 texels", "a square");
    refused(LOBE_CUBE_DDS, 28, 5, "5 mips", "[1, 4]");
    refused(LOBE_CUBE_DDS, 84, 0x31545844, "0x31545844", "DX10 or 113");
    refused(LOBE_CUBE_DDS, 128, 2, "DXGI format 2", "expected 10");
    refused(LOBE_CUBE_DDS, 132, 4, "resource dimension 4", "expected 3");
    refused(LOBE_CUBE_DDS, 136, 0, "flags 0x0", "a cube (0x4)");
    refused(LOBE_CUBE_DDS, 140, 2, "array size 2", "expected 1");
    refused(LOBE_CUBE_DDS, 148, 0x3c007c00, "0x7c00 (inf)", "finite");
    refused(LOBE_CUBE_DDS, 152, 0x3c00fe01, "0xfe01", "finite");
}

static void ktx2_refused(void **state)
{
    (void)state;
    refused(LOBE_CUBE_KTX2, 12, 109, "Vulkan format 109", "[97, 97]");
    refused(LOBE_CUBE_KTX2, 24, 9, "8 x 9 texels", "a square");
    refused(LOBE_CUBE_KTX2, 28, 1, "depth 1", "[0, 0]");
    refused(LOBE_CUBE_KTX2, 32, 2, "number of layers 2", "[0, 1]");
    refused(LOBE_CUBE_KTX2, 36, 1, "number of faces 1", "[6, 6]");
    refused(LOBE_CUBE_KTX2, 40, 9, "9 mips", "[1, 4]");
    refused(LOBE_CUBE_KTX2, 44, 2, "supercompression scheme 2", "[0, 0]");
    refused(LOBE_CUBE_KTX2, 88, 1, "1 bytes for mip 0", "3072");
    refused(LOBE_CUBE_KTX2, 80, 0x7fffffff, "mip 0 at byte 2147483647", "inside the file");
}

/* Legacy heads, and what no writer here makes. */
static void dds_legacy(void **state)
{
    (void)state;
    lobe_cube cube = counted(), again;
    lobe_environment_fault fault;
    size_t clamped;
    file f = written(&cube, LOBE_CUBE_DDS, &clamped);
    memmove(f.bytes + 128, f.bytes + 148, f.size - 148);
    memcpy(f.bytes + 84, "q\0\0\0", 4); /* 113, D3DFMT_A16B16G16R16F */
    assert_true(lobe_cube_parse(f.bytes, f.size - 20, &again, &fault));
    assert_true(again.rgb[0][0] == -700);
    lobe_cube_free(&again);
    f.bytes[113] = 0x06; /* one face of the cube */
    assert_false(lobe_cube_parse(f.bytes, f.size - 20, &again, &fault));
    assert_int_equal(fault.offset, 112);
    lobe_cube_free(&cube);
    free(f.bytes);
}

/* Cut anywhere: refused. Any byte of the head set to anything of four: a cube or a refusal inside the file; the
 * sanitizers watch. */
static void cuts_and_mutations(void **state)
{
    (void)state;
    static const unsigned char values[4] = {0, 1, 0x7f, 0xff};
    for (int format = 0; format < 2; format++) {
        lobe_cube cube = counted(), again;
        lobe_environment_fault fault;
        size_t clamped;
        const file f = written(&cube, (lobe_cube_format)format, &clamped);
        for (size_t n = 0; n < f.size; n++) {
            unsigned char *cut = malloc(n + 1); /* of the exact size, for the address sanitizer */
            assert_non_null(cut);
            memcpy(cut, f.bytes, n);
            assert_false(n >= 12 && lobe_cube_parse(cut, n, &again, &fault));
            assert_true(n < 12 || fault.offset <= n);
            free(cut);
        }
        for (size_t at = 0; at < 400; at++)
            for (int v = 0; v < 4; v++) {
                const unsigned char kept = f.bytes[at];
                f.bytes[at] = values[v];
                if (lobe_cube_parse(f.bytes, f.size, &again, &fault))
                    lobe_cube_free(&again);
                else
                    assert_true(fault.offset < f.size && strstr(fault.reason, "found") &&
                                strstr(fault.reason, "expected"));
                f.bytes[at] = kept;
            }
        lobe_cube_free(&cube);
        free(f.bytes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dds_head),           cmocka_unit_test(ktx2_head),
        cmocka_unit_test(raw_layout),         cmocka_unit_test(read_back),
        cmocka_unit_test(dds_refused),        cmocka_unit_test(ktx2_refused),
        cmocka_unit_test(dds_legacy),         cmocka_unit_test(too_bright_is_counted),
        cmocka_unit_test(cuts_and_mutations),
    };
    return cmocka_run_group_tests_name("prefilter_files", tests, NULL, NULL);
}
