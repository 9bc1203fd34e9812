/* The public functions of sphere_diffuse behind one signature, for measuring what ships. */
#ifndef LOBE_SPHERE_DIFFUSE_SHIPPED_H
#define LOBE_SPHERE_DIFFUSE_SHIPPED_H

typedef struct lobe_sphere_diffuse_shipped {
    const char *tier, *format;
    double (*call)(double n_dot_l, double sine); /* of numbers that the format has; q30 with its block exponent */
} lobe_sphere_diffuse_shipped;

/* The i-th, or NULL past the end; both formats of a tier stand together, f32 first. */
const lobe_sphere_diffuse_shipped *lobe_sphere_diffuse_shipped_at(int i);

#endif
