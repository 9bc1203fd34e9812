/* A white Burley sphere under one environment: what the picture needs to shade it by full integration and by each tier
 * from nine coefficients a channel. A sun, where there is one, is a punctual light of every tier, and part of the map
 * for the truth. */
#ifndef LOBE_PICTURE_SCENE_H
#define LOBE_PICTURE_SCENE_H
#include "../environment/lobes.h"
#include "../environment/reflect.h"
#include "../environment/sun.h"

/* The columns: the truth, then tiers. */
enum { LOBE_PICTURE_COLUMNS = 6, LOBE_PICTURE_ROUGHNESSES = 3 };
extern const char *const lobe_picture_column[LOBE_PICTURE_COLUMNS];
extern const double lobe_picture_roughness[LOBE_PICTURE_ROUGHNESSES];

typedef struct lobe_scene {
    char name[32];
    int own; /* our own sky, so the picture may show the map itself */
    int have_sun;
    lobe_sun sun;
    lobe_environment small;   /* at most 256 columns where the sides allow it: full integration sums over these */
    lobe_light_texels texels; /* of the small map */
    double sh[3][9];          /* of the whole map without its sun */
    double right[3], up[3], view[3];
} lobe_scene;

/* Takes the sun out of the map. The eye stands a little above the horizon, 75 degrees beside the direction most light
 * comes from. 0 where there is no memory. */
int lobe_scene_of(const char *name, lobe_environment *map, lobe_scene *scene);
void lobe_scene_free(lobe_scene *scene);

/* Values a pixel: rgb[roughness][column][channel]. */
enum { LOBE_PICTURE_VALUES = LOBE_PICTURE_ROUGHNESSES * LOBE_PICTURE_COLUMNS * 3 };

/* The sphere's points x (right), y (up) in the unit disc, two numbers each; a lobe_batch_fn whose ctx is the scene. */
void lobe_scene_shade(void *scene, const double *points, size_t count, double *rgb);

#endif
