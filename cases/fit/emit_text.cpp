/* A recorded formula as straight-line text, one operation a line, in the languages that share C's expressions,
 * and as FPCore (FPBench 2.0) for tools that bound rounding errors or search for better orders. */
#include "trace.h"

#include <stdlib.h>
#include <string.h>

struct dialect {
    const char *name;
    const char *local;  /* starts the declaration of a local */
    const char *suffix; /* of a literal */
};

static const dialect dialects[] = {
    {"c", "const float", "f"},         {"cl", "const float", "f"},    {"glsl", "precise float", ""},
    {"es", "precise highp float", ""}, {"hlsl", "precise float", ""},
};

/* The shortest decimal that gives this double back, with a point so that every language sees a float. */
static const char *decimal(double x)
{
    static char text[40];
    for (int digits = 1; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, x);
        if (strtod(text, NULL) == x)
            break;
    }
    if (!strpbrk(text, ".e"))
        strcat(text, ".0");
    return text;
}

static const char *operand(const lobe_graph *g, int i, const dialect *d, char *text)
{
    const lobe_node *n = &g->node[i];
    if (n->op == LOBE_OP_CONST)
        sprintf(text, n->value < 0.0 ? "(%s%s)" : "%s%s", decimal(n->value), d->suffix);
    else if (n->op == LOBE_OP_INPUT)
        strcpy(text, g->input_name[n->input]);
    else
        sprintf(text, "t%d", i);
    return text;
}

static void statement(const lobe_graph *g, int i, const dialect *d, FILE *out)
{
    static const char *const infix[] = {"", "", "+", "-", "*", "/", "<", ">"};
    const lobe_node *n = &g->node[i];
    char a[48] = "", b[48] = "", c[48] = "";
    if (n->arg[0] >= 0)
        operand(g, n->arg[0], d, a);
    if (n->arg[1] >= 0)
        operand(g, n->arg[1], d, b);
    if (n->arg[2] >= 0)
        operand(g, n->arg[2], d, c);
    const char *own = strcmp(d->name, "c") ? "" : "lobe_";
    fprintf(out, "    %s t%d = ", d->local, i);
    switch (n->op) {
    case LOBE_OP_MIN:
    case LOBE_OP_MAX:
        fprintf(out, "%s %s %s ? %s : %s;\n", a, infix[n->op], b, a, b);
        break;
    case LOBE_OP_SATURATE: /* a NaN becomes 0, as in the kernel */
        fprintf(out, "%s > 0.0%s ? (%s < 1.0%s ? %s : 1.0%s) : 0.0%s;\n", a, d->suffix, a, d->suffix, a, d->suffix,
                d->suffix);
        break;
    case LOBE_OP_NEGATE:
        fprintf(out, "-%s;\n", a);
        break;
    case LOBE_OP_SELECT:
        fprintf(out, "%s > 0.0%s ? %s : %s;\n", a, d->suffix, b, c);
        break;
    case LOBE_OP_EXP2:
        fprintf(out, "%sexp2(%s);\n", own, a);
        break;
    case LOBE_OP_LOG2:
        fprintf(out, "%slog2(%s);\n", own, a);
        break;
    case LOBE_OP_SQRT:
        fprintf(out, "%ssqrt(%s);\n", own, a);
        break;
    default:
        fprintf(out, "%s %s %s;\n", a, infix[n->op], b);
    }
}

