/* Six faces in one picture: what a layout is and is not, that faces which touch in a cross touch in the cube, and that
 * each layout filters to the same bytes as the same cube from DDS. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../prefilter/cube_file.h"
#include "../prefilter/faces.h"
#include "../prefilter/prefilter.h"

enum { SIDE = 5, LAYOUTS = 4 };

/* Rows of faces: X x Y y Z z are +x -x +y -y +z -z, r is -z on its head, a dot nothing. */
static const char *const drawn[LAYOUTS] = {"XxYyZz", "X|x|Y|y|Z|z", ".Y..|xZXz|.y..", ".Y.|xZX|.y.|.r."};

/* Every number differs from all others, and each is a half. */
static lobe_cube counted(void)
{
    lobe_cube cube;
    assert_true(lobe_cube_allocate(&cube, SIDE, 1));
    for (int i = 0; i < 18 * SIDE * SIDE; i++)
        cube.rgb[0][i] = (float)(i + 1);
    return cube;
}

/* The faces where the letters say, noise elsewhere. */
static lobe_environment picture_of(const lobe_cube *cube, const char *letters)
{
    lobe_environment picture;
    const int across = (int)strcspn(letters, "|"), down = ((int)strlen(letters) + 1) / (across + 1);
    assert_true(lobe_environment_allocate(&picture, across * SIDE, down * SIDE));
    for (int y = 0; y < down * SIDE; y++)
        for (int x = 0; x < across * SIDE; x++) {
            const char letter = letters[y / SIDE * (across + 1) + x / SIDE];
            const char *at = strchr("XxYyZz", letter == 'r' ? 'z' : letter);
            const int row = letter == 'r' ? SIDE - 1 - y % SIDE : y % SIDE;
            const int column = letter == 'r' ? SIDE - 1 - x % SIDE : x % SIDE;
            const lobe_cube_texel texel = {at ? (int)(at - "XxYyZz") : 0, row, column};
            float *to = picture.rgb + 3 * (y * picture.width + x);
            for (int k = 0; k < 3; k++)
                to[k] = at ? lobe_cube_at(cube, 0, texel)[k] : -(float)(x * y + k);
        }
    return picture;
}

static void layouts(void **state)
{
    (void)state;
    lobe_cube cube = counted();
    for (int i = 0; i < LAYOUTS; i++) {
        lobe_environment picture = picture_of(&cube, drawn[i]);
        lobe_environment_fault fault = {0, ""};
        lobe_cube taken;
        assert_true(lobe_faces_take(&picture, &taken, &fault));
        assert_int_equal(taken.size, SIDE);
        assert_int_equal(taken.mips, 1);
        assert_memory_equal(taken.rgb[0], cube.rgb[0], 18 * SIDE * SIDE * sizeof(float));
        lobe_cube_free(&taken);
        lobe_environment_free(&picture);
    }
    lobe_cube_free(&cube);
}

/* The texel of the cube with this number in its red, or face -1. */
static lobe_cube_texel numbered(const lobe_cube *cube, float number)
{
    for (int i = 0; i < 6 * SIDE * SIDE; i++)
        if (cube->rgb[0][3 * i] == number) {
            const lobe_cube_texel t = {i / SIDE / SIDE, i / SIDE % SIDE, i % SIDE};
            return t;
        }
    const lobe_cube_texel none = {-1, 0, 0};
    return none;
}

static int beside(lobe_cube_texel a, lobe_cube_texel b)
{
    for (int i = 0; i < 4; i++) {
        lobe_cube_texel out = a;
        *(i < 2 ? &out.row : &out.column) += i % 2 ? 1 : -1;
        if (out.row < 0 || out.row == SIDE || out.column < 0 || out.column == SIDE) {
            const lobe_cube_texel in = lobe_cube_fold(SIDE, out);
            if (in.face == b.face && in.row == b.row && in.column == b.column)
                return 1;
        }
    }
    return 0;
}

/* Needs no table of faces: a cross is a cube unfolded, so texels side by side in it lie side by side on the cube. */
static void crosses_fold(void **state)
{
    (void)state;
    for (int tall = 0; tall < 2; tall++) {
        lobe_environment picture;
        lobe_environment_fault fault = {0, ""};
        lobe_cube cube;
        const int width = (tall ? 3 : 4) * SIDE, height = (tall ? 4 : 3) * SIDE;
        int seams = 0;
        assert_true(lobe_environment_allocate(&picture, width, height));
        for (int i = 0; i < width * height; i++)
            picture.rgb[3 * i] = (float)i;
        assert_true(lobe_faces_take(&picture, &cube, &fault));
        for (int i = 0; i < width * height; i++)
            for (int down = 0; down < 2; down++) {
                const lobe_cube_texel a = numbered(&cube, (float)i),
                                      b = numbered(&cube, (float)(i + (down ? width : 1)));
                if (a.face < 0 || b.face < 0 || a.face == b.face || (!down && i % width == width - 1))
                    continue;
                assert_true(beside(a, b));
                seams++;
            }
        assert_int_equal(seams, 5 * SIDE);
        lobe_cube_free(&cube);
        lobe_environment_free(&picture);
    }
}

