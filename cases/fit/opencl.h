/* One kernel over many rows in double through the OpenCL loader, which is opened at run time: lobefit links to
 * nothing, and says plainly when there is no loader, no platform, or no device that has doubles. */
#ifndef LOBE_OPENCL_H
#define LOBE_OPENCL_H
#include <stddef.h>

typedef struct lobe_opencl_job {
    const char *source; /* OpenCL C 1.2, complete: no include path is needed */
    const char *entry;  /* kernel(__global const double *in, __global double *out, __global const double *table, int) */
    const double *in;
    size_t in_count;
    double *out;
    size_t out_count;
    const double *table; /* constants that all rows share; at least one */
    size_t table_count;
    int mode; /* the last argument */
    size_t rows;
} lobe_opencl_job;

/* Runs the job to its end. 0, or 2 with the reason in error. */
int lobe_opencl_run(const lobe_opencl_job *job, char *error, size_t error_size);

#endif
