#include "rooms.h"
#include <math.h>
#include "../environment/sky.h"
#include "../fit/random.h"

const char *const lobe_room_name[LOBE_ROOMS] = {"sky", "lamps", "checker", "texel", "clouds"};

static double between(lobe_random *r, double lo, double hi) { return lo + (hi - lo) * lobe_random_unit(r); }

static void direction(lobe_random *r, double d[3])
{
    const double z = between(r, -1, 1), turn = 2 * LOBE_PI * lobe_random_unit(r), sine = sqrt(1 - z * z);
    d[0] = sine * cos(turn);
    d[1] = sine * sin(turn);
    d[2] = z;
}

/* A disc of about 5 degrees, soft at its edge over a texel, with 3 to 8 times the irradiance of a sky of radiance 1:
 * as wide as a map of this size can hold it. */
static void add_sun(lobe_environment *map, lobe_random *r)
{
    double sun[3];
    const double share = between(r, 3, 8), radius = 2.5 * LOBE_PI / 180, edge = LOBE_PI / map->height;
    const double radiance = share * LOBE_PI / (LOBE_PI * radius * radius);
    do
        direction(r, sun);
    while (sun[2] < 0.1 || sun[2] > 0.95);
    for (int i = 0; i < map->height; i++)
        for (int j = 0; j < map->width; j++) {
            double d[3], c, part;
            lobe_environment_direction(map, i, j, d);
            c = d[0] * sun[0] + d[1] * sun[1] + d[2] * sun[2];
            part = fmin(1, fmax(0, 0.5 + (radius - acos(fmin(1, fmax(-1, c)))) / edge));
            for (int k = 0; k < 3; k++)
                map->rgb[3 * ((size_t)i * (size_t)map->width + (size_t)j) + (size_t)k] +=
                    (float)(part * radiance * (1 - 0.1 * k));
        }
}

/* The box that is seen from inside it, at a point away from its middle. */
typedef struct box {
    double lo[3], hi[3];
    double wall[6][3];              /* colours: -x +x -y +y -z +z */
    double lamp[6][4], lamp_light;  /* rectangles on the ceiling, x0 x1 y0 y1 */
    double window[4], window_light; /* on the wall +y, x0 x1 z0 z1 */
    int lamps;
} box;

static void furnish(box *b, lobe_random *r)
{
    for (int k = 0; k < 3; k++) {
        b->lo[k] = -between(r, 1, k == 2 ? 1.6 : 4);
        b->hi[k] = between(r, 1, k == 2 ? 1.6 : 4);
    }
    for (int i = 0; i < 6; i++) {
        const double grey = between(r, 0.05, 0.5);
        for (int k = 0; k < 3; k++)
            b->wall[i][k] = grey * between(r, 0.6, 1.2);
    }
    b->lamps = 1 + (int)lobe_random_below(r, 6);
    b->lamp_light = between(r, 8, 40);
    for (int i = 0; i < b->lamps; i++) {
        const double x = between(r, b->lo[0] + 0.3, b->hi[0] - 0.3), y = between(r, b->lo[1] + 0.3, b->hi[1] - 0.3);
        const double dx = between(r, 0.1, 0.4), dy = between(r, 0.1, 0.4);
        b->lamp[i][0] = x - dx;
        b->lamp[i][1] = x + dx;
        b->lamp[i][2] = y - dy;
        b->lamp[i][3] = y + dy;
    }
    b->window[0] = between(r, b->lo[0], 0);
    b->window[1] = between(r, 0, b->hi[0]);
    b->window[2] = between(r, -0.7, 0);
    b->window[3] = between(r, 0.3, 0.9);
    b->window_light = between(r, 2, 10);
}

static void look(const box *b, const double d[3], double rgb[3])
{
    double least = 1e30, x, y, z;
    int side = 0;
    for (int k = 0; k < 3; k++) {
        const double far_side = d[k] < 0 ? b->lo[k] : b->hi[k], t = d[k] != 0 ? far_side / d[k] : 1e30;
        if (t < least) {
            least = t;
            side = 2 * k + (d[k] >= 0);
        }
    }
    x = d[0] * least;
    y = d[1] * least;
    z = d[2] * least;
    for (int k = 0; k < 3; k++)
        rgb[k] = b->wall[side][k] * (1 + 0.3 * sin(3 * x + k) * sin(4 * y) * cos(3 * z)); /* pictures on the walls */
    for (int i = 0; side == 5 && i < b->lamps; i++) {
        if (x > b->lamp[i][0] && x < b->lamp[i][1] && y > b->lamp[i][2] && y < b->lamp[i][3]) {
            for (int k = 0; k < 3; k++)
                rgb[k] = b->lamp_light * (1 - 0.15 * k);
        }
    }
    if (side == 3 && x > b->window[0] && x < b->window[1] && z > b->window[2] && z < b->window[3]) {
        for (int k = 0; k < 3; k++)
            rgb[k] = b->window_light * (0.7 + 0.15 * k);
    }
}

