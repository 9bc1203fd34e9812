/* The public functions of liblobe.a behind one signature, for measuring what ships. */
#ifndef LOBE_SPLIT_SUM_SHIPPED_H
#define LOBE_SPLIT_SUM_SHIPPED_H
#include <stdbool.h>

typedef struct lobe_shipped {
    const char *model, *tier, *format;
    int measures; /* 3: scale, bias and their sum; 1: E */
    bool inverse; /* there is a function of 1/E, and the last output is its own */
    /* Roughness and NdotV, multiples of 2^-24, to scale, bias, E; or to E, 1/E. */
    void (*call)(const double *in, double *out);
} lobe_shipped;

/* The i-th, or NULL past the end. */
const lobe_shipped *lobe_shipped_at(int i);

#endif
