#include "scene.h"
#include "../environment/project.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 256, LAMBERT = LOBE_PICTURE_COLUMNS - 1 };

const char *const lobe_picture_column[LOBE_PICTURE_COLUMNS] = {"truth", "exact", "medium", "low", "zonal", "lambert"};
const double lobe_picture_roughness[LOBE_PICTURE_ROUGHNESSES] = {0, 0.5, 1};

static const lobe_diffuse_tier tier[LOBE_PICTURE_COLUMNS] = {LOBE_DIFFUSE_TIERS,  LOBE_DIFFUSE_EXACT,
                                                             LOBE_DIFFUSE_MEDIUM, LOBE_DIFFUSE_LOW,
                                                             LOBE_DIFFUSE_ZONAL,  LOBE_DIFFUSE_LAMBERT};

static void look(lobe_scene *s)
{
    double along[3] = {0, 0, 0};
    for (int c = 0; c < 3; c++) {
        along[0] += s->sh[c][3] + (s->have_sun ? s->sun.direction[0] * s->sun.irradiance[c] : 0);
        along[1] += s->sh[c][1] + (s->have_sun ? s->sun.direction[1] * s->sun.irradiance[c] : 0);
    }
    const double azimuth = atan2(along[1], along[0]) - 75 * LOBE_PI / 180, elevation = 12 * LOBE_PI / 180;
    const double view[3] = {cos(elevation) * cos(azimuth), cos(elevation) * sin(azimuth), sin(elevation)};
    const double right[3] = {-sin(azimuth), cos(azimuth), 0};
    const double up[3] = {-sin(elevation) * cos(azimuth), -sin(elevation) * sin(azimuth), cos(elevation)};
    memcpy(s->view, view, sizeof view);
    memcpy(s->right, right, sizeof right);
    memcpy(s->up, up, sizeof up);
}

int lobe_scene_of(const char *name, lobe_environment *map, lobe_scene *s)
{
    const int factor = map->width > WIDTH && map->width % WIDTH == 0 ? map->width / WIDTH : 1;
    snprintf(s->name, sizeof s->name, "%s", name);
    if (!lobe_environment_shrink(map, map->height % factor ? 1 : factor, &s->small))
        return 0;
    s->own = 0;
    s->have_sun = lobe_environment_take_sun(map, LOBE_SUN_SHARE, &s->sun);
    if (!lobe_environment_project(map, s->sh) || !lobe_light_texels_of(&s->small, &s->texels)) {
        lobe_environment_free(&s->small);
        return 0;
    }
    look(s);
    return 1;
}

void lobe_scene_free(lobe_scene *s)
{
    lobe_environment_free(&s->small);
    lobe_light_texels_free(&s->texels);
}

static void shade(const lobe_scene *s, const double n[3], double roughness, int column, double rgb[3])
{
    double lobe[9], sh[3][9];
    if (tier[column] == LOBE_DIFFUSE_TIERS) {
        lobe_reflect_texels(&s->texels, roughness, n, s->view, rgb);
        return;
    }
    memcpy(sh, s->sh, sizeof sh);
    lobe_diffuse_lobe(tier[column], roughness, n, s->view, lobe);
    lobe_diffuse_light(lobe, sh, rgb);
    for (int k = 0; k < 3; k++)
        rgb[k] = fmax(0, rgb[k]);
    if (s->have_sun && column == LAMBERT)
        lobe_reflect_lambert(s->sun.direction, s->sun.irradiance, n, rgb);
    else if (s->have_sun)
        lobe_reflect_burley(s->sun.direction, s->sun.irradiance, roughness, n, s->view, rgb);
}

void lobe_scene_shade(void *scene, const double *points, size_t count, double *rgb)
{
    const lobe_scene *s = scene;
    for (size_t i = 0; i < count; i++, points += 2) {
        /* A point on the rim's outer half is shaded as the rim. */
        const double shrink = fmin(1, 0.9999 / fmax(1e-9, hypot(points[0], points[1])));
        const double x = points[0] * shrink, y = points[1] * shrink, z = sqrt(1 - x * x - y * y);
        double n[3];
        for (int k = 0; k < 3; k++)
            n[k] = x * s->right[k] + y * s->up[k] + z * s->view[k];
        for (int r = 0; r < LOBE_PICTURE_ROUGHNESSES; r++)
            for (int c = 0; c < LOBE_PICTURE_COLUMNS; c++, rgb += 3)
                shade(s, n, lobe_picture_roughness[r], c, rgb);
    }
}
