/* Radiance's RGBE pictures: flat, old run lengths and new run lengths.
 *
 * A texel (r, g, b, e) is (r, g, b) 2^(e - 136), 0 where e = 0: the reading of most loaders. Radiance itself adds half
 * a unit; a file that holds 1.0 as 128, 128, 128, 129 then reads 1.0039. */
#include "environment.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LINE 256

typedef struct cursor {
    const unsigned char *bytes;
    size_t size, at;
    lobe_environment_fault *fault;
} cursor;

/* What a message may show of a line: its first characters, the unprintable ones as dots. */
static const char *shown(const char *text, char out[41])
{
    size_t n = 0;
    for (; n < 40 && text[n]; n++)
        out[n] = text[n] < ' ' || text[n] > '~' ? '.' : text[n];
    out[n] = 0;
    return out;
}

/* The next line without its end; 0 where the file ends first or the line is longer than any header line is. */
static int line(cursor *c, char text[LINE])
{
    size_t n = 0;
    while (c->at < c->size && c->bytes[c->at] != '\n') {
        if (c->bytes[c->at] == 0)
            return lobe_environment_refuse(c->fault, c->at, "found a zero byte in the header, expected text");
        if (n == LINE - 1)
            return lobe_environment_refuse(c->fault, c->at, "found a header line of more than %d bytes, expected less",
                                           LINE - 1);
        text[n++] = (char)c->bytes[c->at++];
    }
    if (c->at == c->size)
        return lobe_environment_refuse(c->fault, c->at,
                                       "found the end of the file in the header, expected the rest of it");
    c->at++;
    if (n && text[n - 1] == '\r')
        n--;
    text[n] = 0;
    return 1;
}

/* One line between the first and the empty one: 0 after a refusal. */
static int setting(cursor *c, size_t start, const char *text, int *format, double *scale)
{
    char quote[41];
    double value;
    if (strncmp(text, "FORMAT=", 7) == 0) {
        if (strcmp(text + 7, "32-bit_rle_rgbe") != 0)
            return lobe_environment_refuse(c->fault, start, "found '%s', expected FORMAT=32-bit_rle_rgbe",
                                           shown(text, quote));
        *format = 1;
    } else if (strncmp(text, "EXPOSURE=", 9) == 0) {
        if (sscanf(text + 9, "%lf", &value) != 1 || !(value > 1e-12 && value < 1e12))
            return lobe_environment_refuse(c->fault, start, "found '%s', expected a number in (1e-12, 1e12)",
                                           shown(text, quote));
        *scale /= value; /* several lines multiply */
        if (!(*scale > 1e-24 && *scale < 1e24))
            return lobe_environment_refuse(
                c->fault, start, "found EXPOSURE lines with the product %g, expected one in (1e-24, 1e24)", 1 / *scale);
    }
    return 1;
}

static int header(cursor *c, int *width, int *height, double *scale)
{
    char text[LINE], quote[41], extra;
    int format = 0;
    size_t start = 0;
    if (!line(c, text))
        return 0;
    if (strncmp(text, "#?", 2) != 0)
        return lobe_environment_refuse(c->fault, 0, "found '%s', expected #? at the start", shown(text, quote));
    *scale = 1;
    for (;;) {
        start = c->at;
        if (!line(c, text))
            return 0;
        if (text[0] == 0)
            break;
        if (!setting(c, start, text, &format, scale))
            return 0;
    }
    if (!format)
        return lobe_environment_refuse(c->fault, start,
                                       "found the header's end, expected FORMAT=32-bit_rle_rgbe before it");
    start = c->at;
    if (!line(c, text))
        return 0;
    if (sscanf(text, "-Y %d +X %d %c", height, width, &extra) != 2)
        return lobe_environment_refuse(c->fault, start, "found '%s', expected -Y height +X width", shown(text, quote));
    if (*width < 1 || *height < 1 || *width > LOBE_ENVIRONMENT_MAX_SIDE || *height > LOBE_ENVIRONMENT_MAX_SIDE ||
        *width > LOBE_ENVIRONMENT_MAX_TEXELS / *height)
        return lobe_environment_refuse(c->fault, start,
                                       "found %d x %d texels, expected sides in [1, %d] and at most %d texels", *width,
                                       *height, LOBE_ENVIRONMENT_MAX_SIDE, LOBE_ENVIRONMENT_MAX_TEXELS);
    return 1;
}

static int row_is_cut(cursor *c, int row, int height)
{
    return lobe_environment_refuse(c->fault, c->size, "found the end of the file in row %d, expected %d rows", row,
                                   height);
}

