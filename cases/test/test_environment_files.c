/* The readers: every spelling of RGBE and PFM gives the texels it should, and a file that is wrong is refused at the
 * byte where it goes wrong, with what was found and what was expected. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <string.h>
#include "../environment/environment.h"

#define HEAD "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"

/* A literal without its final zero. */
#define BYTES(s) (const unsigned char *)(s), sizeof(s) - 1

static void refused(const unsigned char *bytes, size_t size, size_t offset, const char *found, const char *expected)
{
    lobe_environment map;
    lobe_environment_fault fault = {(size_t)-1, ""};
    const int good = lobe_environment_parse(bytes, size, &map, &fault);
    if (!good && (fault.offset != offset || !strstr(fault.reason, found) || !strstr(fault.reason, expected)))
        printf("# byte %zu: %s\n", fault.offset, fault.reason);
    assert_false(good);
    assert_int_equal(fault.offset, offset);
    assert_non_null(strstr(fault.reason, found));
    assert_non_null(strstr(fault.reason, expected));
}

/* Reads a map whose texels have red 1, 2, 3 ... modulo `period`, green .5 and blue 0. */
static void ramp(const unsigned char *bytes, size_t size, int width, int height, int period)
{
    lobe_environment map;
    lobe_environment_fault fault = {0, ""};
    const int good = lobe_environment_parse(bytes, size, &map, &fault);
    if (!good)
        printf("# byte %zu: %s\n", fault.offset, fault.reason);
    assert_true(good);
    assert_int_equal(map.width, width);
    assert_int_equal(map.height, height);
    for (int i = 0; i < width * height; i++) {
        assert_true(map.rgb[3 * i] == (float)(1 + i % period));
        assert_true(map.rgb[3 * i + 1] == 0.5f);
        assert_true(map.rgb[3 * i + 2] == 0);
    }
    lobe_environment_free(&map);
}

/* Exponent 136 makes the mantissa whole; green .5 wants 135, so the mantissas are doubled there. */
#define TEXEL(r) r "\1\0\207"

static void rgbe_flat(void **state)
{
    (void)state;
    ramp(BYTES(HEAD "-Y 2 +X 2\n" TEXEL("\2") TEXEL("\4") TEXEL("\6") TEXEL("\10")), 2, 2, 4);
    ramp(BYTES("#?RGBE\r\n# comment\r\nFORMAT=32-bit_rle_rgbe\r\nSOFTWARE=x\r\n\r\n-Y 1 +X 1\r\n" TEXEL("\2")), 1, 1,
         1);
    /* Exposures divide, and multiply with each other: 4 in all. */
    ramp(BYTES("#?RADIANCE\nEXPOSURE=8\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=.5\n\n-Y 1 +X 1\n\10\4\0\207"), 1, 1, 1);
}

static void rgbe_old_runs(void **state)
{
    (void)state;
    ramp(BYTES(HEAD "-Y 1 +X 4\n" TEXEL("\2") "\1\1\1\3"), 4, 1, 1);
    /* 5 and 256 more. */
    ramp(BYTES(HEAD "-Y 1 +X 262\n" TEXEL("\2") "\1\1\1\5\1\1\1\1"), 262, 1, 1);
}

static void rgbe_new_runs(void **state)
{
    (void)state;
    ramp(BYTES(HEAD "-Y 2 +X 8\n"
                    "\2\2\0\10\10\2\4\6\10\12\14\16\20\210\1\210\0\210\207"
                    "\2\2\0\10\4\2\4\6\10\4\12\14\16\20\204\1\204\1\210\0\210\207"),
         8, 2, 8);
    /* A width of 8 may still be flat. */
    ramp(BYTES(HEAD "-Y 1 +X 8\n" TEXEL("\2") "\1\1\1\7"), 8, 1, 1);
}

static void rgbe_values(void **state)
{
    (void)state;
    lobe_environment map;
    lobe_environment_fault fault;
    assert_true(
        lobe_environment_parse(BYTES(HEAD "-Y 1 +X 3\n\200\100\40\201\377\377\377\0\377\1\0\377"), &map, &fault));
    assert_true(map.rgb[0] == 1 && map.rgb[1] == 0.5f && map.rgb[2] == 0.25f); /* 1 stays 1: no half unit */
    assert_true(map.rgb[3] == 0 && map.rgb[4] == 0 && map.rgb[5] == 0);        /* exponent 0 is black */
    assert_true(map.rgb[6] > 1.6e38f && map.rgb[6] <= 3.0e38f && map.rgb[8] == 0);
    lobe_environment_free(&map);
}

