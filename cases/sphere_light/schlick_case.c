#include "schlick_case.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../models/coeffs/sphere_light_schlick_bounds.h"
#include "columns.h"
#include "points.h"
#include "truth_sphere.h"

static double schlick_of(const double row[5], double tolerance)
{
    const lobe_sphere_scene white = {row[0] * row[0], row[1], row[2], row[3], row[4], 1};
    lobe_sphere_scene black = white;
    double lit;
    black.f0 = 0;
    lit = lobe_truth_sphere_stretched(&white, tolerance);
    return lit > 0 ? lobe_truth_sphere_stretched(&black, tolerance) / lit : 0;
}

void lobe_truth_sphere_schlick_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++)
        out[i] = schlick_of(in + 5 * i, 1e-8);
}

const char *lobe_truth_sphere_schlick_refusal(const double *in)
{
    return asin(in[2]) <= -in[4] ? "the light is wholly set and reflects nothing to take a mean of" : NULL;
}

static void columns(const double *in, double *out, size_t n, double tolerance)
{
    size_t i;
    for (i = 0; i < n; i++, in += 5) {
        const double row[5] = {in[0], in[1], in[2], lobe_sphere_azimuth(in), asin(in[4])};
        out[i] = schlick_of(row, tolerance);
    }
}
void lobe_truth_sphere_schlick_columns(const double *in, double *out, size_t n) { columns(in, out, n, 1e-8); }
void lobe_truth_sphere_schlick_columns_fast(const double *in, double *out, size_t n) { columns(in, out, n, 1e-6); }

/* The rows of sphere_light whose light gives enough. */
static size_t points(double domain_lo, int beyond, uint64_t seed, double *rows, size_t room)
{
    double *all = malloc(5 * LOBE_SPHERE_VECTORS * sizeof *all), radiance;
    size_t i, n = 0, count = all ? lobe_sphere_points(domain_lo, beyond, seed, all, LOBE_SPHERE_VECTORS) : 0;
    for (i = 0; i < count && n < room; i++) {
        lobe_truth_sphere_columns_fast(all + 5 * i, &radiance, 1);
        if (radiance >= LOBE_SPHERE_SCHLICK_LEAST)
            memcpy(rows + 5 * n++, all + 5 * i, 5 * sizeof *rows);
    }
    free(all);
    return n;
}

#define ROW(tier, format, TIER, FORMAT)                                                                                \
    {                                                                                                                  \
        "sphere_light_schlick", tier, format, 0, LOBE_SPHERE_LIGHT_SCHLICK_##TIER##_##FORMAT##_MAX,                    \
            LOBE_SPHERE_LIGHT_SCHLICK_##TIER##_##FORMAT##_RMS,                                                         \
            LOBE_SPHERE_LIGHT_SCHLICK_##TIER##_##FORMAT##_BELOW_MAX, 0, 0                                              \
    }
static const lobe_tier_bounds bounds[] = {ROW("low", "f32", LOW, F32), ROW("low", "q30", LOW, Q30),
                                          ROW("high", "f32", HIGH, F32), ROW("high", "q30", HIGH, Q30)};

static const lobe_case columns_case = {
    .name = "sphere_light_schlick",
    .integral =
        "s = int D V (1 - v.h)^5 n.l dl / int D V n.l dl over the part above the horizon of a cone of this sine",
    .brdf = "GGX, height-correlated Smith, alpha = roughness^2",
    .accuracy = "1e-6 relative",
    .input_count = 5,
    .output_count = 1,
    .inputs = {{"roughness", LOBE_SPHERE_ROUGHNESS_LEAST, 1},
               {"n_dot_v", LOBE_SPHERE_N_DOT_V_LEAST, 1},
               {"n_dot_l", -1, 1},
               {"tangent2", 0, 1},
               {"sine", LOBE_SPHERE_SINE_LEAST, 1}},
    .outputs = {"schlick"},
    .truth = lobe_truth_sphere_schlick_columns,
    .vectors = &lobe_sphere_schlick_vectors};

#define TEXT_OF(x) #x
#define TEXT(x) TEXT_OF(x)
#define LIGHT                                                                                                          \
    "n_dot_l in [-1, 1], tangent2 = |(v + l)/2 along the surface|^2, radiance at least " TEXT(LOBE_SPHERE_SCHLICK_LEAST)
const lobe_vector_set lobe_sphere_schlick_vectors = {
    .seed = 1,
    .points = points,
    .bounds = bounds,
    .bound_count = (int)(sizeof bounds / sizeof bounds[0]),
    .columns = &columns_case,
    .domain = "roughness in [" TEXT(LOBE_SPHERE_ROUGHNESS_LO) ", 1], n_dot_v in [" TEXT(
        LOBE_SPHERE_N_DOT_V_LO) ", 1], sine in (0, " TEXT(LOBE_SPHERE_SINE_HI) "], " LIGHT,
    .beyond = "roughness in [" TEXT(LOBE_SPHERE_ROUGHNESS_LEAST) ", 1], n_dot_v in [" TEXT(
        LOBE_SPHERE_N_DOT_V_LEAST) ", 1], sine in (0, 1], " LIGHT
                                   ", at least one below " TEXT(LOBE_SPHERE_ROUGHNESS_LO) ", below " TEXT(
                                       LOBE_SPHERE_N_DOT_V_LO) " or above " TEXT(LOBE_SPHERE_SINE_HI),
    .rows = LOBE_SPHERE_VECTORS};
