#include "lights.h"
#include "../capsule_light/candidates.h"
#include "../capsule_light/truth_capsule.h"
#include "../sphere_light/candidates.h"
#include "../sphere_light/truth_sphere.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

const char *const lobe_lights_column[LOBE_LIGHTS_COLUMNS] = {"truth", "Karis", "smoothed", "low", "medium", "high"};
const double lobe_lights_roughness[LOBE_LIGHTS_ROUGHNESSES] = {.25, .4, .6, .85};
const double lobe_lights_sphere_rgb[3] = {1, .78, .5}, lobe_lights_capsule_rgb[3] = {.45, .75, 1};

/* The forms behind the columns; the seed paper and `low` and `high` say nothing
 * of capsules of their own. */
static const char *const sphere_form[LOBE_LIGHTS_COLUMNS] = {NULL,  "Karis 1/2", "smoothed point as printed",
                                                             "low", "medium",    "high"};
static const char *const capsule_form[LOBE_LIGHTS_COLUMNS] = {NULL, "Karis 1/2", "Karis 1/2", "low", "medium", "high"};

static const double tolerance = 1e-5; /* of the truth */

typedef struct vec {
    double x, y, z;
} vec;

static const vec eye = {0, -5, 1.3}, target = {.1, 0, .48}, ball = {-.8, .3, .6}, lamp = {.3, .35, .95},
                 tube[2] = {{.95, -.45, .34}, {1.55, .75, .34}};
static const double half_width = .31, ball_radius = .6, lamp_radius = .3, tube_radius = .09;

static vec add(vec a, vec b, double t) { return (vec){a.x + t * b.x, a.y + t * b.y, a.z + t * b.z}; }
static double dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vec cross(vec a, vec b) { return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static vec unit(vec a) { return add((vec){0, 0, 0}, a, 1 / sqrt(dot(a, a))); }

/* The nearer distance to a ball along the ray from the eye; infinite where
 * there is none. */
static double to_ball(vec ray, vec centre, double radius)
{
    const vec c = add(centre, eye, -1);
    const double b = dot(ray, c), d = b * b - dot(c, c) + radius * radius;
    return d < 0 || b < 0 ? INFINITY : b - sqrt(d);
}

/* To the tube: of its line the point nearest to the ray, then a ball there;
 * twice, which is a picture's worth. */
static double to_tube(vec ray)
{
    const vec along = add(tube[1], tube[0], -1), from = add(tube[0], eye, -1);
    const double aa = dot(along, along), ar = dot(along, ray), fa = dot(from, along), fr = dot(from, ray);
    const double t = fmin(1, fmax(0, (ar * fr - fa) / (aa - ar * ar)));
    return to_ball(ray, add(tube[0], along, t), tube_radius);
}

static vec ray_of(double x, double y)
{
    const vec forward = unit(add(target, eye, -1)), right = unit(cross(forward, (vec){0, 0, 1}));
    return unit(add(add(forward, right, x * half_width), cross(right, forward), y * half_width));
}

/* The surface's point and normal. */
static lobe_lights_seen hit(double x, double y, vec *point, vec *normal)
{
    const vec ray = ray_of(x, y);
    const double on_ball = to_ball(ray, ball, ball_radius), floor = ray.z < 0 ? -eye.z / ray.z : INFINITY;
    const double lit = fmin(to_ball(ray, lamp, lamp_radius), to_tube(ray)), solid = fmin(on_ball, floor);
    if (lit < solid)
        return LOBE_LIGHTS_LAMP;
    if (!(solid < 60))
        return LOBE_LIGHTS_NOTHING;
    *point = add(eye, ray, solid);
    *normal = on_ball < floor ? unit(add(*point, ball, -1)) : (vec){0, 0, 1};
    return LOBE_LIGHTS_SURFACE;
}

lobe_lights_seen lobe_lights_see(double x, double y)
{
    vec point, normal;
    return hit(x, y, &point, &normal);
}

static double sphere(int column, double roughness, double v, vec to_lamp)
{
    const double distance = sqrt(dot(to_lamp, to_lamp));
    const double row[5] = {roughness, v, to_lamp.z / distance, fabs(atan2(to_lamp.y, to_lamp.x)),
                           asin(lamp_radius / distance)};
    const lobe_sphere_scene scene = {roughness * roughness, v, row[2], row[3], row[4], 1};
    int i;
    if (column == 0)
        return lobe_truth_sphere_stretched(&scene, tolerance);
    for (i = 0; lobe_sphere_candidate_at(i); i++) {
        if (strcmp(lobe_sphere_candidate_at(i)->name, sphere_form[column]) == 0)
            return lobe_sphere_candidate_at(i)->call(row);
    }
    abort(); /* a column without a form is a mistake in the table above */
}

static double capsule(int column, double roughness, double v, vec p, vec q)
{
    const double row[9] = {roughness,        v,
                           .5 * (p.x + q.x), .5 * (p.y + q.y),
                           .5 * (p.z + q.z), .5 * (q.x - p.x),
                           .5 * (q.y - p.y), .5 * (q.z - p.z),
                           tube_radius};
    const lobe_capsule_scene scene = {roughness * roughness,    v,          1, {row[2], row[3], row[4]},
                                      {row[5], row[6], row[7]}, tube_radius};
    int i;
    if (column == 0)
        return lobe_truth_capsule(&scene, tolerance);
    for (i = 0; lobe_capsule_candidate_at(i); i++) {
        if (strcmp(lobe_capsule_candidate_at(i)->name, capsule_form[column]) == 0)
            return lobe_capsule_candidate_at(i)->call(row);
    }
    abort();
}

static vec local(vec x, vec y, vec z, vec a) { return (vec){dot(x, a), dot(y, a), dot(z, a)}; }

static void shade(vec point, vec n, double *rgb)
{
    const vec view = unit(add(eye, point, -1));
    const double v = fmax(.002, dot(n, view));
    const vec along = add(view, n, -dot(n, view)); /* the view's side, x */
    const vec x = unit(dot(along, along) > 1e-12 ? along : cross(n, (vec){0, 1, 0})), y = cross(n, x);
    const vec to_lamp = local(x, y, n, add(lamp, point, -1));
    const vec p = local(x, y, n, add(tube[0], point, -1)), q = local(x, y, n, add(tube[1], point, -1));
    int r, c, k;
    for (r = 0; r < LOBE_LIGHTS_ROUGHNESSES; r++) {
        for (c = 0; c < LOBE_LIGHTS_COLUMNS; c++) {
            const double from_lamp = sphere(c, lobe_lights_roughness[r], v, to_lamp);
            const double from_tube = capsule(c, lobe_lights_roughness[r], v, p, q);
            for (k = 0; k < 3; k++)
                *rgb++ = lobe_lights_sphere_rgb[k] * from_lamp + lobe_lights_capsule_rgb[k] * from_tube;
        }
    }
}

void lobe_lights_shade(void *context, const double *points, size_t count, double *rgb)
{
    size_t i;
    (void)context;
    for (i = 0; i < count; i++, points += 2, rgb += LOBE_LIGHTS_VALUES) {
        vec point, normal;
        if (hit(points[0], points[1], &point, &normal) == LOBE_LIGHTS_SURFACE)
            shade(point, normal, rgb);
        else
            memset(rgb, 0, LOBE_LIGHTS_VALUES * sizeof *rgb);
    }
}
