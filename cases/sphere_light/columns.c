#include "columns.h"
#include <math.h>
#include "truth_sphere.h"

static const double pi = 3.14159265358979323846, unit = 16777216;

typedef struct span {
    double sum, apart; /* the ends of tangent2 */
    double product;    /* of the two sines: their difference */
} span;

static span span_of(double v, double l)
{
    const double sv = sqrt(1 - v * v), sl = sqrt(1 - l * l);
    const span s = {.25 * (sv + sl) * (sv + sl), .25 * (sv - sl) * (sv - sl), sv * sl};
    return s;
}

/* tangent2 = apart + product cos^2(azimuth / 2); both differences are exact to rounding, and so is the angle. */
double lobe_sphere_azimuth(const double row[5])
{
    const span s = span_of(row[1], row[2]);
    return 2 * atan2(sqrt(fmax(s.sum - row[3], 0)), sqrt(fmax(row[3] - s.apart, 0)));
}

void lobe_truth_sphere_columns(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += 5) {
        const double row[5] = {in[0], in[1], in[2], lobe_sphere_azimuth(in), asin(in[4])};
        lobe_truth_sphere_rows(row, out + i, 1);
    }
}

void lobe_truth_sphere_columns_fast(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += 5) {
        const lobe_sphere_scene s = {in[0] * in[0], in[1], in[2], lobe_sphere_azimuth(in), asin(in[4]), 1};
        out[i] = lobe_truth_sphere_stretched(&s, 1e-6);
    }
}

static double nearest(double x, double lo, double hi)
{
    return fmin(fmax(floor(x * unit + .5), ceil(lo * unit)), floor(hi * unit)) / unit;
}

/* On the normal tangent2 is (1 - x^2) / 4, x the other height, and no number between: a multiple of 2^-24 where x is
 * one of 2^-11. */
static double coarse(double x) { return floor(x * 2048 + .5) / 2048; }

bool lobe_sphere_place(double row[5], double roughness, double v, double l, double azimuth, double sine)
{
    const double half = cos(.5 * azimuth);
    span s;
    row[0] = nearest(roughness, 0, 1);
    row[1] = nearest(v, 0, 1);
    row[2] = nearest(l, -1, 1);
    row[4] = nearest(sine, 0, 1);
    if (row[1] == 1)
        row[2] = coarse(row[2]);
    else if (fabs(row[2]) == 1)
        row[1] = coarse(row[1]);
    s = span_of(row[1], row[2]);
    row[3] = nearest(s.apart + s.product * half * half, s.apart, s.sum);
    return row[3] >= s.apart && row[3] <= s.sum;
}

bool lobe_sphere_inside(const double row[5])
{
    return row[0] >= LOBE_SPHERE_ROUGHNESS_LO && row[1] >= LOBE_SPHERE_N_DOT_V_LO && row[4] <= LOBE_SPHERE_SINE_HI;
}

bool lobe_sphere_taken(const double row[5])
{
    return row[0] >= LOBE_SPHERE_ROUGHNESS_LEAST && row[1] >= LOBE_SPHERE_N_DOT_V_LEAST &&
           row[4] >= LOBE_SPHERE_SINE_LEAST;
}

static double mix(double lo, double hi, double u) { return lo + (hi - lo) * u; }

/* u again in [0, 1), after it chose one of n ways. */
static double rest(double u, int n, int *way)
{
    *way = (int)(n * u);
    return n * u - *way;
}

bool lobe_sphere_draw(double row[5], const double u[5], bool beyond, bool near)
{
    int out = 0, small;
    const double w = beyond ? rest(u[0], 3, &out) : u[0], sine_u = rest(u[4], 2, &small);
    double roughness = mix(LOBE_SPHERE_ROUGHNESS_LO, 1, w), v = mix(LOBE_SPHERE_N_DOT_V_LO, 1, u[1] * u[1]);
    double sine = small ? LOBE_SPHERE_SINE_LEAST * pow(LOBE_SPHERE_SINE_HI / LOBE_SPHERE_SINE_LEAST, sine_u)
                        : mix(LOBE_SPHERE_SINE_LEAST, LOBE_SPHERE_SINE_HI, sine_u);
    double z, azimuth;
    if (beyond) {
        roughness = mix(LOBE_SPHERE_ROUGHNESS_LEAST, out == 0 ? LOBE_SPHERE_ROUGHNESS_LO : 1, w);
        v = mix(LOBE_SPHERE_N_DOT_V_LEAST, out == 1 ? LOBE_SPHERE_N_DOT_V_LO : 1, out == 1 ? u[1] : u[1] * u[1]);
        sine = out == 2 ? mix(LOBE_SPHERE_SINE_HI, 1, u[4]) : sine;
    }
    if (near) { /* turned from the mirror direction by t, around it by turn */
        const double s = sqrt(1 - v * v), t = fmin(pi / 2, asin(sine) + 3 * roughness * roughness) * u[2];
        const double turn = 2 * pi * u[3];
        z = v * cos(t) + s * sin(t) * cos(turn);
        azimuth = fabs(atan2(sin(t) * sin(turn), -s * cos(t) + v * sin(t) * cos(turn)));
    } else {
        z = mix(-sine, 1, u[2]);
        azimuth = pi * u[3];
    }
    return lobe_sphere_place(row, roughness, v, z, azimuth, sine) && lobe_sphere_inside(row) == !beyond &&
           lobe_sphere_taken(row);
}
