#define LOBE_DOUBLE 1
#include "even.h"
#include <math.h>
#include <stdlib.h>
#include "../fit/truth_cache.h"
#include "row.h"
#include "truth_sphere.h"

enum { COUNT = LOBE_SPHERE_CELLS * LOBE_SPHERE_EVEN };

static double halton(int i, int base)
{
    double part = 1, sum = 0;
    for (; i > 0; i /= base) {
        part /= base;
        sum += part * (i % base);
    }
    return sum;
}

static void truth_rows(const double *in, double *out, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++, in += 5) {
        const lobe_sphere_scene s = {in[0] * in[0], in[1], in[2], in[3], in[4], 1};
        out[i] = lobe_truth_sphere_stretched(&s, 1e-4);
    }
}

static const lobe_case kept = {.name = "sphere_light_even", .input_count = 5, .output_count = 1, .truth = truth_rows};

bool lobe_sphere_even_make(lobe_sphere_even *even, const lobe_sphere_cells *cells, const lobe_sweep_options *options)
{
    double *rows = malloc(5 * COUNT * sizeof *rows);
    int i;
    even->columns = malloc(5 * COUNT * sizeof *even->columns);
    even->truth = malloc(COUNT * sizeof *even->truth);
    if (!rows || !even->columns || !even->truth) {
        free(rows);
        return false;
    }
    for (i = 0; i < COUNT; i++) {
        const double *cell = cells->in + 5 * (i / LOBE_SPHERE_EVEN * LOBE_SPHERE_POSITIONS);
        double *row = rows + 5 * i, *to = even->columns + 5 * i;
        lobe_sphere light;
        row[0] = cell[0];
        row[1] = cell[1];
        row[2] = (1 + sin(cell[4])) * halton(1 + i % LOBE_SPHERE_EVEN, 2) - sin(cell[4]);
        row[3] = 3.14159265358979323846 * halton(1 + i % LOBE_SPHERE_EVEN, 3);
        row[4] = cell[4];
        light = lobe_sphere_of_row(row);
        to[0] = row[0];
        to[1] = light.n_dot_v;
        to[2] = light.n_dot_l;
        to[3] = light.tangent2;
        to[4] = light.sine;
    }
    lobe_truth_cached(&kept, rows, even->truth, COUNT, options);
    free(rows);
    return true;
}

void lobe_sphere_even_free(lobe_sphere_even *even)
{
    free(even->columns);
    free(even->truth);
    even->columns = even->truth = NULL;
}

double lobe_sphere_even_energy(const lobe_sphere_even *even, double (*call)(const double row[5]))
{
    double worst = 0;
    int cell, i;
    for (cell = 0; cell < LOBE_SPHERE_CELLS; cell++) {
        double sum = 0, truth = 0, energy;
        for (i = cell * LOBE_SPHERE_EVEN; i < (cell + 1) * LOBE_SPHERE_EVEN; i++) {
            sum += call(even->columns + 5 * i);
            truth += even->truth[i];
        }
        energy = sum / truth - 1;
        if (!(fabs(energy) <= fabs(worst)))
            worst = energy;
    }
    return worst;
}
