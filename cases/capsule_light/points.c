#include "points.h"
#include <math.h>
#include "../fit/random.h"

enum { BEYOND = 192, SEED = 3, TRIES = 64, COLUMNS = 9, DRAWN = 8 };

static const double pi = 3.14159265358979323846, unit = 16777216;

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static bool inside(const double row[9])
{
    return row[0] >= LOBE_CAPSULE_ROUGHNESS_LO && row[1] >= LOBE_CAPSULE_N_DOT_V_LO && row[8] <= LOBE_CAPSULE_RADIUS_HI;
}

bool lobe_capsule_settle(double row[9], bool beyond)
{
    const double length = sqrt(dot(row + 2, row + 2)), radius = row[8];
    double along, arm2, line2;
    int k;
    for (k = 2; k < 5; k++)
        row[k] /= length;
    for (k = 0; k < COLUMNS; k++)
        row[k] = floor(row[k] * unit + .5) / unit;
    arm2 = dot(row + 5, row + 5);
    along = dot(row + 2, row + 5);
    line2 = arm2 > 0 ? 1 - along * along / arm2 : 1;
    if (!(row[0] >= LOBE_CAPSULE_ROUGHNESS_LEAST && row[0] <= 1 && row[1] >= LOBE_CAPSULE_N_DOT_V_LEAST &&
          row[1] <= 1 && radius >= LOBE_CAPSULE_RADIUS_LEAST && radius <= .9 && arm2 <= 1.000001))
        return false;
    if (row[4] + fabs(row[7]) + radius < 0)
        return false;
    if (beyond)
        return !inside(row) && line2 >= 1.05 * 1.05 * radius * radius;
    return inside(row) && line2 >= 1.5 * 1.5 * radius * radius && line2 >= .04;
}

static double mix(double lo, double hi, double u) { return lo + (hi - lo) * u; }

/* u again in [0, 1), after it chose one of n ways. */
static double rest(double u, int n, int *way)
{
    *way = (int)(n * u);
    return n * u - *way;
}

static void direction(double out[3], double z, double turn)
{
    const double s = sqrt(fmax(0, 1 - z * z));
    out[0] = s * cos(turn);
    out[1] = s * sin(turn);
    out[2] = z;
}

/* One row from eight numbers in [0, 1); false: draw again. */
static bool draw(double row[9], const double u[DRAWN], bool beyond, bool near)
{
    int out = 0, small, k;
    const double w = beyond ? rest(u[0], 3, &out) : u[0], size = rest(u[7], 2, &small);
    double v, s, arm[3], length;
    row[0] = mix(LOBE_CAPSULE_ROUGHNESS_LO, 1, w);
    row[1] = v = mix(LOBE_CAPSULE_N_DOT_V_LO, 1, u[1] * u[1]);
    row[8] = small ? LOBE_CAPSULE_RADIUS_LEAST * pow(LOBE_CAPSULE_RADIUS_HI / LOBE_CAPSULE_RADIUS_LEAST, size)
                   : mix(LOBE_CAPSULE_RADIUS_LEAST, LOBE_CAPSULE_RADIUS_HI, size);
    if (beyond) {
        row[0] = mix(LOBE_CAPSULE_ROUGHNESS_LEAST, out == 0 ? LOBE_CAPSULE_ROUGHNESS_LO : 1, w);
        row[1] = v = mix(LOBE_CAPSULE_N_DOT_V_LEAST, out == 1 ? LOBE_CAPSULE_N_DOT_V_LO : 1, u[1]);
        row[8] = out == 2 ? mix(LOBE_CAPSULE_RADIUS_HI, .9, u[7]) : row[8];
    }
    s = sqrt(1 - v * v);
    length = u[4] * u[4];
    direction(arm, 2 * u[5] - 1, 2 * pi * u[6]);
    for (k = 0; k < 3; k++)
        row[5 + k] = arm[k] * length;
    if (near) { /* turned from the mirror direction by t, around it by turn */
        const double t = fmin(1.2, asin(row[8]) + 2 * row[0] * row[0] + .5 * length) * u[2], turn = 2 * pi * u[3];
        row[2] = -s * cos(t) + v * sin(t) * cos(turn);
        row[3] = sin(t) * sin(turn);
        row[4] = v * cos(t) + s * sin(t) * cos(turn);
    } else {
        direction(row + 2, mix(-.3, 1, u[2]), 2 * pi * u[3]);
    }
    return lobe_capsule_settle(row, beyond);
}