static void rgbe_header_refused(void **state)
{
    (void)state;
    refused(BYTES(""), 0, "0 bytes", "#? (RGBE) or PF (PFM)");
    refused(BYTES("hello"), 0, "0x68 0x65", "#? (RGBE) or PF (PFM)");
    refused(BYTES("#?RADIANCE\nFORMAT=32"), 20, "end of the file in the header", "rest");
    refused(BYTES("#?RADIANCE\nGAMMA=1\n\n-Y 1 +X 1\n0000"), 19, "header's end", "FORMAT=32-bit_rle_rgbe");
    refused(BYTES("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n0000"), 11, "xyze", "FORMAT=32-bit_rle_rgbe");
    refused(BYTES("#?RADIANCE\nEXPOSURE=0\n"), 11, "EXPOSURE=0", "(1e-12, 1e12)");
    refused(BYTES("#?RADIANCE\nEXPOSURE=nan\n"), 11, "EXPOSURE=nan", "(1e-12, 1e12)");
    refused(BYTES("#?RADIANCE\nEXPOSURE=x\n"), 11, "EXPOSURE=x", "(1e-12, 1e12)");
    refused(BYTES("#?RADIANCE\nEXPOSURE=9e11\nEXPOSURE=9e11\nEXPOSURE=9e11\n"), 39, "product", "(1e-24, 1e24)");
    refused(BYTES("#?RADIANCE\n\0"), 11, "zero byte", "text");
    refused(BYTES(HEAD "+X 1 -Y 1\n0000"), 35, "+X 1 -Y 1", "-Y height +X width");
    refused(BYTES(HEAD "-Y 1 +X 1 7\n0000"), 35, "-Y 1 +X 1 7", "-Y height +X width");
    refused(BYTES(HEAD "-Y 30000 +X 30000\n0000"), 35, "30000 x 30000", "at most 134217728");
    refused(BYTES(HEAD "-Y 0 +X 8\n0000"), 35, "8 x 0", "[1, 32768]");
    refused(BYTES(HEAD "-Y -5 +X 8\n0000"), 35, "8 x -5", "[1, 32768]");
    char long_line[400];
    memset(long_line, 'x', sizeof long_line);
    memcpy(long_line, "#?R\n", 4);
    refused((const unsigned char *)long_line, sizeof long_line, 4 + 255, "more than 255 bytes", "less");
}

static void rgbe_rows_refused(void **state)
{
    (void)state;
    refused(BYTES(HEAD "-Y 3 +X 1\n00000000"), 53, "8 bytes after the header", "3 rows");
    refused(BYTES(HEAD "-Y 1 +X 2\n0000"), 49, "end of the file in row 0", "1 rows");
    refused(BYTES(HEAD "-Y 1 +X 2\n\1\1\1\1\1\1\1\1"), 45, "repeat at the start of row 0", "a texel");
    refused(BYTES(HEAD "-Y 1 +X 3\n\0\0\0\0\1\1\1\3"), 49, "run of 3", "1 to 2");
    refused(BYTES(HEAD "-Y 1 +X 9\n\0\0\0\0\1\1\1\0\1\1\1\0\1\1\1\0\1\1\1\0"), 61, "run of 10", "1 to 8");
    refused(BYTES(HEAD "-Y 1 +X 8\n\2\2\0\11\210\1\210\1\210\1\210\1"), 47, "row of 9", "expected 8");
    refused(BYTES(HEAD "-Y 1 +X 8\n\2\2\0\10\211\1\210\1\210\1\210\1"), 49, "run of 9", "1 to 8");
    refused(BYTES(HEAD "-Y 1 +X 8\n\2\2\0\10\200\1\210\1\210\1\210\1"), 49, "run of 128", "1 to 8");
    refused(BYTES(HEAD "-Y 1 +X 8\n\2\2\0\10\0\1\210\1\210\1\210\1"), 49, "run of 0", "1 to 8");
    refused(BYTES(HEAD "-Y 1 +X 8\n\2\2\0\10\210\1\210\1\210\1\10\1"), 57, "end of the file in row 0", "1 rows");
    refused(BYTES(HEAD "-Y 1 +X 8\n\2\2\0\10\210\1\210\1\210\1\210"), 56, "end of the file in row 0", "1 rows");
}

