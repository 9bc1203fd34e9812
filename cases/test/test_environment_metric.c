/* What the tiers lose under skies without their sun: the floors of the project, for procedural skies always and for
 * ../shared/data/environments where that folder is. Prints TAP. */
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include "../environment/metric.h"
#include "../environment/sky.h"
#include "../environment/sun.h"

#define FOLDER "../shared/data/environments"

static int number, failed;

static void check(int good, const char *name, const char *what)
{
    printf("%sok %d - %s %s\n", good ? "" : "not ", ++number, name, what);
    failed += !good;
}

static void floors(const char *name, const lobe_environment *map)
{
    const lobe_environment_metric_options options = lobe_environment_metric_default();
    double e[LOBE_DIFFUSE_TIERS] = {0};
    check(lobe_environment_metric(map, &options, e), name, "is measured");
    printf("#");
    for (int t = 0; t < LOBE_DIFFUSE_TIERS; t++)
        printf(" %s %.3f %%", lobe_diffuse_tier_name[t], 100 * e[t]);
    putchar('\n');
    check(e[LOBE_DIFFUSE_EXACT] <= 0.010, name, "exact, at most 1.0 %");
    check(e[LOBE_DIFFUSE_MEDIUM] <= 0.013, name, "medium, at most 1.3 %");
    check(e[LOBE_DIFFUSE_LOW] < e[LOBE_DIFFUSE_SEED], name, "low, less than the seed");
    /* If the lobes were swapped or turned wrongly, or the truth were Lambert's, this would not hold. */
    check(e[LOBE_DIFFUSE_LAMBERT] > 0.08 && e[LOBE_DIFFUSE_LAMBERT] < 0.14, name, "Lambert, around 10 %");
}

static void procedural(unsigned seed)
{
    char name[32];
    lobe_environment map;
    snprintf(name, sizeof name, "procedural sky %u", seed);
    if (!lobe_environment_sky(&map, 512, 256, seed)) {
        check(0, name, "fits into memory");
        return;
    }
    floors(name, &map);
    lobe_environment_free(&map);
}

static void sky(void)
{
    struct stat folder;
    lobe_environment map;
    lobe_sun sun;
    if (stat(FOLDER, &folder) != 0) {
        printf("ok %d - sky.hdr without its sun # SKIP no " FOLDER "\n", ++number);
        return;
    }
    const int read = lobe_environment_load(FOLDER "/sky.hdr", &map);
    check(read, "sky.hdr", "is read");
    if (!read)
        return;
    check(lobe_environment_take_sun(&map, LOBE_SUN_SHARE, &sun), "sky.hdr", "has a sun");
    floors("sky.hdr without its sun", &map);
    lobe_environment_free(&map);
    /* A lamp is no sun: it stays in the map. */
    if (lobe_environment_load(FOLDER "/workshop.hdr", &map)) {
        check(!lobe_environment_take_sun(&map, LOBE_SUN_SHARE, &sun), "workshop.hdr", "has none");
        lobe_environment_free(&map);
    } else {
        check(0, "workshop.hdr", "is read");
    }
}

int main(void)
{
    for (unsigned seed = 1; seed <= 3; seed++)
        procedural(seed);
    sky();
    printf("1..%d\n", number);
    return failed != 0;
}
