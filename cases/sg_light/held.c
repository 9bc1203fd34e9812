#define LOBE_DOUBLE 1
#include "held.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "row.h"

bool lobe_sg_held_make(lobe_sg_held *held, const lobe_sweep_options *options)
{
    int set, i;
    memset(held, 0, sizeof *held);
    held->ready = true;
    for (set = 0; set < 2; set++) {
        held->columns[set] = malloc(5 * LOBE_SG_COUNT * sizeof *held->columns[set]);
        if (!held->columns[set] || !lobe_sg_cells_make(&held->cells[set], true, set == 1, options)) {
            fputs("lobefit: not enough memory for the cells\n", stderr);
            return false;
        }
        for (i = 0; i < LOBE_SG_COUNT; i++) {
            const double *row = held->cells[set].in + 5 * i;
            const lobe_sg light = lobe_sg_of_row(row);
            double *to = held->columns[set] + 5 * i;
            to[0] = row[0];
            to[1] = light.n_dot_v;
            to[2] = light.n_dot_l;
            to[3] = light.tangent2;
            to[4] = light.versine;
        }
    }
    return true;
}

void lobe_sg_held_free(lobe_sg_held *held)
{
    int set;
    for (set = 0; held->ready && set < 2; set++) {
        lobe_sg_cells_free(&held->cells[set]);
        free(held->columns[set]);
    }
    held->ready = false;
}

void lobe_sg_held_judge(const lobe_sg_held *held, double (*call)(const double row[5]), lobe_sg_figures figures[2])
{
    static const lobe_sg_figures unknown = {NAN, NAN, NAN, NAN};
    double *values = malloc(LOBE_SG_COUNT * sizeof *values);
    int set, i;
    for (set = 0; set < 2; set++) {
        lobe_sg_score score;
        figures[set] = unknown;
        if (!values)
            continue;
        for (i = 0; i < LOBE_SG_COUNT; i++)
            values[i] = call(held->columns[set] + 5 * i);
        lobe_sg_judge_values(values, &held->cells[set], &score);
        figures[set].all = score.all;
        figures[set].smooth = score.smooth;
        figures[set].worst = score.worst;
        figures[set].energy = score.energy;
    }
    free(values);
}

lobe_sg_figures lobe_sg_figures_worse(const lobe_sg_figures *a, const lobe_sg_figures *b)
{
    lobe_sg_figures worse;
    worse.all = fmax(a->all, b->all);
    worse.smooth = fmax(a->smooth, b->smooth);
    worse.worst = fmax(a->worst, b->worst);
    worse.energy = fabs(a->energy) > fabs(b->energy) ? a->energy : b->energy;
    return worse;
}
