/* Reads numbers and rows of numbers from text that may be anything at all. */
#ifndef LOBE_ROWS_H
#define LOBE_ROWS_H
#include <stddef.h>

enum { LOBE_REASON_SIZE = 192, LOBE_NUMBER_LENGTH = 63 };

/* Writes at most size bytes; what cannot be printed becomes '?', what is too long ends in "...". */
void lobe_quote(const char *text, size_t length, char *quoted, size_t size);

/* The whole of text as one number: decimal, hex float, inf or nan. Returns 1, or 0 where it is none. */
int lobe_read_number(const char *text, size_t length, double *number);

/* A row separated by blanks or single commas; '#' starts a comment. Returns how many numbers it has, at
 * most max, or -1 with the reason. */
int lobe_read_row(const char *line, size_t length, double *numbers, int max, char reason[LOBE_REASON_SIZE]);

#endif
