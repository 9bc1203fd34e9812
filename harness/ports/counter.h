/* Counts instructions between two calls, up to ten million; always 0 where the target cannot. */
#ifndef LOBE_PORTS_COUNTER_H
#define LOBE_PORTS_COUNTER_H
#include <stdint.h>

void lobe_count_from_here(void);
uint32_t lobe_counted(void);

#endif
