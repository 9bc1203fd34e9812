#include "coefficients.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "atomic_file.h"
#include "digest.h"

double lobe_coefficient_rounded(double x)
{
    char text[40];
    snprintf(text, sizeof text, "%.9g", x);
    return (double)strtof(text, NULL);
}

void lobe_put_upper(FILE *out, const char *text)
{
    for (; *text; text++)
        fputc(*text >= 'a' && *text <= 'z' ? *text - 'a' + 'A' : *text, out);
}

/* The whole file, with a zero at its end; NULL after a line on stderr. */
static char *read_text(const char *path)
{
    FILE *f = fopen(path, "rb");
    char *text = NULL;
    long size = -1;
    if (f && fseek(f, 0, SEEK_END) == 0 && (size = ftell(f)) >= 0 && fseek(f, 0, SEEK_SET) == 0)
        text = malloc((size_t)size + 1);
    if (text && fread(text, 1, (size_t)size, f) == (size_t)size) {
        text[size] = '\0';
    } else {
        fprintf(stderr, "lobefit: %s: cannot read; run lobefit in the root of the repository\n", path);
        free(text);
        text = NULL;
    }
    if (f)
        fclose(f);
    return text;
}

bool lobe_kernel_digest(const char *source, const char *function, uint64_t *digest)
{
    char *text = read_text(source), name[128], *at, *end;
    int comment = 0;
    if (!text)
        return false;
    snprintf(name, sizeof name, " %s(", function);
    at = strstr(text, name);
    end = at ? strstr(at, "\n}") : NULL;
    if (!end) {
        fprintf(stderr, "lobefit: %s: no function '%s' ends here\n", source, function);
        free(text);
        return false;
    }
    *digest = LOBE_DIGEST_START;
    for (; at < end; at++) {
        if (!comment && at[0] == '/' && at[1] == '*')
            comment = 1;
        if (!comment && !strchr(" \t\r\n", *at))
            *digest = lobe_digest(*digest, at, 1);
        if (comment && at[-1] == '*' && at[0] == '/')
            comment = 0;
    }
    free(text);
    return true;
}

static void put_name(FILE *f, const lobe_coefficients *c, size_t i)
{
    fputs("#define LOBE_", f);
    lobe_put_upper(f, c->model);
    fputc('_', f);
    lobe_put_upper(f, c->tier);
    fprintf(f, "_C%zu ", i);
}

/* Nine significant digits round-trip a float; the point makes an integer a floating literal. */
static void put_literal(FILE *f, double x)
{
    char text[40];
    snprintf(text, sizeof text, "%.9g", x);
    fprintf(f, "LOBE_R(%s%s)\n", text, strpbrk(text, ".en") ? "" : ".0");
}

static void put_head(FILE *f, const lobe_coefficients *c, uint64_t digest)
{
    fprintf(f, "/* Generated, not edited: build/lobefit fit %s --tier %s\n", c->model, c->tier);
    fprintf(f, " * BRDF     %s\n * domain   %s\n * grid     %s\n", c->brdf, c->domain, c->grid);
    fprintf(f, " * metric   %s\n", c->metric);
    if (c->error)
        fprintf(f, " * error    %s;\n", c->error);
    else
        fprintf(f, " * error    max %.4g at %.9g %.9g, rms %.4g, on that grid, in double;\n", c->max, c->at[0],
                c->at[1], c->rms);
    fprintf(f, " *          what ships is measured on a finer one: %s_bounds.h\n", c->model);
    fprintf(f, " * seed     %" PRIu64 "%s\n", c->seed, c->seed ? "" : ", nothing in this fit is random");
    fprintf(f, " * kernel   %s in %s, digest %016" PRIx64 " */\n", c->kernel, c->source, digest);
}

static void put_guard(FILE *f, const char *directive, const lobe_coefficients *c)
{
    fprintf(f, "#%s LOBE_COEFFS_", directive);
    lobe_put_upper(f, c->model);
    fputc('_', f);
    lobe_put_upper(f, c->tier);
    fputs("_H\n", f);
}

bool lobe_coefficients_write(const lobe_coefficients *c, const char *folder)
{
    lobe_atomic_file file;
    char path[4096];
    uint64_t digest = 0;
    size_t i;
    if (snprintf(path, sizeof path, "%s/%s_%s.h", folder, c->model, c->tier) >= (int)sizeof path) {
        fprintf(stderr, "lobefit: %s: the name is too long\n", folder);
        return false;
    }
    if ((c->kernel && !lobe_kernel_digest(c->source, c->kernel, &digest)) || !lobe_atomic_open(&file, path))
        return false;
    if (c->kernel)
        put_head(file.stream, c, digest);
    else
        fputs("/* Zeros that stand in until the first fit: build/lobefit fit writes this file. */\n", file.stream);
    put_guard(file.stream, "ifndef", c);
    put_guard(file.stream, "define", c);
    fputs("#if defined(LOBE_FIT)\n", file.stream);
    for (i = 0; i < c->count; i++) {
        put_name(file.stream, c, i);
        fprintf(file.stream, "p[%zu]\n", i);
    }
    fputs("#else\n", file.stream);
    for (i = 0; i < c->count; i++) {
        put_name(file.stream, c, i);
        put_literal(file.stream, c->values ? c->values[i] : 0.0);
    }
    fputs("#endif\n#endif\n", file.stream);
    return lobe_atomic_commit(&file);
}
