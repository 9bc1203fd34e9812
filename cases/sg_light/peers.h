/* The published forms, as they are used: the NDF as one SG of sharpness 2 / a2 and amplitude 1 / (pi a2), warped about
 * the mirror direction, its integral with the light; visibility (separable Smith, as their code has it) and cosine at
 * the warped lobe's axis. A row is one of lobe_truth_sg_rows. Where the view stands on the normal, the frame of the
 * anisotropic warp is 0/0 in print: here any tangent is taken. */
#ifndef LOBE_SG_LIGHT_PEERS_H
#define LOBE_SG_LIGHT_PEERS_H

/* Wang et al. 2009: an SG of a quarter of the sharpness over n.v. */
double lobe_peer_sg_warp(const double row[5]);

/* Xu et al. 2013: anisotropic, sharpnesses s / (8 (n.v)^2) across and s / 8 along the plane of incidence. */
double lobe_peer_asg_warp(const double row[5]);

/* The same with correlated visibility and four constants refitted: sharpness, axis, least n.v, amplitude. */
double lobe_peer_asg_refitted(const double row[5]);

#endif
