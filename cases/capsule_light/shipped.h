/* What ships of capsule_light: the public functions behind one signature. */
#ifndef LOBE_CAPSULE_LIGHT_SHIPPED_H
#define LOBE_CAPSULE_LIGHT_SHIPPED_H

typedef struct lobe_capsule_shipped {
    const char *tier, *format;
    double (*call)(const double *row); /* q30 with its own exponent, not as Q30 */
} lobe_capsule_shipped;

/* The i-th, or NULL past the end. */
const lobe_capsule_shipped *lobe_capsule_shipped_at(int i);

#endif
