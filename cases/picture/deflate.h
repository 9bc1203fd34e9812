/* A small compressor for pictures: zlib's format (RFC 1950 and 1951), matches by hash chains, Huffman codes of its own
 * for each block. About as tight as zlib, a tenth of its size, and the same bytes everywhere. */
#ifndef LOBE_PICTURE_DEFLATE_H
#define LOBE_PICTURE_DEFLATE_H
#include <stddef.h>

typedef struct lobe_bytes {
    unsigned char *data; /* malloc; the caller frees it */
    size_t size, room;
    int failed; /* memory ran out: what is here is not whole */
} lobe_bytes;

void lobe_bytes_add(lobe_bytes *bytes, unsigned char byte);

/* Appends the compressed data; see failed. */
void lobe_deflate(const unsigned char *data, size_t size, lobe_bytes *out);

#endif
