#include "points.h"
#include <math.h>
#include "../fit/random.h"

enum { COUNT = 256, SIDE = 14, EDGE = 8 };

typedef struct list {
    double *points;
    size_t room, count;
} list;

/* Multiples of 2^-24 are exact in f32 and in q30. */
static double exact(double x) { return floor(x * 16777216 + 0.5) / 16777216; }

static void add(list *l, double roughness, double n_dot_v)
{
    if (l->count < l->room && l->count < COUNT) {
        l->points[2 * l->count] = exact(roughness);
        l->points[2 * l->count + 1] = exact(n_dot_v);
        l->count++;
    }
}

size_t lobe_diffuse_points(double domain_lo, int below, uint64_t seed, double *points, size_t room)
{
    list l = {points, room, 0};
    lobe_random random;
    int i, k;
    (void)domain_lo;
    if (below)
        return 0;
    lobe_random_seed(&random, seed, 0);
    for (i = 0; i < 4; i++)
        add(&l, i & 1, i >> 1);
    for (i = 1; i <= EDGE; i++) {
        const double x = i / (EDGE + 1.0);
        add(&l, 0, x);
        add(&l, 1, x);
        add(&l, x, 0);
        add(&l, x, 1);
    }
    /* Next to the ends of NdotV, where the root of 1 - v^2 and (1 - v)^5 turn. */
    for (i = 1; i <= 6; i++) {
        add(&l, 1, pow(0.0625, i));
        add(&l, 1, 1 - pow(0.0625, i));
    }
    for (i = 0; i < SIDE; i++)
        for (k = 0; k < SIDE; k++) {
            const double r = (i + lobe_random_unit(&random)) / SIDE, v = (k + lobe_random_unit(&random)) / SIDE;
            add(&l, r, v * v);
        }
    while (l.count < COUNT && l.count < l.room) {
        const double r = lobe_random_unit(&random), v = lobe_random_unit(&random);
        add(&l, r, v);
    }
    return l.count;
}
