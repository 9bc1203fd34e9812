/* Tone: exposure alone, so that the brightest point at roughness .5 becomes .9, then the sRGB curve. Differences are
 * ten times the exposed difference of the luminances, orange where the tier is too bright and blue where it is too
 * dark, without a curve: twice the difference is twice the number in the file. */
#include "sheet.h"
#include "tone.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MARGIN = 16,
    PANEL = 176,     /* the scene's name and its map */
    ROUGHNESS = 122, /* the roughness' label */
    GAP = 10,        /* between discs */
    BETWEEN = 40,    /* between the spheres and their differences */
    CAPTION = 26,    /* the number below a difference */
    TITLE = 40,
    HEADINGS = 56,
    FOOT = 104,
    SCENES_APART = 18
};

static const char *const foot[] = {
    "truth: a sum over every direction of the map, no SH. exact: what it misses, nine coefficients cannot hold.",
    "base colour 1. a sun is a punctual light for all but the truth. lambert does not know the roughness.",
    "tone: exposure (brightest point at roughness 0.5 = 0.9) and sRGB, nothing else. differences: 10 x exposed",
    "luminance, linear. per cent: rms of the difference over the sphere, relative to the truth's rms.",
};
enum { FOOT_LINES = sizeof foot / sizeof foot[0] };

int lobe_shaded_of(int diameter, lobe_shaded *s)
{
    const size_t most = (size_t)diameter * (size_t)diameter;
    const double radius = diameter / 2.0;
    s->diameter = diameter;
    s->count = 0;
    s->pixel = malloc(2 * most * sizeof *s->pixel);
    s->point = malloc(2 * most * sizeof *s->point);
    s->rgb = malloc(LOBE_PICTURE_VALUES * most * sizeof *s->rgb);
    if (!s->pixel || !s->point || !s->rgb) {
        lobe_shaded_free(s);
        return 0;
    }
    for (int j = 0; j < diameter; j++)
        for (int i = 0; i < diameter; i++) {
            const double x = (i + 0.5 - radius) / radius, y = (radius - j - 0.5) / radius;
            if (hypot(x, y) * radius < radius + 0.5) {
                s->pixel[2 * s->count] = i;
                s->pixel[2 * s->count + 1] = j;
                s->point[2 * s->count] = x;
                s->point[2 * s->count++ + 1] = y;
            }
        }
    return 1;
}

void lobe_shaded_free(lobe_shaded *s)
{
    free(s->pixel);
    free(s->point);
    free(s->rgb);
    memset(s, 0, sizeof *s);
}

static int pitch(int diameter) { return diameter + GAP; }
static int block(int diameter) { return LOBE_PICTURE_ROUGHNESSES * (diameter + CAPTION) + SCENES_APART; }
static int first_sphere(void) { return MARGIN + PANEL + ROUGHNESS; }
static int first_difference(int diameter) { return first_sphere() + LOBE_PICTURE_COLUMNS * pitch(diameter) + BETWEEN; }

static void centred(lobe_canvas *sheet, int middle, int y, int scale, const char *text, const unsigned char colour[3])
{
    lobe_canvas_text(sheet, middle - lobe_text_width(text, scale) / 2, y, scale, text, colour);
}

int lobe_sheet_of(int diameter, int scenes, lobe_canvas *sheet)
{
    const int width = first_difference(diameter) + (LOBE_PICTURE_COLUMNS - 1) * pitch(diameter) + MARGIN;
    const int top = MARGIN + TITLE, below = top + HEADINGS + scenes * block(diameter);
    if (!lobe_canvas_allocate(sheet, width, below + FOOT, lobe_tone_background))
        return 0;
    lobe_canvas_text(sheet, MARGIN, MARGIN, 2,
                     "Disney (Burley) diffuse, white, under environment light from nine SH coefficients a channel",
                     lobe_tone_white);
    for (int side = 0; side < 2; side++)
        for (int c = side; c < LOBE_PICTURE_COLUMNS; c++) {
            const int left =
                side ? first_difference(diameter) + (c - 1) * pitch(diameter) : first_sphere() + c * pitch(diameter);
            centred(sheet, left + diameter / 2, top + 28, diameter < 84 ? 1 : 2, lobe_picture_column[c],
                    lobe_tone_white);
        }
    lobe_canvas_text(sheet, first_sphere(), top, 2, "rendered", lobe_tone_grey);
    lobe_canvas_text(sheet, first_difference(diameter), top, 2, "minus truth, x 10:", lobe_tone_grey);
    const int after = first_difference(diameter) + lobe_text_width("minus truth, x 10: ", 2);
    lobe_canvas_text(sheet, after, top, 2, "bright", lobe_tone_orange);
    lobe_canvas_text(sheet, after + lobe_text_width("bright ", 2) + 2, top, 2, "dark", lobe_tone_blue);
    for (int i = 0; i < FOOT_LINES; i++)
        lobe_canvas_text(sheet, MARGIN, below + 4 + 20 * i, 2, foot[i], lobe_tone_grey);
    return 1;
}

