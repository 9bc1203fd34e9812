#include "../split_sum.h"
#include "entry.h"

LOBE_DFG_F32(lobe_split_sum_high)
