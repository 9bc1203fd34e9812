#include "hash.h"

enum { SPECIALS = 16 };

/* 0, -0, the least denormal, the least normal, 2^-24, .02, .5, the neighbours of 1, 2, -1, the largest
 * of both signs, the infinities, a NaN. */
static const uint32_t special_f32[SPECIALS] = {
    0x00000000, 0x80000000, 0x00000001, 0x00800000, 0x33800000, 0x3ca3d70a, 0x3f000000, 0x3f7fffff,
    0x3f800000, 0x3f800001, 0x40000000, 0xbf800000, 0x7f7fffff, 0xff7fffff, 0x7f800000, 0x7fc00000,
};
/* The same places in q30, with the two ends of the range. */
static const uint32_t special_q30[SPECIALS] = {
    0x00000000, 0xffffffff, 0x00000001, 0x00000002, 0x00000040, 0x0147ae14, 0x20000000, 0x3fffffff,
    0x40000000, 0x40000001, 0x60000000, 0xc0000000, 0x7fffffff, 0x80000000, 0x80000001, 0x7ffffffe,
};

uint64_t lobe_fnv1a(uint64_t hash, const void *bytes, size_t length)
{
    const unsigned char *b = bytes;
    size_t i;
    for (i = 0; i < length; i++)
        hash = (hash ^ b[i]) * LOBE_FNV_PRIME;
    return hash;
}

uint64_t lobe_fnv1a_word(uint64_t hash, uint32_t word)
{
    int i;
    for (i = 0; i < 4; i++)
        hash = (hash ^ (word >> 8 * i & 255u)) * LOBE_FNV_PRIME;
    return hash;
}

/* splitmix64 at a counter (Steele, Lea, Flood 2014): random access, integers only. */
static uint64_t mix(uint64_t counter)
{
    uint64_t z = (counter + 1) * UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

void lobe_hash_inputs(const lobe_entry *entry, uint32_t i, lobe_value *in)
{
    const int q30 = entry->format == LOBE_Q30;
    /* 5 was the most inputs once, and committed hashes stay */
    const uint64_t stride = entry->inputs <= 5 ? 5 : 16;
    int k;
    for (k = 0; k < entry->inputs; k++) {
        const uint64_t r = mix((uint64_t)i * stride + (uint64_t)k);
        const int both = entry->ranges[k].least < 0.0; /* signs */
        uint32_t unit = (uint32_t)(r >> 40);           /* [0, 2^24) */
        if (i < SPECIALS * SPECIALS) {
            const uint32_t which = k == 0 ? i / SPECIALS : k == 1 ? i % SPECIALS : unit % SPECIALS;
            in[k].bits = q30 ? special_q30[which] : special_f32[which];
        } else if (i % 16 == 15) {
            in[k].bits = (uint32_t)r;
        } else {
            unit >>= i % 16 == 14 ? r % 24 : 0;
            if (q30)
                in[k].q = (int32_t)(unit << 6);
            else
                in[k].f = (float)unit * 0x1p-24f;
            if (both && (r >> 32 & 1u)) { /* a bit that no other choice hangs on */
                in[k].q = q30 ? -in[k].q : in[k].q;
                in[k].bits ^= q30 ? 0u : 0x80000000u;
            }
        }
    }
}

uint64_t lobe_hash_entry(const lobe_entry *entry, uint32_t count)
{
    uint64_t hash = LOBE_FNV_START;
    uint32_t i;
    for (i = 0; i < count; i++) {
        lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
        int k;
        lobe_hash_inputs(entry, i, in);
        entry->call(in, out);
        for (k = 0; k < entry->outputs; k++)
            hash = lobe_fnv1a_word(hash, out[k].bits);
    }
    return hash;
}
