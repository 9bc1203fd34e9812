/* Gauss-Legendre nodes and weights on [0, 1], by Newton's method from a guess that uses no library function: the
 * same bits on every machine. */
#ifndef LOBE_TRUTH_NODES_H
#define LOBE_TRUTH_NODES_H

#define LOBE_TRUTH_NODES_MAX 256

/* Fills u and weight with n nodes in rising order; n in [1, LOBE_TRUTH_NODES_MAX]. */
void lobe_truth_nodes(double *u, double *weight, int n);

#endif