static int bad_run(cursor *c, size_t start, long found, int room)
{
    return lobe_environment_refuse(c->fault, start, "found a run of %ld texels, expected 1 to %d", found, room);
}

/* New run lengths: four planes of one row, each in runs (count > 128) and copies. */
static int row_of_planes(cursor *c, unsigned char *row, int width, int y, int height)
{
    c->at += 4;
    for (int plane = 0; plane < 4; plane++) {
        int x = 0;
        while (x < width) {
            if (c->size - c->at < 2)
                return row_is_cut(c, y, height);
            const size_t start = c->at;
            int count = c->bytes[c->at++];
            const int run = count > 128;
            count -= run ? 128 : 0;
            if (count == 0 || count > width - x)
                return bad_run(c, start, count, width - x);
            if (!run && (size_t)count > c->size - c->at)
                return row_is_cut(c, y, height);
            for (int i = 0; i < count; i++)
                row[4 * (x + i) + plane] = c->bytes[run ? c->at : c->at + (size_t)i];
            c->at += run ? 1 : (size_t)count;
            x += count;
        }
    }
    return 1;
}

/* Flat texels; 1, 1, 1, n repeats the texel before n times, and again by 256 n if it follows such a one. */
static int row_of_texels(cursor *c, unsigned char *row, int width, int y, int height)
{
    int x = 0, shift = 0;
    while (x < width) {
        const size_t start = c->at;
        const unsigned char *p = c->bytes + c->at;
        if (c->size - c->at < 4)
            return row_is_cut(c, y, height);
        c->at += 4;
        if (p[0] == 1 && p[1] == 1 && p[2] == 1) {
            const long count = shift > 16 ? (long)width + 1 : (long)p[3] << shift;
            if (x == 0)
                return lobe_environment_refuse(c->fault, start,
                                               "found a repeat at the start of row %d, expected a texel", y);
            if (count > width - x)
                return bad_run(c, start, count, width - x);
            for (long i = 0; i < count; i++, x++)
                memcpy(row + 4 * x, row + 4 * (x - 1), 4);
            shift += 8;
        } else {
            memcpy(row + 4 * x, p, 4);
            x++;
            shift = 0;
        }
    }
    return 1;
}

/* Reads one row; which of the spellings it has stands in its first bytes. */
static int read_row(cursor *c, unsigned char *row, int width, int y, int height)
{
    const unsigned char *p = c->bytes + c->at;
    if (!(width >= 8 && width < 32768 && c->size - c->at >= 4 && p[0] == 2 && p[1] == 2 && p[2] < 128))
        return row_of_texels(c, row, width, y, height);
    if ((p[2] << 8 | p[3]) != width)
        return lobe_environment_refuse(c->fault, c->at + 2, "found a row of %d texels, expected %d", p[2] << 8 | p[3],
                                       width);
    return row_of_planes(c, row, width, y, height);
}

int lobe_environment_from_rgbe(const unsigned char *bytes, size_t size, lobe_environment *map,
                               lobe_environment_fault *fault)
{
    cursor c = {bytes, size, 0, fault};
    int width = 0, height = 0, good = 1;
    double scale = 1;
    if (!header(&c, &width, &height, &scale))
        return 0;
    /* A row takes 4 bytes at least, so that a small file cannot ask for a big map. */
    if ((size - c.at) / 4 < (size_t)height)
        return lobe_environment_refuse(fault, size,
                                       "found the end of the file %zu bytes after the header, "
                                       "expected %d rows",
                                       size - c.at, height);
    unsigned char *row = malloc(4 * (size_t)width);
    if (!row || !lobe_environment_allocate(map, width, height)) {
        free(row);
        return lobe_environment_refuse(fault, c.at, "found %d x %d texels, expected a map that fits into memory", width,
                                       height);
    }
    for (int y = 0; y < height && good; y++) {
        good = read_row(&c, row, width, y, height);
        for (int x = 0; x < width && good; x++) {
            const unsigned char *p = row + 4 * x;
            const double unit = p[3] ? ldexp(scale, p[3] - 136) : 0;
            float *out = map->rgb + 3 * ((size_t)y * (size_t)width + (size_t)x);
            for (int k = 0; k < 3; k++) {
                const double value = p[k] * unit;
                out[k] = (float)(value < 3e38 ? value : 3e38);
            }
        }
    }
    free(row);
    if (!good)
        lobe_environment_free(map);
    return good;
}
