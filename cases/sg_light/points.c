#include "points.h"
#include <math.h>
#include "../fit/random.h"
#include "../sphere_light/columns.h"
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

/* The axis in every telling place for one roughness, view and versine. */
static void add_places(list *l, double roughness, double v, double versine, bool beyond)
{
    const double width = sqrt(versine);
    const double places[][2] = {
        {v, pi},             /* where the mirror looks */
        {v, 0},              /* behind the eye */
        {1, 0},              /* overhead */
        {0, pi},             /* half set, and the mirror's side */
        {-width, 2.5},       /* all but set */
        {-2.2 * width, 2.5}, /* set */
    };
    double row[5];
    size_t i;
    for (i = 0; i < sizeof places / sizeof places[0]; i++)
        if (lobe_sphere_place(row, roughness, v, fmax(places[i][0], -1), places[i][1], versine) &&
            lobe_sg_inside(row) == !beyond && lobe_sg_taken(row))
            add(l, row);
}

/* The first multiple of 2^-24 at x or above. */
static double up(double x) { return ceil(x * 16777216) / 16777216; }

size_t lobe_sg_points(double domain_lo, int beyond, uint64_t seed, double *points, size_t room)
{
    const double roughnesses[] = {up(LOBE_SG_ROUGHNESS_LO), .35, .6, 1};
    const double views[] = {up(LOBE_SG_N_DOT_V_LO), .3, .8, 1};
    const double versines[] = {LOBE_SG_VERSINE_LO, 1.0 / 256, 1.0 / 32, LOBE_SG_VERSINE_HI};
    const double far[][3] = {{.05, .5, .01}, {.05, .001, .1}, {.3, .001, .2}, {.6, .5, 1}, {1, 1, 1}, {.05, 1, 1}};
    list l = {points, beyond ? (room < BEYOND ? room : BEYOND) : room, 0};
    lobe_random random;
    int i, j, k;
    (void)domain_lo;
    if (!beyond && l.room > LOBE_SG_VECTORS)
        l.room = LOBE_SG_VECTORS;
    for (i = 0; !beyond && i < 4; i++)
        for (j = 0; j < 4; j++)
            for (k = 0; k < 4; k++)
                add_places(&l, roughnesses[i], views[j], versines[k], false);
    for (i = 0; beyond && i < 6; i++)
        add_places(&l, up(far[i][0]), up(far[i][1]), far[i][2], true);
    lobe_random_seed(&random, seed, (uint64_t)beyond);
    for (i = 0; l.count < l.room; i++) {
        double u[5], row[5];
        for (k = 0; k < 5; k++)
            u[k] = lobe_random_unit(&random);
        if (lobe_sg_draw(row, u, beyond, i & 1))
            add(&l, row);
    }
    return l.count;
}

void lobe_sg_judged(bool beyond, double *rows, size_t count)
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
        for (turn = 0; !lobe_sg_draw(rows + 5 * i, u, beyond, i & 1) && turn < TRIES; turn++)
            for (k = 0; k < 5; k++)
                u[k] = lobe_random_unit(&random);
    }
}