/* The picture as a PFM in memory, read again. */
static lobe_environment through_pfm(const lobe_environment *picture)
{
    lobe_environment again;
    lobe_environment_fault fault = {0, ""};
    char *text;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    assert_non_null(stream);
    fprintf(stream, "PF\n%d %d\n-1\n", picture->width, picture->height);
    for (int y = picture->height - 1; y >= 0; y--)
        for (int i = 0; i < 3 * picture->width; i++) {
            uint32_t bits;
            memcpy(&bits, &picture->rgb[3 * y * picture->width + i], sizeof bits);
            lobe_cube_put32(stream, bits);
        }
    assert_int_equal(fclose(stream), 0);
    assert_true(lobe_environment_parse((const unsigned char *)text, size, &again, &fault));
    free(text);
    return again;
}

static char *written(const lobe_cube *cube, lobe_prefilter_scale scale, size_t *size)
{
    char *text;
    size_t clamped;
    FILE *stream = open_memstream(&text, size);
    assert_non_null(stream);
    lobe_cube_write(stream, LOBE_CUBE_DDS, cube, &scale, &clamped);
    assert_int_equal(fclose(stream), 0);
    return text;
}

static char *filtered(const lobe_cube *from, size_t *size)
{
    const lobe_prefilter_image image = {NULL, from, 0};
    lobe_prefilter_options o = lobe_prefilter_options_default(LOBE_PREFILTER_GGX, 8);
    lobe_cube cube;
    char error[256];
    o.scale.mips = 3;
    o.progress = 0;
    assert_int_equal(lobe_prefilter(&image, &o, &cube, error, sizeof error), LOBE_PREFILTER_DONE);
    char *bytes = written(&cube, o.scale, size);
    lobe_cube_free(&cube);
    return bytes;
}

static void same_bytes_as_dds(void **state)
{
    (void)state;
    lobe_cube cube = counted(), from_dds;
    lobe_environment_fault fault = {0, ""};
    size_t dds_size, want_size, got_size;
    char *dds = written(&cube, lobe_prefilter_scale_default(LOBE_PREFILTER_GGX, 1), &dds_size);
    assert_true(lobe_cube_parse((const unsigned char *)dds, dds_size, &from_dds, &fault));
    char *want = filtered(&from_dds, &want_size);
    for (int i = 0; i < LAYOUTS; i++) {
        lobe_environment drawing = picture_of(&cube, drawn[i]), picture = through_pfm(&drawing);
        lobe_cube taken;
        assert_true(lobe_faces_take(&picture, &taken, &fault));
        char *got = filtered(&taken, &got_size);
        assert_int_equal(got_size, want_size);
        assert_memory_equal(got, want, want_size);
        free(got);
        lobe_cube_free(&taken);
        lobe_environment_free(&picture);
        lobe_environment_free(&drawing);
    }
    free(want);
    free(dds);
    lobe_cube_free(&from_dds);
    lobe_cube_free(&cube);
}

static void other_sides(void **state)
{
    (void)state;
    static const int sides[][2] = {{5, 5}, {7, 5}, {61, 10}, {10, 61}, {41, 30}, {30, 41}, {1023, 512}, {1, 1}};
    for (size_t i = 0; i < sizeof sides / sizeof sides[0]; i++) {
        const lobe_environment picture = {sides[i][0], sides[i][1], NULL};
        lobe_environment_fault fault = {9, ""};
        lobe_cube cube;
        char found[40];
        snprintf(found, sizeof found, "found %d x %d texels, expected", sides[i][0], sides[i][1]);
        assert_int_equal(lobe_faces_of(sides[i][0], sides[i][1]), LOBE_FACES_UNKNOWN);
        assert_false(lobe_faces_take(&picture, &cube, &fault));
        assert_ptr_equal(strstr(fault.reason, found), fault.reason);
        assert_non_null(strstr(fault.reason, "6 : 1, 1 : 6, 4 : 3 or 3 : 4"));
    }
    assert_int_equal(lobe_faces_of(1024, 512), LOBE_FACES_NONE);
    assert_int_equal(lobe_faces_of(2, 1), LOBE_FACES_NONE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layouts),
        cmocka_unit_test(crosses_fold),
        cmocka_unit_test(same_bytes_as_dds),
        cmocka_unit_test(other_sides),
    };
    return cmocka_run_group_tests_name("prefilter_faces", tests, NULL, NULL);
}
