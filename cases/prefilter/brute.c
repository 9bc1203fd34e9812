#include "brute.h"
#include "cells.h"
#include <math.h>

typedef struct lobe {
    lobe_prefilter_kernel kernel;
    double parameter, peak, detail;
    const double *d;
} lobe;

static double cosine(const double a[3], const double b[3])
{
    const double length = sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
    double chord = 0;
    for (int k = 0; k < 3; k++)
        chord += (a[k] - b[k] / length) * (a[k] - b[k] / length);
    return 1 - chord / 2;
}

/* Integral of the kernel over one texel. */
static double over_texel(const lobe_prefilter_image *image, const lobe *l, int chart, int row, int column)
{
    double moment[3], sum = 0;
    const double angle = lobe_prefilter_image_moment(image, chart, row, column, row + 1, column + 1, moment);
    const double c = cosine(l->d, moment), far = sqrt(fmax(0, 2 - 2 * c)), size = sqrt(angle) * 1.5;
    const double near = fmax(0, far - size),
                 scale = fmin(1, l->kernel == LOBE_PREFILTER_GGX ? sqrt(l->peak * l->peak + near * near) : l->peak);
    if (l->kernel == LOBE_PREFILTER_SG && l->parameter * near * near / 2 > 40)
        return 0;
    const int parts = (int)fmax(1, ceil(size / (l->detail * scale)));
    if (parts == 1)
        return angle * lobe_prefilter_density(l->kernel, l->parameter, c);
    for (int i = 0; i < parts; i++)
        for (int j = 0; j < parts; j++) {
            const double part =
                lobe_prefilter_image_moment(image, chart, row + (double)i / parts, column + (double)j / parts,
                                            row + (i + 1.0) / parts, column + (j + 1.0) / parts, moment);
            sum += part * lobe_prefilter_density(l->kernel, l->parameter, cosine(l->d, moment));
        }
    return sum;
}

void lobe_prefilter_brute(const lobe_prefilter_image *image, lobe_prefilter_kernel kernel, double width, double detail,
                          const double d[3], double rgb[3])
{
    const double parameter = lobe_prefilter_parameter(kernel, width);
    const lobe l = {kernel, parameter, lobe_prefilter_peak(kernel, parameter), detail, d};
    int charts, rows, columns;
    lobe_prefilter_image_size(image, &charts, &rows, &columns);
    for (int k = 0; k < 3; k++)
        rgb[k] = 0;
    for (int chart = 0; chart < charts; chart++)
        for (int i = 0; i < rows; i++)
            for (int j = 0; j < columns; j++) {
                const double weight = over_texel(image, &l, chart, i, j);
                const float *texel = lobe_prefilter_image_texel(image, chart, i, j);
                for (int k = 0; k < 3; k++)
                    rgb[k] += weight * (double)texel[k];
            }
}
