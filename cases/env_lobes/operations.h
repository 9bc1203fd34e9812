/* What the kernels of environment lobes cost, as cases/fit/trace.cpp counts. */
#ifndef LOBE_ENV_OPERATIONS_H
#define LOBE_ENV_OPERATIONS_H

#if defined(__cplusplus)
extern "C" {
#endif

/* Operations of env_lobes, or where gaussian of env_lobes_sg, with that many lobes and the albedo given; -1 where there
 * is no such tier. */
int lobe_env_operations(int gaussian, int lobes);

#if defined(__cplusplus)
}
#endif
#endif
