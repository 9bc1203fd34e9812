/* The command line of the prefilter: everything is read and computed before the file is opened for writing, and it
 * appears whole or not at all. */
#include "prefilter_command.h"
#include "cube_file.h"
#include "faces.h"
#include "half.h"
#include "prefilter.h"
#include "../fit/atomic_file.h"
#include "../fit/interrupt.h"
#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ACCEPTS "--out --format --kernel --size --mips --curve --up --threads --fit --opencl --progress"

enum { LEAST_SIZE = 1, MOST_SIZE = 4096 };

typedef struct options {
    const char *file, *out;
    lobe_cube_format format;
    lobe_prefilter_kernel kernel;
    int size, mips, threads, y_up, opencl, fit, progress, up_given;
    double curve;
} options;

static int refuse(const char *format, ...) __attribute__((format(printf, 1, 2)));

static int refuse(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fputs("lobefit: prefilter: ", stderr);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
    return 2;
}

static int whole(const char *option, const char *value, int low, int high, int *out)
{
    char *rest;
    errno = 0;
    const long n = strtol(value, &rest, 10);
    if (rest == value || *rest || errno || n < low || n > high)
        return refuse("%s '%s' is not a whole number in [%d, %d]", option, value, low, high);
    *out = (int)n;
    return 0;
}

/* The place of value among names separated by one space, or -1. */
static int choice(const char *value, const char *names)
{
    const size_t length = strlen(value);
    for (int i = 0; *names; i++) {
        const size_t n = strcspn(names, " ");
        if (n == length && strncmp(names, value, n) == 0)
            return i;
        names += n + (names[n] == ' ');
    }
    return -1;
}

static int chosen(const char *option, const char *value, const char *names, int *out)
{
    *out = choice(value, names);
    return *out >= 0 ? 0 : refuse("%s '%s' is not one of: %s", option, value, names);
}

static int parse_value(const char *option, const char *value, options *o)
{
    int n = 0, status = 0;
    char *rest;
    if (strcmp(option, "--out") == 0) {
        o->out = value;
    } else if (strcmp(option, "--format") == 0) {
        status = chosen(option, value, "dds ktx2 raw", &n);
        o->format = (lobe_cube_format)n;
    } else if (strcmp(option, "--kernel") == 0) {
        status = chosen(option, value, "ggx sg", &n);
        o->kernel = (lobe_prefilter_kernel)n;
    } else if (strcmp(option, "--up") == 0) {
        o->up_given = 1;
        status = chosen(option, value, "z y", &o->y_up);
    } else if (strcmp(option, "--size") == 0) {
        status = whole(option, value, LEAST_SIZE, MOST_SIZE, &o->size);
    } else if (strcmp(option, "--mips") == 0) {
        status = whole(option, value, 1, lobe_cube_full_chain(MOST_SIZE), &o->mips);
    } else if (strcmp(option, "--threads") == 0) {
        status = whole(option, value, 1, LOBE_PREFILTER_THREADS, &o->threads);
    } else {
        o->curve = strtod(value, &rest);
        if (rest == value || *rest || !(o->curve >= LOBE_PREFILTER_CURVE_MIN && o->curve <= LOBE_PREFILTER_CURVE_MAX))
            status = refuse("--curve '%s' is not a number in [%g, %g]", value, LOBE_PREFILTER_CURVE_MIN,
                            LOBE_PREFILTER_CURVE_MAX);
    }
    return status;
}

static int parse_options(int argc, char **argv, options *o)
{
    const options defaults = {NULL, NULL, LOBE_CUBE_DDS, LOBE_PREFILTER_GGX, 256, 0, 0, 0, 0, 0, 0, 0, 0};
    int format_given = 0;
    *o = defaults;
    for (int i = 0; i < argc; i++) {
        const char *word = argv[i];
        if (strcmp(word, "--opencl") == 0) {
            o->opencl = 1;
        } else if (strcmp(word, "--fit") == 0) {
            o->fit = 1;
        } else if (strcmp(word, "--progress") == 0) {
            o->progress = 1;
        } else if (word[0] == '-' && word[1]) {
            if (choice(word, "--out --format --kernel --size --mips --curve --up --threads") < 0)
                return refuse("unknown option '%s'; it takes %s", word, ACCEPTS);
            if (++i == argc)
                return refuse("%s needs a value", word);
            const int status = parse_value(word, argv[i], o);
            if (status)
                return status;
            format_given |= strcmp(word, "--format") == 0;
        } else if (o->file) {
            return refuse("'%s' is one word too many", word);
        } else {
            o->file = word;
        }
    }
    if (!o->file)
        return refuse("which file? FILE.hdr (RGBE) or FILE.pfm, equirectangular or six faces, or a cube as FILE.dds or "
                      "FILE.ktx2");
    if (!o->out)
        return refuse("where to? --out FILE");
    if (o->mips > lobe_cube_full_chain(o->size))
        return refuse("--mips %d is more than the %d of a size of %d", o->mips, lobe_cube_full_chain(o->size), o->size);
    const char *dot = strrchr(o->out, '.');
    if (!format_given && dot && choice(dot + 1, "dds ktx2 raw") >= 0)
        o->format = (lobe_cube_format)choice(dot + 1, "dds ktx2 raw");
    return 0;
}

