/* An integer program as C99 on the primitives of core/q30.h, below a head that says what was measured. */
#include "emit_q30.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct measured {
    double error;
    int32_t at[2], got;
    double want;
    int output;
};

static void measure_at(const lobe_q_program *q, const int32_t *in, measured *m, int *wide)
{
    static double value[LOBE_NODES];
    int32_t out[LOBE_OUTPUTS];
    const double x[2] = {in[0] * 0x1p-30, in[1] * 0x1p-30};
    *wide |= lobe_q_run(q, in, out);
    lobe_graph_eval(q->graph, x, value);
    for (int o = 0; o < q->graph->outputs; o++) {
        const double want = value[q->graph->output[o]];
        const double e = fabs(out[o] * 0x1p-30 - want);
        if (e > m->error) {
            m->error = e;
            m->at[0] = in[0];
            m->at[1] = in[1];
            m->got = out[o];
            m->want = want;
            m->output = o;
        }
    }
}

/* A uniform grid over the domain of the fits, and one that is uniform in the logarithm down to 2^-30. */
static void measure(const lobe_q_program *q, measured *domain, measured *below, int *wide)
{
    const int side = 1024, octaves = 30, parts = 17;
    memset(domain, 0, sizeof *domain);
    memset(below, 0, sizeof *below);
    *wide = 0;
    for (int i = 0; i < side; i++)
        for (int k = 0; k < side; k++) {
            const int32_t in[2] = {(int32_t)floor((0.02 + 0.98 * i / (side - 1)) * 0x1p30 + 0.5),
                                   (int32_t)floor((0.02 + 0.98 * k / (side - 1)) * 0x1p30 + 0.5)};
            measure_at(q, in, domain, wide);
        }
    for (int i = 0; i <= octaves * parts; i++)
        for (int k = 0; k <= octaves * parts; k++) {
            /* 2^o (1 + f / parts), the last step being 0 */
            int32_t in[2];
            const int at[2] = {i, k};
            for (int j = 0; j < 2; j++)
                in[j] =
                    at[j] == octaves * parts
                        ? 0
                        : (int32_t)((((int64_t)1 << (29 - at[j] / parts)) * (2 * parts - at[j] % parts) + parts / 2) /
                                    parts);
            measure_at(q, in, below, wide);
        }
}

static uint64_t digest(const lobe_graph *g)
{
    uint64_t h = 0xcbf29ce484222325u;
    char *text = NULL;
    size_t size = 0;
    FILE *f = open_memstream(&text, &size);
    if (!f)
        return 0;
    lobe_graph_text(g, "c", f);
    fclose(f);
    for (size_t i = 0; i < size; i++)
        h = (h ^ (unsigned char)text[i]) * 0x100000001b3u;
    free(text);
    return h;
}

static const char *const input_short[] = {"r", "v"};

static const char *name(const lobe_q_program *q, int i, char *text)
{
    while (q->op[i].kind == LOBE_Q_RESCALE)
        i = q->op[i].a;
    const lobe_q_op *o = &q->op[i];
    if (o->kind == LOBE_Q_INPUT)
        strcpy(text, input_short[o->imm]);
    else if (o->kind == LOBE_Q_SCALED_INPUT)
        sprintf(text, "%s_up", input_short[o->imm]);
    else if (o->kind == LOBE_Q_LITERAL)
        sprintf(text, "%d", o->imm);
    else
        sprintf(text, "t%d", i);
    return text;
}

