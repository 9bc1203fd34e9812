/* `make pictures`: spheres under environments, as one PNG. */
#include "../environment/sky.h"
#include "../fit/parallel.h"
#include "png.h"
#include "sheet.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static const char usage[] = "usage: pictures [--threads N] [--size PIXELS] OUT.png [FILE.hdr|FILE.pfm ...]\n"
                            "  the spheres' diameter is 88 pixels if left out; threads 2\n";

enum { BATCH = 512, SKY_SEED = 1 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Shades all points of one scene; a line with the rate where somebody watches. */
static void shade(lobe_scene *scene, lobe_shaded *s, size_t threads)
{
    const lobe_parallel parallel = {lobe_scene_shade, scene, 2, LOBE_PICTURE_VALUES, threads};
    const size_t count = (size_t)s->count;
    const double start = now();
    const int watched = isatty(STDERR_FILENO);
    for (size_t first = 0; first < count; first += BATCH) {
        const size_t n = count - first < BATCH ? count - first : BATCH;
        lobe_parallel job = parallel;
        lobe_parallel_eval(&job, s->point + 2 * first, n, s->rgb + LOBE_PICTURE_VALUES * first);
        const double rate = (double)(first + n) / (now() - start + 1e-9);
        if (watched)
            fprintf(stderr, "\r%s: %zu of %zu points, %.0f/s, %.0f s left  ", scene->name, first + n, count, rate,
                    (double)(count - first - n) / rate);
    }
    if (watched)
        fputc('\n', stderr);
}

/* Reads or makes the map, shades it and draws it. The exit status. */
static int add(lobe_canvas *sheet, int index, const char *path, lobe_shaded *s, size_t threads)
{
    lobe_environment map;
    lobe_scene scene;
    char name[32] = "procedural sky";
    if (path) {
        const char *slash = strrchr(path, '/');
        snprintf(name, sizeof name, "%s", slash ? slash + 1 : path);
        if (!lobe_environment_load(path, &map))
            return 2;
    } else if (!lobe_environment_sky(&map, 1024, 512, SKY_SEED)) {
        fprintf(stderr, "pictures: not enough memory for a map\n");
        return 2;
    }
    const int good = lobe_scene_of(name, &map, &scene);
    scene.own = path == NULL;
    lobe_environment_free(&map);
    if (!good) {
        fprintf(stderr, "pictures: not enough memory for %s\n", name);
        return 2;
    }
    shade(&scene, s, threads);
    lobe_sheet_draw(sheet, index, &scene, s);
    lobe_scene_free(&scene);
    return 0;
}

static int whole(const char *text, long least, long most, long *value)
{
    char *rest;
    *value = text ? strtol(text, &rest, 10) : 0;
    return text && rest != text && !*rest && *value >= least && *value <= most;
}

int main(int argc, char **argv)
{
    const double start = now();
    long threads = 2, size = 88;
    int at = 1, status = 0;
    for (; at < argc && argv[at][0] == '-'; at += 2) {
        if (strcmp(argv[at], "-h") == 0)
            return fputs(usage, stdout) < 0;
        if (!(strcmp(argv[at], "--threads") == 0 && whole(argv[at + 1], 1, LOBE_PARALLEL_MAX, &threads)) &&
            !(strcmp(argv[at], "--size") == 0 && whole(argv[at + 1], 8, 1024, &size))) {
            fprintf(stderr, "pictures: '%s': --threads takes 1 to %d, --size 8 to 1024\n%s", argv[at],
                    LOBE_PARALLEL_MAX, usage);
            return 2;
        }
    }
    if (at >= argc) {
        fputs(usage, stderr);
        return 2;
    }
    const char *out = argv[at++];
    lobe_canvas sheet;
    lobe_shaded s;
    if (!lobe_shaded_of((int)size, &s) || !lobe_sheet_of((int)size, argc - at + 1, &sheet)) {
        fprintf(stderr, "pictures: not enough memory\n");
        return 2;
    }
    for (int i = 0; at + i < argc && !status; i++)
        status = add(&sheet, i, argv[at + i], &s, (size_t)threads);
    if (!status)
        status = add(&sheet, argc - at, NULL, &s, (size_t)threads);
    if (!status && !lobe_png_write(&sheet, out))
        status = 2;
    if (!status)
        printf("%s: %d scenes, %d x %d, %.1f s\n", out, argc - at + 1, sheet.width, sheet.height, now() - start);
    lobe_canvas_free(&sheet);
    lobe_shaded_free(&s);
    return status;
}
