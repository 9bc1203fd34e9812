/* Start-up of a Cortex-M without an operating system: vectors, memory, the FPU if code uses it, main, and the
 * exit status through semihosting. */
#include "../../port.h"

#include <stdint.h>

extern uint32_t ram_image[], data_start[], data_end[], bss_start[], bss_end[], stack_top[];
extern int main(void);

/* Two semihosting calls: write a text, stop the machine. */
enum { SYS_WRITE0 = 0x04, SYS_EXIT = 0x18 };
enum { STOPPED_RUN_TIME_ERROR = 0x20023, STOPPED_EXIT = 0x20026 };

static void semihost(uint32_t operation, uintptr_t argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register uintptr_t r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void lobe_port_print(const char *text) { semihost(SYS_WRITE0, (uintptr_t)text); }

void lobe_port_exit(int status)
{
    semihost(SYS_EXIT, status == 0 ? STOPPED_EXIT : STOPPED_RUN_TIME_ERROR);
    for (;;)
        ;
}

void start(void);
void start(void)
{
    const uint32_t *from = ram_image;
    uint32_t *to;
#if defined(__ARM_FP)
    *(volatile uint32_t *)0xe000ed88u |= 0xfu << 20; /* CPACR: coprocessors 10 and 11, the FPU */
    __asm__ volatile("dsb\n isb");
#endif
    for (to = data_start; to < data_end; to++)
        *to = *from++;
    for (to = bss_start; to < bss_end; to++)
        *to = 0;
    lobe_port_exit(main());
}

static void fault(void)
{
    lobe_port_print("fail the chip faulted\n");
    lobe_port_exit(1);
}

/* Stack, reset, NMI, hard fault; the rest end in a hard fault, since nothing enables them. */
__attribute__((section(".vectors"), used)) static const uintptr_t vectors[16] = {
    (uintptr_t)stack_top, (uintptr_t)start, (uintptr_t)fault, (uintptr_t)fault,
    (uintptr_t)fault,     (uintptr_t)fault, (uintptr_t)fault,
};
