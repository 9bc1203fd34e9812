#include "../compensation.h"
#include "../lobe.h"

float lobe_compensation_f32(float f0, float inverse_e) { return lobe_compensation(f0, inverse_e); }

float lobe_inverse_energy_alpha2_view_f32(float roughness, float n_dot_v)
{
    return lobe_inverse_energy_alpha2_view(roughness, n_dot_v);
}

float lobe_inverse_energy_alpha2_f32(float roughness) { return lobe_inverse_energy_alpha2(roughness); }
