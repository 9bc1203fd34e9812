/* `make pictures`: a ball on a floor under light from all around, as one PNG an environment; below every form what it
 * adds to the truth. Tone: exposure, a row each, and the sRGB curve. */
#include "../env_lobes/rooms.h"
#include "../fit/parallel.h"
#include "environments.h"
#include "png.h"
#include "tone.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static const char usage[] =
    "usage: environments_picture [--threads N] [--size PIXELS] [--cube SIDE] sky|lamps|white|FILE.hdr OUT.png\n"
    "  a tile is 208 pixels wide if left out; threads 2; the filtered cube 256 a side, a power of 2, 8 to 512\n"
    "  a FILE is looked at with its brightest texel to the right\n";

enum { BATCH = 512, MARGIN = 16, LABEL = 112, GAP = 8, TOP = 72, CAPTION = 20, FOOT = 94, TIMES = 2 };

/* The brightest texel is that far to the right of the picture's middle, in radians. */
#define BESIDE .15

static const char *const foot[] = {
    "truth: the GGX lobe (correlated Smith), integrated at every pixel. all others look up one filtered cube map:",
    "split sum: once, in the mirror direction. taps: env_lobes. mean error: |difference| / truth over ball and floor.",
    "mirrors of every roughness: F = 1, no shadow, no second bounce. tone: exposure (a row each) and sRGB.",
};

typedef struct tile {
    int width, height;
    double *point, *rgb;
} tile;

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static const double *value(const tile *t, int pixel, int a, int c)
{
    return t->rgb + (size_t)pixel * LOBE_AROUND_VALUES + 3 * (a * LOBE_AROUND_COLUMNS + c);
}

static int shade(const lobe_around *around, tile *t, size_t threads)
{
    const size_t count = (size_t)t->width * (size_t)t->height;
    const double start = now();
    const int watched = isatty(STDERR_FILENO);
    t->point = malloc(2 * count * sizeof *t->point);
    t->rgb = malloc(LOBE_AROUND_VALUES * count * sizeof *t->rgb);
    if (!t->point || !t->rgb)
        return 0;
    for (size_t i = 0; i < count; i++) {
        t->point[2 * i] = (2 * (double)(i % (size_t)t->width) + 1) / t->width - 1;
        t->point[2 * i + 1] = (t->height - 1 - 2 * (double)(i / (size_t)t->width)) / t->width;
    }
    for (size_t first = 0; first < count; first += BATCH) {
        lobe_parallel job = {lobe_around_shade, (void *)around, 2, LOBE_AROUND_VALUES, threads};
        const size_t n = count - first < BATCH ? count - first : BATCH;
        const double done = (double)(first + n);
        lobe_parallel_eval(&job, t->point + 2 * first, n, t->rgb + LOBE_AROUND_VALUES * first);
        if (watched)
            fprintf(stderr, "\r%.0f of %zu points, %.0f/s, %.0f s left  ", done, count, done / (now() - start),
                    ((double)count - done) * (now() - start) / done);
    }
    if (watched)
        fputc('\n', stderr);
    for (size_t i = 0; i < count; i++)
        if (isnan(t->rgb[LOBE_AROUND_VALUES * i]))
            return 0;
    return 1;
}

/* One point of the surfaces in forty is brighter than .9. 0 where there is no memory. */
static double exposure_of(const lobe_around *around, const tile *t, int a)
{
    const int count = t->width * t->height;
    double *all = malloc((size_t)count * sizeof *all), exposure, rgb[3];
    int n = 0;
    if (!all)
        return 0;
    for (int i = 0; i < count; i++)
        if (lobe_around_see(around, t->point[2 * i], t->point[2 * i + 1], rgb))
            all[n++] = lobe_tone_luminance(value(t, i, a, 0));
    exposure = lobe_tone_exposure(all, (size_t)n, 40);
    free(all);
    return exposure;
}

