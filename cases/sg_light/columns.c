#include "columns.h"
#include <math.h>
#include "../sphere_light/columns.h"
#include "truth_sg.h"

static const double pi = 3.14159265358979323846;

static void truth(const double *in, double *out, size_t n, double tolerance)
{
    size_t i;
    for (i = 0; i < n; i++, in += 5) {
        const lobe_sg_scene s = {in[0] * in[0], in[1], in[2], lobe_sphere_azimuth(in), 1 / in[4]};
        out[i] = lobe_truth_sg_axis(&s, tolerance);
    }
}

void lobe_truth_sg_columns(const double *in, double *out, size_t n) { truth(in, out, n, 1e-8); }

void lobe_truth_sg_columns_fast(const double *in, double *out, size_t n) { truth(in, out, n, 1e-5); }

bool lobe_sg_inside(const double row[5])
{
    return row[0] >= LOBE_SG_ROUGHNESS_LO && row[1] >= LOBE_SG_N_DOT_V_LO && row[4] >= LOBE_SG_VERSINE_LO &&
           row[4] <= LOBE_SG_VERSINE_HI;
}

bool lobe_sg_taken(const double row[5])
{
    return row[0] >= LOBE_SG_ROUGHNESS_LEAST && row[1] >= LOBE_SG_N_DOT_V_LEAST && row[4] >= LOBE_SG_VERSINE_LEAST;
}

static double mix(double lo, double hi, double u) { return lo + (hi - lo) * u; }

bool lobe_sg_draw(double row[5], const double u[5], bool beyond, bool near)
{
    const int out = beyond ? (int)(3 * u[0]) : 0;
    const double first = beyond ? 3 * u[0] - out : u[0];
    double roughness = mix(LOBE_SG_ROUGHNESS_LO, 1, first), v = mix(LOBE_SG_N_DOT_V_LO, 1, u[1] * u[1]);
    double versine = LOBE_SG_VERSINE_LO * pow(LOBE_SG_VERSINE_HI / LOBE_SG_VERSINE_LO, u[4]);
    double z, azimuth, width;
    if (beyond) {
        roughness = mix(LOBE_SG_ROUGHNESS_LEAST, out == 0 ? LOBE_SG_ROUGHNESS_LO : 1, first);
        v = mix(LOBE_SG_N_DOT_V_LEAST, out == 1 ? LOBE_SG_N_DOT_V_LO : 1, out == 1 ? u[1] : u[1] * u[1]);
        if (out == 2)
            versine = u[4] < .5 ? mix(LOBE_SG_VERSINE_LEAST, LOBE_SG_VERSINE_LO, 2 * u[4])
                                : mix(LOBE_SG_VERSINE_HI, 1, 2 * u[4] - 1);
    }
    width = sqrt(versine);
    if (near) { /* turned from the mirror direction by t, around it by turn */
        const double s = sqrt(1 - v * v), t = fmin(pi / 2, 2 * width + 3 * roughness * roughness) * u[2];
        const double turn = 2 * pi * u[3];
        z = v * cos(t) + s * sin(t) * cos(turn);
        azimuth = fabs(atan2(sin(t) * sin(turn), -s * cos(t) + v * sin(t) * cos(turn)));
    } else {
        z = mix(-fmin(1, 1.5 * width), 1, u[2]);
        azimuth = pi * u[3];
    }
    return lobe_sphere_place(row, roughness, v, z, azimuth, versine) && lobe_sg_inside(row) == !beyond &&
           lobe_sg_taken(row);
}
