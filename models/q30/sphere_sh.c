#include "sphere_sh.h"

lobe_sh9_q30 lobe_sphere_sh_q30(int32_t sine, lobe_vec3_q30 direction)
{
    return lobe_sphere_sh_of_q30(sine, direction);
}
