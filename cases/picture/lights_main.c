/* `make pictures`: a floor and a ball under a sphere light and a capsule light,
 * as one PNG. Below every form what it adds to the truth. Tone: exposure and
 * the sRGB curve; differences as in sheet.c, but three times and not ten. */
#include "../fit/parallel.h"
#include "lights.h"
#include "png.h"
#include "tone.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static const char usage[] = "usage: lights_picture [--threads N] [--size PIXELS] OUT.png\n"
                            "  a tile is 208 pixels wide if left out; threads 2\n";

enum { BATCH = 512, MARGIN = 16, LABEL = 112, GAP = 8, TOP = 70, CAPTION = 20, FOOT = 74 };

static const char *const foot[] = {
    "mirrors of every roughness: F = 1, no diffuse light, no shadow, no second bounce.",
    "smoothed: the seed paper's soft minimum as printed, its capsule is Karis'.",
    "tone: exposure (a row each) and sRGB; differences 3 x, linear. per cent: rms difference over the truth's rms.",
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

static const double *value(const tile *t, int pixel, int r, int c)
{
    return t->rgb + (size_t)pixel * LOBE_LIGHTS_VALUES + 3 * (r * LOBE_LIGHTS_COLUMNS + c);
}

static int shade(tile *t, size_t threads)
{
    const size_t count = (size_t)t->width * (size_t)t->height;
    const double start = now();
    const int watched = isatty(STDERR_FILENO);
    size_t i, first;
    t->point = malloc(2 * count * sizeof *t->point);
    t->rgb = malloc(LOBE_LIGHTS_VALUES * count * sizeof *t->rgb);
    if (!t->point || !t->rgb)
        return 0;
    for (i = 0; i < count; i++) {
        t->point[2 * i] = (2 * (double)(i % (size_t)t->width) + 1) / t->width - 1;
        t->point[2 * i + 1] = (t->height - 1 - 2 * (double)(i / (size_t)t->width)) / t->width;
    }
    for (first = 0; first < count; first += BATCH) {
        lobe_parallel job = {lobe_lights_shade, NULL, 2, LOBE_LIGHTS_VALUES, threads};
        const size_t n = count - first < BATCH ? count - first : BATCH;
        const double done = (double)(first + n);
        lobe_parallel_eval(&job, t->point + 2 * first, n, t->rgb + LOBE_LIGHTS_VALUES * first);
        if (watched)
            fprintf(stderr, "\r%.0f of %zu points, %.0f/s, %.0f s left  ", done, count, done / (now() - start),
                    ((double)count - done) * (now() - start) / done);
    }
    if (watched)
        fputc('\n', stderr);
    return 1;
}

/* One point in a hundred is brighter than .9. 0 where there is no memory. */
static double exposure_of(const tile *t, int r)
{
    const size_t count = (size_t)t->width * (size_t)t->height;
    double *all = malloc(count * sizeof *all), exposure = 0;
    size_t i;
    if (!all)
        return 0;
    for (i = 0; i < count; i++)
        all[i] = lobe_tone_luminance(value(t, (int)i, r, 0));
    exposure = lobe_tone_exposure(all, count, 100);
    free(all);
    return exposure;
}

static void draw(lobe_canvas *sheet, const tile *t, int left, int top, int r, int c, double exposure)
{
    int i;
    for (i = 0; i < t->width * t->height; i++) {
        const lobe_lights_seen seen = lobe_lights_see(t->point[2 * i], t->point[2 * i + 1]);
        unsigned char rgb[3] = {lobe_tone_background[0], lobe_tone_background[1], lobe_tone_background[2]};
        if (seen == LOBE_LIGHTS_LAMP)
            memset(rgb, 255, sizeof rgb);
        else if (seen == LOBE_LIGHTS_SURFACE)
            lobe_tone_colour(value(t, i, r, c), exposure, rgb);
        lobe_canvas_pixel(sheet, left + i % t->width, top + i / t->width, rgb);
    }
}

static void draw_difference(lobe_canvas *sheet, const tile *t, int left, int top, int r, int c, double exposure)
{
    double error = 0, square = 0;
    char text[16];
    int i, k;
    for (i = 0; i < t->width * t->height; i++) {
        const double *truth = value(t, i, r, 0), *form = value(t, i, r, c);
        const double d = 3 * exposure * (lobe_tone_luminance(form) - lobe_tone_luminance(truth));
        unsigned char rgb[3];
        for (k = 0; k < 3; k++) {
            error += (form[k] - truth[k]) * (form[k] - truth[k]);
            square += truth[k] * truth[k];
        }
        lobe_tone_difference(d, rgb);
        lobe_canvas_pixel(sheet, left + i % t->width, top + i / t->width, rgb);
    }
    snprintf(text, sizeof text, "%.1f %%", 100 * sqrt(error / square));
    lobe_canvas_text(sheet, left + t->width - lobe_text_width(text, 2), top + t->height + 3, 2, text, lobe_tone_grey);
}

static int draw_all(lobe_canvas *sheet, const tile *t)
{
    const int across = t->width + GAP, down = 2 * (t->height + GAP) + CAPTION;
    const int width = MARGIN + LABEL + LOBE_LIGHTS_COLUMNS * across + MARGIN;
    const int height = TOP + LOBE_LIGHTS_ROUGHNESSES * down + FOOT;
    size_t i;
    int r, c;
    if (!lobe_canvas_allocate(sheet, width, height, lobe_tone_background))
        return 0;
    lobe_canvas_text(sheet, MARGIN, MARGIN, 2, "A floor and a ball of one roughness under a sphere light and a capsule",
                     lobe_tone_white);
    for (c = 0; c < LOBE_LIGHTS_COLUMNS; c++)
        lobe_canvas_text(sheet, MARGIN + LABEL + c * across, TOP - 24, 2, lobe_lights_column[c], lobe_tone_white);
    for (r = 0; r < LOBE_LIGHTS_ROUGHNESSES; r++) {
        const int top = TOP + r * down, below = top + t->height + GAP / 2;
        const double exposure = exposure_of(t, r);
        char text[16];
        if (exposure == 0) {
            lobe_canvas_free(sheet);
            return 0;
        }
        snprintf(text, sizeof text, "%g", lobe_lights_roughness[r]);
        lobe_canvas_text(sheet, MARGIN, top, 2, "roughness", lobe_tone_grey);
        lobe_canvas_text(sheet, MARGIN, top + 20, 2, text, lobe_tone_white);
        lobe_canvas_text(sheet, MARGIN, below, 2, "too", lobe_tone_grey);
        lobe_canvas_text(sheet, MARGIN, below + 20, 2, "bright", lobe_tone_orange);
        lobe_canvas_text(sheet, MARGIN, below + 40, 2, "dark", lobe_tone_blue);
        for (c = 0; c < LOBE_LIGHTS_COLUMNS; c++) {
            draw(sheet, t, MARGIN + LABEL + c * across, top, r, c, exposure);
            if (c > 0)
                draw_difference(sheet, t, MARGIN + LABEL + c * across, below, r, c, exposure);
        }
    }
    for (i = 0; i < sizeof foot / sizeof foot[0]; i++)
        lobe_canvas_text(sheet, MARGIN, height - FOOT + 8 + 20 * (int)i, 2, foot[i], lobe_tone_grey);
    return 1;
}

static int whole(const char *text, long least, long most, long *number)
{
    char *rest;
    *number = text ? strtol(text, &rest, 10) : 0;
    return text && rest != text && !*rest && *number >= least && *number <= most;
}

int main(int argc, char **argv)
{
    const double start = now();
    long threads = 2, size = 208;
    tile t = {0, 0, NULL, NULL};
    lobe_canvas sheet;
    int at = 1, status = 0;
    for (; at < argc && argv[at][0] == '-'; at += 2) {
        if (strcmp(argv[at], "-h") == 0)
            return fputs(usage, stdout) < 0;
        if (!(strcmp(argv[at], "--threads") == 0 && whole(argv[at + 1], 1, LOBE_PARALLEL_MAX, &threads)) &&
            !(strcmp(argv[at], "--size") == 0 && whole(argv[at + 1], 8, 1024, &size))) {
            fprintf(stderr, "lights_picture: '%s': --threads takes 1 to %d, --size 8 to 1024\n%s", argv[at],
                    LOBE_PARALLEL_MAX, usage);
            return 2;
        }
    }
    if (at != argc - 1) {
        fputs(usage, stderr);
        return 2;
    }
    t.width = (int)size;
    t.height = (int)size * 5 / 8;
    if (!shade(&t, (size_t)threads) || !draw_all(&sheet, &t)) {
        fprintf(stderr, "lights_picture: not enough memory\n");
        return 2;
    }
    if (!lobe_png_write(&sheet, argv[at]))
        status = 2;
    else
        printf("%s: %d x %d, %.1f s\n", argv[at], sheet.width, sheet.height, now() - start);
    lobe_canvas_free(&sheet);
    free(t.point);
    free(t.rgb);
    return status;
}