typedef struct list {
    double *points;
    size_t room, count;
} list;

static void add(list *l, const double row[9])
{
    int k;
    if (l->count >= l->room)
        return;
    for (k = 0; k < COLUMNS; k++)
        l->points[COLUMNS * l->count + (size_t)k] = row[k];
    l->count++;
}

/* The first multiple of 2^-24 at x or above. */
static double up(double x) { return ceil(x * unit) / unit; }

/* The light in every telling place for one roughness, view and radius. */
static void add_places(list *l, double roughness, double v, double radius, bool beyond)
{
    const double s = sqrt(1 - v * v);
    const double middles[][3] = {{-s, 0, v}, {-.8, .6, 0}, {0, 0, 1}, {s, .1, v}};
    const double arms[][3] = {{0, 0, 0},  {0, .7, 0},       {.7 * v, 0, .7 * s},
                              {0, 0, .5}, {.004, 0, -.003}, {-.9 * s, .5, .9 * v}};
    size_t i, k;
    for (i = 0; i < sizeof middles / sizeof middles[0]; i++)
        for (k = 0; k < sizeof arms / sizeof arms[0]; k++) {
            double row[9] = {roughness,  v,          middles[i][0], middles[i][1], middles[i][2],
                             arms[k][0], arms[k][1], arms[k][2],    radius};
            if (lobe_capsule_settle(row, beyond))
                add(l, row);
        }
}

size_t lobe_capsule_points(double domain_lo, int beyond, uint64_t seed, double *points, size_t room)
{
    const double roughnesses[] = {up(LOBE_CAPSULE_ROUGHNESS_LO), .6, 1};
    const double views[] = {up(LOBE_CAPSULE_N_DOT_V_LO), .5, 1};
    const double radii[] = {up(LOBE_CAPSULE_RADIUS_LEAST), .2};
    const double far[][3] = {{.05, .5, .1}, {.3, .001, .3}, {.6, .5, .7}, {.05, .001, .01}};
    list l = {points, beyond ? (room < BEYOND ? room : BEYOND) : room, 0};
    lobe_random random;
    int i, j, k;
    (void)domain_lo;
    if (!beyond && l.room > LOBE_CAPSULE_VECTORS)
        l.room = LOBE_CAPSULE_VECTORS;
    for (i = 0; !beyond && i < 3; i++)
        for (j = 0; j < 3; j++)
            for (k = 0; k < 2; k++)
                add_places(&l, roughnesses[i], views[j], radii[k], false);
    for (i = 0; beyond && i < 4; i++)
        add_places(&l, up(far[i][0]), up(far[i][1]), far[i][2], true);
    lobe_random_seed(&random, seed, (uint64_t)beyond);
    for (i = 0; l.count < l.room; i++) {
        double u[DRAWN], row[9];
        for (k = 0; k < DRAWN; k++)
            u[k] = lobe_random_unit(&random);
        if (draw(row, u, beyond, i & 1))
            add(&l, row);
    }
    return l.count;
}

void lobe_capsule_judged(bool beyond, double *rows, size_t count)
{
    static const double lower[DRAWN] = {0}, upper[DRAWN] = {1, 1, 1, 1, 1, 1, 1, 1};
    lobe_random random;
    size_t i = count;
    int k, turn;
    lobe_random_seed(&random, SEED, beyond);
    lobe_random_latin(&random, lower, upper, DRAWN, count, rows);
    while (i-- > 0) { /* from the end: a row is longer than what was drawn for it */
        double u[DRAWN];
        for (k = 0; k < DRAWN; k++)
            u[k] = rows[DRAWN * i + (size_t)k];
        for (turn = 0; !draw(rows + COLUMNS * i, u, beyond, i & 1) && turn < TRIES; turn++)
            for (k = 0; k < DRAWN; k++)
                u[k] = lobe_random_unit(&random);
    }
}
