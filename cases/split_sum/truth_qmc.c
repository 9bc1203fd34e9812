#include "truth_qmc.h"
#include <math.h>
#include "../fit/random.h"

#define PI 3.14159265358979323846

lobe_qmc_options lobe_qmc_options_default(void)
{
    const lobe_qmc_options options = {LOBE_QMC_HAMMERSLEY, 65536, 16, 1};
    return options;
}

static double radical_inverse(size_t i, size_t base)
{
    double digit = 1.0 / (double)base, x = 0;
    for (; i; i /= base, digit /= (double)base)
        x += digit * (double)(i % base);
    return x;
}

static double smith_g1(double a, double c) { return 2 * c / (c + sqrt(a * a + (1 - a * a) * c * c)); }

/* G2 */
static double masking(int smith, double a, double l, double v)
{
    const double gl = smith_g1(a, l), gv = smith_g1(a, v), k = 0.5 * a;
    if (smith == 0)
        return 1 / (1 / gl + 1 / gv - 1);
    if (smith == 1)
        return gl * gv;
    return l / (l * (1 - k) + k) * (v / (v * (1 - k) + k));
}

/* A normal that is visible from (sin_v, 0, v), and what a light mirrored at it adds: Heitz 2018, "Sampling the GGX
 * Distribution of Visible Normals". Its density makes the weight G2 / G1(v). */
static void add_sample(int smith, double a, double v, double u1, double u2, double *sum)
{
    const double sin_v = sqrt((1 - v) * (1 + v));
    /* stretch the view, take a point of the projected hemisphere, unstretch the normal */
    const double length = sqrt(a * a * sin_v * sin_v + v * v);
    const double vx = a * sin_v / length, vz = v / length;
    const double radius = sqrt(u1), phi = 2 * PI * u2, t1 = radius * cos(phi), s = 0.5 * (1 + vz);
    const double t2 = (1 - s) * sqrt(1 - t1 * t1) + s * radius * sin(phi);
    const double t3 = sqrt(fmax(0, 1 - t1 * t1 - t2 * t2));
    const double nx = -t2 * vz + t3 * vx, ny = t1, nz = t2 * vx + t3 * vz;
    const double norm = sqrt(a * a * (nx * nx + ny * ny) + nz * nz);
    const double hx = a * nx / norm, hz = fmax(0, nz) / norm;
    const double v_dot_h = fmin(1, fmax(0, sin_v * hx + v * hz));
    const double l = fmin(1, 2 * v_dot_h * hz - v);
    if (l > 0) {
        const double weight = masking(smith, a, l, v) / smith_g1(a, v), f = pow(1 - v_dot_h, 5);
        sum[0] += weight * (1 - f);
        sum[1] += weight * f;
    }
}

void lobe_truth_qmc(int smith, double alpha, double n_dot_v, const lobe_qmc_options *options, double *out,
                    double *error)
{
    const double n = (double)options->samples, m = options->shifts;
    double mean[2] = {0, 0}, spread[2] = {0, 0};
    lobe_random random;
    int shift, k;
    size_t i;
    lobe_random_seed(&random, options->seed, (uint64_t)options->sequence);
    for (shift = 0; shift < options->shifts; shift++) {
        const double d1 = lobe_random_unit(&random), d2 = lobe_random_unit(&random);
        double sum[2] = {0, 0};
        for (i = 0; i < options->samples; i++) {
            const double x = options->sequence == LOBE_QMC_HALTON ? radical_inverse(i + 1, 3) : ((double)i + 0.5) / n;
            const double u1 = x + d1, u2 = radical_inverse(i + 1, 2) + d2;
            add_sample(smith, alpha, n_dot_v, u1 - floor(u1), u2 - floor(u2), sum);
        }
        for (k = 0; k < 2; k++) {
            /* Welford's update: the spread is far below the mean */
            const double off = sum[k] / n - mean[k];
            mean[k] += off / (shift + 1);
            spread[k] += off * (sum[k] / n - mean[k]);
        }
    }
    for (k = 0; k < 2; k++) {
        out[k] = mean[k];
        error[k] = sqrt(spread[k] / (m * (m - 1)));
    }
}