static void draw(lobe_canvas *sheet, const lobe_around *around, const tile *t, int left, int top, int a, int c,
                 double exposure)
{
    for (int i = 0; i < t->width * t->height; i++) {
        double seen[3];
        const int surface = lobe_around_see(around, t->point[2 * i], t->point[2 * i + 1], seen);
        unsigned char rgb[3];
        lobe_tone_colour(surface ? value(t, i, a, c) : seen, exposure, rgb);
        lobe_canvas_pixel(sheet, left + i % t->width, top + i / t->width, rgb);
    }
}

static void draw_difference(lobe_canvas *sheet, const lobe_around *around, const tile *t, int left, int top, int a,
                            int c, double exposure)
{
    double sum = 0;
    int count = 0;
    char text[24];
    for (int i = 0; i < t->width * t->height; i++) {
        const double is = lobe_tone_luminance(value(t, i, a, c)), should = lobe_tone_luminance(value(t, i, a, 0));
        const double d = TIMES * exposure * (is - should);
        double seen[3];
        unsigned char rgb[3] = {lobe_tone_background[0], lobe_tone_background[1], lobe_tone_background[2]};
        if (lobe_around_see(around, t->point[2 * i], t->point[2 * i + 1], seen)) {
            lobe_tone_difference(d, rgb);
            sum += fabs(is - should) / should;
            count++;
        }
        lobe_canvas_pixel(sheet, left + i % t->width, top + i / t->width, rgb);
    }
    snprintf(text, sizeof text, "%.1f %%", 100 * sum / count);
    lobe_canvas_text(sheet, left + t->width - lobe_text_width(text, 2), top + t->height + 3, 2, text, lobe_tone_white);
}

/* What stands beside the differences, where the truth has none. */
static void legend(lobe_canvas *sheet, int top, const tile *t)
{
    const int right = MARGIN + LABEL + t->width;
    const char *const text[] = {"minus truth, x2", "too bright", "too dark", "mean error"};
    const unsigned char *const colour[] = {lobe_tone_grey, lobe_tone_orange, lobe_tone_blue, lobe_tone_grey};
    for (int i = 0; i < 4; i++)
        lobe_canvas_text(sheet, right - lobe_text_width(text[i], 2),
                         i < 3 ? top + t->height / 2 - 30 + 20 * i : top + t->height + 3, 2, text[i], colour[i]);
}

static int draw_all(lobe_canvas *sheet, const char *title, const lobe_around *around, const tile *t)
{
    const int across = t->width + GAP, down = 2 * (t->height + GAP) + CAPTION;
    const int width = MARGIN + LABEL + LOBE_AROUND_COLUMNS * across + MARGIN;
    const int height = TOP + LOBE_AROUND_ALPHAS * down + FOOT;
    char text[128];
    if (!lobe_canvas_allocate(sheet, width, height, lobe_tone_background))
        return 0;
    snprintf(text, sizeof text, "A ball and a floor of one roughness, lit by all that is around them: %s", title);
    lobe_canvas_text(sheet, MARGIN, MARGIN, 2, text, lobe_tone_white);
    for (int c = 0; c < LOBE_AROUND_COLUMNS; c++)
        lobe_canvas_text(sheet, MARGIN + LABEL + c * across, TOP - 24, 2, lobe_around_column[c], lobe_tone_white);
    for (int a = 0; a < LOBE_AROUND_ALPHAS; a++) {
        const int top = TOP + a * down, below = top + t->height + GAP / 2;
        const double exposure = exposure_of(around, t, a);
        if (exposure == 0) {
            lobe_canvas_free(sheet);
            return 0;
        }
        snprintf(text, sizeof text, "%g", lobe_around_alpha[a]);
        lobe_canvas_text(sheet, MARGIN, top, 2, "alpha", lobe_tone_grey);
        lobe_canvas_text(sheet, MARGIN, top + 20, 2, text, lobe_tone_white);
        legend(sheet, below, t);
        for (int c = 0; c < LOBE_AROUND_COLUMNS; c++) {
            draw(sheet, around, t, MARGIN + LABEL + c * across, top, a, c, exposure);
            if (c > 0)
                draw_difference(sheet, around, t, MARGIN + LABEL + c * across, below, a, c, exposure);
        }
    }
    for (size_t i = 0; i < sizeof foot / sizeof foot[0]; i++)
        lobe_canvas_text(sheet, MARGIN, height - FOOT + 8 + 20 * (int)i, 2, foot[i], lobe_tone_grey);
    snprintf(text, sizeof text, "the cube: %d a side, %d mips, trilinear, as engines have it.", around->cube.size,
             around->cube.mips);
    lobe_canvas_text(sheet, MARGIN, height - FOOT + 8 + 20 * (int)(sizeof foot / sizeof foot[0]), 2, text,
                     lobe_tone_grey);
    return 1;
}

