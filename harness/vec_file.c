#include "vec_file.h"
#include "hash.h"
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NAME_BREAKS " ,"

static const char *const key_names[LOBE_VEC_KEYS] = {"model", "tier",   "format",    "inputs",       "outputs",
                                                     "brdf",  "domain", "truth",     "bound_max",    "command",
                                                     "seed",  "digest", "bound_rms", "bound_furnace"};

typedef struct reader {
    const char *text;
    size_t length, at, line; /* at: the next byte; line: the number of the line last taken */
    size_t key_line[LOBE_VEC_KEYS];
    lobe_vec_file *file;
    lobe_vec_error *error;
    uint32_t capacity;
} reader;

#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
static int
refuse(lobe_vec_error *error, size_t line, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(error->reason, sizeof error->reason, format, args);
    va_end(args);
    error->line = line;
    return 0;
}

/* The next line without its newline. Returns 0 where it is too long or has no newline. */
static int take_line(reader *r, const char **line, size_t *length)
{
    const char *end = memchr(r->text + r->at, '\n', r->length - r->at);
    *line = r->text + r->at;
    r->line++;
    if (!end)
        return refuse(r->error, r->line, "the last line does not end; is the file cut short?");
    *length = (size_t)(end - *line);
    r->at += *length + 1;
    if (*length > LOBE_VEC_LINE_MAX)
        return refuse(r->error, r->line, "a line of %zu bytes, %d are allowed", *length, (int)LOBE_VEC_LINE_MAX);
    if (memchr(*line, 0, *length))
        return refuse(r->error, r->line, "a NUL byte; this is not a text file");
    return 1;
}

static char *copy_text(const char *text, size_t length)
{
    char *copy = malloc(length + 1);
    if (copy) {
        memcpy(copy, text, length);
        copy[length] = 0;
    }
    return copy;
}

/* `# key: value`; any other line that starts with '#' is a comment. */
static int read_head_line(reader *r, const char *line, size_t length)
{
    size_t key_at = 1, key_end, value_at;
    int k;
    while (key_at < length && line[key_at] == ' ')
        key_at++;
    key_end = key_at;
    while (key_end < length && ((line[key_end] >= 'a' && line[key_end] <= 'z') || line[key_end] == '_'))
        key_end++;
    if (key_end == key_at || key_end == length || line[key_end] != ':')
        return 1;
    value_at = key_end + 1;
    while (value_at < length && line[value_at] == ' ')
        value_at++;
    while (length > value_at && line[length - 1] == ' ')
        length--;
    for (k = 0; k < LOBE_VEC_KEYS; k++)
        if (strlen(key_names[k]) == key_end - key_at && memcmp(key_names[k], line + key_at, key_end - key_at) == 0)
            break;
    if (k == LOBE_VEC_KEYS)
        return 1;
    if (r->file->key[k])
        return refuse(r->error, r->line, "the key '%s' again; line %zu has it", key_names[k], r->key_line[k]);
    if (value_at == length)
        return refuse(r->error, r->line, "the key '%s' has no value", key_names[k]);
    r->key_line[k] = r->line;
    r->file->key[k] = copy_text(line + value_at, length - value_at);
    return r->file->key[k] ? 1 : refuse(r->error, r->line, "out of memory");
}

static int read_bound(reader *r, lobe_vec_key k, double *bound)
{
    const char *value = r->file->key[k];
    if (!value)
        return 1; /* not stated */
    if (lobe_read_number(value, strlen(value), bound) && *bound > 0.0 && *bound <= 1e30)
        return 1;
    return refuse(r->error, r->key_line[k], "%s '%.40s' is not a number above 0", key_names[k], value);
}

static int count_names(reader *r, lobe_vec_key k, int max, int *count)
{
    const char *s = r->file->key[k];
    for (*count = 0; *s; *count += 1) {
        s += strcspn(s, NAME_BREAKS);
        s += strspn(s, NAME_BREAKS);
    }
    if (*count <= max)
        return 1;
    return refuse(r->error, r->key_line[k], "%d %s, at most %d are allowed", *count, key_names[k], max);
}

