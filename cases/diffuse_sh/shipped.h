/* The public functions of diffuse_sh behind one signature, for measuring what ships. */
#ifndef LOBE_DIFFUSE_SHIPPED_H
#define LOBE_DIFFUSE_SHIPPED_H
#include "metric.h"

typedef struct lobe_diffuse_shipped {
    const char *tier, *format;
    int constant; /* 1: depends on nothing, and costs nothing */
    lobe_diffuse_model call;
} lobe_diffuse_shipped;

/* The i-th, or NULL past the end; both formats of a tier stand together, f32 first. */
const lobe_diffuse_shipped *lobe_diffuse_shipped_at(int i);

#endif
