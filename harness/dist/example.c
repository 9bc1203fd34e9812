#include <lobe.h>
#include <stdio.h>

int main(void)
{
    const lobe_dfg_f32 d = lobe_split_sum_low_f32(0.4f, 0.7f);
    printf("gold reflects %.2f of red light\n", 1.0 * d.scale + d.bias);
    return !(d.scale > 0.0f && d.bias >= 0.0f && d.scale + d.bias <= 1.0f);
}
