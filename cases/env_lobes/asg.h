/* One anisotropic spherical Gaussian as the whole lobe, a star: max(0, z) exp(-x_sharpness x^2 - y_sharpness y^2) about
 * an axis in the plane of incidence, x along that plane (Xu et al., "Anisotropic Spherical Gaussians", 2013), at every
 * point the one whose shape is nearest to the response. */
#ifndef LOBE_ENV_ASG_H
#define LOBE_ENV_ASG_H

typedef struct lobe_asg {
    double angle, x_sharpness, y_sharpness; /* angle from the normal, positive away from the view */
    double weight;                          /* its integral over the sphere */
} lobe_asg;

/* Least relative L2 error against the response over its albedo by Nelder-Mead from the ASG warp; energy: of weight 1,
 * else of any weight. error: that error, unless NULL. */
lobe_asg lobe_asg_fit(double alpha, double n_dot_v, int energy, double *error);

double lobe_asg_at(const lobe_asg *asg, const double d[3]);

/* Rows as of lobe_visible_nodes, order^2 of them. */
int lobe_asg_nodes(const lobe_asg *asg, int order, double *rows);

/* The fits with energy at the points of judge.h, and a lobe_judge_model's nodes of them. */
enum { LOBE_ASG_POINTS = 30 };
typedef struct lobe_asg_star {
    double alpha[LOBE_ASG_POINTS], n_dot_v[LOBE_ASG_POINTS];
    lobe_asg asg[LOBE_ASG_POINTS];
} lobe_asg_star;
void lobe_asg_star_fit(lobe_asg_star *star);
int lobe_asg_star_nodes(const void *star, double alpha, double n_dot_v, double *rows);

#endif
