/* Constants of the published forms in peers.h, in their order there.
 * Generated: lobefit search sphere_light --peers FILE (make sphere-light-peers); do not edit.
 * Fit: Nelder-Mead on the fit cells, uniform and mixed positions (cells.h), in double.
 * Metric: relative L2 error of a cell; above each stands the rms over the cells of both sets. */
#ifndef LOBE_SPHERE_LIGHT_PEERS_FITTED_H
#define LOBE_SPHERE_LIGHT_PEERS_FITTED_H

/* 0.4469 */
#define LOBE_PEER_SMOOTH_POINT 1.00557, 0.207828, 1.62556
/* 0.3324 */
#define LOBE_PEER_WIDER 0.730016
/* 0.2745 */
#define LOBE_PEER_WIDER_CAPPED 0.510080, 0.637010
/* 0.1784 */
#define LOBE_PEER_CAPPED_POINT 2.89641, 0.759694

#endif
