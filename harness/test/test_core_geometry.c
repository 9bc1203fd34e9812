/* Frames, sphere maps, GGX, Smith and Fresnel against their definitions: integrals by quadrature and textbook formulas
 * in double, never the code's own rearrangements. Compiled for float, and with LOBE_DOUBLE as the ground truth is. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <cmocka.h>
#include "../../core/frame.h"
#include "../../core/fresnel.h"
#include "../../core/smith.h"
#include "../../core/sphere_map.h"
#include <math.h>

#if defined(LOBE_DOUBLE)
#define EPSILON 1.1102230246251565e-16
#define MAP_BOUND(float_bound) 1e-13
#else
#define EPSILON 5.9604644775390625e-8
#define MAP_BOUND(float_bound) (float_bound)
#endif

static const double pi = 3.141592653589793;
static uint64_t random_state = 1;

static double random_unit(void)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return (double)(random_state >> 11) * 0x1p-53;
}

/* Inputs as the scalar under test holds them. */
static lobe_real real(double x) { return (lobe_real)x; }

static lobe_vec3 direction(double z, double azimuth)
{
    const double s = sqrt(1.0 - z * z);
    return lobe_vec3_of(real(s * cos(azimuth)), real(s * sin(azimuth)), real(z));
}

/* Uniform, and every fourth within 1e-1 to 1e-12 of a pole or of an axis. */
static lobe_vec3 random_direction(int i)
{
    const double near_pole = i % 4 == 0 ? pow(10.0, -1.0 - 11.0 * random_unit()) : 2.0 * random_unit();
    const double z = (i & 8 ? 1.0 - near_pole : near_pole - 1.0);
    return direction(z, i % 16 < 2 ? floor(8.0 * random_unit()) * pi / 4.0 : 2.0 * pi * random_unit());
}

static double distance(lobe_vec3 a, lobe_vec3 b)
{
    const double x = (double)(a.x - b.x), y = (double)(a.y - b.y), z = (double)(a.z - b.z);
    return sqrt(x * x + y * y + z * z);
}

static double dot(lobe_vec3 a, lobe_vec3 b)
{
    return (double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z;
}

static void check_frame(lobe_vec3 n)
{
    const double bound = MAP_BOUND(LOBE_FRAME_ORTHONORMAL);
    const lobe_frame f = lobe_frame_around(n);
    const lobe_vec3 w = lobe_vec3_of(real(0.36), real(-0.48), real(0.8));
    assert_true(fabs(dot(f.tangent, f.tangent) - 1.0) <= bound);
    assert_true(fabs(dot(f.bitangent, f.bitangent) - 1.0) <= bound);
    assert_true(fabs(dot(f.tangent, f.bitangent)) <= bound);
    assert_true(fabs(dot(f.tangent, n)) <= bound);
    assert_true(fabs(dot(f.bitangent, n)) <= bound);
    assert_true(distance(lobe_vec3_cross(f.tangent, f.bitangent), n) <= 2.0 * bound);
    assert_true(distance(lobe_frame_to_world(f, lobe_frame_to_local(f, w)), w) <= 4.0 * bound);
    assert_true(distance(lobe_frame_to_local(f, n), lobe_vec3_of(0, 0, 1)) <= 2.0 * bound);
}

static void frames_are_orthonormal(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 300000; i++)
        check_frame(random_direction(i));
    for (i = -1; i <= 1; i += 2) {
        check_frame(lobe_vec3_of(0, 0, real(i)));
        check_frame(lobe_vec3_of(real(-0.0), real(-0.0), real(i)));
        check_frame(lobe_vec3_of(real(i), 0, 0));
        check_frame(lobe_vec3_of(0, real(i), real(-0.0)));
    }
}

static void vectors_obey_their_algebra(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 100000; i++) {
        const lobe_vec3 n = random_direction(i), a = random_direction(i + 1);
        const double size = pow(10.0, 24.0 * random_unit() - 12.0);
        const lobe_vec3 r = lobe_vec3_reflect(a, n);
        assert_true(distance(lobe_vec3_normalize(lobe_vec3_scale(a, real(size))), a) <= 4.0 * EPSILON);
        assert_true(fabs(dot(r, n) - dot(a, n)) <= 10.0 * EPSILON);
        assert_true(distance(lobe_vec3_add(r, a), lobe_vec3_scale(n, real(2.0 * dot(a, n)))) <= 10.0 * EPSILON);
    }
    assert_true(distance(lobe_vec3_normalize(lobe_vec3_of(0, 0, 0)), lobe_vec3_of(0, 0, 0)) == 0.0);
}

