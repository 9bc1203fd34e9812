#define LOBE_ARRAYS 1
#include "../split_sum.h"
#include "entry.h"

LOBE_DFG_N_F32(lobe_split_sum_high)
