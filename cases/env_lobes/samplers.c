#include "samplers.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

static void place(double z, double turn, double d[3])
{
    const double sine = sqrt(fmax(0, (1 - z) * (1 + z)));
    d[0] = sine * cos(2 * pi * turn);
    d[1] = sine * sin(2 * pi * turn);
    d[2] = z;
}

void lobe_sample_sg(double sharpness, double a, double b, double d[3])
{
    place(fmax(-1, 1 + log1p(a * expm1(-2 * sharpness)) / sharpness), b, d);
}

double lobe_sample_sg_density(double sharpness, double z)
{
    return sharpness * exp(sharpness * (z - 1)) / (-2 * pi * expm1(-2 * sharpness));
}

/* The azimuth's density is that of a stretched circle; along a radius sin^2 is exponential, cut at 1. */
void lobe_sample_asg(double x_sharpness, double y_sharpness, double a, double b, double d[3])
{
    const double x = cos(2 * pi * b) / sqrt(x_sharpness), y = sin(2 * pi * b) / sqrt(y_sharpness);
    const double n = sqrt(x * x + y * y), c = 1 / (n * n), square = -log1p(a * expm1(-c)) / c;
    d[0] = sqrt(square) * x / n;
    d[1] = sqrt(square) * y / n;
    d[2] = sqrt(fmax(0, 1 - square));
}

double lobe_sample_asg_density(double x_sharpness, double y_sharpness, const double d[3])
{
    const double square = d[0] * d[0] + d[1] * d[1], power = x_sharpness * d[0] * d[0] + y_sharpness * d[1] * d[1];
    const double c = square > 0 ? power / square : x_sharpness;
    return d[2] > 0 ? sqrt(x_sharpness * y_sharpness) / pi * exp(-power) / -expm1(-c) * d[2] : 0;
}

void lobe_sample_tap(double t, double a, double b, double d[3])
{
    const double k = 0.5 / (t * t);
    place(1 - a / (1 + k * (1 - a)), b, d);
}

double lobe_sample_tap_density(double t, double z)
{
    const double k = 0.5 / (t * t), w = 1 + k * (1 - z);
    return z > 0 ? (1 + k) / (2 * pi * w * w) : 0;
}
