#include "deflate.h"
#include "huffman.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
    BLOCK = 1 << 13, /* symbols a block: codes follow the picture without costing much */
    WINDOW = 1 << 15,
    HASHES = 1 << 15,
    CHAIN = 1024, /* candidates looked at: pictures of like things gain a tenth by it */
    SHORTEST = 3,
    LONGEST = 258,
    END = 256,
    LITERALS = 286,
    DISTANCES = 30,
    LENGTH_CODES = 19
};

void lobe_bytes_add(lobe_bytes *bytes, unsigned char byte)
{
    if (bytes->size == bytes->room) {
        const size_t room = bytes->room ? 2 * bytes->room : 4096;
        unsigned char *more = bytes->failed ? NULL : realloc(bytes->data, room);
        if (!more) {
            bytes->failed = 1;
            return;
        }
        bytes->data = more;
        bytes->room = room;
    }
    bytes->data[bytes->size++] = byte;
}

/* A literal has distance 0. */
typedef struct symbol {
    unsigned short value, distance; /* literal or length; 1 .. 32767 */
} symbol;

typedef struct writer {
    lobe_bytes *out;
    uint32_t held;
    int bits;
} writer;

static void put(writer *w, unsigned value, int bits)
{
    w->held |= value << w->bits;
    for (w->bits += bits; w->bits >= 8; w->bits -= 8, w->held >>= 8)
        lobe_bytes_add(w->out, (unsigned char)(w->held & 255));
}

/* The code of a length (3 .. 258) or a distance (1 .. 32768), its extra bits and their number. RFC 1951, 3.2.5: each
 * doubling of the range has `steps` codes. */
static unsigned ranged(unsigned value, unsigned first, unsigned steps, unsigned *extra, int *bits)
{
    unsigned code = 0, base = first;
    for (int b = 0;; b++)
        for (unsigned i = 0; i < (b == 0 ? 2 * steps : steps); i++, code++, base += 1u << b)
            if (value < base + (1u << b)) {
                *extra = value - base;
                *bits = b;
                return code;
            }
}

static unsigned length_code(unsigned length, unsigned *extra, int *bits)
{
    if (length == LONGEST) {
        *extra = 0;
        *bits = 0;
        return 285;
    }
    return 257 + ranged(length, 3, 4, extra, bits);
}

static unsigned distance_code(unsigned distance, unsigned *extra, int *bits)
{
    return ranged(distance, 1, 2, extra, bits);
}

/* Writes the lengths of both codes, themselves coded; zeros in runs. */
static void put_lengths(writer *w, const unsigned char *length, int n)
{
    static const unsigned char order[LENGTH_CODES] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    unsigned char value[LITERALS + DISTANCES], run[LITERALS + DISTANCES], code_length[LENGTH_CODES];
    unsigned short code[LENGTH_CODES];
    unsigned count[LENGTH_CODES] = {0};
    int items = 0, codes = LENGTH_CODES;
    for (int i = 0; i < n;) {
        int zeros = 0;
        while (i + zeros < n && zeros < 138 && length[i + zeros] == 0)
            zeros++;
        value[items] = zeros > 10 ? 18 : zeros > 2 ? 17 : length[i];
        run[items] = (unsigned char)(zeros > 2 ? zeros : 1);
        count[value[items]]++;
        i += run[items++];
    }
    lobe_huffman_lengths(count, LENGTH_CODES, 7, code_length);
    lobe_huffman_codes(code_length, LENGTH_CODES, code);
    while (codes > 4 && code_length[order[codes - 1]] == 0)
        codes--;
    put(w, (unsigned)codes - 4, 4);
    for (int i = 0; i < codes; i++)
        put(w, code_length[order[i]], 3);
    for (int i = 0; i < items; i++) {
        put(w, code[value[i]], code_length[value[i]]);
        if (value[i] == 17)
            put(w, (unsigned)run[i] - 3, 3);
        else if (value[i] == 18)
            put(w, (unsigned)run[i] - 11, 7);
    }
}

