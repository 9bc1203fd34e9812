/* What ships of sphere_light: the public functions behind one signature. */
#ifndef LOBE_SPHERE_LIGHT_SHIPPED_H
#define LOBE_SPHERE_LIGHT_SHIPPED_H

typedef struct lobe_sphere_shipped {
    const char *tier, *format;
    double (*call)(const double row[5]); /* of the columns of columns.h; q30 with its own exponent, not as Q30 */
} lobe_sphere_shipped;

/* The i-th, or NULL past the end. */
const lobe_sphere_shipped *lobe_sphere_shipped_at(int i);

#endif