static void c_like(const lobe_graph *g, const dialect *d, FILE *out)
{
    const int shader = !strcmp(d->name, "glsl") || !strcmp(d->name, "es") || !strcmp(d->name, "hlsl");
    const int cl = !strcmp(d->name, "cl");
    const char *pair = !strcmp(d->name, "hlsl") || cl ? "float2" : "vec2";
    char text[48];
    const lobe_op_count count = lobe_graph_count(g);
    const int e = g->outputs - 1;

    fprintf(
        out,
        "/* %s, %s: %d operations. Inputs and results in [0, 1].\n * Generated: lobefit emit %s --tier %s --to %s */\n",
        g->model, g->tier, count.fused, g->model, g->tier, d->name);
    /* C takes core's functions, whose bits are the library's; elsewhere the language has its own. */
    static const char *const calls[] = {"exp2", "log2", "sqrt"};
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < g->nodes; i++)
            if (g->node[i].op == LOBE_OP_EXP2 + k) {
                fprintf(out,
                        !strcmp(d->name, "c")
                            ? "#include \"core/%s.h\"\n"
                            : "/* %s is the language's own: its last bits are not the library's. */\n",
                        calls[k]);
                break;
            }
    if (cl)
        fprintf(out, "#pragma OPENCL FP_CONTRACT OFF\n");
    if (!shader && !cl) {
        /* Plain C has no vectors: results go through pointers. */
        fprintf(out,
                "/* Build with -ffp-contract=off to keep the bits. */\nvoid lobe_%s_%s(float roughness, float n_dot_v",
                g->model, g->tier);
        for (int i = 0; i < g->outputs; i++)
            fprintf(out, ", float *%s", g->output_name[i]);
        fprintf(out, ")\n{\n");
    } else if (e > 1) {
        const char *highp = !strcmp(d->name, "es") ? "highp " : "";
        fprintf(out, "void lobe_%s_%s(%sfloat roughness, %sfloat n_dot_v", g->model, g->tier, highp, highp);
        for (int i = 0; i < g->outputs; i++)
            fprintf(out, ", %s%sfloat %s%s", cl ? "" : "out ", highp, cl ? "*" : "", g->output_name[i]);
        fprintf(out, ")\n{\n");
    } else {
        const char *highp = !strcmp(d->name, "es") ? "highp " : "";
        fprintf(out, "%s%s%s lobe_%s_%s(%sfloat roughness, %sfloat n_dot_v)%s\n{\n", cl ? "" : "", highp,
                e ? pair : "float", g->model, g->tier, highp, highp, e ? " /* scale, bias */" : "");
    }
    for (int i = 0; i < g->nodes; i++)
        if (g->node[i].op != LOBE_OP_CONST && g->node[i].op != LOBE_OP_INPUT)
            statement(g, i, d, out);
    if (!shader && !cl) {
        for (int i = 0; i < g->outputs; i++)
            fprintf(out, "    *%s = %s;\n", g->output_name[i], operand(g, g->output[i], d, text));
    } else if (e > 1) {
        for (int i = 0; i < g->outputs; i++)
            fprintf(out, "    %s%s = %s;\n", cl ? "*" : "", g->output_name[i], operand(g, g->output[i], d, text));
    } else if (e) {
        fprintf(out, "    return %s%s%s(%s, ", cl ? "(" : "", pair, cl ? ")" : "", operand(g, g->output[0], d, text));
        fprintf(out, "%s);\n", operand(g, g->output[1], d, text));
    } else {
        fprintf(out, "    return %s;\n", operand(g, g->output[0], d, text));
    }
    fprintf(out, "}\n");
}

static void fpcore(const lobe_graph *g, FILE *out)
{
    static const char *const names[] = {"",     "", "+", "-", "*",    "/",    "fmin",
                                        "fmax", "", "-", "",  "exp2", "log2", "sqrt"};
    const dialect d = {"fpcore", "", ""};
    char a[48] = "", b[48] = "", c[48] = "";
    for (int o = 0; o < g->outputs; o++) {
        lobe_graph one = *g;
        one.output[0] = g->output[o];
        one.outputs = 1;
        lobe_graph_prune(&one);
        fprintf(out, "(FPCore lobe_%s_%s_%s (%s %s)\n", g->model, g->tier, g->output_name[o], g->input_name[0],
                g->input_name[1]);
        fprintf(out, "  :name \"lobe %s %s: %s\"\n  :precision binary32\n", g->model, g->tier, g->output_name[o]);
        fprintf(out, "  :pre (and (<= 0.02 %s 1) (<= 0.02 %s 1))\n  (let* (", g->input_name[0], g->input_name[1]);
        for (int i = 0, first = 1; i < one.nodes; i++) {
            const lobe_node *n = &one.node[i];
            if (n->op == LOBE_OP_CONST || n->op == LOBE_OP_INPUT)
                continue;
            for (int k = 0; k < lobe_op_arity(n->op); k++) {
                char *text = k == 0 ? a : k == 1 ? b : c;
                const lobe_node *arg = &one.node[n->arg[k]];
                if (arg->op == LOBE_OP_CONST)
                    strcpy(text, decimal(arg->value));
                else
                    operand(&one, n->arg[k], &d, text);
            }
            fprintf(out, "%s[t%d ", first ? "" : "\n         ", i);
            first = 0;
            if (n->op == LOBE_OP_SATURATE)
                fprintf(out, "(fmin (fmax %s 0) 1)]", a);
            else if (n->op == LOBE_OP_SELECT)
                fprintf(out, "(if (> %s 0) %s %s)]", a, b, c);
            else if (lobe_op_arity(n->op) == 1)
                fprintf(out, "(%s %s)]", names[n->op], a);
            else
                fprintf(out, "(%s %s %s)]", names[n->op], a, b);
        }
        fprintf(out, ")\n    %s))\n", operand(&one, one.output[0], &d, a));
    }
}

int lobe_graph_text(const lobe_graph *g, const char *language, FILE *out)
{
    if (!strcmp(language, "fpcore")) {
        fpcore(g, out);
        return 0;
    }
    for (size_t i = 0; i < sizeof dialects / sizeof dialects[0]; i++)
        if (!strcmp(language, dialects[i].name)) {
            c_like(g, &dialects[i], out);
            return 0;
        }
    return 2;
}