static int check_head(reader *r)
{
    lobe_vec_file *f = r->file;
    lobe_vectors *v = &f->vectors;
    char wanted[24];
    int k;
    for (k = 0; k < LOBE_VEC_KEYS_NEEDED; k++)
        if (!f->key[k])
            return refuse(r->error, r->line, "the head ends without the key '%s'", key_names[k]);
    v->model = f->key[LOBE_KEY_MODEL];
    v->tier = f->key[LOBE_KEY_TIER];
    v->format = lobe_format_named(f->key[LOBE_KEY_FORMAT]);
    if (v->format == LOBE_FORMATS)
        return refuse(r->error, r->key_line[LOBE_KEY_FORMAT], "format '%.20s', allowed: f32 q30",
                      f->key[LOBE_KEY_FORMAT]);
    if (!count_names(r, LOBE_KEY_INPUTS, LOBE_MAX_INPUTS, &v->inputs) ||
        !count_names(r, LOBE_KEY_OUTPUTS, LOBE_MAX_OUTPUTS, &v->outputs) ||
        !read_bound(r, LOBE_KEY_BOUND_MAX, &v->bound_max) || !read_bound(r, LOBE_KEY_BOUND_RMS, &v->bound_rms) ||
        !read_bound(r, LOBE_KEY_BOUND_FURNACE, &v->bound_furnace))
        return 0;
    snprintf(wanted, sizeof wanted, "%016llx",
             (unsigned long long)lobe_fnv1a(LOBE_FNV_START, r->text + r->at, r->length - r->at));
    if (strcmp(f->key[LOBE_KEY_DIGEST], wanted) != 0)
        return refuse(r->error, r->key_line[LOBE_KEY_DIGEST], "digest %.24s, but the rows have %s",
                      f->key[LOBE_KEY_DIGEST], wanted);
    return 1;
}

static int grow(reader *r)
{
    lobe_vec_file *f = r->file;
    const uint32_t capacity = r->capacity ? 2 * r->capacity : 256;
    uint32_t *in = realloc(f->in, (size_t)capacity * (size_t)f->vectors.inputs * sizeof *in);
    double *truth;
    if (in)
        f->in = in;
    truth = realloc(f->truth, (size_t)capacity * (size_t)f->vectors.outputs * sizeof *truth);
    if (truth)
        f->truth = truth;
    r->capacity = capacity;
    return in && truth ? 1 : refuse(r->error, r->line, "out of memory");
}

static int read_case(reader *r, const char *line, size_t length)
{
    lobe_vec_file *f = r->file;
    lobe_vectors *v = &f->vectors;
    double numbers[LOBE_MAX_INPUTS + LOBE_MAX_OUTPUTS];
    char reason[LOBE_REASON_SIZE];
    const int count = lobe_read_row(line, length, numbers, v->inputs + v->outputs, reason);
    int k;
    if (count == 0)
        return 1;
    if (count < 0)
        return refuse(r->error, r->line, "%s", reason);
    if (count < v->inputs + v->outputs)
        return refuse(r->error, r->line, "%d numbers, %d are needed", count, v->inputs + v->outputs);
    if (v->rows == LOBE_VEC_ROWS_MAX)
        return refuse(r->error, r->line, "more than %d rows", (int)LOBE_VEC_ROWS_MAX);
    if (v->rows == r->capacity && !grow(r))
        return 0;
    for (k = 0; k < v->inputs; k++) {
        const lobe_value value = lobe_value_nearest(v->format, numbers[k]);
        if (!isfinite(numbers[k]) || lobe_value_real(v->format, value) != numbers[k])
            return refuse(r->error, r->line, "input %d, %.17g, is not exact in %s", k + 1, numbers[k],
                          lobe_format_names[v->format]);
        f->in[(size_t)v->rows * (size_t)v->inputs + (size_t)k] = value.bits;
    }
    for (k = 0; k < v->outputs; k++) {
        const double truth = numbers[v->inputs + k];
        if (!isfinite(truth))
            return refuse(r->error, r->line, "output %d is %g; a truth is finite", k + 1, truth);
        f->truth[(size_t)v->rows * (size_t)v->outputs + (size_t)k] = truth;
    }
    v->rows++;
    return 1;
}

