/* Writes the generated sources models/tables/env_lobesN_table16_i16.c. */
#ifndef LOBE_ENV_TABLE_WRITE_H
#define LOBE_ENV_TABLE_WRITE_H
#include <stdbool.h>
#include "table.h"

typedef struct lobe_env_table_text {
    const char *brdf, *grid, *metric;
    int taps;
    const double *table; /* multiples of lobe_env_table_unit */
    double error[LOBE_CELL_PARTS];
} lobe_env_table_text;

/* To what the file holds. */
void lobe_env_table_round(double *table, int taps);

/* Whole or not at all; false after a line on stderr. */
bool lobe_env_table_write(const lobe_env_table_text *text, const char *folder);

#endif