/* One operation into line; 0 where it needs none. */
static int operation(const lobe_q_program *q, int i, char *text)
{
    const lobe_q_op *o = &q->op[i];
    char a[32] = "", b[32] = "", line[160] = "";
    if (o->a >= 0)
        name(q, o->a, a);
    if (o->b >= 0)
        name(q, o->b, b);
    switch (o->kind) {
    case LOBE_Q_SCALED_LITERAL:
        sprintf(line, "%d >> (%d - up)", o->imm, 2 * LOBE_Q_STEP * q->steps);
        break;
    case LOBE_Q_ADD:
        if (b[0] == '-')
            sprintf(line, "%s - %s", a, b + 1);
        else
            sprintf(line, "%s + %s", a, b);
        break;
    case LOBE_Q_SUB:
        sprintf(line, b[0] == '-' ? "%s - (%s)" : "%s - %s", a, b);
        break;
    case LOBE_Q_MUL:
        sprintf(line, "lobe_q_mul(%s, %s, %d)", a, b, o->imm);
        break;
    case LOBE_Q_SHIFT_RIGHT:
        sprintf(line, "lobe_q_shift_right(%s, %d)", a, o->imm);
        break;
    case LOBE_Q_SHIFT_LEFT:
        sprintf(line, "%s * %d", a, 1 << o->imm);
        break;
    case LOBE_Q_MIN:
        sprintf(line, "lobe_q_min(%s, %s)", a, b);
        break;
    case LOBE_Q_MAX:
        sprintf(line, "lobe_q_max(%s, %s)", a, b);
        break;
    case LOBE_Q_CLAMP:
        if (o->imm == 1)
            sprintf(line, "lobe_q_max(%s, 0)", a);
        else if (o->imm == 2)
            sprintf(line, "lobe_q_min(%s, %d)", a, 1 << o->fraction);
        else
            sprintf(line, "lobe_q_clamp(%s, 0, %d)", a, 1 << o->fraction);
        break;
    case LOBE_Q_INVERSE:
        sprintf(text, "    const lobe_q_inverse t%d = lobe_q_reciprocal(%s);", i, a);
        return 1;
    case LOBE_Q_RATIO:
        sprintf(line, "lobe_q_ratio(%s, %s)", a, b);
        break;
    case LOBE_Q_QUOTIENT:
        sprintf(line, "lobe_q_quotient(%s, %s, %d)", a, b, o->imm);
        break;
    case LOBE_Q_LOG2:
        sprintf(line, "lobe_q_log2(%s) - %d", a, q->op[o->a].fraction << 26);
        break;
    case LOBE_Q_RECIPROCAL:
        sprintf(line, "lobe_q_shift_right(%s.mantissa, %s.shift - %d)", a, a, o->imm);
        break;
    case LOBE_Q_UNSCALE:
        sprintf(line, "lobe_q_shift_right(%s, up)", a);
        break;
    default:
        return 0;
    }
    sprintf(text, "    const int32_t t%d = %s;", i, line);
    return 1;
}

static void operations(const lobe_q_program *q, FILE *out)
{
    char line[200];
    int width = 0;
    for (int i = 0; i < q->ops; i++)
        if (operation(q, i, line) && (int)strlen(line) > width)
            width = (int)strlen(line);
    for (int i = 0; i < q->ops; i++) {
        if (!operation(q, i, line))
            continue;
        fprintf(out, "%-*s ", width, line);
        if (q->op[i].kind == LOBE_Q_INVERSE)
            fprintf(out, "/* mantissa and shift */\n");
        else
            fprintf(out, "/* Q%d */\n", q->op[i].fraction);
    }
}

static int is_shape(const lobe_graph *g) { return strcmp(g->model, "diffuse_shape") == 0; }

static int is_zonal(const lobe_graph *g) { return is_shape(g) && strncmp(g->tier, "zonal", 5) == 0; }

static void head(const lobe_q_program *q, const lobe_q_proof *proof, FILE *out)
{
    const lobe_graph *g = q->graph;
    measured domain, below;
    int wide;
    measure(q, &domain, &below, &wide);
    fprintf(out, "/* Generated, not edited: lobefit emit %s --tier %s --to q30\n",
            is_shape(g) ? "diffuse_sh" : g->model, g->tier);
    fprintf(out, " * Digest of the formula with its coefficients: %016llx (FNV-1a 64 of `lobefit emit --to c`).\n",
            (unsigned long long)digest(g));
    fprintf(out,
            " *\n * %s, %s, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale\n"
            " * stands beside it. Every product and shift rounds to nearest, ties up.\n",
            is_shape(g) ? "Shape of diffuse_sh" : g->model, g->tier);
    const measured *const both[2] = {&domain, &below};
    const char *const where[2] = {"[.02, 1], 1024 x 1024 points", "[0, 1], 511 x 511 points, uniform in the logarithm"};
    for (int i = 0; i < 2; i++)
        fprintf(out,
                " * Difference to the same formula in double over %s:\n"
                " *   %.2e (2^%.1f) in %s at 0x%08x 0x%08x: got 0x%08x, want %.12f.\n",
                where[i], both[i]->error, log2(both[i]->error), g->output_name[both[i]->output],
                (unsigned)both[i]->at[0], (unsigned)both[i]->at[1], (unsigned)both[i]->got, both[i]->want);
    double worst = 0.0, worst_domain = 0.0;
    for (int i = 0; i < g->outputs; i++) {
        worst = proof->error[i] > worst ? proof->error[i] : worst;
        worst_domain = proof->error_domain[i] > worst_domain ? proof->error_domain[i] : worst_domain;
    }
    fprintf(out,
            " * Proved by interval analysis: no value leaves 32 bits; the difference is at most %.2e over\n"
            " * [.02, 1] and %.2e over [0, 1]. */\n",
            worst_domain, worst);
}

