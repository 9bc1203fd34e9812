/* The command line of the projection: everything is read and computed before the first byte is written. */
#include "project_command.h"
#include "project.h"
#include "sun.h"
#include "window.h"
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum window { WINDOW_NONE, WINDOW_POSITIVE, WINDOW_HANNING } window;
static const char *const window_name[] = {"none", "positive", "hanning", NULL};

#define HANNING_WIDTH 5

typedef struct options {
    const char *file, *c_name;
    window window;
    int sun, y_up;
    double share;
} options;

/* What is printed. */
typedef struct projection {
    int width, height, have_sun;
    double sh[3][9], smoothing;
    lobe_sun sun;
} projection;

static int refuse(const char *format, ...) __attribute__((format(printf, 1, 2)));

static int refuse(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fputs("lobefit: project: ", stderr);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
    return 2;
}

static int is_identifier(const char *s)
{
    if (!(isalpha((unsigned char)*s) || *s == '_') || strlen(s) > 60)
        return 0;
    while (isalnum((unsigned char)*s) || *s == '_')
        s++;
    return *s == 0;
}

static int parse_window(const char *value, options *o)
{
    for (int w = 0; window_name[w]; w++)
        if (strcmp(value, window_name[w]) == 0) {
            o->window = (window)w;
            return 0;
        }
    return refuse("--window '%s' is not one of none, positive, hanning", value);
}

static int parse_value(const char *option, const char *value, options *o)
{
    char *rest;
    if (strcmp(option, "--window") == 0)
        return parse_window(value, o);
    if (strcmp(option, "--up") == 0) {
        o->y_up = strcmp(value, "y") == 0;
        return o->y_up || strcmp(value, "z") == 0 ? 0 : refuse("--up '%s' is not one of y, z", value);
    }
    if (strcmp(option, "--c") == 0) {
        o->c_name = value;
        return is_identifier(value) ? 0 : refuse("--c '%s' is not a C name of at most 60 characters", value);
    }
    o->share = strtod(value, &rest);
    if (rest == value || *rest || !(o->share >= 0 && o->share <= 4))
        return refuse("--sun-share '%s' is not a number in [0, 4]", value);
    return 0;
}

static int parse_options(int argc, char **argv, options *o)
{
    static const char *const valued[] = {"--c", "--window", "--up", "--sun-share"};
    const options defaults = {NULL, NULL, WINDOW_NONE, 0, 0, LOBE_SUN_SHARE};
    *o = defaults;
    for (int i = 0; i < argc; i++) {
        size_t k = 0;
        while (k < 4 && strcmp(argv[i], valued[k]) != 0)
            k++;
        if (strcmp(argv[i], "--sun") == 0) {
            o->sun = 1;
        } else if (k < 4) {
            if (++i == argc)
                return refuse("%s needs a value", argv[i - 1]);
            const int status = parse_value(argv[i - 1], argv[i], o);
            if (status)
                return status;
        } else if (argv[i][0] == '-' && argv[i][1]) {
            return refuse("unknown option '%s'; it takes --c --window --sun --sun-share --up", argv[i]);
        } else if (o->file) {
            return refuse("'%s' is one word too many", argv[i]);
        } else {
            o->file = argv[i];
        }
    }
    return o->file ? 0 : refuse("which file? FILE.hdr (RGBE) or FILE.pfm, equirectangular");
}

static int compute(const options *o, projection *p)
{
    lobe_environment map;
    if (!lobe_environment_load(o->file, &map))
        return 2;
    memset(p, 0, sizeof *p);
    p->width = map.width;
    p->height = map.height;
    p->sun.direction[2] = 1;
    if (o->sun) {
        p->have_sun = lobe_environment_take_sun(&map, o->share, &p->sun);
        if (!p->have_sun) {
            const lobe_sun none = {{0, 0, 1}, {0, 0, 0}, 0};
            p->sun = none;
        }
    }
    const int good = lobe_environment_project(&map, p->sh);
    lobe_environment_free(&map);
    if (!good)
        return refuse("%s: not enough memory for a row of %d texels", o->file, p->width);
    if (o->window == WINDOW_POSITIVE) {
        p->smoothing = lobe_sh9_window_positive(p->sh);
        if (p->smoothing < 0)
            return refuse("%s: the mean radiance of a channel is negative; no window makes it positive", o->file);
    }
    for (int c = 0; c < 3; c++) {
        if (o->window == WINDOW_HANNING)
            lobe_sh9_window_hanning(p->sh[c], HANNING_WIDTH);
        if (o->y_up)
            lobe_sh9_y_up(p->sh[c]);
    }
    if (o->y_up) {
        const double *d = p->sun.direction, turned[3] = {-d[1], d[2], -d[0]};
        memcpy(p->sun.direction, turned, sizeof turned);
    }
    return 0;
}