static void put_block(writer *w, const symbol *symbols, int n, int last)
{
    unsigned count[LITERALS] = {0}, distances[DISTANCES] = {0}, extra = 0;
    unsigned char length[LITERALS + DISTANCES];
    unsigned short code[LITERALS], distance[DISTANCES];
    int bits = 0;
    count[END] = 1;
    for (int i = 0; i < n; i++) {
        count[symbols[i].distance ? length_code(symbols[i].value, &extra, &bits) : symbols[i].value]++;
        if (symbols[i].distance)
            distances[distance_code(symbols[i].distance, &extra, &bits)]++;
    }
    lobe_huffman_lengths(count, LITERALS, 15, length);
    lobe_huffman_lengths(distances, DISTANCES, 15, length + LITERALS);
    lobe_huffman_codes(length, LITERALS, code);
    lobe_huffman_codes(length + LITERALS, DISTANCES, distance);
    put(w, (unsigned)last, 1);
    put(w, 2, 2); /* codes of its own */
    put(w, LITERALS - 257, 5);
    put(w, DISTANCES - 1, 5);
    put_lengths(w, length, LITERALS + DISTANCES);
    for (int i = 0; i < n; i++) {
        const unsigned s = symbols[i].distance ? length_code(symbols[i].value, &extra, &bits) : symbols[i].value;
        put(w, code[s], length[s]);
        if (symbols[i].distance) {
            put(w, extra, bits);
            const unsigned d = distance_code(symbols[i].distance, &extra, &bits);
            put(w, distance[d], length[LITERALS + d]);
            put(w, extra, bits);
        }
    }
    put(w, code[END], length[END]);
}

static unsigned hash(const unsigned char *p) { return ((unsigned)p[0] << 10 ^ (unsigned)p[1] << 5 ^ p[2]) % HASHES; }

/* The longest earlier text like that at `at`; 0 where none has three bytes. head and before hold positions + 1. */
static size_t find(const unsigned char *data, size_t size, size_t at, const size_t *head, const size_t *before,
                   size_t *distance)
{
    size_t best = SHORTEST - 1, most = size - at < LONGEST ? size - at : LONGEST;
    size_t next = most < SHORTEST ? 0 : head[hash(data + at)];
    for (int turn = 0; turn < CHAIN && next && at - (next - 1) < WINDOW; turn++) {
        const size_t from = next - 1;
        size_t n = 0;
        while (n < most && data[from + n] == data[at + n])
            n++;
        if (n > best) {
            best = n;
            *distance = at - from;
        }
        next = before[from % WINDOW];
    }
    return best < SHORTEST ? 0 : best;
}

static void put_adler(lobe_bytes *out, const unsigned char *data, size_t size)
{
    uint32_t a = 1, b = 0;
    for (size_t i = 0; i < size; i++) {
        a = (a + data[i]) % 65521;
        b = (b + a) % 65521;
    }
    for (int shift = 8; shift >= 0; shift -= 8)
        lobe_bytes_add(out, (unsigned char)(b >> shift & 255));
    for (int shift = 8; shift >= 0; shift -= 8)
        lobe_bytes_add(out, (unsigned char)(a >> shift & 255));
}

void lobe_deflate(const unsigned char *data, size_t size, lobe_bytes *out)
{
    size_t *head = calloc(HASHES + WINDOW, sizeof *head), *before = head + HASHES;
    symbol *symbols = malloc(BLOCK * sizeof *symbols);
    writer w = {out, 0, 0};
    int n = 0;
    if (!head || !symbols)
        out->failed = 1;
    lobe_bytes_add(out, 0x78);
    lobe_bytes_add(out, 0x9c);
    for (size_t at = 0; at < size && !out->failed;) {
        size_t distance = 0;
        const size_t length = find(data, size, at, head, before, &distance), step = length ? length : 1;
        symbols[n].value = (unsigned short)(length ? length : data[at]);
        symbols[n++].distance = (unsigned short)distance;
        for (size_t i = 0; i < step; i++, at++)
            if (size - at >= SHORTEST) {
                const unsigned h = hash(data + at);
                before[at % WINDOW] = head[h];
                head[h] = at + 1;
            }
        if (n == BLOCK && at < size) {
            put_block(&w, symbols, n, 0);
            n = 0;
        }
    }
    if (!out->failed)
        put_block(&w, symbols, n, 1);
    put(&w, 0, 7); /* to a whole byte */
    put_adler(out, data, size);
    free(head);
    free(symbols);
}
