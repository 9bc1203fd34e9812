/* Operations of the kernels in models/env_lobes*.h, the albedo given, as cases/fit/trace.cpp counts them
 * (cases/env_lobes/operations.cpp; cases/test/test_env_operations.c holds these to it). The albedo's error is that of
 * energy_bounds.h. */
#define LOBE_ENV_LOBES_SG_LOBES1_OPS 86
#define LOBE_ENV_LOBES_SG_LOBES2_OPS 150
#define LOBE_ENV_LOBES_SG_LOBES4_OPS 223
#define LOBE_ENV_LOBES_SG_LOBES8_OPS 287