static void print_head(const options *o, const projection *p, const char *mark)
{
    /* The file's name, not its folder: the output does not depend on where the file lies. */
    const char *slash = strrchr(o->file, '/');
    printf("%s environment: ", mark);
    for (const char *s = slash ? slash + 1 : o->file; *s; s++)
        putchar(iscntrl((unsigned char)*s) || *s == '*' ? '?' : *s);
    printf(", %d x %d texels, order-3 projection, exact solid angles\n", p->width, p->height);
    printf("%s basis: real SH, index l^2 + l + m, all polynomials with positive sign (Y11 = +.488603x)\n", mark);
    printf("%s world: %s\n", mark,
           o->y_up ? "y up, middle column along -z, columns to the right turn towards +x"
                   : "z up, middle column along +x, columns to the right turn towards -y");
    printf("%s window: %s", mark, window_name[o->window]);
    if (o->window == WINDOW_POSITIVE)
        printf(", 1/(1 + k l^2 (l + 1)^2) with k = %.6g", p->smoothing);
    if (o->window == WINDOW_HANNING)
        printf(", (1 + cos(pi l / %d)) / 2", HANNING_WIDTH);
    putchar('\n');
    if (o->sun && !p->have_sun)
        printf("%s sun: none; no spot carries %g of the mean irradiance\n", mark, o->share);
    if (p->have_sun)
        printf("%s sun: taken out of the map, %.3g sr\n", mark, p->sun.solid_angle);
}

/* -0 would be noise, and so would the last digits of a sum that cancels: 0 where nothing else can be told. */
static double clean(double x, double scale) { return fabs(x) <= 1e-14 * scale ? 0 : x; }

static void print_text(const options *o, const projection *p)
{
    const double *d = p->sun.direction, *e = p->sun.irradiance;
    print_head(o, p, "#");
    if (p->have_sun) {
        printf("# sun_direction: %.9g %.9g %.9g\n", clean(d[0], 1), clean(d[1], 1), clean(d[2], 1));
        printf("# sun_irradiance: %.9g %.9g %.9g\n", e[0], e[1], e[2]);
    }
    printf("# columns: red green blue, a row a coefficient\n");
    for (int k = 0; k < 9; k++)
        printf("%.9g %.9g %.9g\n", clean(p->sh[0][k], p->sh[0][0]), clean(p->sh[1][k], p->sh[1][0]),
               clean(p->sh[2][k], p->sh[2][0]));
}

/* A literal of type float: 9 digits, with a point or an exponent before the f. */
static void print_float(double x)
{
    char text[32];
    snprintf(text, sizeof text, "%.9g", x);
    printf("%s%sf", text, strpbrk(text, ".e") ? "" : ".0");
}

static void print_list(const double *x, int n, double scale)
{
    putchar('{');
    for (int k = 0; k < n; k++) {
        print_float(clean(x[k], scale));
        fputs(k + 1 < n ? ", " : "}", stdout);
    }
}

static void print_c(const options *o, const projection *p)
{
    static const char *const channel[3] = {"red", "green", "blue"};
    puts("/*");
    print_head(o, p, " *");
    puts(" */");
    printf("static const float %s[3][9] = {\n", o->c_name);
    for (int c = 0; c < 3; c++) {
        fputs("    ", stdout);
        print_list(p->sh[c], 9, p->sh[c][0]);
        printf("%s /* %s */\n", c < 2 ? "," : "", channel[c]);
    }
    puts("};");
    if (!o->sun)
        return;
    printf("static const float %s_sun_direction[3] = ", o->c_name);
    print_list(p->sun.direction, 3, 1);
    printf("; /* towards it */\nstatic const float %s_sun_irradiance[3] = ", o->c_name);
    print_list(p->sun.irradiance, 3, 0);
    printf("; /* on a surface that faces it */\n");
}

int lobe_project_command(int argc, char **argv)
{
    options o;
    projection p;
    int status = parse_options(argc, argv, &o);
    if (!status)
        status = compute(&o, &p);
    if (status)
        return status;
    if (o.c_name)
        print_c(&o, &p);
    else
        print_text(&o, &p);
    if (fflush(stdout) != 0 || ferror(stdout))
        return refuse("<stdout>: cannot write: %s", strerror(errno));
    return 0;
}