/* Fields of a grid on the cube around the viewer, turned. */
static void checker(const double frame[3][3], int fields, const double d[3], double rgb[3])
{
    double e[3], most;
    int sum = 0, axis = 0;
    for (int k = 0; k < 3; k++)
        e[k] = frame[k][0] * d[0] + frame[k][1] * d[1] + frame[k][2] * d[2];
    for (int k = 1; k < 3; k++)
        axis = fabs(e[k]) > fabs(e[axis]) ? k : axis;
    most = fabs(e[axis]);
    for (int k = 0; k < 3; k++)
        sum += (int)floor(k == axis ? (e[k] > 0 ? 1 : 4) : e[k] / most * fields / 2 + 100.3 + 0.37 * axis);
    rgb[0] = sum & 1 ? 1 : 0.02;
    rgb[1] = sum & 1 ? 0.9 : 0.03;
    rgb[2] = sum & 1 ? 0.8 : 0.06;
}

static void turn_frame(lobe_random *r, double frame[3][3])
{
    double n = 0;
    direction(r, frame[0]);
    direction(r, frame[1]);
    for (int k = 0; k < 3; k++)
        n += frame[0][k] * frame[1][k];
    for (int k = 0; k < 3; k++)
        frame[1][k] -= n * frame[0][k];
    n = sqrt(frame[1][0] * frame[1][0] + frame[1][1] * frame[1][1] + frame[1][2] * frame[1][2]);
    for (int k = 0; k < 3; k++)
        frame[1][k] /= n;
    for (int k = 0; k < 3; k++)
        frame[2][k] = frame[0][(k + 1) % 3] * frame[1][(k + 2) % 3] - frame[0][(k + 2) % 3] * frame[1][(k + 1) % 3];
}

/* Plane waves over space, looked at on the sphere, octave by octave. */
enum { WAVES = 12, OCTAVES = 6 };
typedef struct waves {
    double along[WAVES * OCTAVES][3], phase[WAVES * OCTAVES], height[WAVES * OCTAVES];
} waves;

static void raise_waves(waves *w, lobe_random *r)
{
    const double fall = between(r, 0.4, 0.8);
    for (int i = 0; i < WAVES * OCTAVES; i++) {
        direction(r, w->along[i]);
        for (int k = 0; k < 3; k++)
            w->along[i][k] *= between(r, 0.7, 1.4) * ldexp(1.5, i / WAVES);
        w->phase[i] = 2 * LOBE_PI * lobe_random_unit(r);
        w->height[i] = pow(fall, i / WAVES);
    }
}

static void cloud(const waves *w, const double d[3], double rgb[3])
{
    double sum = 0;
    for (int i = 0; i < WAVES * OCTAVES; i++)
        sum += w->height[i] * sin(w->along[i][0] * d[0] + w->along[i][1] * d[1] + w->along[i][2] * d[2] + w->phase[i]);
    for (int k = 0; k < 3; k++)
        rgb[k] = exp(0.35 * sum) * (1 - 0.1 * k);
}

int lobe_room_make(lobe_environment *map, lobe_room room, int width, unsigned seed)
{
    lobe_random r;
    box b;
    waves w;
    double frame[3][3];
    int fields;
    lobe_random_seed(&r, seed, (uint64_t)room + 100);
    furnish(&b, &r);
    raise_waves(&w, &r);
    turn_frame(&r, frame);
    fields = 4 + 2 * (int)lobe_random_below(&r, 5);
    if (room == LOBE_ROOM_SKY) {
        if (!lobe_environment_sky(map, width, width / 2, seed))
            return 0;
        add_sun(map, &r);
        return 1;
    }
    if (!lobe_environment_allocate(map, width, width / 2))
        return 0;
    for (int i = 0; i < map->height; i++)
        for (int j = 0; j < map->width; j++) {
            float *out = map->rgb + 3 * ((size_t)i * (size_t)map->width + (size_t)j);
            double d[3], rgb[3] = {0, 0, 0};
            lobe_environment_direction(map, i, j, d);
            if (room == LOBE_ROOM_LAMPS)
                look(&b, d, rgb);
            else if (room == LOBE_ROOM_CHECKER)
                checker(frame, fields, d, rgb);
            else if (room == LOBE_ROOM_CLOUDS)
                cloud(&w, d, rgb);
            for (int k = 0; k < 3; k++)
                out[k] = (float)rgb[k];
        }
    if (room == LOBE_ROOM_TEXEL) {
        const size_t row = (size_t)map->height / 4 + lobe_random_below(&r, (size_t)map->height / 2);
        const size_t column = lobe_random_below(&r, (size_t)map->width);
        for (size_t k = 0; k < 3; k++)
            map->rgb[3 * (row * (size_t)map->width + column) + k] = 1000;
    }
    return 1;
}
