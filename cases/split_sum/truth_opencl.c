#define LOBE_DOUBLE
#include "truth_kernel.h"
#include "truth_nodes.h"
#include "truth_split_sum.h"
#include "../fit/opencl.h"

/* core/dialect.h, truth_kernel.h and truth_rows.cl, embedded at build time */
extern const char lobe_truth_source[];

static int rows(int smith, int columns, const double *in, double *out, size_t n, char *error, size_t error_size)
{
    double table[2 * LOBE_TRUTH_ORDER];
    lobe_opencl_job job = {lobe_truth_source,
                           "lobe_truth_rows",
                           in,
                           2 * n,
                           out,
                           (size_t)columns * n,
                           table,
                           2 * LOBE_TRUTH_ORDER,
                           columns == 1 ? smith + 16 : smith,
                           n};
    lobe_truth_nodes(table, table + LOBE_TRUTH_ORDER, LOBE_TRUTH_ORDER);
    return lobe_opencl_run(&job, error, error_size);
}

int lobe_truth_split_sum_opencl(const double *in, double *out, size_t n, char *error, size_t error_size)
{
    return rows(LOBE_TRUTH_CORRELATED, 2, in, out, n, error, error_size);
}

int lobe_truth_split_sum_sep_opencl(const double *in, double *out, size_t n, char *error, size_t error_size)
{
    return rows(LOBE_TRUTH_SEPARABLE, 2, in, out, n, error, error_size);
}

int lobe_truth_split_sum_kibl_opencl(const double *in, double *out, size_t n, char *error, size_t error_size)
{
    return rows(LOBE_TRUTH_KIBL, 2, in, out, n, error, error_size);
}

int lobe_truth_energy_opencl(const double *in, double *out, size_t n, char *error, size_t error_size)
{
    return rows(LOBE_TRUTH_CORRELATED, 1, in, out, n, error, error_size);
}
