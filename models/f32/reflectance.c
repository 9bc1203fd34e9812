#include "../lobe.h"
#include "../reflectance.h"

float lobe_reflectance_f32(lobe_dfg_f32 d, float f0, float f90)
{
    lobe_dfg terms;
    terms.scale = d.scale;
    terms.bias = d.bias;
    return lobe_reflectance(terms, f0, f90);
}

float lobe_f90_of_f0_f32(float f0) { return lobe_f90_of_f0(f0); }
