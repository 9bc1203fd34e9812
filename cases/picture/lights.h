/* A floor and a ball under a sphere light and a capsule light: what the picture shades by the truth, by published forms
 * and by each tier. Mirrors of every roughness (F = 1) without diffuse light, shadow or a second bounce, so that all
 * that is seen is the integral that the forms approximate. */
#ifndef LOBE_PICTURE_LIGHTS_H
#define LOBE_PICTURE_LIGHTS_H
#include <stddef.h>

/* The columns: the truth, published forms, tiers. */
enum { LOBE_LIGHTS_COLUMNS = 6, LOBE_LIGHTS_ROUGHNESSES = 4 };
extern const char *const lobe_lights_column[LOBE_LIGHTS_COLUMNS];
extern const double lobe_lights_roughness[LOBE_LIGHTS_ROUGHNESSES];

/* What is seen at a point of the picture. */
typedef enum lobe_lights_seen { LOBE_LIGHTS_NOTHING, LOBE_LIGHTS_LAMP, LOBE_LIGHTS_SURFACE } lobe_lights_seen;

/* x in [-1, 1] to the right, y up in the same unit. */
lobe_lights_seen lobe_lights_see(double x, double y);

/* Values a point: rgb[roughness][column][channel]; 0 where there is no surface. */
enum { LOBE_LIGHTS_VALUES = LOBE_LIGHTS_ROUGHNESSES * LOBE_LIGHTS_COLUMNS * 3 };

/* Points of the picture, two numbers each; a lobe_batch_fn whose context is not used. */
void lobe_lights_shade(void *context, const double *points, size_t count, double *rgb);

/* The radiance of the lamps. */
extern const double lobe_lights_sphere_rgb[3], lobe_lights_capsule_rgb[3];

#endif