/* A picture of six faces becomes the cube, and the map goes. */
static int unfold(const char *path, lobe_environment *map, lobe_cube *cube, lobe_prefilter_image *image)
{
    lobe_environment_fault fault = {0, ""};
    if (lobe_faces_of(map->width, map->height) == LOBE_FACES_NONE) {
        image->map = map;
        return 1;
    }
    image->cube = cube;
    const int good = lobe_faces_take(map, cube, &fault);
    lobe_environment_free(map);
    if (!good)
        fprintf(stderr, "%s: %s\n", path, fault.reason);
    return good;
}

/* A map or a cube, whichever the first bytes and the sides say. 0 after a message. */
static int load(const char *path, lobe_environment *map, lobe_cube *cube, lobe_prefilter_image *image)
{
    size_t size;
    lobe_environment_fault fault = {0, ""};
    unsigned char *bytes = lobe_environment_read(path, &size);
    int good;
    if (!bytes)
        return 0;
    memset(image, 0, sizeof *image);
    if (lobe_cube_is_file(bytes, size)) {
        good = lobe_cube_parse(bytes, size, cube, &fault);
        image->cube = cube;
    } else {
        good = lobe_environment_parse(bytes, size, map, &fault);
    }
    free(bytes);
    if (!good) {
        fprintf(stderr, "%s: byte %zu: %s\n", path, fault.offset, fault.reason);
        return 0;
    }
    return image->cube || unfold(path, map, cube, image);
}

static int write_cube(const options *o, const lobe_cube *cube, const lobe_prefilter_scale *scale)
{
    lobe_atomic_file file;
    size_t clamped;
    if (!lobe_atomic_open(&file, o->out))
        return 2;
    lobe_cube_write(file.stream, o->format, cube, scale, &clamped);
    if (lobe_interrupt_requested()) {
        lobe_atomic_abandon(&file);
        return refuse("interrupted; %s is as it was", o->out);
    }
    if (!lobe_atomic_commit(&file))
        return 2;
    if (clamped)
        fprintf(stderr, "lobefit: prefilter: %s: %zu numbers larger than a half float holds became %g\n", o->out,
                clamped, (double)LOBE_HALF_MAX);
    return 0;
}

static int print_scale(const options *o, const lobe_prefilter_image *image, const lobe_prefilter_scale *scale)
{
    const int last = scale->mips - 1;
    const char *slash = strrchr(o->file, '/');
    int charts, rows, columns;
    lobe_prefilter_image_size(image, &charts, &rows, &columns);
    fputs("# source: ", stdout);
    for (const char *s = slash ? slash + 1 : o->file; *s; s++)
        putchar(iscntrl((unsigned char)*s) ? '?' : *s);
    printf(", %d x %d texels%s\n", columns, rows, charts == 6 ? ", six faces" : "");
    printf("# kernel: %s\n", o->kernel == LOBE_PREFILTER_GGX
                                 ? "ggx, max(0, c)/(1 + k(1 - c))^2, k = (1/alpha^2 - 1)/2, alpha = roughness^2"
                                 : "sg, exp(sharpness (c - 1))");
    printf("# scale: lod = min(t, t^3), t = %d r (a + (1 - a) r), r = %s, a = %.9g\n", last,
           o->kernel == LOBE_PREFILTER_GGX ? "roughness" : "sharpness^(-1/4)", scale->curve);
    if (image->map)
        printf("# world: %s up\n", o->y_up ? "y" : "z");
    printf("# columns: mip side %s\n", o->kernel == LOBE_PREFILTER_GGX ? "roughness" : "sharpness");
    for (int m = 0; m < scale->mips; m++)
        printf("%d %d %.9g\n", m, lobe_cube_side(o->size, m), lobe_prefilter_width(scale, m));
    return fflush(stdout) != 0 || ferror(stdout) ? refuse("<stdout>: cannot write: %s", strerror(errno)) : 0;
}

static int filter(const options *o, const lobe_prefilter_image *image)
{
    lobe_prefilter_options p = lobe_prefilter_options_default(o->kernel, o->size);
    lobe_cube cube;
    char error[1024] = "";
    int status;
    p.scale.mips = o->mips ? o->mips : p.scale.mips;
    p.scale.curve = o->curve > 0 ? o->curve : p.scale.curve;
    p.threads = o->threads ? o->threads : p.threads;
    p.progress = o->progress ? 1 : p.progress;
    p.opencl = o->opencl;
    p.fit = o->fit;
    lobe_interrupt_install();
    switch (lobe_prefilter(image, &p, &cube, error, sizeof error)) {
    case LOBE_PREFILTER_INTERRUPTED:
        return refuse("interrupted; %s is as it was", o->out);
    case LOBE_PREFILTER_NO_MEMORY:
        return refuse("%s: not enough memory for a cube of size %d", o->file, o->size);
    case LOBE_PREFILTER_NO_OPENCL:
        return refuse("%s", error);
    case LOBE_PREFILTER_DONE:
        break;
    }
    status = write_cube(o, &cube, &p.scale);
    lobe_cube_free(&cube);
    return status ? status : print_scale(o, image, &p.scale);
}

int lobe_prefilter_command(int argc, char **argv)
{
    options o;
    lobe_environment map = {0, 0, NULL};
    lobe_cube cube;
    lobe_prefilter_image image;
    int status = parse_options(argc, argv, &o);
    memset(&cube, 0, sizeof cube);
    if (status)
        return status;
    if (!load(o.file, &map, &cube, &image))
        return 2;
    image.y_up = o.y_up;
    if (image.cube && o.up_given)
        status = refuse("--up is for equirectangular maps; %s is a cube and keeps its axes", o.file);
    else
        status = filter(&o, &image);
    lobe_environment_free(&map);
    lobe_cube_free(&cube);
    return status;
}
