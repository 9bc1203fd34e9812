#include "interrupt.h"

#include <signal.h>

/* A signal handler can reach nothing but a global. */
static volatile sig_atomic_t requested;

static void on_interrupt(int number)
{
    requested = 1;
    signal(number, SIG_DFL);
}

bool lobe_interrupt_install(void) { return signal(SIGINT, on_interrupt) != SIG_ERR; }

bool lobe_interrupt_requested(void) { return requested != 0; }

void lobe_interrupt_clear(void)
{
    requested = 0;
    lobe_interrupt_install();
}
