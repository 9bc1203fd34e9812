/* Gauss-Legendre nodes and weights on [0, 1]. */
#ifndef LOBE_ENV_GAUSS_H
#define LOBE_ENV_GAUSS_H

enum { LOBE_GAUSS_MOST = 2048 };

/* 1 <= n <= LOBE_GAUSS_MOST. */
void lobe_gauss(int n, double *node, double *weight);

#endif
