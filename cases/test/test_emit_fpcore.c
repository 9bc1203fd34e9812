/* Reads the FPCore text that lobefit emits, evaluates it in double, and compares with the recorded formula.
 * A small reader of its own: balanced parentheses, known operators, names bound before use.
 * Usage: test_emit_fpcore MODEL TIER <text; exits 0, or 1 after a line that says what is wrong. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../fit/emit.h"

enum { NAMES = 1024, WORD = 64 };

static char text[1 << 20];
static const char *cursor;
static struct {
    char name[WORD];
    double value;
} bound[NAMES];
static int names;

static void wrong(const char *what, const char *word)
{
    printf("# fpcore: %s '%s' near byte %ld\n", what, word, (long)(cursor - text));
    exit(1);
}

/* A parenthesis, a name, a number, or a quoted string; brackets are parentheses. */
static const char *token(void)
{
    static char word[WORD];
    int n = 0;
    while (isspace((unsigned char)*cursor))
        cursor++;
    if (!*cursor)
        return "";
    if (strchr("()[]", *cursor)) {
        word[0] = *cursor == '[' ? '(' : *cursor == ']' ? ')' : *cursor;
        word[1] = 0;
        cursor++;
        return word;
    }
    if (*cursor == '"') {
        const char *end = strchr(cursor + 1, '"');
        if (!end)
            wrong("unfinished", "string");
        cursor = end + 1;
        return "\"";
    }
    while (*cursor && !isspace((unsigned char)*cursor) && !strchr("()[]\"", *cursor) && n < WORD - 1)
        word[n++] = *cursor++;
    word[n] = 0;
    return word;
}

static void expect(const char *want)
{
    const char *got = token();
    if (strcmp(got, want) != 0)
        wrong("unexpected", got);
}

static void bind(const char *name, double value)
{
    if (names == NAMES)
        wrong("too many names at", name);
    snprintf(bound[names].name, WORD, "%s", name);
    bound[names++].value = value;
}

static int at_close(void)
{
    while (isspace((unsigned char)*cursor))
        cursor++;
    return *cursor == ')' || *cursor == ']';
}

static double evaluate(void)
{
    char word[WORD], *end;
    double arg[3] = {0.0, 0.0, 0.0};
    int i, n = 0;
    snprintf(word, WORD, "%s", token());
    if (strcmp(word, "(") != 0) {
        const double number = strtod(word, &end);
        if (end != word && !*end)
            return number;
        for (i = names - 1; i >= 0; i--)
            if (strcmp(bound[i].name, word) == 0)
                return bound[i].value;
        wrong("unbound", word);
    }
    snprintf(word, WORD, "%s", token());
    if (strcmp(word, "let*") == 0) {
        double result;
        expect("(");
        while (!at_close()) {
            expect("(");
            snprintf(word, WORD, "%s", token());
            bind(word, evaluate());
            expect(")");
        }
        expect(")");
        result = evaluate();
        expect(")");
        return result;
    }
    while (!at_close()) {
        if (n == 3)
            wrong("too many arguments of", word);
        arg[n++] = evaluate();
    }
    expect(")");
    if (n == 2 && strlen(word) == 1) {
        if (word[0] == '+')
            return arg[0] + arg[1];
        if (word[0] == '-')
            return arg[0] - arg[1];
        if (word[0] == '*')
            return arg[0] * arg[1];
        if (word[0] == '/')
            return arg[0] / arg[1];
        if (word[0] == '>')
            return arg[0] > arg[1];
    }
    if (n == 2 && strcmp(word, "fmin") == 0)
        return fmin(arg[0], arg[1]);
    if (n == 2 && strcmp(word, "fmax") == 0)
        return fmax(arg[0], arg[1]);
    if (n == 1 && strcmp(word, "-") == 0)
        return -arg[0];
    if (n == 1 && strcmp(word, "sqrt") == 0)
        return sqrt(arg[0]);
    if (n == 1 && strcmp(word, "log2") == 0)
        return log2(arg[0]);
    if (n == 1 && strcmp(word, "exp2") == 0)
        return exp2(arg[0]);
    if (n == 3 && strcmp(word, "if") == 0)
        return arg[0] != 0.0 ? arg[1] : arg[2];
    wrong("unknown operator or number of arguments:", word);
    return 0.0;
}

/* (FPCore NAME (ARGUMENTS) :property value ... expression), its value at one point. */
static double core(const double *in)
{
    char word[WORD];
    int depth;
    names = 0;
    expect("(");
    expect("FPCore");
    token();
    expect("(");
    snprintf(word, WORD, "%s", token());
    bind(word, in[0]);
    snprintf(word, WORD, "%s", token());
    bind(word, in[1]);
    expect(")");
    for (;;) {
        const char *before = cursor;
        double result;
        const char *key = token();
        if (key[0] != ':') {
            cursor = before;
            result = evaluate();
            expect(")");
            return result;
        }
        depth = 0;
        do {
            const char *part = token();
            if (!*part)
                wrong("unfinished", "property");
            depth += part[0] == '(' ? 1 : part[0] == ')' ? -1 : 0;
        } while (depth > 0);
    }
}

int main(int argc, char **argv)
{
    double in[2], want[9];
    int i, o, n;
    if (argc != 3)
        return 2;
    text[fread(text, 1, sizeof text - 1, stdin)] = 0;
    for (i = 0; i < 400; i++) {
        in[0] = 0.02 + 0.98 * (i % 20) / 19.0;
        in[1] = 0.02 + 0.98 * (i / 20) / 19.0;
        n = lobe_emit_value(argv[1], argv[2], in, want);
        if (n == 0)
            return 2;
        cursor = text;
        for (o = 0; o < n; o++) {
            const double got = core(in);
            if (!(fabs(got - want[o]) <= 1e-15)) {
                printf("# fpcore: output %d at %g %g is %.17g, not %.17g\n", o, in[0], in[1], got, want[o]);
                return 1;
            }
        }
        if (*token())
            wrong("text after", "the last FPCore");
    }
    return 0;
}
