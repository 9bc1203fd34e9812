#include "../lobe.h"

lobe_sh9_q30 lobe_diffuse_sh_lambert_q30(void)
{
    /* sqrt(1 / 4 pi), sqrt(1 / 3 pi), sqrt(5 / 64 pi) */
    const lobe_sh9_q30 c = {{302896976, 0, 349755302, 0, 0, 0, 169324557, 0, 0}};
    return c;
}
