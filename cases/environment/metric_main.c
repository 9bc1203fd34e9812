/* `make environment-metric`: the table of metric.h for procedural skies and for the maps that are named.
 * Usage: environment_metric [FILE.hdr|FILE.pfm ...] */
#include "metric.h"
#include "sky.h"
#include "sun.h"
#include <stdio.h>
#include <string.h>

static int row(const char *name, const char *note, const lobe_environment *map, double hanning)
{
    lobe_environment_metric_options options = lobe_environment_metric_default();
    double error[LOBE_DIFFUSE_TIERS];
    options.hanning = hanning;
    if (!lobe_environment_metric(map, &options, error)) {
        fprintf(stderr, "environment_metric: not enough memory for %s\n", name);
        return 2;
    }
    printf("%-16s %-10s", name, note);
    for (int t = 0; t < LOBE_DIFFUSE_TIERS; t++)
        printf(" %9.3f", 100 * error[t]);
    putchar('\n');
    fflush(stdout);
    return 0;
}

static int file(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *name = slash ? slash + 1 : path;
    lobe_environment map;
    lobe_sun sun;
    if (!lobe_environment_load(path, &map))
        return 2;
    int status = row(name, "as it is", &map, 0);
    if (!status)
        status = row(name, "hanning 5", &map, 5);
    if (!status && lobe_environment_take_sun(&map, LOBE_SUN_SHARE, &sun)) {
        status = row(name, "sun taken", &map, 0);
        if (!status)
            status = row(name, "hanning 5", &map, 5);
    }
    lobe_environment_free(&map);
    return status;
}

int main(int argc, char **argv)
{
    int status = 0;
    if (argc > 1 && argv[1][0] == '-') {
        fputs("usage: environment_metric [FILE.hdr|FILE.pfm ...]\n", strcmp(argv[1], "-h") == 0 ? stdout : stderr);
        return strcmp(argv[1], "-h") == 0 ? 0 : 2;
    }
    puts("Relative rms of the reflected radiance in per cent: 600 orientations, against full integration");
    printf("%-16s %-10s", "environment", "");
    for (int t = 0; t < LOBE_DIFFUSE_TIERS; t++)
        printf(" %9s", lobe_diffuse_tier_name[t]);
    putchar('\n');
    for (unsigned seed = 1; seed <= 3 && !status; seed++) {
        char name[32];
        lobe_environment map;
        snprintf(name, sizeof name, "procedural %u", seed);
        if (!lobe_environment_sky(&map, 1024, 512, seed)) {
            fprintf(stderr, "environment_metric: not enough memory for a map\n");
            return 2;
        }
        status = row(name, "no sun", &map, 0);
        lobe_environment_free(&map);
    }
    for (int i = 1; i < argc && !status; i++)
        status = file(argv[i]);
    return status;
}
