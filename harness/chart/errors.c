/* The error of every tier and every published formula over a dense grid, as CSV.
 *
 *   errors grid N        prints the grid: roughness and NdotV, each at N places from .02 to 1
 *   errors BRDF          split_sum, split_sum_sep or split_sum_kibl: reads rows of roughness, NdotV, true scale and
 *                        true bias on stdin
 *   errors energy        reads rows of roughness, NdotV and true E
 * Columns: brdf, name, format, kind (tier, table, star), fitted BRDF, title, operations, table bytes, max over all
 * three, max of scale, bias and E, rms of scale, bias and E. For energy the error is that of the white furnace,
 * f E - 1, where f stands for 1/E; it is in the columns of E. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../peers/energy.h"
#include "../peers/split_sum.h"
#include "../registry.h"
#include "../../models/compensation.h"
#include "../../models/coeffs/energy_bounds.h"
#include "../../models/lobe.h"

typedef lobe_dfg dfg_function(lobe_real, lobe_real);

typedef struct star {
    const char *name, *title, *fitted;
    int ops;
    dfg_function *f;
} star;

/* Operations as their table in the literature review counts them: from roughness, or from gloss where the two
 * differ by a square root that an engine stores away. */
static const star stars[] = {
    {"karis", "Karis", "split_sum_kibl", 14, peer_karis},
    {"iwanicki_pesce", "Iwanicki-Pesce", "split_sum_sep", 16, peer_iwanicki_pesce},
    {"lazarov", "Lazarov", "split_sum_sep", 17, peer_lazarov},
    {"narkowicz", "Narkowicz", "split_sum_sep", 18, peer_narkowicz},
    {"hdrp_lite", "HDRP-Lite", "split_sum", 25, peer_hdrp_lite},
    {"ray_tracing_gems", "RT Gems", "split_sum_sep", 37, peer_ray_tracing_gems},
    {"materialx", "MaterialX", "split_sum", 43, peer_materialx},
    {"unreal5", "Unreal 5", "split_sum", 49, peer_unreal5},
};
enum { STARS = sizeof stars / sizeof stars[0] };

typedef struct rows {
    size_t n;
    float *in;     /* roughness, NdotV */
    double *truth; /* scale, bias or E */
} rows;

typedef struct sums {
    double max[3], square[3];
} sums;

static void add(sums *s, int column, double error)
{
    /* not > so that a NaN counts */
    if (!(fabs(error) <= s->max[column]))
        s->max[column] = fabs(error);
    s->square[column] += error * error;
}

static rows read_rows(int outputs)
{
    rows r = {0, NULL, NULL};
    size_t room = 0, line = 0;
    char text[512];
    while (fgets(text, sizeof text, stdin)) {
        double in[2], out[2] = {0.0, 0.0};
        line++;
        if (text[0] == '#')
            continue;
        if (sscanf(text, "%lf %lf %lf %lf", &in[0], &in[1], &out[0], &out[1]) != 2 + outputs) {
            fprintf(stderr, "errors: <stdin>:%zu: expected %d numbers\n", line, 2 + outputs);
            exit(2);
        }
        if (r.n == room) {
            room = room ? 2 * room : 4096;
            r.in = realloc(r.in, 2 * room * sizeof *r.in);
            r.truth = realloc(r.truth, 2 * room * sizeof *r.truth);
            if (!r.in || !r.truth) {
                fprintf(stderr, "errors: out of memory\n");
                exit(2);
            }
        }
        r.in[2 * r.n] = (float)in[0];
        r.in[2 * r.n + 1] = (float)in[1];
        r.truth[2 * r.n] = out[0];
        r.truth[2 * r.n + 1] = out[1];
        r.n++;
    }
    if (!r.n) {
        fprintf(stderr, "errors: <stdin>: no rows\n");
        exit(2);
    }
    return r;
}

/* What a row of the CSV says before its errors. */
typedef struct subject {
    const char *brdf, *name, *format, *kind, *fitted, *title;
    int ops, bytes;
} subject;

static void print(const subject *of, const sums *s, size_t n)
{
    const double largest = fmax(s->max[0], fmax(s->max[1], s->max[2]));
    int k;
    printf("%s,%s,%s,%s,%s,%s,%d,%d,%.3e", of->brdf, of->name, of->format, of->kind, of->fitted, of->title, of->ops,
           of->bytes, largest);
    for (k = 0; k < 3; k++)
        printf(",%.3e", s->max[k]);
    for (k = 0; k < 3; k++)
        printf(",%.3e", sqrt(s->square[k] / (double)n));
    putchar('\n');
}

static void add_dfg(sums *s, const double *truth, double scale, double bias)
{
    add(s, 0, scale - truth[0]);
    add(s, 1, bias - truth[1]);
    add(s, 2, scale + bias - truth[0] - truth[1]);
}

static subject entry_subject(const lobe_entry *entry)
{
    const int side = strncmp(entry->tier, "table", 5) ? 0 : atoi(entry->tier + 5);
    const int texel = entry->format == LOBE_F32 ? 8 : 4;
    subject of;
    of.brdf = of.fitted = entry->model;
    of.name = of.title = entry->tier;
    of.format = lobe_format_names[entry->format];
    of.kind = side ? "table" : "tier";
    of.ops = entry->ops;
    of.bytes = side * side * texel;
    return of;
}

