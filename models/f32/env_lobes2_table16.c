#include "env_lobes_table_entry.h"

LOBE_ENV_TABLE_F32(lobe_env_lobes2_table16, 2)
