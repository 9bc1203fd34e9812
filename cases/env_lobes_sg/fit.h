/* `lobefit fit env_lobes_sg`: the coefficients of the outer layer. */
#ifndef LOBE_SG_FIT_H
#define LOBE_SG_FIT_H
#include "../case.h"
#include "../fit/sweep.h"

int lobe_env_sg_fit(const lobe_case *self, int argc, char **argv);

/* Coefficients c of a fan of count lobes on the environments of the fit; quantities whose bit is in held stay 0, and
 * with LOBE_SG_PRINTED the weights are the seed paper's as printed (fan.h). shape: of that fit, rms. 0, or 1 where it
 * was interrupted, 2 where there is no memory. */
#define LOBE_SG_PRINTED (1u << 31)
int lobe_env_sg_solve(int count, unsigned held, const lobe_sweep_options *sweep, double *c, double *radiance,
                      double *shape);

#endif
