#include "light_points.h"
#include <math.h>
#include "../fit/random.h"
#include "columns.h"

enum { BEYOND = 256, SEED = 3, TRIES = 64 };

static const double pi = 3.14159265358979323846;

typedef struct list {
    double *points;
    size_t room, count;
} list;

static void add(list *l, const double row[5])
{
    int k;
    for (k = 0; k < 5 && l->count < l->room; k++)
        l->points[5 * l->count + (size_t)k] = row[k];
    if (l->count < l->room)
        l->count++;
}

/* The light in every telling place for one roughness, view and size. */
static void add_places(const lobe_light_points *of, list *l, double roughness, double v, double size, bool beyond)
{
    const double width = of->width(size);
    const double places[][2] = {
        {v, pi},                     /* where the mirror looks */
        {v, 0},                      /* behind the eye */
        {1, 0},                      /* overhead */
        {0, pi},                     /* half set, and the mirror's side */
        {-of->setting * width, 2.5}, /* all but set */
        {-of->set * width, 2.5},     /* set; there is no such direction for the largest sphere lights */
    };
    double row[5];
    size_t i;
    for (i = 0; i < sizeof places / sizeof places[0]; i++)
        if (lobe_sphere_place(row, roughness, v, fmax(places[i][0], -1), places[i][1], size) &&
            of->inside(row) == !beyond && of->taken(row))
            add(l, row);
}

/* The first multiple of 2^-24 at x or above. */
static double up(double x) { return ceil(x * 16777216) / 16777216; }

size_t lobe_light_vector_points(const lobe_light_points *of, int beyond, uint64_t seed, double *points, size_t room)
{
    const double roughnesses[] = {up(of->roughness_lo), .35, .6, 1}, views[] = {up(of->n_dot_v_lo), .3, .8, 1};
    const size_t most = beyond ? BEYOND : of->vectors;
    list l = {points, room < most ? room : most, 0};
    lobe_random random;
    int i, j, k;
    for (i = 0; !beyond && i < 4; i++)
        for (j = 0; j < 4; j++)
            for (k = 0; k < 4; k++)
                add_places(of, &l, roughnesses[i], views[j], of->sizes[k], false);
    for (i = 0; beyond && i < 6; i++)
        add_places(of, &l, up(of->far[i][0]), up(of->far[i][1]), of->far[i][2], true);
    lobe_random_seed(&random, seed, (uint64_t)beyond);
    for (i = 0; l.count < l.room; i++) {
        double u[5], row[5];
        for (k = 0; k < 5; k++)
            u[k] = lobe_random_unit(&random);
        if (of->draw(row, u, beyond, i & 1))
            add(&l, row);
    }
    return l.count;
}

void lobe_light_judged(const lobe_light_points *of, bool beyond, double *rows, size_t count)
{
    static const double lower[5] = {0, 0, 0, 0, 0}, upper[5] = {1, 1, 1, 1, 1};
    lobe_random random;
    size_t i;
    int k, turn;
    lobe_random_seed(&random, SEED, beyond);
    lobe_random_latin(&random, lower, upper, 5, count, rows);
    for (i = 0; i < count; i++) {
        double u[5];
        for (k = 0; k < 5; k++)
            u[k] = rows[5 * i + (size_t)k];
        for (turn = 0; !of->draw(rows + 5 * i, u, beyond, i & 1) && turn < TRIES; turn++)
            for (k = 0; k < 5; k++)
                u[k] = lobe_random_unit(&random);
    }
}
