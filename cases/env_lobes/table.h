/* A fan of taps as a bilinear table of 16 x 16 nodes (models/env_lobes_table.h): of every tap its shift, its width over
 * the roughness and its part of the albedo; the last tap has what the parts leave. */
#ifndef LOBE_ENV_TABLE_H
#define LOBE_ENV_TABLE_H
#include "fan.h"

enum {
    LOBE_ENV_TABLE_SIDE = 16,
    LOBE_ENV_TABLE_NODES = LOBE_ENV_TABLE_SIDE * LOBE_ENV_TABLE_SIDE,
    LOBE_ENV_TABLE_NUMBERS = 3 * LOBE_CELL_TAPS - 1, /* of a node, at most */
    LOBE_ENV_TABLE_MOST = LOBE_ENV_TABLE_NODES * LOBE_ENV_TABLE_NUMBERS
};

/* The largest width of a fit, all but a clamped cosine; between nodes what ships may go on to 1. */
#define LOBE_ENV_TABLE_WIDEST 0.9975

/* Where a point lies: between node, the next, and those two of the row after, which have these parts in it. */
typedef struct lobe_env_table_point {
    double alpha, n_dot_v, roughness, theta, reach;
    int node;
    double part[4];
} lobe_env_table_point;

lobe_env_table_point lobe_env_table_point_of(double alpha, double n_dot_v);

/* The inverse: the point at (row, column), which need not be whole. */
void lobe_env_table_place(double row, double column, double *alpha, double *n_dot_v);

int lobe_env_table_numbers(int taps); /* of a node */

/* table: [node][number]. growth, unless NULL: of each tap the derivative of ln t by its number for the width. */
void lobe_env_table_taps(const lobe_env_table_point *point, const double *table, int taps, lobe_cell_tap *out,
                         double *growth);

/* The closed form with coefficients p (fan.h), at the nodes. */
void lobe_env_table_start(const double *p, int taps, double *table);

/* What ships are integers: a number of this kind (0: shift, 1: width, 2: part) in these units. */
double lobe_env_table_unit(int kind);

/* What a number of this kind may be in this node. */
void lobe_env_table_bounds(int kind, int node, double *least, double *most);

#endif
