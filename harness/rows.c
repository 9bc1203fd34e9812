#include "rows.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void lobe_quote(const char *text, size_t length, char *quoted, size_t size)
{
    size_t i;
    for (i = 0; i < length && i + 1 < size; i++)
        quoted[i] = (char)(text[i] >= ' ' && text[i] <= '~' ? text[i] : '?');
    quoted[i] = 0;
    if (i < length && size > 3)
        memcpy(quoted + i - 3, "...", 3);
}

int lobe_read_number(const char *text, size_t length, double *number)
{
    char copy[LOBE_NUMBER_LENGTH + 1];
    char *end;
    size_t i;
    if (length == 0 || length > LOBE_NUMBER_LENGTH)
        return 0;
    for (i = 0; i < length; i++)
        if (text[i] <= ' ' || text[i] > '~')
            return 0; /* strtod would skip blanks, and stop at a NUL */
    memcpy(copy, text, length);
    copy[length] = 0;
    *number = strtod(copy, &end);
    return end == copy + length;
}

static int is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

static size_t skip_blanks(const char *line, size_t length, size_t i)
{
    while (i < length && is_blank(line[i]))
        i++;
    return i;
}

int lobe_read_row(const char *line, size_t length, double *numbers, int max, char reason[LOBE_REASON_SIZE])
{
    char quoted[32];
    const char *comment = memchr(line, '#', length);
    size_t i;
    int count = 0, comma = 0;
    if (comment)
        length = (size_t)(comment - line);
    for (i = skip_blanks(line, length, 0); i < length || comma; i = skip_blanks(line, length, i)) {
        const size_t start = i;
        while (i < length && !is_blank(line[i]) && line[i] != ',')
            i++;
        if (i == start) {
            snprintf(reason, LOBE_REASON_SIZE, "nothing stands %s a comma", comma ? "after" : "before");
            return -1;
        }
        if (count == max) {
            snprintf(reason, LOBE_REASON_SIZE, "more than %d numbers", max);
            return -1;
        }
        if (!lobe_read_number(line + start, i - start, &numbers[count])) {
            lobe_quote(line + start, i - start, quoted, sizeof quoted);
            snprintf(reason, LOBE_REASON_SIZE, "'%s' is not a number", quoted);
            return -1;
        }
        count++;
        i = skip_blanks(line, length, i);
        comma = i < length && line[i] == ',';
        i += (size_t)comma;
    }
    return count;
}
