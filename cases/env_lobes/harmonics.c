#include "harmonics.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = LOBE_ENV_BANDS, TOGETHER = LOBE_HARMONICS_TOGETHER };

/* next = a (cosine now - b before), from l to l + 1 at fixed m: normalised associated Legendre functions. */
static void fill_recurrence(double *recurrence)
{
    for (int m = 0; m < SIDE; m++)
        for (int l = m; l < SIDE; l++) {
            const double n = l, k = m;
            double *out = recurrence + 2 * (m * SIDE + l);
            out[0] = sqrt((4 * (n + 1) * (n + 1) - 1) / ((n + 1) * (n + 1) - k * k));
            out[1] = l > m ? sqrt((n * n - k * k) / (4 * n * n - 1)) : 0;
        }
}

/* Fourier sums of one row: out[2 m + part]. */
static void row_waves(const lobe_environment *map, int row, int channel, double *out)
{
    memset(out, 0, sizeof *out * 2 * SIDE);
    for (int j = 0; j < map->width; j++) {
        const float *rgb = map->rgb + 3 * ((size_t)row * (size_t)map->width + (size_t)j);
        const double value =
            channel < 0 ? ((double)rgb[0] + (double)rgb[1] + (double)rgb[2]) / 3 : (double)rgb[channel];
        const double phi = LOBE_PI * (1 - 2 * (j + 0.5) / map->width), c1 = cos(phi), s1 = sin(phi);
        double c = 1, s = 0;
        if (value == 0)
            continue;
        for (int m = 0; m < SIDE && 2 * m <= map->width; m++) {
            const double next = c * c1 - s * s1;
            out[2 * m] += c * value;
            out[2 * m + 1] += s * value;
            s = s * c1 + c * s1;
            c = next;
        }
    }
}

static void add_row(const lobe_harmonics *h, const double *waves, double cosine, double area)
{
    const double sine = sqrt(1 - cosine * cosine);
    double start = sqrt(1 / (4 * LOBE_PI));
    for (int m = 0; m < SIDE; m++) {
        const double scale = (m ? sqrt(2) : 1) * area;
        double before = 0, now = start;
        for (int l = m; l < SIDE; l++) {
            double *out = h->coefficient + 2 * (m * SIDE + l);
            const double *r = h->recurrence + 2 * (m * SIDE + l), next = r[0] * (cosine * now - r[1] * before);
            out[0] += scale * now * waves[2 * m];
            out[1] += scale * now * waves[2 * m + 1];
            before = now;
            now = next;
        }
        start *= sine * sqrt((2.0 * m + 3) / (2.0 * m + 2));
    }
}

int lobe_harmonics_of(const lobe_environment *map, int channel, lobe_harmonics *harmonics)
{
    const size_t count = (size_t)SIDE * SIDE * 2;
    double waves[2 * SIDE];
    harmonics->coefficient = calloc(2 * count, sizeof *harmonics->coefficient);
    if (!harmonics->coefficient)
        return 0;
    harmonics->recurrence = harmonics->coefficient + count;
    fill_recurrence(harmonics->recurrence);
    for (int i = 0; i < map->height; i++) {
        row_waves(map, i, channel, waves);
        add_row(harmonics, waves, cos(LOBE_PI * (i + 0.5) / map->height), lobe_environment_solid_angle(map, i));
    }
    return 1;
}

void lobe_harmonics_free(lobe_harmonics *harmonics)
{
    free(harmonics->coefficient);
    harmonics->coefficient = NULL;
}

void lobe_harmonics_scale(lobe_harmonics *harmonics, const double *factor)
{
    for (int m = 0; m < SIDE; m++)
        for (int l = m; l < SIDE; l++) {
            harmonics->coefficient[2 * (m * SIDE + l)] *= factor[l];
            harmonics->coefficient[2 * (m * SIDE + l) + 1] *= factor[l];
        }
}

void lobe_harmonics_bands_at(const lobe_harmonics *harmonics, double d[TOGETHER][3], double out[SIDE][TOGETHER])
{
    double sine[TOGETHER], cosine[TOGETHER], c1[TOGETHER], s1[TOGETHER], c[TOGETHER], s[TOGETHER], start[TOGETHER];
    memset(out, 0, sizeof(double) * SIDE * TOGETHER);
    for (int i = 0; i < TOGETHER; i++) {
        sine[i] = sqrt(d[i][0] * d[i][0] + d[i][1] * d[i][1]);
        cosine[i] = d[i][2];
        c1[i] = sine[i] > 0 ? d[i][0] / sine[i] : 1;
        s1[i] = sine[i] > 0 ? d[i][1] / sine[i] : 0;
        c[i] = 1;
        s[i] = 0;
        start[i] = sqrt(1 / (4 * LOBE_PI));
    }
    for (int m = 0; m < SIDE; m++) {
        const double turn = m ? sqrt(2) : 1, *in = harmonics->coefficient + 2 * m * SIDE;
        double before[TOGETHER] = {0}, now[TOGETHER], x[TOGETHER], y[TOGETHER];
        for (int i = 0; i < TOGETHER; i++) {
            now[i] = start[i];
            x[i] = turn * c[i];
            y[i] = turn * s[i];
        }
        for (int l = m; l < SIDE; l++) {
            const double p = in[2 * l], q = in[2 * l + 1], *r = harmonics->recurrence + 2 * (m * SIDE + l);
            const double a = r[0], b = r[1];
            for (int i = 0; i < TOGETHER; i++) {
                const double next = a * (cosine[i] * now[i] - b * before[i]);
                out[l][i] += now[i] * (x[i] * p + y[i] * q);
                before[i] = now[i];
                now[i] = next;
            }
        }
        for (int i = 0; i < TOGETHER; i++) {
            const double next = c[i] * c1[i] - s[i] * s1[i];
            start[i] *= sine[i] * sqrt((2.0 * m + 3) / (2.0 * m + 2));
            s[i] = s[i] * c1[i] + c[i] * s1[i];
            c[i] = next;
        }
    }
}

void lobe_harmonics_synthesise(const lobe_harmonics *harmonics, int bands, int height, float *out)
{
    const int width = 2 * height;
    for (int i = 0; i < height; i++) {
        const double theta = LOBE_PI * (i + 0.5) / height, sine = sin(theta), cosine = cos(theta);
        double wave[2 * SIDE], start = sqrt(1 / (4 * LOBE_PI));
        for (int m = 0; m < bands; m++) {
            const double *in = harmonics->coefficient + 2 * m * SIDE, *r = harmonics->recurrence + 2 * m * SIDE;
            double before = 0, now = start, x = 0, y = 0;
            for (int l = m; l < bands; l++) {
                const double next = r[2 * l] * (cosine * now - r[2 * l + 1] * before);
                x += now * in[2 * l];
                y += now * in[2 * l + 1];
                before = now;
                now = next;
            }
            wave[2 * m] = (m ? sqrt(2) : 1) * x;
            wave[2 * m + 1] = (m ? sqrt(2) : 1) * y;
            start *= sine * sqrt((2.0 * m + 3) / (2.0 * m + 2));
        }
        for (int j = 0; j < width; j++) {
            const double phi = LOBE_PI * (1 - 2 * (j + 0.5) / width), c1 = cos(phi), s1 = sin(phi);
            double c = 1, s = 0, sum = 0;
            for (int m = 0; m < bands; m++) {
                const double next = c * c1 - s * s1;
                sum += c * wave[2 * m] + s * wave[2 * m + 1];
                s = s * c1 + c * s1;
                c = next;
            }
            out[i * width + j] = (float)sum;
        }
    }
}
