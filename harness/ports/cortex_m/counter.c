/* Instructions from SysTick. Under `qemu-system-arm -icount shift=6` an instruction lasts 64 ns and the 25 MHz
 * clock of the mps2 boards ticks every 40 ns: five instructions are eight ticks, exactly. */
#include "../counter.h"

#define SYST_CSR (*(volatile uint32_t *)0xe000e010u)
#define SYST_RVR (*(volatile uint32_t *)0xe000e014u)
#define SYST_CVR (*(volatile uint32_t *)0xe000e018u)

void lobe_count_from_here(void)
{
    SYST_RVR = 0xffffffu; /* 24 bits: the loops must stay under ten million instructions */
    SYST_CSR = 5;         /* run, from the core clock, without interrupts */
    SYST_CVR = 0;         /* any write starts over from the reload value */
}

uint32_t lobe_counted(void) { return ((0xffffffu - (SYST_CVR & 0xffffffu)) * 5 + 4) / 8; }
