#define LOBE_DOUBLE 1
#include "closed_form.h"
#include "../../models/diffuse_sh_radiance.h"

static void spread(lobe_sh9 a, double c[9])
{
    const double all[9] = {a.c0, a.c1, a.c2, a.c3, a.c4, a.c5, a.c6, a.c7, a.c8};
    int i;
    for (i = 0; i < 9; i++)
        c[i] = all[i];
}

void lobe_diffuse_closed_form(double roughness, double n_dot_v, double c[9])
{
    spread(lobe_diffuse_sh_exact(roughness, n_dot_v), c);
}

void lobe_diffuse_closed_form_turned(double roughness, const double normal[3], const double view[3], double c[9])
{
    const lobe_vec3 n = lobe_vec3_of(normal[0], normal[1], normal[2]), w = lobe_vec3_of(view[0], view[1], view[2]);
    const double v = lobe_saturate(lobe_vec3_dot(n, w));
    spread(lobe_diffuse_sh_turned_full(lobe_diffuse_shape_exact(roughness, v), n, w, v), c);
}
