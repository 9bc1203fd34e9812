/* What the rows of a light of five columns have in common, whatever its last column, the size, means: corners, then
 * any, for the vectors; a Latin hypercube for the bounds. */
#ifndef LOBE_SPHERE_LIGHT_LIGHT_POINTS_H
#define LOBE_SPHERE_LIGHT_LIGHT_POINTS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct lobe_light_points {
    double roughness_lo, n_dot_v_lo; /* of the domain */
    double sizes[4];                 /* of the corners in it */
    double far[6][3];                /* roughness, n_dot_v and size of those beyond it */
    double (*width)(double size);    /* how far the light reaches under its middle */
    double setting, set;             /* so many widths deep it has all but set, and has set */
    size_t vectors;                  /* in the domain, at most */
    bool (*inside)(const double row[5]), (*taken)(const double row[5]);
    bool (*draw)(double row[5], const double u[5], bool beyond, bool near);
} lobe_light_points;

/* As a lobe_points_fn. */
size_t lobe_light_vector_points(const lobe_light_points *of, int beyond, uint64_t seed, double *points, size_t room);

/* count rows, each second one near the mirror direction. */
void lobe_light_judged(const lobe_light_points *of, bool beyond, double *rows, size_t count);

#endif
