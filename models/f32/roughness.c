#include "../lobe.h"
#include "../roughness.h"

float lobe_alpha_of_roughness_f32(float roughness) { return lobe_alpha_of_roughness(roughness); }

float lobe_roughness_of_alpha_f32(float alpha) { return lobe_roughness_of_alpha(alpha); }

float lobe_roughness_of_smoothness_f32(float smoothness) { return lobe_roughness_of_smoothness(smoothness); }

float lobe_roughness_of_gloss_f32(float gloss) { return lobe_roughness_of_gloss(gloss); }

float lobe_gloss_of_roughness_f32(float roughness) { return lobe_gloss_of_roughness(roughness); }

float lobe_roughness_of_phong_f32(float exponent) { return lobe_roughness_of_phong(exponent); }

float lobe_phong_of_roughness_f32(float roughness) { return lobe_phong_of_roughness(roughness); }
