/* OpenCL: kernel `run(in, out, rows)` of a one-file program. */
#include "device.h"
#include "read_whole.h"

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <stdlib.h>
#include <string.h>

const char *const device_suffix = "cl";

static cl_device_id device;
static cl_context context;
static cl_command_queue queue;
static char name[128];

const char *device_name(void) { return name; }

const char *device_open(void)
{
    cl_platform_id platforms[8];
    cl_uint n = 0, i;
    cl_int bad;
    if (clGetPlatformIDs(8, platforms, &n) || n == 0)
        return "no OpenCL platform (is an ICD installed?)";
    for (i = 0; i < n && i < 8 && !device; i++)
        if (clGetDeviceIDs(platforms[i], CL_DEVICE_TYPE_ALL, 1, &device, NULL))
            device = NULL;
    if (!device)
        return "no OpenCL device (is the cache folder writable? see POCL_CACHE_DIR)";
    clGetDeviceInfo(device, CL_DEVICE_NAME, sizeof name, name, NULL);
    context = clCreateContext(NULL, 1, &device, NULL, NULL, &bad);
    if (bad)
        return "no OpenCL context";
    queue = clCreateCommandQueue(context, device, 0, &bad);
    return bad ? "no OpenCL queue" : NULL;
}

void device_close(void)
{
    if (queue)
        clReleaseCommandQueue(queue);
    if (context)
        clReleaseContext(context);
}

static cl_program build(const char *path)
{
    static char log[8192];
    size_t size;
    char *text = read_whole(path, &size);
    const char *source = text;
    cl_int bad;
    cl_program p;
    if (!text)
        return NULL;
    p = clCreateProgramWithSource(context, 1, &source, &size, &bad);
    free(text);
    if (bad)
        return NULL;
    if (clBuildProgram(p, 1, &device, "-cl-std=CL1.2", NULL, NULL)) {
        clGetProgramBuildInfo(p, device, CL_PROGRAM_BUILD_LOG, sizeof log, log, NULL);
        fputs(log, stderr);
        clReleaseProgram(p);
        return NULL;
    }
    return p;
}

static const char *launch(cl_program p, cl_mem in, cl_mem out, size_t rows)
{
    const cl_uint n = (cl_uint)rows;
    const char *failure = NULL;
    cl_int bad;
    cl_kernel k = clCreateKernel(p, "run", &bad);
    if (bad)
        return "the program has no kernel `run`";
    if (clSetKernelArg(k, 0, sizeof in, &in) || clSetKernelArg(k, 1, sizeof out, &out) ||
        clSetKernelArg(k, 2, sizeof n, &n) || clEnqueueNDRangeKernel(queue, k, 1, NULL, &rows, NULL, 0, NULL, NULL) ||
        clFinish(queue))
        failure = "the kernel does not run";
    clReleaseKernel(k);
    return failure;
}

const char *device_run(const char *path, const float *in, unsigned n_in, float *out, unsigned n_out, size_t rows)
{
    const size_t in_size = rows * n_in * sizeof *in, out_size = rows * n_out * sizeof *out;
    const char *failure;
    cl_int bad_in, bad_out;
    cl_mem i, o;
    cl_program p = build(path);
    if (!p)
        return "the program does not build";
    i = clCreateBuffer(context, CL_MEM_READ_ONLY, in_size, NULL, &bad_in);
    o = clCreateBuffer(context, CL_MEM_WRITE_ONLY, out_size, NULL, &bad_out);
    if (bad_in || bad_out || clEnqueueWriteBuffer(queue, i, CL_TRUE, 0, in_size, in, 0, NULL, NULL))
        failure = "no memory on the device";
    else
        failure = launch(p, i, o, rows);
    if (!failure && clEnqueueReadBuffer(queue, o, CL_TRUE, 0, out_size, out, 0, NULL, NULL))
        failure = "the results cannot be read back";
    if (!bad_in)
        clReleaseMemObject(i);
    if (!bad_out)
        clReleaseMemObject(o);
    clReleaseProgram(p);
    return failure;
}
