#include "../lobe.h"
#include "../env_fresnel.h"

void lobe_env_fresnel_f32(const lobe_env_tap_f32 *taps, const float *v_dot_tap, size_t n, float bias, float *tap_bias)
{
    float sum = 0.0f, grazing = 0.0f, scale, share, mean;
    size_t i;
    for (i = 0; i < n; i++) {
        tap_bias[i] = lobe_env_grazing(v_dot_tap[i], taps[i].width);
        sum += taps[i].weight;
        grazing += taps[i].weight * tap_bias[i];
    }
    scale = 1.0f / lobe_max(sum, 0.001f); /* no albedo is as low */
    share = lobe_saturate(bias) * scale;
    mean = grazing * scale;
    for (i = 0; i < n; i++)
        tap_bias[i] = lobe_env_bias(taps[i].weight, tap_bias[i], mean, share);
}
