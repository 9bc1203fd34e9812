#include "vectors.h"
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "../case.h"
#include "digest.h"
#include "sweep.h"

#define POINTS_MAX 512 /* where a set does not say */
#define ROW_MAX (LOBE_CASE_COLUMNS * 2 * 26)

/* The rows as they stand in the file. */
static char *rows_text(const lobe_case *c, const double *in, const double *out, size_t n, size_t *length)
{
    char *text = malloc(n * ROW_MAX + 1), *at = text;
    size_t i;
    int k;
    if (!text)
        return NULL;
    for (i = 0; i < n; i++) {
        for (k = 0; k < c->input_count; k++)
            at += sprintf(at, "%.17g ", in[i * (size_t)c->input_count + (size_t)k]);
        for (k = 0; k < c->output_count; k++)
            at += sprintf(at, "%.17g%c", out[i * (size_t)c->output_count + (size_t)k],
                          k + 1 < c->output_count ? ' ' : '\n');
    }
    *length = (size_t)(at - text);
    return text;
}

static void write_head(FILE *f, const lobe_case *c, const lobe_tier_bounds *b, int below, uint64_t digest)
{
    int k;
    fprintf(f, "# model: %s\n# tier: %s\n# format: %s\n# inputs:", c->name, b->tier, b->format);
    for (k = 0; k < c->input_count; k++)
        fprintf(f, " %s", c->inputs[k].name);
    fputs("\n# outputs:", f);
    for (k = 0; k < c->output_count; k++)
        fprintf(f, " %s", c->outputs[k]);
    fprintf(f, "\n# brdf: %s\n# domain:", c->brdf);
    if (c->vectors->domain)
        fprintf(f, " %s", below ? c->vectors->beyond : c->vectors->domain);
    for (k = 0; k < c->input_count && !c->vectors->domain; k++)
        fprintf(f, " %s in [%.9g, %.9g]%s", c->inputs[k].name, below ? c->inputs[k].lo : b->domain_lo, c->inputs[k].hi,
                k + 1 < c->input_count ? "," : "");
    if (below && !c->vectors->domain)
        fprintf(f, ", at least one below %.9g", b->domain_lo);
    fprintf(f, "\n# truth: %s; its own error is at most %s\n", c->integral, c->accuracy);
    fprintf(f, "# bound_max: %.9g\n", below ? b->below_max : b->max);
    if (!below)
        fprintf(f, "# bound_rms: %.9g\n", b->rms);
    if (b->furnace > 0)
        fprintf(f, "# bound_furnace: %.9g\n", below ? b->below_furnace : b->furnace);
    fprintf(f, "# command: build/lobefit vectors %s\n# seed: %" PRIu64 "\n# digest: %016" PRIx64 "\n", c->name,
            c->vectors->seed, digest);
}

static int refuse(char *error, size_t error_size, const char *path, const char *what)
{
    snprintf(error, error_size, "%s: %s: %s", path, what, strerror(errno ? errno : EIO));
    return 2;
}

/* Written under another name and renamed, so that a reader never sees half a file. */
static int write_file(const lobe_case *c, const lobe_tier_bounds *b, int below, const char *path, const char *text,
                      size_t length, char *error, size_t error_size)
{
    char temporary[4200];
    FILE *f;
    int good;
    snprintf(temporary, sizeof temporary, "%s.new", path);
    errno = 0;
    f = fopen(temporary, "wb");
    if (!f)
        return refuse(error, error_size, path, "cannot write");
    write_head(f, c, b, below, lobe_digest(LOBE_DIGEST_START, text, length));
    good = fwrite(text, 1, length, f) == length && !ferror(f);
    if (fclose(f) != 0 || !good || rename(temporary, path) != 0) {
        refuse(error, error_size, path, "cannot write");
        remove(temporary);
        return 2;
    }
    return 0;
}

static int write_group(const lobe_case *c, const lobe_tier_bounds *b, int below, const char *folder,
                       const lobe_sweep_options *options, char *error, size_t error_size)
{
    const size_t room = c->vectors->rows ? c->vectors->rows : POINTS_MAX;
    const char *suffix = !below ? "" : c->vectors->domain ? ".beyond" : ".below";
    char path[4096];
    double *in = malloc(room * LOBE_CASE_COLUMNS * sizeof *in);
    double *out = malloc(room * LOBE_CASE_COLUMNS * sizeof *out);
    char *text = NULL;
    size_t n, length = 0;
    int status = 2;
    if (snprintf(path, sizeof path, "%s/%s.%s.%s%s.vec", folder, c->name, b->tier, b->format, suffix) >=
        (int)sizeof path) {
        snprintf(error, error_size, "vectors: the folder's name is too long");
    } else if (in && out) {
        n = c->vectors->points(b->domain_lo, below, c->vectors->seed, in, room);
        lobe_sweep(c->truth, in, c->input_count, out, c->output_count, n, options);
        text = rows_text(c, in, out, n, &length);
        if (text)
            status = write_file(c, b, below, path, text, length, error, error_size);
    }
    if (!in || !out || (!text && status == 2 && !*error))
        snprintf(error, error_size, "vectors: not enough memory");
    free(text);
    free(out);
    free(in);
    return status;
}

int lobe_vectors_write(const struct lobe_case *self, const char *folder, const struct lobe_sweep_options *options,
                       char *error, size_t error_size)
{
    const lobe_case *c = self->vectors->columns ? self->vectors->columns : self;
    int i, status, found = 0;
    error[0] = '\0';
    errno = 0;
    for (i = 0; i < self->vectors->bound_count; i++) {
        const lobe_tier_bounds *b = &self->vectors->bounds[i];
        if (strcmp(b->model, self->name) != 0)
            continue;
        if (!found++ && mkdir(folder, 0777) != 0 && errno != EEXIST)
            return refuse(error, error_size, folder, "cannot make the folder");
        status = write_group(c, b, 0, folder, options, error, error_size);
        if (!status && b->below_max > 0)
            status = write_group(c, b, 1, folder, options, error, error_size);
        if (status)
            return status;
    }
    if (!found) {
        snprintf(error, error_size, "vectors: not available for %s yet", self->name);
        return 2;
    }
    return 0;
}
