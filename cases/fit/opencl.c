#include "opencl.h"
#include <stdio.h>

#if defined(__has_include) && !defined(LOBE_WITHOUT_OPENCL)
#if __has_include(<CL/cl.h>)
#define HAVE_OPENCL 1
#endif
#endif

#if !defined(HAVE_OPENCL)

int lobe_opencl_run(const lobe_opencl_job *job, char *error, size_t error_size)
{
    (void)job;
    snprintf(error, error_size,
             "OpenCL: this program was built without the OpenCL headers (CL/cl.h); "
             "install them and rebuild, or leave --opencl out");
    return 2;
}

#else

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The functions that are used, loaded by name. */
#define FUNCTIONS(X)                                                                                                   \
    X(clGetPlatformIDs)                                                                                                \
    X(clGetPlatformInfo)                                                                                               \
    X(clGetDeviceIDs)                                                                                                  \
    X(clGetDeviceInfo)                                                                                                 \
    X(clCreateContext)                                                                                                 \
    X(clReleaseContext)                                                                                                \
    X(clCreateCommandQueue)                                                                                            \
    X(clReleaseCommandQueue)                                                                                           \
    X(clCreateProgramWithSource)                                                                                       \
    X(clBuildProgram)                                                                                                  \
    X(clGetProgramBuildInfo)                                                                                           \
    X(clReleaseProgram)                                                                                                \
    X(clCreateKernel)                                                                                                  \
    X(clReleaseKernel)                                                                                                 \
    X(clSetKernelArg)                                                                                                  \
    X(clCreateBuffer)                                                                                                  \
    X(clReleaseMemObject)                                                                                              \
    X(clEnqueueNDRangeKernel)                                                                                          \
    X(clEnqueueReadBuffer)                                                                                             \
    X(clFinish)

typedef struct api {
#define MEMBER(name) __typeof__(name) *name;
    FUNCTIONS(MEMBER)
#undef MEMBER
} api;

typedef struct session {
    api cl;
    cl_platform_id platform;
    cl_device_id device;
    cl_context context;
    cl_command_queue queue;
    cl_program program;
    cl_kernel kernel;
    cl_mem in, out, table;
} session;

