#include "table_entry.h"

LOBE_TABLE_F32(lobe_split_sum_table128, 128)