static void array_version(const lobe_graph *g, FILE *out)
{
    const int pair = g->outputs == 2;
    char line[240];
    const int at = snprintf(line, sizeof line, "void lobe_%s_%s_n_q30(", g->model, g->tier);
    snprintf(line + at, sizeof line - (size_t)at, "const int32_t *roughness, const int32_t *n_dot_v, %s, size_t n)",
             pair ? "int32_t *scale, int32_t *bias" : "int32_t *e");
    if (strlen(line) > 120) /* as clang-format would break it */
        sprintf(strstr(line, " size_t"), "\n%*ssize_t n)", at, "");
    fprintf(out, "%s\n{\n    size_t i;\n", line);
    if (pair) {
        fprintf(out, "    for (i = 0; i < n; i++) {\n");
        fprintf(out, "        const lobe_dfg_q30 d = lobe_%s_%s_q30(roughness[i], n_dot_v[i]);\n", g->model, g->tier);
        fprintf(out, "        scale[i] = d.scale;\n        bias[i] = d.bias;\n    }\n}\n");
    } else {
        fprintf(out, "    for (i = 0; i < n; i++)\n        e[i] = lobe_%s_%s_q30(roughness[i], n_dot_v[i]);\n}\n",
                g->model, g->tier);
    }
}

int lobe_q_text(const lobe_graph *g, FILE *out)
{
    static lobe_q_program program;
    lobe_q_proof proof;
    const lobe_q_program *q = &program;
    char text[32];
    if (lobe_q_compile(g, &program, &proof))
        return 2;
    head(q, &proof, out);
    int logs = 0;
    for (int i = 0; i < q->ops; i++)
        logs += q->op[i].kind == LOBE_Q_LOG2;
    fprintf(out, "#include \"../lobe.h\"\n#include \"../../core/%s.h\"\n%s", logs ? "q30_log2" : "q30",
            is_shape(g) ? "" : "\n");
    if (is_shape(g))
        fprintf(out, "#include \"diffuse_sh.h\"\n\n");
    const char *type = is_zonal(g)       ? "lobe_zonal_shape_q30"
                       : is_shape(g)     ? "lobe_diffuse_shape_q30"
                       : g->outputs == 2 ? "lobe_dfg_q30"
                                         : "int32_t";
    fprintf(out, "%s lobe_%s_%s_q30(int32_t roughness, int32_t n_dot_v)\n{\n", type, g->model, g->tier);
    for (int i = 0; i < 2; i++)
        fprintf(out, "    const int32_t %s = lobe_q_saturate(%s);\n", input_short[i], g->input_name[i]);
    if (q->steps) {
        fprintf(out,
                "    /* v / (v + k r^2) keeps its value when r grows by %d and v by %d: that keeps its precision near "
                "0. */\n",
                1 << LOBE_Q_STEP, 1 << 2 * LOBE_Q_STEP);
        fprintf(out, "    int32_t r_up = r, v_up = v;\n    int up = 0;\n");
        fprintf(out, "    while (up < %d && r_up < 1 << %d && v_up < 1 << %d) {\n", 2 * LOBE_Q_STEP * q->steps,
                (int)LOBE_Q_LARGE_R, (int)LOBE_Q_LARGE_V);
        fprintf(out, "        r_up <<= %d;\n        v_up <<= %d;\n        up += %d;\n    }\n", (int)LOBE_Q_STEP,
                2 * LOBE_Q_STEP, 2 * LOBE_Q_STEP);
    }
    operations(q, out);
    if (g->outputs > 1) {
        fprintf(out, "    %s d;\n", type);
        for (int i = 0; i < g->outputs; i++)
            fprintf(out, "    d.%s = %s;\n", g->output_name[i], name(q, q->output[i], text));
        fprintf(out, "    return d;\n}\n\n");
    } else {
        fprintf(out, "    return %s;\n}\n\n", name(q, q->output[0], text));
    }
    if (is_shape(g))
        fprintf(out, "%s(%s)\n", is_zonal(g) ? "LOBE_DIFFUSE_ZONAL_Q30" : "LOBE_DIFFUSE_SH_Q30", g->tier);
    else
        array_version(g, out);
    return 0;
}
