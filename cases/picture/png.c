#include "png.h"
#include "../fit/atomic_file.h"
#include "deflate.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint32_t crc(uint32_t c, const unsigned char *data, size_t size)
{
    for (size_t i = 0; i < size; i++) {
        c ^= data[i];
        for (int k = 0; k < 8; k++)
            c = c & 1 ? 0xedb88320u ^ c >> 1 : c >> 1;
    }
    return c;
}

static void put_word(FILE *f, uint32_t x)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        putc((int)(x >> shift & 255), f);
}

static void put_chunk(FILE *f, const char *name, const unsigned char *data, size_t size)
{
    const uint32_t c = crc(0xffffffffu, (const unsigned char *)name, 4);
    put_word(f, (uint32_t)size);
    fwrite(name, 1, 4, f);
    if (size)
        fwrite(data, 1, size, f);
    put_word(f, ~crc(c, data, size));
}

static int paeth(int a, int b, int c)
{
    const int pa = abs(b - c), pb = abs(a - c), pc = abs(a + b - 2 * c);
    return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

/* One row less its prediction: none, left, above, their mean, Paeth. Returns the sum of the differences' sizes. */
static long filter(int type, const unsigned char *row, const unsigned char *above, int bytes, unsigned char *out)
{
    long sum = 0;
    for (int i = 0; i < bytes; i++) {
        const int a = i < 3 ? 0 : row[i - 3], b = above[i], c = i < 3 ? 0 : above[i - 3];
        const int p = type == 0 ? 0 : type == 1 ? a : type == 2 ? b : type == 3 ? (a + b) / 2 : paeth(a, b, c);
        out[i] = (unsigned char)(row[i] - p);
        sum += out[i] < 128 ? out[i] : 256 - out[i];
    }
    return sum;
}

/* The rows, each with the filter that leaves the smallest differences. */
static unsigned char *filtered(const lobe_canvas *canvas, size_t *size)
{
    const int bytes = 3 * canvas->width;
    const size_t stride = (size_t)bytes + 1;
    unsigned char *all = malloc(stride * (size_t)canvas->height), *spare = calloc(2, (size_t)bytes);
    *size = stride * (size_t)canvas->height;
    for (int y = 0; all && spare && y < canvas->height; y++) {
        const unsigned char *row = canvas->rgb + (size_t)bytes * (size_t)y;
        const unsigned char *above = y ? row - bytes : spare + bytes;
        unsigned char *out = all + stride * (size_t)y;
        long least = -1;
        for (int type = 0; type < 5; type++) {
            const long sum = filter(type, row, above, bytes, spare);
            if (least < 0 || sum < least) {
                least = sum;
                out[0] = (unsigned char)type;
                memcpy(out + 1, spare, (size_t)bytes);
            }
        }
    }
    if (!spare) {
        free(all);
        all = NULL;
    }
    free(spare);
    return all;
}

int lobe_png_write(const lobe_canvas *canvas, const char *path)
{
    const uint32_t w = (uint32_t)canvas->width, h = (uint32_t)canvas->height;
    const unsigned char head[13] = {(unsigned char)(w >> 24),
                                    (unsigned char)(w >> 16),
                                    (unsigned char)(w >> 8),
                                    (unsigned char)w,
                                    (unsigned char)(h >> 24),
                                    (unsigned char)(h >> 16),
                                    (unsigned char)(h >> 8),
                                    (unsigned char)h,
                                    8,
                                    2,
                                    0,
                                    0,
                                    0};
    static const unsigned char srgb = 0; /* perceptual */
    lobe_bytes packed = {NULL, 0, 0, 0};
    lobe_atomic_file file;
    size_t size;
    unsigned char *rows = filtered(canvas, &size);
    if (rows)
        lobe_deflate(rows, size, &packed);
    free(rows);
    if (!rows || packed.failed) {
        fprintf(stderr, "%s: not enough memory for a picture of %d x %d\n", path, canvas->width, canvas->height);
        free(packed.data);
        return 0;
    }
    int good = lobe_atomic_open(&file, path);
    if (good) {
        fwrite("\x89PNG\r\n\x1a\n", 1, 8, file.stream);
        put_chunk(file.stream, "IHDR", head, sizeof head);
        put_chunk(file.stream, "sRGB", &srgb, 1);
        put_chunk(file.stream, "IDAT", packed.data, packed.size);
        put_chunk(file.stream, "IEND", NULL, 0);
        good = lobe_atomic_commit(&file);
    }
    free(packed.data);
    return good;
}