static int whole(const char *text, long least, long most, long *number)
{
    char *rest;
    *number = text ? strtol(text, &rest, 10) : 0;
    return text && rest != text && !*rest && *number >= least && *number <= most;
}

/* What needs no file: seeds from 101 on are of no fit. These have a light in front, whose reflection stretches. */
static const struct own {
    const char *name, *title;
    lobe_room room;
    unsigned seed;
} own[] = {
    {"sky", "a sky with a low sun", LOBE_ROOM_SKY, 128},
    {"lamps", "a room with lamps", LOBE_ROOM_LAMPS, 107},
};

/* The exit status. */
static int map_of(const char *what, int side, lobe_environment *map, const char **title)
{
    const int width = 4 * side;
    const char *slash = strrchr(what, '/');
    int good = -1;
    *title = slash ? slash + 1 : what;
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++)
        if (strcmp(what, own[i].name) == 0) {
            *title = own[i].title;
            good = lobe_room_make(map, own[i].room, width, own[i].seed);
        }
    if (strcmp(what, "white") == 0) {
        good = lobe_environment_allocate(map, width, width / 2);
        for (int i = 0; good && i < 3 * width * width / 2; i++)
            map->rgb[i] = 1;
    }
    if (good < 0)
        return lobe_environment_load(what, map) ? 0 : 2;
    if (!good)
        fprintf(stderr, "environments_picture: not enough memory for %s\n", what);
    return good ? 0 : 2;
}

int main(int argc, char **argv)
{
    const double start = now();
    long threads = 2, size = 208, side = 256;
    tile t = {0, 0, NULL, NULL};
    lobe_environment map;
    lobe_around around;
    lobe_canvas sheet;
    const char *title;
    int at = 1, status = 0;
    for (; at < argc && argv[at][0] == '-'; at += 2) {
        if (strcmp(argv[at], "-h") == 0)
            return fputs(usage, stdout) < 0;
        if (!(strcmp(argv[at], "--threads") == 0 && whole(argv[at + 1], 1, LOBE_PARALLEL_MAX, &threads)) &&
            !(strcmp(argv[at], "--size") == 0 && whole(argv[at + 1], 8, 1024, &size)) &&
            !(strcmp(argv[at], "--cube") == 0 && whole(argv[at + 1], 8, 512, &side) && (side & (side - 1)) == 0)) {
            fprintf(stderr,
                    "environments_picture: '%s': --threads takes 1 to %d, --size 8 to 1024, --cube a power of 2 from 8 "
                    "to 512\n%s",
                    argv[at], LOBE_PARALLEL_MAX, usage);
            return 2;
        }
    }
    if (at != argc - 2) {
        fputs(usage, stderr);
        return 2;
    }
    status = map_of(argv[at], (int)side, &map, &title);
    if (status)
        return status;
    if (!lobe_around_of(&map, (int)side, lobe_around_brightest(&map) + BESIDE, (int)threads, &around)) {
        fprintf(stderr, "environments_picture: not enough memory\n");
        return 2;
    }
    t.width = (int)size;
    t.height = (int)size * 5 / 8;
    if (!shade(&around, &t, (size_t)threads) || !draw_all(&sheet, title, &around, &t)) {
        fprintf(stderr, "environments_picture: not enough memory\n");
        return 2;
    }
    if (!lobe_png_write(&sheet, argv[at + 1]))
        status = 2;
    else
        printf("%s: %d x %d, %.1f s\n", argv[at + 1], sheet.width, sheet.height, now() - start);
    lobe_canvas_free(&sheet);
    lobe_around_free(&around);
    lobe_environment_free(&map);
    free(t.point);
    free(t.rgb);
    return status;
}
