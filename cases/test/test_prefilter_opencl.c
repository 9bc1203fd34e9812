/* The sums in C and in OpenCL C: one text, the same bits. Skipped only where no OpenCL driver is registered at all. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <dirent.h>
#include <string.h>
#include "../environment/sky.h"
#include "../prefilter/prefilter.h"

static int driver_is_registered(void)
{
    DIR *folder = opendir("/etc/OpenCL/vendors");
    int found = 0;
    const struct dirent *entry;
    while (folder && (entry = readdir(folder)))
        found |= strstr(entry->d_name, ".icd") != NULL;
    if (folder)
        closedir(folder);
    return found;
}

static void compare(lobe_prefilter_kernel kernel)
{
    lobe_environment map;
    lobe_cube c, cl;
    char error[1024] = "";
    int64_t worst = 0;
    if (!driver_is_registered())
        skip();
    assert_true(lobe_environment_sky(&map, 128, 64, 2));
    const lobe_prefilter_image image = {&map, NULL, 0};
    lobe_prefilter_options o = lobe_prefilter_options_default(kernel, 32);
    o.scale.mips = 5;
    o.progress = 0;
    assert_int_equal(lobe_prefilter(&image, &o, &c, error, sizeof error), LOBE_PREFILTER_DONE);
    o.opencl = 1;
    if (lobe_prefilter(&image, &o, &cl, error, sizeof error) != LOBE_PREFILTER_DONE)
        fail_msg("%s", error);
    for (int m = 0; m < 5; m++)
        for (int i = 0; i < 18 * lobe_cube_side(32, m) * lobe_cube_side(32, m); i++) {
            int32_t a, b;
            memcpy(&a, &c.rgb[m][i], sizeof a);
            memcpy(&b, &cl.rgb[m][i], sizeof b);
            assert_true(c.rgb[m][i] > 0);
            const int64_t off = a > b ? (int64_t)a - b : (int64_t)b - a; /* both positive */
            worst = off > worst ? off : worst;
        }
    print_message("# worst difference %lld ulp of a float\n", (long long)worst);
    assert_in_range(worst, 0, 1);
    lobe_cube_free(&c);
    lobe_cube_free(&cl);
    lobe_environment_free(&map);
}

static void ggx(void **state)
{
    (void)state;
    compare(LOBE_PREFILTER_GGX);
}

static void sg(void **state)
{
    (void)state;
    compare(LOBE_PREFILTER_SG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(ggx), cmocka_unit_test(sg)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
