#include "env_lobes_table_entry.h"

LOBE_ENV_TABLE_Q30(lobe_env_lobes4_table16, 4)
