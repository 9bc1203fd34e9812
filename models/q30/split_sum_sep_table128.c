#include "table_entry.h"

LOBE_TABLE_Q30(lobe_split_sum_sep_table128, 128)
