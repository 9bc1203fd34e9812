#include "hash_file.h"
#include <errno.h>
#include <stdio.h>
#include <string.h>

static const char *read_hash_line(const char *text, lobe_hash_line *line)
{
    char format[8], hash[20], rest;
    unsigned long long bits;
    if (sscanf(text, "%31s %31s %7s %19s %c", line->model, line->tier, format, hash, &rest) != 4)
        return "a line is: model tier format hash";
    line->format = lobe_format_named(format);
    if (line->format == LOBE_FORMATS)
        return "the format is neither f32 nor q30";
    if (strlen(hash) != 16 || strspn(hash, "0123456789abcdef") != 16 || sscanf(hash, "%16llx", &bits) != 1)
        return "the hash is not 16 hex digits";
    line->hash = bits;
    return NULL;
}

int lobe_read_hashes(const char *path, lobe_hash_line *lines, lobe_vec_error *error)
{
    FILE *stream = fopen(path, "r");
    const char *reason = NULL;
    char text[160];
    int count = 0;
    error->line = 0;
    if (!stream) {
        snprintf(error->reason, sizeof error->reason, "cannot be opened: %s", strerror(errno));
        return -1;
    }
    while (!reason && fgets(text, sizeof text, stream)) {
        error->line++;
        if (!strchr(text, '\n'))
            reason = "a line is too long, or the last one does not end";
        else if (text[0] == '#' || text[strspn(text, " \t\r\n")] == 0)
            continue;
        else if (count == LOBE_HASHES_MAX)
            reason = "too many lines";
        else
            reason = read_hash_line(text, &lines[count++]);
    }
    fclose(stream);
    if (!reason)
        return count;
    snprintf(error->reason, sizeof error->reason, "%s", reason);
    return -1;
}