/* The integral of D(h) (n.h) over the hemisphere, by the midpoint rule in x with theta = (pi / 2) x^4. */
static void ggx_is_normalised(void **state)
{
    static const double alphas[] = {1.0, 0.7, 0.25, 0.04, 0.01, 0.002};
    enum { N = 20000 };
    size_t k;
    (void)state;
    for (k = 0; k < sizeof alphas / sizeof alphas[0]; k++) {
        double sum = 0.0, sine_sum = 0.0;
        int i;
        for (i = 0; i < N; i++) {
            const double x = (i + 0.5) / N, theta = 0.5 * pi * x * x * x * x;
            const double c = cos(theta), s = sin(theta);
            const double weight = 2.0 * pi * c * s * 2.0 * pi * x * x * x / N;
            sum += weight * (double)lobe_ggx_d(real(alphas[k]), real(c));
            sine_sum += weight * (double)lobe_ggx_d_sine(real(alphas[k]), real(c * c), real(s * s));
        }
        assert_true(fabs(sine_sum - 1.0) < 1e-6 + 16.0 * EPSILON);
        /* A cosine that is rounded to float moves the narrow lobes. */
        assert_true(fabs(sum - 1.0) < 1e-6 + EPSILON * 16.0 / (alphas[k] * alphas[k]));
    }
}

/* Midpoint rule over the hemisphere of half vectors, graded towards the peak. */
static double half_vector_integral(double alpha, double v, int visible_density)
{
    enum { N = 600, M = 400 };
    const lobe_vec3 view = direction(v, 0.0);
    double sum = 0.0;
    int i, j;
    for (i = 0; i < N; i++) {
        const double x = (i + 0.5) / N, theta = 0.5 * pi * x * x * x;
        const double weight = sin(theta) * 1.5 * pi * x * x / N * 2.0 * pi / M;
        for (j = 0; j < M; j++) {
            const lobe_vec3 h = direction(cos(theta), 2.0 * pi * (j + 0.5) / M);
            const double vh = fmax(0.0, dot(view, h));
            sum += weight * (visible_density ? (double)lobe_ggx_visible_density(real(alpha), view.z, h.z, real(vh))
                                             : vh * (double)lobe_ggx_d(real(alpha), h.z) *
                                                   (double)lobe_smith_g1(real(alpha), view.z));
        }
    }
    return sum;
}

/* Heitz 2014, eq. 22: what is visible of the microsurface covers exactly the projected area of the surface. */
static void masking_conserves_projected_area(void **state)
{
    static const double cases[][2] = {{1.0, 1.0}, {1.0, 0.3}, {0.5, 0.05}, {0.3, 0.6}, {0.1, 0.9}, {0.1, 0.2}};
    size_t k;
    (void)state;
    for (k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        const double alpha = cases[k][0], v = cases[k][1];
        assert_true(fabs(half_vector_integral(alpha, v, 0) - v) < 2e-4);
        assert_true(fabs(half_vector_integral(alpha, v, 1) - 1.0) < 5e-4);
    }
}

/* Lambda as the textbook has it, in double. */
static double lambda_of(double alpha, double c)
{
    const double tangent2 = (1.0 - c) * (1.0 + c) / (c * c);
    return alpha * alpha * tangent2 / (2.0 * (1.0 + sqrt(1.0 + alpha * alpha * tangent2)));
}

/* In double the textbook's own roundings count too. */
static void check_relative(lobe_real got, double want, double float_ulps)
{
    const double ulps = sizeof got == sizeof want ? float_ulps + 4.0 : float_ulps;
    if (!(fabs((double)got - want) <= ulps * 2.0 * EPSILON * fabs(want)))
        fail_msg("%.17g, want %.17g", (double)got, want);
}

