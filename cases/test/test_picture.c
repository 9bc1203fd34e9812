/* The picture's file format: what the compressor writes is read back by an inflater written here, and a PNG gives back
 * the canvas it was made of. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../picture/deflate.h"
#include "../picture/huffman.h"
#include "../picture/png.h"

/* A reader of RFC 1951, dynamic blocks only, slow and strict: a code must be complete. */
typedef struct reader {
    const unsigned char *data;
    size_t size, at;
    int bit;
} reader;

static unsigned bits(reader *r, int n)
{
    unsigned x = 0;
    for (int i = 0; i < n; i++) {
        assert_true(r->at < r->size);
        x |= (unsigned)(r->data[r->at] >> r->bit & 1) << i;
        if (++r->bit == 8) {
            r->bit = 0;
            r->at++;
        }
    }
    return x;
}

static int symbol(reader *r, const unsigned char *length, int n)
{
    int code = 0, first = 0;
    for (int l = 1; l <= 15; l++) {
        int count = 0;
        code |= (int)bits(r, 1);
        for (int i = 0; i < n; i++)
            count += length[i] == l;
        if (code - first < count) {
            int left = code - first;
            for (int i = 0; i < n; i++)
                if (length[i] == l && left-- == 0)
                    return i;
        }
        first = (first + count) << 1;
        code <<= 1;
    }
    fail_msg("no such code");
    return -1;
}

static void complete(const unsigned char *length, int n)
{
    unsigned used = 0;
    for (int i = 0; i < n; i++)
        used += length[i] ? 1u << (15 - length[i]) : 0;
    assert_int_equal(used, 1 << 15);
}

static void read_lengths(reader *r, unsigned char *length, int n)
{
    static const int order[19] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    unsigned char meta[19] = {0};
    const unsigned codes = bits(r, 4) + 4;
    for (unsigned i = 0; i < codes; i++)
        meta[order[i]] = (unsigned char)bits(r, 3);
    complete(meta, 19);
    for (int i = 0; i < n;) {
        const int s = symbol(r, meta, 19);
        const int run = s == 16   ? 3 + (int)bits(r, 2)
                        : s == 17 ? 3 + (int)bits(r, 3)
                        : s == 18 ? 11 + (int)bits(r, 7)
                                  : 1;
        assert_true(i + run <= n && (s != 16 || i > 0));
        for (int k = 0; k < run; k++, i++)
            length[i] = (unsigned char)(s == 16 ? length[i - 1] : s > 16 ? 0 : s);
    }
}

static uint32_t word(const unsigned char *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | (uint32_t)p[3];
}

/* RFC 1951's tables. */
static const unsigned short length_base[29] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                               31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
static const unsigned char length_extra[29] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                               2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
static const unsigned short distance_base[30] = {1,    2,    3,    4,    5,    7,    9,    13,    17,    25,
                                                 33,   49,   65,   97,   129,  193,  257,  385,   513,   769,
                                                 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};

static void inflate(const unsigned char *data, size_t size, unsigned char *out, size_t expected)
{
    reader r = {data, size, 2, 0};
    size_t n = 0;
    int last = 0;
    assert_true(data[0] == 0x78 && (data[0] * 256 + data[1]) % 31 == 0);
    while (!last) {
        unsigned char length[288 + 32] = {0};
        last = (int)bits(&r, 1);
        assert_int_equal(bits(&r, 2), 2);
        const int literals = 257 + (int)bits(&r, 5), distances = 1 + (int)bits(&r, 5);
        read_lengths(&r, length, literals + distances);
        complete(length, literals);
        complete(length + literals, distances);
        for (int s; (s = symbol(&r, length, literals)) != 256;) {
            if (s < 256) {
                assert_true(n < expected);
                out[n++] = (unsigned char)s;
                continue;
            }
            const size_t run = length_base[s - 257] + bits(&r, length_extra[s - 257]);
            const int d = symbol(&r, length + literals, distances);
            const size_t back = distance_base[d] + bits(&r, d < 4 ? 0 : d / 2 - 1);
            assert_true(back <= n && n + run <= expected);
            for (size_t i = 0; i < run; i++, n++)
                out[n] = out[n - back];
        }
    }
    assert_int_equal(n, expected);
    if (r.bit)
        r.at++;
    uint32_t a = 1, b = 0;
    for (size_t i = 0; i < n; i++) {
        a = (a + out[i]) % 65521;
        b = (b + a) % 65521;
    }
    assert_int_equal(size - r.at, 4);
    assert_int_equal(word(data + r.at), b << 16 | a);
}

static void there_and_back(const unsigned char *data, size_t size, size_t most)
{
    lobe_bytes packed = {NULL, 0, 0, 0};
    unsigned char *back = malloc(size + 1);
    lobe_deflate(data, size, &packed);
    assert_false(packed.failed);
    assert_true(packed.size <= most);
    inflate(packed.data, packed.size, back, size);
    assert_memory_equal(back, data, size);
    free(packed.data);
    free(back);
}

