/* What the pictures of environments are made of: the truth at a pixel is the sum of the response over every texel, in a
 * white furnace everything is the albedo, and taps look where the light is. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include "../env_lobes/response.h"
#include "../env_lobes/rooms.h"
#include "../picture/environments.h"
#include "../split_sum/truth_split_sum.h"

static double nodes[5 * LOBE_AROUND_ORDER * LOBE_AROUND_ORDER];

/* All of mip 0, each texel in `parts` x `parts` pieces. */
static void brute(const lobe_cube *cube, double alpha, double v, double frame[3][3], int parts, double rgb[3])
{
    const int side = cube->size, fine = side * parts;
    rgb[0] = rgb[1] = rgb[2] = 0;
    for (int i = 0; i < 6 * fine * fine; i++) {
        const int face = i / (fine * fine), row = i / fine % fine, column = i % fine;
        const float *light = lobe_cube_at(cube, 0, (lobe_cube_texel){face, row / parts, column / parts});
        double d[3], l[3], weight;
        lobe_cube_direction(fine, face, row + .5, column + .5, d);
        for (int k = 0; k < 3; k++)
            l[k] = frame[k][0] * d[0] + frame[k][1] * d[1] + frame[k][2] * d[2];
        weight = lobe_response(alpha, v, l) * lobe_cube_solid_angle(fine, row, column, row + 1, column + 1);
        for (int k = 0; k < 3; k++)
            rgb[k] += weight * (double)light[k];
    }
}

static void truth_is_the_sum_over_all_texels(void **state)
{
    static const double point[][2] = {{.1, .3}, {.3, .1}, {.35, .6}, {.7, .05}, {.7, .9}};
    /* x y z of response.h in the cube's world, askew */
    double frame[3][3] = {{.48, -.64, .6}, {.8, .6, 0}, {-.36, .48, .8}}, worst = 0;
    lobe_environment map;
    lobe_around around;
    (void)state;
    assert_true(lobe_room_make(&map, LOBE_ROOM_LAMPS, 128, 107));
    assert_true(lobe_around_of(&map, 32, 0, 1, &around));
    assert_true(around.light.count > 20); /* lamps are summed up one by one */
    for (int i = 0; i < 5; i++) {
        double got[3], want[3];
        lobe_all_around_truth(&around.light, point[i][0], point[i][1], frame, around.order, nodes, got);
        brute(&around.cube, point[i][0], point[i][1], frame, i == 0 ? 6 : 3, want);
        for (int k = 0; k < 3; k++)
            worst = fmax(worst, fabs(got[k] / want[k] - 1));
    }
    lobe_around_free(&around);
    lobe_environment_free(&map);
    print_message("# truth against the sum over all texels: within %.1e\n", worst);
    assert_true(worst <= 4e-3);
}

static void white_is_the_albedo(void **state)
{
    static const double up[3] = {0, 0, 1}, view[] = {.05, .2, .6, 1};
    double of_truth = 0, of_forms = 0;
    lobe_environment map;
    lobe_around around;
    (void)state;
    assert_true(lobe_environment_allocate(&map, 32, 16));
    for (int i = 0; i < 3 * 32 * 16; i++)
        map.rgb[i] = 1;
    assert_true(lobe_around_of(&map, 8, 1, 1, &around));
    for (int i = 0; i < 4 * LOBE_AROUND_ALPHAS; i++) {
        const double alpha = lobe_around_alpha[i / 4], v = view[i % 4], in[2] = {sqrt(alpha), v};
        const double to_eye[3] = {-.6 * sqrt(1 - v * v), .8 * sqrt(1 - v * v), v};
        double rgb[LOBE_AROUND_COLUMNS][3], dfg[2];
        lobe_truth_split_sum_rows(in, dfg, 1);
        lobe_around_reflect(&around, alpha, to_eye, up, nodes, rgb);
        for (int k = 0; k < 3; k++) {
            of_truth = fmax(of_truth, fabs(rgb[0][k] - dfg[0] - dfg[1]));
            for (int c = 1; c < LOBE_AROUND_COLUMNS; c++)
                of_forms = fmax(of_forms, fabs(rgb[c][k] - dfg[0] - dfg[1]));
        }
    }
    lobe_around_free(&around);
    lobe_environment_free(&map);
    print_message("# white furnace: truth within %.1e of the albedo, forms within %.1e\n", of_truth, of_forms);
    assert_true(of_forms <= 6.3e-5 + 5e-6); /* what lobe_env.h states, and float's rounding of eight weights */
    assert_true(of_truth <= 2e-3);
}

/* One bright texel: where the mirror looks at it all columns are brightest, against the same surface turned away. */
static void taps_look_to_the_mirror_side(void **state)
{
    static const double up[3] = {0, 0, 1};
    double toward[LOBE_AROUND_COLUMNS][3], away[LOBE_AROUND_COLUMNS][3], d[3];
    lobe_environment map;
    lobe_around around;
    (void)state;
    assert_true(lobe_environment_allocate(&map, 64, 32));
    map.rgb[3 * (10 * 64 + 20)] = 1000; /* red */
    lobe_environment_direction(&map, 10, 20, d);
    assert_true(lobe_around_of(&map, 16, lobe_around_brightest(&map), 1, &around));
    /* the picture's +y looks to the texel's azimuth */
    const double flat = sqrt(d[0] * d[0] + d[1] * d[1]), before[3] = {0, -flat, d[2]}, behind[3] = {0, flat, d[2]};
    lobe_around_reflect(&around, .15, before, up, nodes, toward);
    lobe_around_reflect(&around, .15, behind, up, nodes, away);
    for (int c = 0; c < LOBE_AROUND_COLUMNS; c++) {
        assert_true(toward[c][0] > 20 * fabs(away[c][0]));
        assert_true(toward[c][1] == 0);
    }
    lobe_around_free(&around);
    lobe_environment_free(&map);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(truth_is_the_sum_over_all_texels),
        cmocka_unit_test(white_is_the_albedo),
        cmocka_unit_test(taps_look_to_the_mirror_side),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
