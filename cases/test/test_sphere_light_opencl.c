/* The truth of sphere_light in C and in OpenCL C: the same bits, adaptive as it is. Skipped only where no OpenCL driver
 * is registered at all. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <dirent.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/random.h"
#include "../sphere_light/truth_sphere.h"

enum { ROWS = 1500 };

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

static void same_bits(void **state)
{
    const double pi = 3.14159265358979323846;
    double *in = malloc(5 * ROWS * sizeof *in), *c = malloc(ROWS * sizeof *c), *cl = malloc(ROWS * sizeof *cl);
    char error[1024] = "";
    lobe_random r;
    int i, lit = 0;
    (void)state;
    if (!driver_is_registered())
        skip();
    assert_true(in && c && cl);
    lobe_random_seed(&r, 61, 0);
    for (i = 0; i < ROWS; i++) {
        double *row = in + 5 * i;
        row[0] = .05 + .95 * lobe_random_unit(&r);
        row[1] = cos(1.55 * lobe_random_unit(&r));
        row[2] = i % 2 ? row[1] : 2 * lobe_random_unit(&r) - 1;
        row[3] = i % 2 ? pi * (1 - .2 * lobe_random_unit(&r)) : pi * lobe_random_unit(&r);
        row[4] = 1e-4 * pow(1.5e4, lobe_random_unit(&r));
    }
    memset(cl, 0xff, ROWS * sizeof *cl);
    lobe_truth_sphere_rows(in, c, ROWS);
    if (lobe_truth_sphere_opencl(in, cl, ROWS, error, sizeof error))
        fail_msg("%s", error);
    for (i = 0; i < ROWS; i++)
        lit += c[i] > 0;
    assert_true(lit > ROWS / 2 && lit < ROWS);
    assert_memory_equal(c, cl, ROWS * sizeof *c);
    free(in);
    free(c);
    free(cl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(same_bits)};
    return cmocka_run_group_tests_name("sphere_light_opencl", tests, NULL, NULL);
}