static const double *value(const lobe_shaded *s, int point, int r, int c)
{
    return s->rgb + LOBE_PICTURE_VALUES * (size_t)point + 3 * (size_t)(r * LOBE_PICTURE_COLUMNS + c);
}

static double exposure_of(const lobe_shaded *s)
{
    double brightest = 1e-30;
    for (int i = 0; i < s->count; i++)
        for (int k = 0; k < 3; k++)
            brightest = fmax(brightest, value(s, i, 1, 0)[k]);
    return 0.9 / brightest;
}

/* A colour over the background, by the share of the pixel that the disc covers. */
static void put(lobe_canvas *sheet, int left, int top, const lobe_shaded *s, int i, const unsigned char rgb[3])
{
    const double radius = s->diameter / 2.0, r = radius * hypot(s->point[2 * i], s->point[2 * i + 1]);
    const double share = fmin(1, fmax(0, radius - r + 0.5));
    unsigned char out[3];
    for (int k = 0; k < 3; k++)
        out[k] = (unsigned char)(share * rgb[k] + (1 - share) * lobe_tone_background[k] + 0.5);
    lobe_canvas_pixel(sheet, left + s->pixel[2 * i], top + s->pixel[2 * i + 1], out);
}

static void draw_sphere(lobe_canvas *sheet, int left, int top, const lobe_shaded *s, int r, int c, double exposure)
{
    for (int i = 0; i < s->count; i++) {
        unsigned char rgb[3];
        lobe_tone_colour(value(s, i, r, c), exposure, rgb);
        put(sheet, left, top, s, i, rgb);
    }
}

static void draw_difference(lobe_canvas *sheet, int left, int top, const lobe_shaded *s, int r, int c, double exposure)
{
    double error = 0, square = 0;
    char text[16];
    for (int i = 0; i < s->count; i++) {
        const double *truth = value(s, i, r, 0), *v = value(s, i, r, c);
        const double d = 10 * exposure * (lobe_tone_luminance(v) - lobe_tone_luminance(truth));
        unsigned char rgb[3];
        for (int k = 0; k < 3; k++) {
            error += (v[k] - truth[k]) * (v[k] - truth[k]);
            square += truth[k] * truth[k];
        }
        lobe_tone_difference(d, rgb);
        put(sheet, left, top, s, i, rgb);
    }
    snprintf(text, sizeof text, "%.2f %%", square > 0 ? 100 * sqrt(error / square) : 0);
    centred(sheet, left + s->diameter / 2, top + s->diameter + 4, 2, text, lobe_tone_grey);
}

/* The map with the spheres' exposure, by nearest texel: it only says where the light is. */
static void draw_map(lobe_canvas *sheet, int left, int top, int width, const lobe_environment *map, double exposure)
{
    for (int j = 0; j < width / 2; j++)
        for (int i = 0; i < width; i++) {
            const int row = (2 * j + 1) * map->height / width, column = (2 * i + 1) * map->width / (2 * width);
            const float *t = map->rgb + 3 * ((size_t)row * (size_t)map->width + (size_t)column);
            const double light[3] = {(double)t[0], (double)t[1], (double)t[2]};
            unsigned char rgb[3];
            lobe_tone_colour(light, exposure, rgb);
            lobe_canvas_pixel(sheet, left + i, top + j, rgb);
        }
}

void lobe_sheet_draw(lobe_canvas *sheet, int index, const lobe_scene *scene, const lobe_shaded *s)
{
    const double exposure = exposure_of(s);
    const int top = MARGIN + TITLE + HEADINGS + index * block(s->diameter);
    lobe_canvas_text(sheet, MARGIN, top, 2, scene->name, lobe_tone_white);
    if (scene->own)
        draw_map(sheet, MARGIN, top + 22, PANEL - 48, &scene->small, exposure);
    lobe_canvas_text(sheet, MARGIN, top + 12 + PANEL / 2, 2, scene->have_sun ? "sun: punctual" : "no sun",
                     lobe_tone_grey);
    lobe_canvas_text(sheet, MARGIN, top + 32 + PANEL / 2, 2, scene->have_sun ? "rest: nine SH" : "all: nine SH",
                     lobe_tone_grey);
    for (int r = 0; r < LOBE_PICTURE_ROUGHNESSES; r++) {
        const int y = top + r * (s->diameter + CAPTION);
        char text[16];
        snprintf(text, sizeof text, "%g", lobe_picture_roughness[r]);
        lobe_canvas_text(sheet, MARGIN + PANEL, y + s->diameter / 2 - 18, 2, "roughness", lobe_tone_grey);
        lobe_canvas_text(sheet, MARGIN + PANEL, y + s->diameter / 2 + 2, 2, text, lobe_tone_white);
        for (int c = 0; c < LOBE_PICTURE_COLUMNS; c++)
            draw_sphere(sheet, first_sphere() + c * pitch(s->diameter), y, s, r, c, exposure);
        for (int c = 1; c < LOBE_PICTURE_COLUMNS; c++)
            draw_difference(sheet, first_difference(s->diameter) + (c - 1) * pitch(s->diameter), y, s, r, c, exposure);
    }
}
