#include "columns.h"
#include "light_points.h"
#include "points.h"
#include <math.h>

static double width(double sine) { return sine; }

static lobe_light_points rows(void) {
  const double tiny = .01 * 3.14159265358979323846 / 180;
  const lobe_light_points y = {.roughness_lo = LOBE_SPHERE_ROUGHNESS_LO,
                               .n_dot_v_lo = LOBE_SPHERE_N_DOT_V_LO,
                               .sizes = {sin(tiny), sin(100 * tiny),
                                         sin(1000 * tiny),
                                         LOBE_SPHERE_SINE_HI - 1e-7},
                               .far = {{.05, .5, .3},
                                       {.05, .001, .1},
                                       {.3, .001, .5},
                                       {.6, .5, 1},
                                       {1, 1, 1},
                                       {.05, 1, 1}},
                               .width = width,
                               .setting = .9,
                               .set = 1.1,
                               .vectors = LOBE_SPHERE_VECTORS,
                               .inside = lobe_sphere_inside,
                               .taken = lobe_sphere_taken,
                               .draw = lobe_sphere_draw};
  return y;
}

size_t lobe_sphere_points(double domain_lo, int beyond, uint64_t seed,
                          double *points, size_t room) {
  const lobe_light_points of = rows();
  (void)domain_lo;
  return lobe_light_vector_points(&of, beyond, seed, points, room);
}

void lobe_sphere_judged(bool beyond, double *points, size_t count) {
  const lobe_light_points of = rows();
  lobe_light_judged(&of, beyond, points, count);
}
