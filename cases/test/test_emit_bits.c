/* Emitted C against the kernel that it came from: equal bits on random inputs and on special ones.
 * Compiled once a tier: HEADER and KERNEL name the kernel, EMITTED the emitted function, ENERGY where it has one
 * result, SH9 where it has nine. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include HEADER

#if defined(ENERGY)
void EMITTED(float roughness, float n_dot_v, float *energy);
#elif defined(SH9)
void EMITTED(float roughness, float n_dot_v, float *c0, float *c1, float *c2, float *c3, float *c4, float *c5,
             float *c6, float *c7, float *c8);
#else
void EMITTED(float roughness, float n_dot_v, float *scale, float *bias);
#endif

static long different;

static void at(float r, float v)
{
    float got[9] = {0.0f}, want[9] = {0.0f};
#if defined(ENERGY)
    EMITTED(r, v, &got[0]);
    want[0] = KERNEL(r, v);
#elif defined(SH9)
    const lobe_sh9 c = KERNEL(r, v);
    const float all[9] = {c.c0, c.c1, c.c2, c.c3, c.c4, c.c5, c.c6, c.c7, c.c8};
    memcpy(want, all, sizeof all);
    EMITTED(r, v, &got[0], &got[1], &got[2], &got[3], &got[4], &got[5], &got[6], &got[7], &got[8]);
#else
    const lobe_dfg d = KERNEL(r, v);
    EMITTED(r, v, &got[0], &got[1]);
    want[0] = d.scale;
    want[1] = d.bias;
#endif
    different += memcmp(got, want, sizeof got) != 0;
}

int main(void)
{
    const float special[] = {0.0f,     -0.0f,     1.0f,  -1.0f, 2.0f,
                             1e-45f,   1e-30f,    1e-6f, 1e30f, NAN,
                             INFINITY, -INFINITY, 0.5f,  0.02f, 0.999999940395355225f};
    const int specials = (int)(sizeof special / sizeof special[0]);
    unsigned state = 88172645u;
    float in[2];
    int i, k;
    for (i = 0; i < specials; i++)
        for (k = 0; k < specials; k++)
            at(special[i], special[k]);
    for (i = 0; i < 200000; i++) {
        for (k = 0; k < 2; k++) {
            state ^= state << 13, state ^= state >> 17, state ^= state << 5;
            in[k] = (float)(state >> 8) / 16777216.0f;
            if (i % 3 == k)
                in[k] *= in[k] * in[k] * in[k];
        }
        at(in[0], in[1]);
    }
    if (different)
        printf("# %ld of %d points differ\n", different, specials * specials + 200000);
    return different != 0;
}
