/* The same text in C and in OpenCL C, on a 64 x 64 grid. Skipped only where no OpenCL driver is registered at all. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <cmocka.h>
#include <dirent.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "../split_sum/truth_split_sum.h"

#define SIDE 64

typedef void (*rows_fn)(const double *in, double *out, size_t n);
typedef int (*opencl_fn)(const double *in, double *out, size_t n, char *error, size_t error_size);

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

static uint64_t ulps(double a, double b)
{
    int64_t x, y;
    memcpy(&x, &a, sizeof x);
    memcpy(&y, &b, sizeof y);
    return (uint64_t)(x > y ? x - y : y - x); /* both positive */
}

static void compare(rows_fn rows, opencl_fn opencl, size_t columns)
{
    const size_t n = SIDE * SIDE;
    double *in = malloc(2 * n * sizeof *in), *c = malloc(2 * n * sizeof *c), *cl = malloc(2 * n * sizeof *cl);
    char error[1024] = "";
    uint64_t worst = 0;
    size_t i;
    if (!driver_is_registered())
        skip();
    assert_true(in && c && cl);
    for (i = 0; i < n; i++) {
        in[2 * i] = 0.001 + 0.999 * (double)(i / SIDE) / (SIDE - 1);
        in[2 * i + 1] = 0.001 + 0.999 * (double)(i % SIDE) / (SIDE - 1);
    }
    memset(cl, 0xff, 2 * n * sizeof *cl);
    rows(in, c, n);
    if (opencl(in, cl, n, error, sizeof error))
        fail_msg("%s", error);
    for (i = 0; i < n * columns; i++) {
        assert_true(c[i] > 0 && cl[i] > 0);
        worst = ulps(c[i], cl[i]) > worst ? ulps(c[i], cl[i]) : worst;
    }
    print_message("# worst difference %llu ulp\n", (unsigned long long)worst);
    assert_in_range(worst, 0, 4);
    free(in);
    free(c);
    free(cl);
}

static void correlated(void **state)
{
    (void)state;
    compare(lobe_truth_split_sum_rows, lobe_truth_split_sum_opencl, 2);
}

static void separable(void **state)
{
    (void)state;
    compare(lobe_truth_split_sum_sep_rows, lobe_truth_split_sum_sep_opencl, 2);
}

static void schlick_smith(void **state)
{
    (void)state;
    compare(lobe_truth_split_sum_kibl_rows, lobe_truth_split_sum_kibl_opencl, 2);
}

static void energy(void **state)
{
    (void)state;
    compare(lobe_truth_energy_rows, lobe_truth_energy_opencl, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(correlated),
        cmocka_unit_test(separable),
        cmocka_unit_test(schlick_smith),
        cmocka_unit_test(energy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
