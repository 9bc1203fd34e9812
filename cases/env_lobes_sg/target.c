#include "target.h"
#include <math.h>
#include <stdlib.h>
#include "../env_lobes/gauss.h"
#include "../env_lobes/kernels.h"
#include "../env_lobes/response.h"
#include "../env_lobes/visible_normals.h"

static const double pi = 3.14159265358979323846;

/* Visible normals, reflected: Gauss-Legendre up their cap and even turns around it; half of the turns, by symmetry. */
bool lobe_sg_target_make(lobe_sg_target *t, double alpha, double n_dot_v, int order)
{
    double *height = malloc(sizeof *height * 2 * (size_t)order), *weight = height + order;
    int i, j;
    t->alpha = alpha;
    t->n_dot_v = n_dot_v;
    t->albedo = t->power = 0;
    t->count = 0;
    t->nodes = malloc(sizeof *t->nodes * 2 * (size_t)order * (size_t)order);
    if (!t->nodes || !height) {
        free(height);
        return false;
    }
    lobe_gauss(order, height, weight);
    for (i = 0; i < order; i++)
        for (j = 0; 2 * j < order; j++) {
            double *row = t->nodes + 4 * t->count;
            lobe_visible_light(alpha, n_dot_v, (j + 0.5) / order, height[i], row);
            if (!(row[2] > 0))
                continue;
            row[3] = 2 * weight[i] / order * lobe_response_shadowing(alpha, n_dot_v, row[2]);
            t->albedo += row[3];
            t->power += row[3] * lobe_response(alpha, n_dot_v, row);
            t->count++;
        }
    free(height);
    return true;
}

void lobe_sg_target_free(lobe_sg_target *t)
{
    free(t->nodes);
    t->nodes = NULL;
    t->count = 0;
}

double lobe_sg_at(const lobe_sg *lobe, const double l[3])
{
    return lobe->weight * lobe_sg_kernel(lobe->sharpness, cos(lobe->angle) * l[2] - sin(lobe->angle) * l[0]);
}

/* Both exponentials are one about the sum of the scaled axes: 4 pi sinh(m) / m, with its length m. */
double lobe_sg_product(const lobe_sg *a, const lobe_sg *b)
{
    const double p = a->sharpness, q = b->sharpness, half = sin((a->angle - b->angle) / 2);
    const double sum = p + q, m = sqrt(sum * sum - 4 * p * q * half * half);
    /* m - p - q without cancellation */
    const double below = -4 * p * q * half * half / (m + sum);
    const double factor = p / (2 * pi * -expm1(-2 * p)) * (q / (2 * pi * -expm1(-2 * q)));
    return a->weight * b->weight * factor * 2 * pi * exp(below) * -expm1(-2 * m) / m;
}

double lobe_sg_target_product(const lobe_sg_target *t, const lobe_sg *lobe)
{
    const double s = -sin(lobe->angle), c = cos(lobe->angle);
    double sum = 0;
    size_t i;
    for (i = 0; i < t->count; i++) {
        const double *row = t->nodes + 4 * i;
        sum += row[3] * exp(lobe->sharpness * (s * row[0] + c * row[2] - 1));
    }
    return lobe->weight * lobe_sg_kernel(lobe->sharpness, 1) * sum;
}

static void products(const lobe_sg_target *t, const lobe_sg *lobes, int count, double *cross, double *own)
{
    int i, j;
    *cross = *own = 0;
    for (i = 0; i < count; i++) {
        *cross += lobe_sg_target_product(t, &lobes[i]);
        for (j = 0; j < count; j++)
            *own += lobe_sg_product(&lobes[i], &lobes[j]);
    }
}

double lobe_sg_target_error(const lobe_sg_target *t, const lobe_sg *lobes, int count)
{
    double cross, own;
    products(t, lobes, count, &cross, &own);
    return sqrt(fmax(0, 1 + (own - 2 * cross) / t->power));
}

double lobe_sg_target_amplitude(const lobe_sg_target *t, const lobe_sg *lobes, int count, double *error)
{
    double cross, own;
    products(t, lobes, count, &cross, &own);
    *error = sqrt(fmax(0, 1 - cross * cross / (own * t->power)));
    return cross / own;
}
