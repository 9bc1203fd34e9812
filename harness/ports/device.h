/* A device that runs a kernel over rows of floats: OpenCL or a Vulkan compute queue, one a program. */
#ifndef LOBE_PORTS_DEVICE_H
#define LOBE_PORTS_DEVICE_H
#include <stddef.h>

/* What the device's kernel files are called: "cl" or "spv". */
extern const char *const device_suffix;

/* Prepares the first device; NULL, or why there is none. */
const char *device_open(void);
const char *device_name(void);

/* Runs the program in file `path` over `rows` rows of n_in floats, to rows of n_out floats.
 * NULL, or what went wrong. */
const char *device_run(const char *path, const float *in, unsigned n_in, float *out, unsigned n_out, size_t rows);

void device_close(void);

#endif