static int read_all(reader *r)
{
    const char *line;
    size_t length;
    while (r->at < r->length && r->text[r->at] == '#')
        if (!take_line(r, &line, &length) || !read_head_line(r, line, length))
            return 0;
    if (r->line == 0)
        return refuse(r->error, 1, "no head: the first line must start with '#'");
    if (!check_head(r))
        return 0;
    while (r->at < r->length)
        if (!take_line(r, &line, &length) || !read_case(r, line, length))
            return 0;
    if (r->file->vectors.rows == 0)
        return refuse(r->error, r->line, "a head without rows");
    r->file->vectors.in = r->file->in;
    r->file->vectors.truth = r->file->truth;
    return 1;
}

int lobe_vec_parse(const char *text, size_t length, lobe_vec_file *file, lobe_vec_error *error)
{
    reader r;
    memset(&r, 0, sizeof r);
    memset(file, 0, sizeof *file);
    r.text = text;
    r.length = length;
    r.file = file;
    r.error = error;
    if (read_all(&r))
        return 1;
    lobe_vec_free(file);
    return 0;
}

int lobe_vec_load(const char *path, lobe_vec_file *file, lobe_vec_error *error)
{
    FILE *stream = fopen(path, "rb");
    char *text = NULL;
    long size = -1;
    int good;
    if (!stream)
        return refuse(error, 0, "cannot be opened: %s", strerror(errno));
    if (fseek(stream, 0, SEEK_END) == 0)
        size = ftell(stream);
    if (size >= 0 && size <= LOBE_VEC_FILE_MAX && fseek(stream, 0, SEEK_SET) == 0)
        text = malloc((size_t)size + 1);
    good = text && fread(text, 1, (size_t)size, stream) == (size_t)size;
    fclose(stream);
    good = good ? lobe_vec_parse(text, (size_t)size, file, error)
                : refuse(error, 0, "cannot be read as a file of at most %d bytes", (int)LOBE_VEC_FILE_MAX);
    free(text);
    return good;
}

void lobe_vec_free(lobe_vec_file *file)
{
    int k;
    for (k = 0; k < LOBE_VEC_KEYS; k++)
        free(file->key[k]);
    free(file->in);
    free(file->truth);
    memset(file, 0, sizeof *file);
}

void lobe_vec_complain(const char *path, const lobe_vec_error *error)
{
    if (error->line)
        fprintf(stderr, "%s:%zu: %s\n", path, error->line, error->reason);
    else
        fprintf(stderr, "%s: %s\n", path, error->reason);
}

static int same_names(const char *a, const char *b)
{
    for (;;) {
        const size_t length = strcspn(a, NAME_BREAKS);
        if (length != strcspn(b, NAME_BREAKS) || memcmp(a, b, length) != 0)
            return 0;
        if (length == 0)
            return 1;
        a += length + strspn(a + length, NAME_BREAKS);
        b += length + strspn(b + length, NAME_BREAKS);
    }
}

int lobe_vec_fits(const lobe_vec_file *file, const lobe_entry *entry, lobe_vec_error *error)
{
    const char *inputs = file->key[LOBE_KEY_INPUTS], *outputs = file->key[LOBE_KEY_OUTPUTS];
    if (!same_names(inputs, entry->input_names))
        return refuse(error, 0, "inputs '%.60s', %s has '%s'", inputs, entry->model, entry->input_names);
    if (!same_names(outputs, lobe_truth_names(entry)))
        return refuse(error, 0, "outputs '%.60s', %s has '%s'", outputs, entry->model, lobe_truth_names(entry));
    return 1;
}
