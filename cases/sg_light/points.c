#include "../sphere_light/light_points.h"
#include "columns.h"
#include "points.h"
#include <math.h>

static const lobe_light_points rows = {
    .roughness_lo = LOBE_SG_ROUGHNESS_LO,
    .n_dot_v_lo = LOBE_SG_N_DOT_V_LO,
    .sizes = {LOBE_SG_VERSINE_LO, 1.0 / 256, 1.0 / 32, LOBE_SG_VERSINE_HI},
    .far = {{.05, .5, .01},
            {.05, .001, .1},
            {.3, .001, .2},
            {.6, .5, 1},
            {1, 1, 1},
            {.05, 1, 1}},
    .width = sqrt,
    .setting = 1,
    .set = 2.2,
    .vectors = LOBE_SG_VECTORS,
    .inside = lobe_sg_inside,
    .taken = lobe_sg_taken,
    .draw = lobe_sg_draw};

size_t lobe_sg_points(double domain_lo, int beyond, uint64_t seed,
                      double *points, size_t room) {
  (void)domain_lo;
  return lobe_light_vector_points(&rows, beyond, seed, points, room);
}

void lobe_sg_judged(bool beyond, double *points, size_t count) {
  lobe_light_judged(&rows, beyond, points, count);
}
