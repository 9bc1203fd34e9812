/* Huffman codes of limited length. */
#ifndef LOBE_PICTURE_HUFFMAN_H
#define LOBE_PICTURE_HUFFMAN_H

enum { LOBE_HUFFMAN_SYMBOLS = 288 };

/* Lengths of at most `limit` bits, 0 for symbols that do not occur; at least two symbols get a code, so that a decoder
 * finds it complete. n <= LOBE_HUFFMAN_SYMBOLS. */
void lobe_huffman_lengths(const unsigned *count, int n, int limit, unsigned char *length);

/* The canonical code of RFC 1951, 3.2.2, with its bits reversed, as deflate writes them. */
void lobe_huffman_codes(const unsigned char *length, int n, unsigned short *code);

#endif
