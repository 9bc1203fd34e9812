#include "counter.h"

void lobe_count_from_here(void) {}

uint32_t lobe_counted(void) { return 0; }