static void compressor(void **state)
{
    (void)state;
    enum { N = 200000 };
    unsigned char *data = malloc(N);
    uint32_t x = 1;
    there_and_back((const unsigned char *)"", 0, 200);
    there_and_back((const unsigned char *)"a", 1, 200);
    there_and_back((const unsigned char *)"aaaa", 4, 200);
    memset(data, 7, N);
    there_and_back(data, N, N / 500);
    for (int i = 0; i < N; i++) {
        x = x * 1664525u + 1013904223u;
        data[i] = (unsigned char)(x >> 24);
    }
    there_and_back(data, N, N + N / 100);
    for (int i = 0; i < N; i++) /* texts of every length and distance */
        data[i] = i < 40000 ? data[i] : data[i - 1 - (i / 300 * 7919) % 32000];
    there_and_back(data, N, N / 2);
    for (int i = 0; i < N; i++)
        data[i] = (unsigned char)(i % 5 == 0 ? i / 1000 : 0);
    there_and_back(data, N, N / 10);
    free(data);
}

/* Counts like Fibonacci's numbers want codes as long as there are symbols; 15 bits are all there is. */
static void limited_lengths(void **state)
{
    (void)state;
    unsigned count[30] = {1, 1};
    unsigned char length[30];
    for (int i = 2; i < 30; i++)
        count[i] = count[i - 1] + count[i - 2];
    lobe_huffman_lengths(count, 30, 15, length);
    complete(length, 30);
    assert_true(length[29] < length[0] && length[0] <= 15);
    lobe_huffman_lengths(count, 19, 7, length);
    for (int i = 0; i < 19; i++)
        assert_in_range(length[i], 1, 7);
    memset(count, 0, sizeof count);
    count[4] = 9;
    lobe_huffman_lengths(count, 30, 15, length);
    complete(length, 30); /* a lone symbol gets a neighbour */
}

static int paeth(int a, int b, int c)
{
    const int p = a + b - c, pa = abs(p - a), pb = abs(p - b), pc = abs(p - c);
    return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

static const char *program; /* the picture lies beside it */

static void png(void **state)
{
    (void)state;
    enum { W = 61, H = 43 };
    static const unsigned char grey[3] = {30, 40, 50}, red[3] = {255, 0, 9};
    static unsigned char file[1 << 16], rows[H * (3 * W + 1)];
    char path[4096];
    lobe_canvas canvas;
    assert_true(lobe_canvas_allocate(&canvas, W, H, grey));
    lobe_canvas_text(&canvas, 3, 20, 2, "Az 9%", red);
    lobe_canvas_text(&canvas, W - 4, H - 4, 2, "out", red); /* cut at the edge */
    for (int i = 0; i < W * 15; i++)
        canvas.rgb[3 * i] = (unsigned char)(i * i / 7);
    snprintf(path, sizeof path, "%s.png", program);
    assert_true(lobe_png_write(&canvas, path));
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    const size_t size = fread(file, 1, sizeof file, f);
    fclose(f);
    remove(path);
    assert_memory_equal(file, "\x89PNG\r\n\x1a\n", 8);
    for (size_t at = 8; at < size; at += 12 + word(file + at)) {
        const uint32_t n = word(file + at);
        uint32_t c = 0xffffffffu;
        for (uint32_t i = 0; i < n + 4; i++)
            for (int k = 0; k < 8; k++)
                c = c >> 1 ^ (((c ^ (uint32_t)file[at + 4 + i] >> k) & 1) ? 0xedb88320u : 0);
        assert_int_equal(~c, word(file + at + 8 + n));
        if (memcmp(file + at + 4, "IHDR", 4) == 0)
            assert_true(word(file + at + 8) == W && word(file + at + 12) == H);
        if (memcmp(file + at + 4, "IDAT", 4) == 0)
            inflate(file + at + 8, n, rows, sizeof rows);
    }
    for (int y = 0; y < H; y++) {
        unsigned char *row = rows + y * (3 * W + 1) + 1;
        for (int i = 0; i < 3 * W; i++) {
            const int a = i < 3 ? 0 : row[i - 3], b = y ? row[i - 3 * W - 1] : 0,
                      d = i < 3 || !y ? 0 : row[i - 3 * W - 4];
            const int type = row[-1];
            assert_in_range(type, 0, 4);
            row[i] = (unsigned char)(row[i] + (type == 0   ? 0
                                               : type == 1 ? a
                                               : type == 2 ? b
                                               : type == 3 ? (a + b) / 2
                                                           : paeth(a, b, d)));
        }
        assert_memory_equal(row, canvas.rgb + 3 * W * y, 3 * W);
    }
    lobe_canvas_free(&canvas);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(compressor), cmocka_unit_test(limited_lengths),
                                       cmocka_unit_test(png)};
    program = argc ? argv[0] : "test_picture";
    return cmocka_run_group_tests_name("picture", tests, NULL, NULL);
}