/* Down to cosines of 1.3e-8 and to alpha = 1e-4, with the errors that smith.h and ggx.h state. */
static void smith_matches_its_definition(void **state)
{
    int i;
    (void)state;
    for (i = 0; i < 300000; i++) {
        const lobe_real alpha = real(pow(10.0, -4.0 * random_unit()));
        const lobe_real v =
            real(pow(10.0, -4.9 * random_unit() * (double)(i & 1))) * real(random_unit() * 0.999 + 0.001);
        const lobe_real l =
            real(pow(10.0, -4.9 * random_unit() * (double)(i >> 1 & 1))) * real(random_unit() * 0.999 + 0.001);
        const double a = (double)alpha, c = (double)v, d = (double)l;
        const double lambda_v = lambda_of(a, c), lambda_l = lambda_of(a, d), t = 1.0 + c * c * (a * a - 1.0);
        const double gv = c * (1.0 - a) + a, gl = d * (1.0 - a) + a;
        check_relative(lobe_ggx_lambda(alpha, v), lambda_v, 4.5);
        check_relative(lobe_smith_g1(alpha, v), 1.0 / (1.0 + lambda_v), 2.0);
        check_relative(lobe_smith_v_correlated(alpha, v, l), 0.25 / (c * d * (1.0 + lambda_v + lambda_l)), 3.0);
        check_relative(lobe_smith_v_separable(alpha, v, l), 0.25 / (c * d * (1.0 + lambda_v) * (1.0 + lambda_l)), 4.5);
        check_relative(lobe_smith_v_schlick(alpha, v, l), 0.25 / (gv * gl), 3.0);
        if (sizeof(lobe_real) == sizeof(float)) /* in double the textbook's t itself cancels */
            check_relative(lobe_ggx_d(alpha, v), a * a / (pi * t * t), 4.5);
    }
    assert_true(lobe_smith_g1(real(0.5), 1) == 1 && lobe_smith_g1(real(0.5), 0) == 0);
    assert_true(lobe_ggx_lambda(real(0.5), 1) == 0);
}

static int finite_real(lobe_real x) { return fabs((double)x) <= 1e31; }

static void odd_inputs_stay_finite(void **state)
{
    static const double odd[] = {0.0, -0.0, 1e-40, -1.0, 2.0, 1e30, -1e30, INFINITY, -INFINITY, NAN, 1.0, 0.5};
    enum { N = sizeof odd / sizeof odd[0] };
    int i, j, k;
    (void)state;
    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++)
            for (k = 0; k < N; k++) {
                const lobe_real a = real(odd[i]), v = real(odd[j]), l = real(odd[k]);
                assert_true(finite_real(lobe_ggx_d(a, v)) && finite_real(lobe_ggx_lambda(a, v)));
                assert_true(finite_real(lobe_ggx_visible_density(a, v, l, l)));
                assert_true(lobe_smith_g1(a, v) >= 0 && lobe_smith_g1(a, v) <= 1);
                assert_true(finite_real(lobe_smith_v_correlated(a, v, l)));
                assert_true(finite_real(lobe_smith_v_separable(a, v, l)));
                assert_true(finite_real(lobe_smith_v_schlick(a, v, l)));
                assert_true(lobe_schlick_weight(v) >= 0 && lobe_schlick_weight(v) <= 1);
                assert_true(finite_real(lobe_octahedral_decode(v, l).x) && finite_real(lobe_equirect_decode(v, l).y));
                assert_true(finite_real(lobe_equal_area_decode(v, l).z) &&
                            finite_real(lobe_octahedral_solid_angle(v, l)));
            }
}

static void schlick_keeps_its_ends(void **state)
{
    int i;
    (void)state;
    for (i = 0; i <= 100000; i++) {
        const lobe_real f0 = real(random_unit()), f90 = real(random_unit()), c = real(i / 100000.0);
        const double want = pow(1.0 - (double)c, 5.0);
        assert_true(lobe_schlick(f0, f90, 1) == f0 && lobe_schlick(f0, f90, 0) == f90);
        assert_true(fabs((double)lobe_schlick(f0, f90, c) - ((double)f0 + ((double)f90 - (double)f0) * want)) <=
                    10.0 * EPSILON);
        assert_true(fabs((double)lobe_schlick_weight(c) - want) <= 9.0 * EPSILON * want);
    }
}

typedef lobe_uv (*encoder)(lobe_vec3 d);
typedef lobe_vec3 (*decoder)(lobe_real u, lobe_real v);

static void check_map(encoder encode, decoder decode, double bound)
{
    const lobe_vec3 up = lobe_vec3_of(0, 0, 1), down = lobe_vec3_of(0, 0, -1);
    double worst = 0.0;
    int i;
    for (i = 0; i < 500000; i++) {
        const lobe_vec3 d = random_direction(i);
        const lobe_uv uv = encode(d);
        const double error = distance(decode(uv.u, uv.v), d);
        assert_true(uv.u >= 0 && uv.u <= 1 && uv.v >= 0 && uv.v <= 1);
        worst = error > worst ? error : worst;
    }
    if (!(worst <= bound))
        fail_msg("round trip is off by %g, bound %g", worst, bound);
    assert_true(distance(decode(encode(up).u, encode(up).v), up) <= 0.1 * bound);
    assert_true(distance(decode(encode(down).u, encode(down).v), down) <= 0.1 * bound);
}