/* Every file that is cut short is refused, at its end. */
static void every_cut(void **state)
{
    (void)state;
    static const char rgbe[] = HEAD "-Y 2 +X 8\n\2\2\0\10\10\2\4\6\10\12\14\16\20\210\1\210\0\210\207"
                                    "\2\2\0\10\4\2\4\6\10\4\12\14\16\20\204\1\204\1\210\0\210\207";
    static const char pfm[] = "PF\n1 2\n-1.0\n\0\0\0\x40\0\0\0\x40\0\0\0\x40\0\0\x80\x3f\0\0\x80\x3f\0\0\x80\x3f";
    lobe_environment map;
    lobe_environment_fault fault;
    for (size_t n = 0; n + 1 < sizeof rgbe; n++) {
        assert_false(lobe_environment_parse((const unsigned char *)rgbe, n, &map, &fault));
        assert_true(fault.offset == n || n < 2);
    }
    for (size_t n = 0; n + 1 < sizeof pfm; n++) {
        assert_false(lobe_environment_parse((const unsigned char *)pfm, n, &map, &fault));
        assert_true(fault.offset <= n);
    }
}

static void pfm(void **state)
{
    (void)state;
    lobe_environment map;
    lobe_environment_fault fault;
    assert_true(lobe_environment_parse(
        BYTES("PF\n1 2\n-1.0\n\0\0\0\x40\0\0\0\x40\0\0\0\x40\0\0\x80\x3f\0\0\x80\x3f\0\0\x80\x3f"), &map, &fault));
    assert_true(map.rgb[0] == 1 && map.rgb[3] == 2); /* little endian, the bottom row first */
    lobe_environment_free(&map);
    assert_true(lobe_environment_parse(BYTES("Pf\n1 2\n1.0\n\x40\0\0\0\x3f\x80\0\0"), &map, &fault));
    assert_true(map.rgb[0] == 1 && map.rgb[2] == 1 && map.rgb[3] == 2); /* big endian, grey */
    lobe_environment_free(&map);
}

static void pfm_refused(void **state)
{
    (void)state;
    refused(BYTES("PFX 1 1 -1\n000000000000"), 0, "'PFX'", "PF or Pf");
    refused(BYTES("PF\n1 1\n-1\n\0\0\0\0\0\0\xc0\x7f\0\0\0\0"), 14, "nan", "finite");
    refused(BYTES("PF\n1 1\n1\n\0\0\0\0\0\0\0\0\x7f\x80\0\0"), 17, "inf", "finite");
    refused(BYTES("PF\n1 1\n0\n000000000000"), 7, "scale '0'", "other than 0");
    refused(BYTES("PF\n1 1\nx\n000000000000"), 7, "scale 'x'", "a number");
    refused(BYTES("PF\n1 0\n-1\n000000000000"), 5, "height '0'", "[1, 32768]");
    refused(BYTES("PF\n1e3 1\n-1\n000000000000"), 3, "width '1e3'", "[1, 32768]");
    refused(BYTES("PF\n30000 30000\n-1\n"), 15, "30000 x 30000", "at most 134217728");
    refused(BYTES("PF\n2 1\n-1\n000000000000"), 22, "after 1 texels", "expected 2");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rgbe_flat),           cmocka_unit_test(rgbe_old_runs),
        cmocka_unit_test(rgbe_new_runs),       cmocka_unit_test(rgbe_values),
        cmocka_unit_test(rgbe_header_refused), cmocka_unit_test(rgbe_rows_refused),
        cmocka_unit_test(every_cut),           cmocka_unit_test(pfm),
        cmocka_unit_test(pfm_refused),
    };
    return cmocka_run_group_tests_name("environment_files", tests, NULL, NULL);
}
