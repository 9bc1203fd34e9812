#include "rows.h"
#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define WORD_MAX 63 /* no decimal of a double needs more characters to be exact enough */

typedef struct cursor {
    const char *at, *end; /* of the line, its comment cut off */
    const char *source;
    size_t line;
    char *error;
    size_t error_size;
} cursor;

static int is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

static void skip_blank(cursor *c)
{
    while (c->at < c->end && is_blank(*c->at))
        c->at++;
}

/* A word for a message: printable, and not longer than a line should be */
static const char *show(const char *word, size_t length, char *shown)
{
    size_t i, n = length < 40 ? length : 40;
    for (i = 0; i < n; i++)
        shown[i] = isprint((unsigned char)word[i]) ? word[i] : '?';
    strcpy(shown + n, length > n ? "..." : "");
    return shown;
}

static int refuse_word(cursor *c, const lobe_column *column, const char *word, size_t length, const char *why)
{
    char shown[48];
    snprintf(c->error, c->error_size, "%s:%zu: %s '%s' %s, allowed range [%.9g, %.9g]", c->source, c->line,
             column->name, show(word, length, shown), why, column->lo, column->hi);
    return 2;
}

/* A finite decimal in range: strtod alone would also take nan, infinity and hexadecimal. */
static int parse_word(cursor *c, const lobe_column *column, const char *word, size_t length, double *value)
{
    char copy[WORD_MAX + 1], *rest;
    size_t i;
    for (i = 0; i < length; i++) {
        if (!strchr("0123456789+-.eE", word[i]) || word[i] == '\0')
            return refuse_word(c, column, word, length, "is not a decimal number");
    }
    if (length > WORD_MAX)
        return refuse_word(c, column, word, length, "is too long for a number");
    memcpy(copy, word, length);
    copy[length] = '\0';
    *value = strtod(copy, &rest);
    if (rest == copy || *rest != '\0')
        return refuse_word(c, column, word, length, "is not a decimal number");
    if (!(*value >= column->lo && *value <= column->hi))
        return refuse_word(c, column, word, length, "is out of its domain");
    return 0;
}

static int refuse_count(cursor *c, const lobe_column *columns, int column_count, const char *what)
{
    int used = snprintf(c->error, c->error_size, "%s:%zu: %s, expected %d:", c->source, c->line, what, column_count);
    int i;
    for (i = 0; i < column_count && used >= 0 && (size_t)used < c->error_size; i++)
        used += snprintf(c->error + used, c->error_size - (size_t)used, " %s in [%.9g, %.9g]%s", columns[i].name,
                         columns[i].lo, columns[i].hi, i + 1 < column_count ? "," : "");
    return 2;
}

/* One line. 0 with *found telling whether there was a row, or 2. */
static int parse_line(cursor *c, const lobe_column *columns, int column_count, double *row, int *found)
{
    char what[48];
    int i = 0;
    *found = 0;
    skip_blank(c);
    if (c->at == c->end)
        return 0;
    for (;;) {
        const char *word = c->at;
        while (c->at < c->end && !is_blank(*c->at) && *c->at != ',')
            c->at++;
        if (c->at == word)
            return refuse_count(c, columns, column_count, "an empty field");
        if (i < column_count) {
            const int status = parse_word(c, &columns[i], word, (size_t)(c->at - word), &row[i]);
            if (status)
                return status;
        }
        i++;
        skip_blank(c);
        if (c->at == c->end)
            break;
        if (*c->at == ',') {
            c->at++;
            skip_blank(c);
        }
    }
    if (i != column_count) {
        snprintf(what, sizeof what, "%d number%s in the row", i, i == 1 ? "" : "s");
        return refuse_count(c, columns, column_count, what);
    }
    *found = 1;
    return 0;
}

int lobe_rows_parse(const char *text, size_t length, const char *source, const lobe_column *columns, int column_count,
                    lobe_rows *rows, char *error, size_t error_size)
{
    const char *end = text + length;
    cursor c = {text, text, source, 0, error, error_size};
    size_t room = 0;
    const size_t width = (size_t)column_count;
    rows->values = NULL;
    rows->count = 0;
    while (text < end) {
        const char *stop = memchr(text, '\n', (size_t)(end - text));
        const char *comment;
        int found, status;
        if (!stop)
            stop = end;
        comment = memchr(text, '#', (size_t)(stop - text));
        c.at = text;
        c.end = comment ? comment : stop;
        c.line++;
        if (rows->count == room) {
            const size_t more = room ? 2 * room : 64;
            double *values = realloc(rows->values, more * width * sizeof *values);
            if (!values) {
                snprintf(error, error_size, "%s:%zu: not enough memory", source, c.line);
                lobe_rows_free(rows);
                return 2;
            }
            rows->values = values;
            room = more;
        }
        status = parse_line(&c, columns, column_count, rows->values + rows->count * width, &found);
        if (status) {
            lobe_rows_free(rows);
            return status;
        }
        rows->count += found ? 1 : 0;
        text = stop < end ? stop + 1 : end;
    }
    return 0;
}

int lobe_rows_read(FILE *in, const char *source, const lobe_column *columns, int column_count, lobe_rows *rows,
                   char *error, size_t error_size)
{
    char *text = NULL;
    size_t length = 0, room = 0;
    int status;
    rows->values = NULL;
    rows->count = 0;
    for (;;) {
        size_t got;
        if (length == room) {
            const size_t more = room ? 2 * room : 65536;
            char *grown = realloc(text, more);
            if (!grown) {
                snprintf(error, error_size, "%s: not enough memory", source);
                free(text);
                return 2;
            }
            text = grown;
            room = more;
        }
        got = fread(text + length, 1, room - length, in);
        length += got;
        if (got == 0)
            break;
    }
    if (ferror(in)) {
        snprintf(error, error_size, "%s: cannot read: %s", source, strerror(errno));
        free(text);
        return 2;
    }
    status = lobe_rows_parse(text, length, source, columns, column_count, rows, error, error_size);
    free(text);
    return status;
}

void lobe_rows_free(lobe_rows *rows)
{
    free(rows->values);
    rows->values = NULL;
    rows->count = 0;
}
