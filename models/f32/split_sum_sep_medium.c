#include "../split_sum_sep.h"
#include "entry.h"

LOBE_DFG_F32(lobe_split_sum_sep_medium)
