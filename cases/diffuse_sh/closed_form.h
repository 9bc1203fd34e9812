/* The kernels of models/ in double: what is fitted and judged over more points than quadrature has time for. The exact
 * one is within 2e-14 of the truth (cases/test/test_diffuse_sh.c). */
#ifndef LOBE_DIFFUSE_CLOSED_FORM_H
#define LOBE_DIFFUSE_CLOSED_FORM_H

void lobe_diffuse_closed_form(double roughness, double n_dot_v, double c[9]);

/* World space: unit normal and view. */
void lobe_diffuse_closed_form_turned(double roughness, const double normal[3], const double view[3], double c[9]);

#endif
