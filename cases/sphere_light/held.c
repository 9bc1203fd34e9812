#define LOBE_DOUBLE 1
#include "held.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "judge.h"
#include "row.h"

bool lobe_sphere_held_make(lobe_sphere_held *held, const lobe_sweep_options *options)
{
    int set, i;
    memset(held, 0, sizeof *held);
    held->ready = true;
    for (set = 0; set < 2; set++) {
        held->columns[set] = malloc(5 * LOBE_SPHERE_COUNT * sizeof *held->columns[set]);
        if (!held->columns[set] || !lobe_sphere_cells_make(&held->cells[set], true, set == 1, options)) {
            fputs("lobefit: not enough memory for the cells\n", stderr);
            return false;
        }
        for (i = 0; i < LOBE_SPHERE_COUNT; i++) {
            const double *row = held->cells[set].in + 5 * i;
            const lobe_sphere light = lobe_sphere_of_row(row);
            double *to = held->columns[set] + 5 * i;
            to[0] = row[0];
            to[1] = light.n_dot_v;
            to[2] = light.n_dot_l;
            to[3] = light.tangent2;
            to[4] = light.sine;
        }
    }
    if (!lobe_sphere_even_make(&held->even, &held->cells[0], options)) {
        fputs("lobefit: not enough memory for even positions\n", stderr);
        return false;
    }
    return true;
}

void lobe_sphere_held_free(lobe_sphere_held *held)
{
    int set;
    for (set = 0; held->ready && set < 2; set++) {
        lobe_sphere_cells_free(&held->cells[set]);
        free(held->columns[set]);
    }
    if (held->ready)
        lobe_sphere_even_free(&held->even);
    held->ready = false;
}

static double punctual(const double row[5]) { return lobe_sphere_light_punctual(row[0], lobe_sphere_of_columns(row)); }

static void judge(const lobe_sphere_held *held, int set, double (*call)(const double row[5]), double *values,
                  lobe_sphere_score *score)
{
    int i;
    for (i = 0; i < LOBE_SPHERE_COUNT; i++)
        values[i] = call(held->columns[set] + 5 * i);
    lobe_sphere_judge_values(values, &held->cells[set], score);
}

void lobe_sphere_held_judge(const lobe_sphere_held *held, double (*call)(const double row[5]),
                            lobe_sphere_figures figures[2])
{
    static const lobe_sphere_figures unknown = {NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    double *values = malloc(LOBE_SPHERE_COUNT * sizeof *values);
    lobe_sphere_score *score = malloc(2 * sizeof *score);
    int set;
    for (set = 0; set < 2; set++) {
        lobe_sphere_figures *f = &figures[set];
        *f = unknown;
        if (!values || !score)
            continue;
        judge(held, set, punctual, values, &score[0]);
        judge(held, set, call, values, &score[1]);
        f->all = score[1].all;
        f->view60 = score[1].view60;
        f->view75 = score[1].view75;
        f->worst = score[1].worst;
        f->energy = score[1].energy;
        f->integral = set ? figures[0].integral : lobe_sphere_even_energy(&held->even, call);
        f->excess = lobe_sphere_excess(&score[1], &score[0], &held->cells[set]);
    }
    free(values);
    free(score);
}

lobe_sphere_figures lobe_sphere_figures_worse(const lobe_sphere_figures *a, const lobe_sphere_figures *b)
{
    lobe_sphere_figures worse;
    worse.all = fmax(a->all, b->all);
    worse.view60 = fmax(a->view60, b->view60);
    worse.view75 = fmax(a->view75, b->view75);
    worse.worst = fmax(a->worst, b->worst);
    worse.energy = fabs(a->energy) > fabs(b->energy) ? a->energy : b->energy;
    worse.integral = a->integral;
    worse.excess = fmax(a->excess, b->excess);
    return worse;
}