/* The share of the square, weighted by solid angle, that falls into a cap around an odd axis. */
static void check_area(decoder decode, double (*solid_angle)(double u, double v))
{
    enum { N = 700 };
    const lobe_vec3 axis = lobe_vec3_of(real(0.36), real(-0.48), real(-0.8));
    static const double caps[] = {0.95, 0.6, 0.0, -0.5};
    double inside[4] = {0.0, 0.0, 0.0, 0.0};
    int i, j, k;
    for (i = 0; i < N; i++)
        for (j = 0; j < N; j++) {
            const double u = (i + 0.5) / N, v = (j + 0.5) / N;
            const double c = dot(decode(real(u), real(v)), axis);
            for (k = 0; k < 4; k++)
                inside[k] += c > caps[k] ? solid_angle(u, v) / ((double)N * N) : 0.0;
        }
    for (k = 0; k < 4; k++)
        assert_true(fabs(inside[k] - 2.0 * pi * (1.0 - caps[k])) < 4e-3);
}

static double octahedral_area(double u, double v) { return (double)lobe_octahedral_solid_angle(real(u), real(v)); }

static double equirect_area(double u, double v)
{
    (void)u;
    return 2.0 * pi * pi * sin(pi * v);
}

static double equal_area(double u, double v)
{
    (void)u, (void)v;
    return 4.0 * pi;
}

static void octahedral_map(void **state)
{
    (void)state;
    check_map(lobe_octahedral_encode, lobe_octahedral_decode, MAP_BOUND(LOBE_OCTAHEDRAL_ROUND_TRIP));
    check_area(lobe_octahedral_decode, octahedral_area);
    assert_true(distance(lobe_octahedral_decode(real(0.5), real(0.5)), lobe_vec3_of(0, 0, 1)) == 0.0);
    assert_true(distance(lobe_octahedral_decode(1, 0), lobe_vec3_of(0, 0, -1)) == 0.0);
    assert_true(distance(lobe_octahedral_decode(1, real(0.5)), lobe_vec3_of(1, 0, 0)) == 0.0);
}

static void equirect_map(void **state)
{
    (void)state;
    check_map(lobe_equirect_encode, lobe_equirect_decode, MAP_BOUND(LOBE_EQUIRECT_ROUND_TRIP));
    check_area(lobe_equirect_decode, equirect_area);
    assert_true(lobe_equirect_encode(lobe_vec3_of(0, 0, 1)).v == 0 &&
                lobe_equirect_encode(lobe_vec3_of(0, 0, -1)).v == 1);
    assert_true(lobe_equirect_encode(lobe_vec3_of(1, 0, 0)).u == real(0.5));
    assert_true(fabs((double)lobe_equirect_encode(lobe_vec3_of(0, 1, 0)).u - 0.75) <= 2.0 * EPSILON);
}

static void equal_area_map(void **state)
{
    (void)state;
    check_map(lobe_equal_area_encode, lobe_equal_area_decode, MAP_BOUND(LOBE_EQUAL_AREA_ROUND_TRIP));
    check_area(lobe_equal_area_decode, equal_area);
    assert_true(distance(lobe_equal_area_decode(real(0.5), real(0.5)), lobe_vec3_of(0, 0, 1)) == 0.0);
    assert_true(distance(lobe_equal_area_decode(0, 1), lobe_vec3_of(0, 0, -1)) == 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_are_orthonormal),
        cmocka_unit_test(vectors_obey_their_algebra),
        cmocka_unit_test(ggx_is_normalised),
        cmocka_unit_test(masking_conserves_projected_area),
        cmocka_unit_test(smith_matches_its_definition),
        cmocka_unit_test(odd_inputs_stay_finite),
        cmocka_unit_test(schlick_keeps_its_ends),
        cmocka_unit_test(octahedral_map),
        cmocka_unit_test(equirect_map),
        cmocka_unit_test(equal_area_map),
    };
    return cmocka_run_group_tests_name("geometry", tests, NULL, NULL);
}
