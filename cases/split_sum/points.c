#include "points.h"
#include <math.h>
#include "../fit/random.h"

#define COUNT 256
#define SIDE 12 /* of the jittered lattice */
#define EDGE 6  /* points inside each edge */
#define TRUTH_LO 0.001

/* Nearest multiple of 2^-24 inside [lo, hi]: exact in f32 and in q30 */
static double exact(double x, double lo, double hi)
{
    const double unit = 16777216;
    return fmin(fmax(floor(x * unit + 0.5), ceil(lo * unit)), floor(hi * unit)) / unit;
}

typedef struct list {
    double *points;
    size_t room, count;
} list;

/* u in [0, 1] to the domain, denser toward lo */
static double dense(double lo, double hi, double u, int power)
{
    return exact(lo + (hi - lo) * u * u * (power == 3 ? u : 1), lo, hi);
}

static void add(list *l, double roughness, double n_dot_v)
{
    if (l->count < l->room && l->count < COUNT) {
        l->points[2 * l->count] = roughness;
        l->points[2 * l->count + 1] = n_dot_v;
        l->count++;
    }
}

static void inside(list *l, double lo, lobe_random *random)
{
    const double bottom = exact(lo, lo, 1);
    int i, k;
    for (i = 0; i < 4; i++)
        add(l, i & 1 ? 1 : bottom, i & 2 ? 1 : bottom);
    for (i = 1; i <= EDGE; i++) {
        const double x = dense(lo, 1, i / (EDGE + 1.0), 2);
        add(l, bottom, x);
        add(l, 1, x);
        add(l, x, bottom);
        add(l, x, 1);
    }
    for (i = 0; i < SIDE; i++) {
        for (k = 0; k < SIDE; k++) {
            const double r = dense(lo, 1, (i + lobe_random_unit(random)) / SIDE, 2);
            const double v = dense(lo, 1, (k + lobe_random_unit(random)) / SIDE, 2);
            add(l, r, v);
        }
    }
    while (l->count < COUNT && l->count < l->room) {
        const double r = dense(lo, 1, lobe_random_unit(random), 3), v = dense(lo, 1, lobe_random_unit(random), 3);
        add(l, r, v);
    }
}

/* The largest multiple of 2^-24 below lo is still below the domain; its neighbour across the edge is not, and the two
 * must agree, so both sides of the edge are here or in the other file. */
static void outside(list *l, double lo, lobe_random *random)
{
    const double least = exact(TRUTH_LO, TRUTH_LO, 1), most = (ceil(lo * 16777216) - 1) / 16777216;
    int i;
    for (i = 0; i < 4; i++)
        add(l, i & 1 ? most : least, i & 2 ? most : least);
    for (i = 0; i < 4; i++) {
        add(l, i & 1 ? most : least, i & 2 ? 1 : exact(lo, lo, 1));
        add(l, i & 2 ? 1 : exact(lo, lo, 1), i & 1 ? most : least);
    }
    /* roughness below, NdotV below, both below, in turns */
    for (i = 0; l->count < COUNT && l->count < l->room; i++) {
        const double u = (i / 3 + lobe_random_unit(random)) / ((COUNT - 12) / 3 + 1), w = lobe_random_unit(random);
        const double low = dense(TRUTH_LO, most, u, 2);
        const double other = i % 3 == 2 ? dense(TRUTH_LO, most, w, 2) : dense(lo, 1, w, 2);
        add(l, i % 3 == 1 ? other : low, i % 3 == 1 ? low : other);
    }
}

size_t lobe_split_sum_points(double domain_lo, int below, uint64_t seed, double *points, size_t room)
{
    list l = {points, room, 0};
    lobe_random random;
    lobe_random_seed(&random, seed, below ? 1 : 0);
    if (below)
        outside(&l, domain_lo, &random);
    else
        inside(&l, domain_lo, &random);
    return l.count;
}