static int load(api *cl, char *error, size_t error_size)
{
    void *library = dlopen("libOpenCL.so.1", RTLD_NOW);
    if (!library)
        library = dlopen("libOpenCL.so", RTLD_NOW);
    if (!library) {
        snprintf(error, error_size,
                 "OpenCL: no loader (libOpenCL.so.1) on this machine; install ocl-icd-libopencl1 "
                 "and an ICD such as pocl-opencl-icd, or leave --opencl out");
        return 2;
    }
#define LOAD(name)                                                                                                     \
    {                                                                                                                  \
        void *f = dlsym(library, #name);                                                                               \
        if (!f) {                                                                                                      \
            snprintf(error, error_size, "OpenCL: the loader lacks " #name);                                            \
            return 2;                                                                                                  \
        }                                                                                                              \
        memcpy(&cl->name, &f, sizeof f); /* ISO C has no cast from object to function pointer */                       \
    }
    FUNCTIONS(LOAD)
#undef LOAD
    return 0;
}

/* PoCL links its kernels with ld, and aborts the whole process where that is not on PATH. */
static int is_on_path(const char *program)
{
    const char *path = getenv("PATH");
    while (path && *path) {
        const char *end = strchr(path, ':');
        const int length = end ? (int)(end - path) : (int)strlen(path);
        char file[4096];
        snprintf(file, sizeof file, "%.*s/%s", length, path, program);
        if (access(file, X_OK) == 0)
            return 1;
        path = end ? end + 1 : NULL;
    }
    return 0;
}

/* The first device with doubles, on any platform. */
static int pick_device(session *s, char *error, size_t error_size)
{
    cl_platform_id platforms[16];
    cl_uint platform_count = 0, device_count, i, k, seen = 0;
    const cl_int status = s->cl.clGetPlatformIDs(16, platforms, &platform_count);
    if (status != CL_SUCCESS || platform_count == 0) {
        snprintf(error, error_size,
                 "OpenCL: no platform (status %d): install an ICD such as pocl-opencl-icd, or leave "
                 "--opencl out",
                 (int)status);
        return 2;
    }
    for (i = 0; i < platform_count && i < 16; i++) {
        cl_device_id devices[16];
        char name[256] = "";
        s->cl.clGetPlatformInfo(platforms[i], CL_PLATFORM_NAME, sizeof name, name, NULL);
        if (strstr(name, "Portable Computing Language") && !is_on_path("ld")) {
            snprintf(error, error_size, "OpenCL: PoCL needs the linker ld (binutils) on PATH");
            return 2;
        }
        device_count = 0;
        if (s->cl.clGetDeviceIDs(platforms[i], CL_DEVICE_TYPE_ALL, 16, devices, &device_count) != CL_SUCCESS)
            continue;
        for (k = 0; k < device_count && k < 16; k++) {
            cl_device_fp_config doubles = 0;
            seen++;
            s->cl.clGetDeviceInfo(devices[k], CL_DEVICE_DOUBLE_FP_CONFIG, sizeof doubles, &doubles, NULL);
            if (doubles) {
                s->platform = platforms[i];
                s->device = devices[k];
                return 0;
            }
        }
    }
    if (seen)
        snprintf(error, error_size, "OpenCL: none of %u devices has double precision", seen);
    else
        snprintf(error, error_size,
                 "OpenCL: no device. With PoCL this is also the sign of a cache that cannot be "
                 "written: set POCL_CACHE_DIR to a folder that can");
    return 2;
}

static int fail(char *error, size_t error_size, const char *what, cl_int status)
{
    snprintf(error, error_size, "OpenCL: %s fails with status %d", what, (int)status);
    return 2;
}

static int build(session *s, const lobe_opencl_job *job, char *error, size_t error_size)
{
    cl_int status;
    s->context = s->cl.clCreateContext(NULL, 1, &s->device, NULL, NULL, &status);
    if (status != CL_SUCCESS)
        return fail(error, error_size, "clCreateContext", status);
    s->queue = s->cl.clCreateCommandQueue(s->context, s->device, 0, &status);
    if (status != CL_SUCCESS)
        return fail(error, error_size, "clCreateCommandQueue", status);
    s->program = s->cl.clCreateProgramWithSource(s->context, 1, (const char **)(size_t)&job->source, NULL, &status);
    if (status != CL_SUCCESS)
        return fail(error, error_size, "clCreateProgramWithSource", status);
    status = s->cl.clBuildProgram(s->program, 1, &s->device, "-cl-std=CL1.2", NULL, NULL);
    if (status != CL_SUCCESS) {
        const size_t size = 1 << 20; /* a log that does not fit is not handed out at all */
        char *log = calloc(1, size);
        if (log)
            s->cl.clGetProgramBuildInfo(s->program, s->device, CL_PROGRAM_BUILD_LOG, size, log, NULL);
        snprintf(error, error_size, "OpenCL: the kernel does not build (status %d): %.600s", (int)status,
                 log ? log : "");
        free(log);
        return 2;
    }
    s->kernel = s->cl.clCreateKernel(s->program, job->entry, &status);
    return status == CL_SUCCESS ? 0 : fail(error, error_size, "clCreateKernel", status);
}

static int run(session *s, const lobe_opencl_job *job, char *error, size_t error_size)
{
    const cl_mem_flags copy = CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR;
    const cl_int mode = job->mode;
    cl_int status;
    s->in = s->cl.clCreateBuffer(s->context, copy, job->in_count * sizeof(double), (void *)(size_t)job->in, &status);
    if (status != CL_SUCCESS)
        return fail(error, error_size, "clCreateBuffer", status);
    s->table =
        s->cl.clCreateBuffer(s->context, copy, job->table_count * sizeof(double), (void *)(size_t)job->table, &status);
    if (status != CL_SUCCESS)
        return fail(error, error_size, "clCreateBuffer", status);
    s->out = s->cl.clCreateBuffer(s->context, CL_MEM_WRITE_ONLY, job->out_count * sizeof(double), NULL, &status);
    if (status != CL_SUCCESS)
        return fail(error, error_size, "clCreateBuffer", status);
    status = s->cl.clSetKernelArg(s->kernel, 0, sizeof s->in, &s->in);
    status |= s->cl.clSetKernelArg(s->kernel, 1, sizeof s->out, &s->out);
    status |= s->cl.clSetKernelArg(s->kernel, 2, sizeof s->table, &s->table);
    status |= s->cl.clSetKernelArg(s->kernel, 3, sizeof mode, &mode);
    if (status != CL_SUCCESS)
        return fail(error, error_size, "clSetKernelArg", status);
    status = s->cl.clEnqueueNDRangeKernel(s->queue, s->kernel, 1, NULL, &job->rows, NULL, 0, NULL, NULL);
    if (status != CL_SUCCESS)
        return fail(error, error_size, "clEnqueueNDRangeKernel", status);
    status = s->cl.clEnqueueReadBuffer(s->queue, s->out, CL_TRUE, 0, job->out_count * sizeof(double), job->out, 0, NULL,
                                       NULL);
    return status == CL_SUCCESS ? 0 : fail(error, error_size, "clEnqueueReadBuffer", status);
}

static void release(session *s)
{
    if (s->out)
        s->cl.clReleaseMemObject(s->out);
    if (s->table)
        s->cl.clReleaseMemObject(s->table);
    if (s->in)
        s->cl.clReleaseMemObject(s->in);
    if (s->kernel)
        s->cl.clReleaseKernel(s->kernel);
    if (s->program)
        s->cl.clReleaseProgram(s->program);
    if (s->queue)
        s->cl.clReleaseCommandQueue(s->queue);
    if (s->context)
        s->cl.clReleaseContext(s->context);
}

int lobe_opencl_run(const lobe_opencl_job *job, char *error, size_t error_size)
{
    session s;
    int status;
    memset(&s, 0, sizeof s);
    status = load(&s.cl, error, error_size);
    if (!status)
        status = pick_device(&s, error, error_size);
    if (!status && job->rows > 0) {
        status = build(&s, job, error, error_size);
        if (!status)
            status = run(&s, job, error, error_size);
        release(&s);
    }
    return status;
}

#endif
