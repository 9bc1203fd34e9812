#include "points.h"
#include <math.h>
#include "../fit/random.h"

enum { COUNT = 256, SIDE = 12, ENDS = 7 };

typedef struct list {
    double *points;
    size_t room, count;
} list;

/* Multiples of 2^-24 are exact in f32 and in q30. */
static double exact(double x) { return floor(x * 16777216 + 0.5) / 16777216; }

static void add(list *l, double n_dot_l, double sine)
{
    if (l->count < l->room && l->count < COUNT) {
        l->points[2 * l->count] = exact(fmin(1, fmax(-1, n_dot_l)));
        l->points[2 * l->count + 1] = exact(fmin(1, fmax(0x1p-24, sine)));
        l->count++;
    }
}

size_t lobe_sphere_diffuse_points(double domain_lo, int below, uint64_t seed, double *points, size_t room)
{
    static const double ends[ENDS] = {0x1p-12, 0.02, 0.2, 0.5, 0.7071, 0.99, 1};
    const double pi = 3.14159265358979323846;
    list l = {points, room, 0};
    lobe_random random;
    int i, k;
    (void)domain_lo;
    if (below)
        return 0;
    lobe_random_seed(&random, seed, 0);
    for (i = 0; i < ENDS; i++)
        for (k = -3; k <= 3; k++) /* wholly down and up, the limbs on the horizon and next to it, the centre on it */
            add(&l, k == 0 ? 0 : (k < 0 ? -1 : 1) * (k == 3 || k == -3 ? 1 : ends[i] * (k * k == 1 ? 1 : 0.99)),
                ends[i]);
    /* Nearly half the sky, where all turns between -sine and just above it. */
    for (i = 1; i <= 8; i++) {
        add(&l, -1 + pow(0.2, i), 1 - pow(0.2, i + 1));
        add(&l, 1 - pow(0.2, i), 1 - pow(0.2, i + 1));
    }
    for (i = 0; i < SIDE; i++)
        for (k = 0; k < SIDE; k++) {
            const double sine = sin(pi / 2 * (i + lobe_random_unit(&random)) / SIDE);
            add(&l, sine * cos(pi * (k + lobe_random_unit(&random)) / SIDE), sine);
        }
    while (l.count < COUNT && l.count < l.room) {
        const double n_dot_l = 2 * lobe_random_unit(&random) - 1;
        add(&l, n_dot_l, lobe_random_unit(&random));
    }
    return l.count;
}
