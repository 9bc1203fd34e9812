/* The normal equations of a sum of squares whose unknowns come in groups: a residual's slope by every unknown of a
 * group is one number times that group's terms, as it is where quantities are linear in their coefficients. A cell's
 * rows are then multiplied once a pair of groups and not once a pair of unknowns. */
#ifndef LOBE_ENV_NORMAL_EQUATIONS_H
#define LOBE_ENV_NORMAL_EQUATIONS_H

typedef struct lobe_normal_equations lobe_normal_equations;

typedef struct lobe_normal_column {
    const double *slope; /* of the residuals by the group's sum */
    const double *term;
    int first, count; /* unknowns */
} lobe_normal_column;

lobe_normal_equations *lobe_normal_new(int unknowns); /* NULL where there is no memory */
void lobe_normal_free(lobe_normal_equations *e);

void lobe_normal_clear(lobe_normal_equations *e);
void lobe_normal_add(lobe_normal_equations *e, const lobe_normal_column *column, int count, const double *residual,
                     int rows);

/* factor * value, value > 0 with slopes by the first `count` unknowns, as if it were the square of its root. */
void lobe_normal_add_square(lobe_normal_equations *e, double factor, double value, const double *slope, int count);

/* ridge * |x|^2; the first `held` unknowns stay where they are. */
void lobe_normal_add_ridge(lobe_normal_equations *e, double ridge, const double *x, int held);

/* The damped step from x to `to`, each unknown in units of the longest column that it has had. What the sum should lose
 * by it, or 0 where there is no step. */
double lobe_normal_step(lobe_normal_equations *e, double damping, const double *x, double *to);

#endif
