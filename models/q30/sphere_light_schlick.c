/* lobe_sphere_light_schlick of ../sphere_light_schlick.h in integers: its letters, and the order of its lines. */
#include "sphere_light_schlick.h"
#include "../../core/dialect.h"
#include "../coeffs/sphere_light_schlick.h"

static const lobe_q_scaled lobe_sphere_schlick_c0 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_SCHLICK_C0);
static const lobe_q_scaled lobe_sphere_schlick_c1 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_SCHLICK_C1);
static const lobe_q_scaled lobe_sphere_schlick_c2 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_SCHLICK_C2);
static const lobe_q_scaled lobe_sphere_schlick_c3 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_SCHLICK_C3);
static const lobe_q_scaled lobe_sphere_schlick_c4 = LOBE_QS_CONSTANT(LOBE_SPHERE_LIGHT_SCHLICK_C4);

int32_t lobe_sphere_light_schlick_q30(int32_t roughness, lobe_sphere_q30 light)
{
    const lobe_sphere_fixed s = lobe_sphere_fixed_of(roughness, light);
    const lobe_sphere_schlick_fixed k = lobe_sphere_schlick_begin(&s, lobe_sphere_schlick_c0, lobe_sphere_schlick_c1);
    const lobe_q_scaled left = lobe_qs_sub(lobe_qs_of(LOBE_Q30_ONE, 0), lobe_qs_mul(lobe_sphere_schlick_c2, k.part));
    const lobe_q_scaled up = lobe_qs_sub(lobe_qs_of(s.v, 0), lobe_qs_mul(left, k.off));
    const lobe_q_scaled level = lobe_qs_add(lobe_sphere_schlick_c3, lobe_qs_mul(lobe_sphere_schlick_c4, k.g));
    const lobe_q_scaled wide = lobe_qs_mul(lobe_qs_mul(lobe_qs_mul(k.r, s.alpha), k.part), level);
    return lobe_sphere_schlick_end(lobe_qs_add(lobe_sphere_schlick_moved(&s, left, up), wide));
}
