/* Rows of numbers as text: separated by white space or one comma, `#` starts a comment, blank lines are skipped.
 * Only finite decimal numbers inside their column's range are taken; anything else refuses the whole text. */
#ifndef LOBE_ROWS_H
#define LOBE_ROWS_H
#include <stddef.h>
#include <stdio.h>

typedef struct lobe_column {
    const char *name;
    double lo, hi;
} lobe_column;

typedef struct lobe_rows {
    double *values; /* count rows of the columns asked for; NULL if count is 0 */
    size_t count;
} lobe_rows;

/* Reads all of text. 0, or 2 with `source:line: reason` in error and rows empty. */
int lobe_rows_parse(const char *text, size_t length, const char *source, const lobe_column *columns, int column_count,
                    lobe_rows *rows, char *error, size_t error_size);

/* The same from a stream, to its end. */
int lobe_rows_read(FILE *in, const char *source, const lobe_column *columns, int column_count, lobe_rows *rows,
                   char *error, size_t error_size);

void lobe_rows_free(lobe_rows *rows);

#endif
