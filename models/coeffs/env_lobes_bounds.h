/* Operations of the kernels in models/env_lobes*.h, the albedo given, as cases/fit/trace.cpp counts them
 * (cases/env_lobes/operations.cpp; cases/test/test_env_operations.c holds these to it). The albedo's error is that of
 * energy_bounds.h. */
#define LOBE_ENV_LOBES_LOBES1_OPS 87
#define LOBE_ENV_LOBES_LOBES2_OPS 143
#define LOBE_ENV_LOBES_LOBES4_OPS 255
#define LOBE_ENV_LOBES_LOBES8_OPS 479
