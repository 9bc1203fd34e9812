/* Ctrl-C as a flag: a fit looks at it between batches, hands back its best point with the status interrupted, and
 * the caller leaves its old result file as it was. A second Ctrl-C ends the process at once. */
#ifndef LOBE_INTERRUPT_H
#define LOBE_INTERRUPT_H

#include <stdbool.h>

/* Takes over SIGINT. Returns false where the system refuses. */
bool lobe_interrupt_install(void);
bool lobe_interrupt_requested(void);
/* Forgets a request, and takes the next Ctrl-C as a first one. */
void lobe_interrupt_clear(void);

#endif
