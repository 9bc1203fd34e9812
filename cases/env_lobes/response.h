/* What a surface answers to light from l: BRDF times n.l, GGX with height-correlated Smith. Frame: z is the normal, the
 * view is (sqrt(1 - v^2), 0, v), v = n_dot_v in (0, 1]. Its integral over l is the albedo. */
#ifndef LOBE_ENV_RESPONSE_H
#define LOBE_ENV_RESPONSE_H

/* F = 1: D G2 / (4 n.v); 0 from the horizon down. */
double lobe_response(double alpha, double n_dot_v, const double l[3]);

/* The same times Schlick's (1 - v.h)^5: with f0 the response is f0 lobe_response + (1 - f0) of this. */
double lobe_response_schlick(double alpha, double n_dot_v, const double l[3]);

/* G2 / G1(v) for n.l above 0: what is left of a visible normal's light. */
double lobe_response_shadowing(double alpha, double n_dot_v, double n_dot_l);

#endif
