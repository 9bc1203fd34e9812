/* lobecheck eval: hands rows of any numbers to one function, and prints what it answers. */
#include "command.h"
#include "rows.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_MAX_BYTES = 4096 };

/* Answers are held back until every row has been read, so that a bad row leaves nothing half-written. */
typedef struct answers {
    lobe_value *values;
    size_t count, capacity;
} answers;

static int keep(answers *a, const lobe_value *values, int count)
{
    if (a->count + (size_t)count > a->capacity) {
        const size_t capacity = 2 * a->capacity + 1024;
        lobe_value *more = realloc(a->values, capacity * sizeof *more);
        if (!more)
            return 0;
        a->values = more;
        a->capacity = capacity;
    }
    memcpy(a->values + a->count, values, (size_t)count * sizeof *values);
    a->count += (size_t)count;
    return 1;
}

/* Reads a line as bytes, NUL included. Returns its length without the newline, -1 at the end of the input,
 * -2 where it is too long. */
static int read_line(FILE *stream, char *line)
{
    int length = 0, c;
    while ((c = getc(stream)) != EOF && c != '\n') {
        if (length == LINE_MAX_BYTES)
            return -2;
        line[length++] = (char)c;
    }
    return c == EOF && length == 0 ? -1 : length;
}

static double held(double x, double lo, double hi) { return x < lo ? lo : x > hi ? hi : x; } /* NaN stays */

static int is_sphere(const lobe_entry *e)
{
    return lobe_same(e->model, "sphere_light") || lobe_same(e->model, "sphere_light_schlick");
}

/* Round lights are asked for by angles, in as many columns as their functions have inputs. */
static const char *user_columns(const lobe_entry *e)
{
    if (lobe_same(e->model, "sg_light"))
        return "roughness n_dot_v n_dot_l azimuth sharpness";
    return is_sphere(e) ? "roughness n_dot_v n_dot_l azimuth half_angle" : e->input_names;
}

/* From the user's columns to the function's. Azimuth 0 is where view and light lean to the same side, pi is the
 * mirror's side; past 90 degrees a half angle counts as 90, and below 1 a sharpness as 1. */
static void to_inputs(const lobe_entry *e, double *x)
{
    const int gaussian = lobe_same(e->model, "sg_light");
    if (gaussian || is_sphere(e)) {
        const double v = held(x[1], 0.0, 1.0), l = held(x[2], -1.0, 1.0);
        const double along_v = sqrt((1.0 - v) * (1.0 + v)), along_l = sqrt((1.0 - l) * (1.0 + l));
        const double apart = along_v - along_l, cosine = cos(0.5 * x[3]);
        x[3] = 0.25 * (apart * apart) + along_v * along_l * (cosine * cosine);
        x[4] = gaussian ? 1.0 / held(x[4], 1.0, 1e30) : sin(held(x[4], 0.0, 1.5707963267948966));
    }
}

static int evaluate_all(const lobe_entry *e, answers *a)
{
    char line[LINE_MAX_BYTES], reason[LOBE_REASON_SIZE];
    size_t number = 0;
    int length;
    while ((length = read_line(stdin, line)) != -1) {
        double numbers[LOBE_MAX_INPUTS];
        lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
        int k, count;
        number++;
        if (length < 0) {
            fprintf(stderr, "<stdin>:%zu: a line of more than %d bytes\n", number, (int)LINE_MAX_BYTES);
            return 2;
        }
        count = lobe_read_row(line, (size_t)length, numbers, e->inputs, reason);
        if (count == 0)
            continue;
        if (count > 0 && count < e->inputs)
            snprintf(reason, sizeof reason, "%d numbers", count);
        if (count < e->inputs) {
            fprintf(stderr, "<stdin>:%zu: %s; a row of %s has %d: %s\n", number, reason, e->model, e->inputs,
                    user_columns(e));
            return 2;
        }
        to_inputs(e, numbers);
        for (k = 0; k < e->inputs; k++)
            in[k] = lobe_value_nearest(e->format, numbers[k]);
        e->call(in, out);
        if (!keep(a, out, e->outputs)) {
            fprintf(stderr, "<stdin>:%zu: out of memory\n", number);
            return 2;
        }
    }
    if (ferror(stdin)) {
        fprintf(stderr, "<stdin>:%zu: cannot be read\n", number + 1);
        return 2;
    }
    return 0;
}

int lobe_command_eval(int argc, char **argv)
{
    const char *model = NULL, *tier = NULL, *format = NULL;
    const lobe_entry *e;
    answers a = {NULL, 0, 0};
    size_t i;
    int k, status;
    for (k = 0; k < argc; k++) {
        const char *value;
        if ((value = lobe_option(argc, argv, &k, "--tier")) != NULL) {
            tier = value;
        } else if ((value = lobe_option(argc, argv, &k, "--format")) != NULL) {
            format = value;
        } else if (argv[k][0] == '-' || model) {
            fprintf(stderr, "lobecheck eval: unexpected '%s'; allowed: MODEL --tier T --format f32|q30\n", argv[k]);
            return 2;
        } else {
            model = argv[k];
        }
    }
    status = model ? lobe_refuse_names(model, tier, format) : 0;
    if (status == 0 && (!model || !tier || !format)) {
        fprintf(stderr, "lobecheck eval: %s is missing; usage: lobecheck eval MODEL --tier T --format f32|q30\n",
                !model  ? "MODEL"
                : !tier ? "--tier"
                        : "--format");
        status = 2;
    }
    if (status)
        return status;
    e = lobe_find_entry(model, tier, lobe_format_named(format));
    status = evaluate_all(e, &a);
    for (i = 0; status == 0 && i < a.count; i++)
        printf("%.9g%c", lobe_output_real(e, (int)(i % (size_t)e->outputs), a.values[i]),
               (int)(i % (size_t)e->outputs) == e->outputs - 1 ? '\n' : ' ');
    free(a.values);
    return status;
}
