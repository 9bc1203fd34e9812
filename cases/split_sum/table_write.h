/* Writes the generated sources of models/tables. */
#ifndef LOBE_TABLE_WRITE_H
#define LOBE_TABLE_WRITE_H
#include <stdbool.h>

typedef struct lobe_table_text {
    const char *model, *brdf;
    int side, per;
    const double *texels; /* scale and bias in turn, rounded by the function below */
    double max[2], rms[2];
} lobe_table_text;

typedef enum lobe_table_format { LOBE_TABLE_F32, LOBE_TABLE_U16 } lobe_table_format;

/* To six decimals, which is all that the file holds. n texels. */
void lobe_table_round_f32(double *texels, int n);

/* To multiples of 1 / 65535, scale + bias at most 65534 of them. */
void lobe_table_round_u16(double *texels, int n);

/* folder/MODEL_tableN_f32.c or _u16.c, whole or not at all; false after a line on stderr. */
bool lobe_table_write(const lobe_table_text *text, lobe_table_format format, const char *folder);

#endif
