/* One 64-bit number that is equal wherever an entry computes the same bits.
 * Inputs come from integers alone, so that no libm and no printf takes part. */
#ifndef LOBE_HASH_H
#define LOBE_HASH_H
#include "registry.h"

#define LOBE_FNV_START UINT64_C(0xcbf29ce484222325)
#define LOBE_FNV_PRIME UINT64_C(0x100000001b3)

/* Evaluations behind a committed hash. */
enum { LOBE_HASH_COUNT = 32768 };

/* FNV-1a, 64 bits, over length bytes; start with LOBE_FNV_START. */
uint64_t lobe_fnv1a(uint64_t hash, const void *bytes, size_t length);

/* The same over four bytes, the lowest first, whatever this machine's byte order. */
uint64_t lobe_fnv1a_word(uint64_t hash, uint32_t word);

/* The inputs of evaluation i: first every pair of special values, then three sorts in turn: 14 of 16
 * uniform on [0, 1], or [-1, 1] where that is the range, one of 16 near 0, one of 16 any 32 bits (NaN, infinities,
 * denormals, all integers). */
void lobe_hash_inputs(const lobe_entry *entry, uint32_t i, lobe_value *in);

/* FNV-1a over the outputs' bits of evaluations 0 to count - 1. */
uint64_t lobe_hash_entry(const lobe_entry *entry, uint32_t count);

#endif
