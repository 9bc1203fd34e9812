#include "random.h"

static uint64_t splitmix64(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

void lobe_random_seed(lobe_random *random, uint64_t seed, uint64_t stream)
{
    uint64_t a = seed, b = stream ^ UINT64_C(0xd1b54a32d192ed03);
    /* Two generators mixed, so that (seed, stream) and (stream, seed) differ. */
    for (int i = 0; i < 4; i++)
        random->s[i] = splitmix64(&a) ^ (splitmix64(&b) << 1);
    random->s[0] |= 1; /* the all-zero state is the one that never leaves */
}

static uint64_t rotate(uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

uint64_t lobe_random_bits(lobe_random *random)
{
    uint64_t *s = random->s;
    const uint64_t result = rotate(s[0] + s[3], 23) + s[0], t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = rotate(s[3], 45);
    return result;
}

double lobe_random_unit(lobe_random *random) { return (double)(lobe_random_bits(random) >> 11) * 0x1p-53; }

size_t lobe_random_below(lobe_random *random, size_t n)
{
    return (size_t)(((lobe_random_bits(random) >> 32) * (uint64_t)n) >> 32);
}

void lobe_random_latin(lobe_random *random, const double *lower, const double *upper, size_t dim, size_t count,
                       double *out)
{
    for (size_t k = 0; k < dim; k++) {
        for (size_t i = 0; i < count; i++)
            out[i * dim + k] = (double)i;
        for (size_t i = count; i > 1; i--) { /* Fisher-Yates */
            const size_t j = lobe_random_below(random, i);
            const double swap = out[(i - 1) * dim + k];
            out[(i - 1) * dim + k] = out[j * dim + k];
            out[j * dim + k] = swap;
        }
        for (size_t i = 0; i < count; i++) {
            const double u = (out[i * dim + k] + lobe_random_unit(random)) / (double)count;
            out[i * dim + k] = lower[k] + u * (upper[k] - lower[k]);
        }
    }
}