static void split_sum(const char *brdf)
{
    const rows r = read_rows(2);
    size_t i, e;
    int k;
    for (e = 0; e < lobe_entry_count; e++) {
        const lobe_entry *entry = &lobe_entries[e];
        const subject of = entry_subject(entry);
        sums s = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        if (strcmp(entry->model, brdf))
            continue;
        for (i = 0; i < r.n; i++) {
            lobe_value in[2], out[2];
            for (k = 0; k < 2; k++)
                in[k] = lobe_value_nearest(entry->format, (double)r.in[2 * i + (size_t)k]);
            entry->call(in, out);
            add_dfg(&s, &r.truth[2 * i], lobe_value_real(entry->format, out[0]),
                    lobe_value_real(entry->format, out[1]));
        }
        print(&of, &s, r.n);
    }
    for (k = 0; k < STARS; k++) {
        const subject of = {brdf, stars[k].name, "f32", "star", stars[k].fitted, stars[k].title, stars[k].ops, 0};
        sums s = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
        for (i = 0; i < r.n; i++) {
            const lobe_dfg d = stars[k].f(r.in[2 * i], r.in[2 * i + 1]);
            add_dfg(&s, &r.truth[2 * i], (double)d.scale, (double)d.bias);
        }
        print(&of, &s, r.n);
    }
    free(r.in);
    free(r.truth);
}

/* Stand-ins for 1/E. */
typedef float inverse_function(float, float);

static float inverse_none(float r, float v)
{
    (void)r;
    (void)v;
    return 1.0f;
}
static float inverse_alpha2_view(float r, float v) { return lobe_inverse_energy_alpha2_view(r, v); }
static float inverse_alpha2(float r, float v)
{
    (void)v;
    return lobe_inverse_energy_alpha2(r);
}
static float inverse_kulla_conty(float r, float v) { return 1.0f / peer_kulla_conty(r, v); }

typedef int32_t inverse_q29_function(int32_t, int32_t);

static void energy(void)
{
    static const struct {
        const char *name, *title, *kind;
        int ops;
        inverse_function *f;
        inverse_q29_function *q; /* NULL: float only */
    } inverses[] = {
        {"low", "low", "tier", LOBE_ENERGY_LOW_INVERSE_OPS, lobe_energy_inverse_low_f32, lobe_energy_inverse_low_q29},
        {"medium", "medium", "tier", LOBE_ENERGY_MEDIUM_INVERSE_OPS, lobe_energy_inverse_medium_f32,
         lobe_energy_inverse_medium_q29},
        {"high", "high", "tier", LOBE_ENERGY_HIGH_INVERSE_OPS, lobe_energy_inverse_high_f32,
         lobe_energy_inverse_high_q29},
        {"none", "no compensation", "star", 0, inverse_none, NULL},
        {"alpha2", "1 + a^2", "star", 3, inverse_alpha2, NULL},
        {"alpha2_view", "1 + 2 a^2 v", "star", 4, inverse_alpha2_view, NULL},
        {"kulla_conty", "Kulla-Conty", "star", 38, inverse_kulla_conty, NULL},
    };
    const rows r = read_rows(1);
    size_t i, k;
    int format;
    for (k = 0; k < sizeof inverses / sizeof inverses[0]; k++) {
        for (format = 0; format <= (inverses[k].q != NULL); format++) {
            const subject of = {"energy", inverses[k].name,  lobe_format_names[format], inverses[k].kind,
                                "energy", inverses[k].title, inverses[k].ops,           0};
            sums s = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
            for (i = 0; i < r.n; i++) {
                const float x = r.in[2 * i], y = r.in[2 * i + 1];
                const double f = format == LOBE_F32 ? (double)inverses[k].f(x, y)
                                                    : inverses[k].q(lobe_value_nearest(LOBE_Q30, (double)x).q,
                                                                    lobe_value_nearest(LOBE_Q30, (double)y).q) /
                                                          536870912.0;
                add(&s, 2, f * r.truth[2 * i] - 1.0);
            }
            print(&of, &s, r.n);
        }
    }
    free(r.in);
    free(r.truth);
}

static int grid(int n)
{
    int i, j;
    for (i = 0; i < n; i++)
        for (j = 0; j < n; j++)
            /* what a float holds, so that truth and model see the same numbers */
            printf("%.17g %.17g\n", (double)(float)(0.02 + 0.98 * i / (n - 1)),
                   (double)(float)(0.02 + 0.98 * j / (n - 1)));
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 3 && !strcmp(argv[1], "grid") && atoi(argv[2]) >= 2)
        return grid(atoi(argv[2]));
    if (argc == 2 && !strcmp(argv[1], "energy"))
        energy();
    else if (argc == 2 && !strncmp(argv[1], "split_sum", 9))
        split_sum(argv[1]);
    else {
        fprintf(stderr, "usage: errors grid N | errors BRDF <rows\n");
        return 2;
    }
    return 0;
}
