#include "huffman.h"
#include <string.h>

/* Joins the two rarest trees until one is left; the depth of a leaf is its length. Ties go to the lower index, so the
 * code depends on the counts alone. Quadratic, and n is 288. */
static int build(const unsigned *count, int n, unsigned char *length)
{
    unsigned weight[2 * LOBE_HUFFMAN_SYMBOLS];
    int parent[2 * LOBE_HUFFMAN_SYMBOLS], open[2 * LOBE_HUFFMAN_SYMBOLS], opens = 0, nodes = n, deepest = 0;
    for (int i = 0; i < n; i++) {
        weight[i] = count[i];
        if (count[i])
            open[opens++] = i;
    }
    while (opens > 1) {
        int pair[2];
        for (int p = 0; p < 2; p++) {
            int best = 0;
            for (int i = 1; i < opens; i++)
                if (weight[open[i]] < weight[open[best]])
                    best = i;
            pair[p] = open[best];
            open[best] = open[--opens];
        }
        weight[nodes] = weight[pair[0]] + weight[pair[1]];
        parent[pair[0]] = parent[pair[1]] = nodes;
        open[opens++] = nodes++;
    }
    parent[nodes - 1] = -1;
    for (int i = 0; i < n; i++) {
        int depth = 0;
        for (int k = i; count[i] && parent[k] >= 0; k = parent[k])
            depth++;
        length[i] = (unsigned char)depth;
        deepest = depth > deepest ? depth : deepest;
    }
    return deepest;
}

void lobe_huffman_lengths(const unsigned *count, int n, int limit, unsigned char *length)
{
    unsigned c[LOBE_HUFFMAN_SYMBOLS];
    int used = 0;
    memcpy(c, count, (size_t)n * sizeof *c);
    for (int i = 0; i < n; i++)
        used += c[i] != 0;
    for (int i = 0; i < n && used < 2; i++)
        if (!c[i]) {
            c[i] = 1;
            used++;
        }
    /* Flatter counts give shorter codes; a few turns suffice, and the loss is far below a per cent. */
    while (build(c, n, length) > limit)
        for (int i = 0; i < n; i++)
            c[i] = c[i] ? c[i] / 2 + 1 : 0;
}

void lobe_huffman_codes(const unsigned char *length, int n, unsigned short *code)
{
    unsigned next = 0;
    for (int bits = 1; bits <= 15; bits++, next <<= 1)
        for (int i = 0; i < n; i++)
            if (length[i] == bits) {
                unsigned reversed = 0;
                for (int b = 0; b < bits; b++)
                    reversed |= (next >> b & 1) << (bits - 1 - b);
                code[i] = (unsigned short)reversed;
                next++;
            }
}
