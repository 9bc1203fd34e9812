#include "table_entry.h"

LOBE_TABLE_Q30(lobe_split_sum_table128, 128)
