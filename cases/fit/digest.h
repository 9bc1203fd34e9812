/* FNV-1a, 64 bit: the digest in the head of vectors and generated headers. It finds accidents, not attacks. */
#ifndef LOBE_DIGEST_H
#define LOBE_DIGEST_H
#include <stddef.h>
#include <stdint.h>

#define LOBE_DIGEST_START UINT64_C(0xcbf29ce484222325)

/* Continues digest (LOBE_DIGEST_START at first) over length bytes. */
uint64_t lobe_digest(uint64_t digest, const void *bytes, size_t length);

#endif
