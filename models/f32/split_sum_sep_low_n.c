#define LOBE_ARRAYS 1
#include "../split_sum_sep.h"
#include "entry.h"

LOBE_DFG_N_F32(lobe_split_sum_sep_low)
