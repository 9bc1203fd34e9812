/* What the kernels of environment lobes cost, as cases/fit/trace.cpp counts. */
#ifndef LOBE_ENV_OPERATIONS_H
#define LOBE_ENV_OPERATIONS_H

#if defined(__cplusplus)
extern "C" {
#endif

/* Operations of env_lobes, or where gaussian of env_lobes_sg, with that many lobes and the albedo given; -1 where there
 * is no such tier. */
int lobe_env_operations(int gaussian, int lobes);

/* Of the tier whose number of taps follows a need, all six of them and the count. */
int lobe_env_adaptive_operations(void);

/* Of a table of env_lobes with that many lobes: coordinates, interpolation of what is read at four nodes, and taps. */
int lobe_env_table_operations(int lobes);

#if defined(__cplusplus)
}
#endif
#endif
