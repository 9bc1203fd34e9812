/* lobecheck run: every vector file against the library, a row a file. */
#include "command.h"
#include "vec_file.h"
#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define VECTOR_FOLDER "vectors"

static int by_name(const void *a, const void *b) { return strcmp(*(char *const *)a, *(char *const *)b); }

/* The .vec files of a folder, sorted; the caller frees them. Returns how many, or -1. */
static int find_vectors(const char *folder, char ***paths)
{
    DIR *d = opendir(folder);
    struct dirent *item;
    int count = 0;
    *paths = NULL;
    if (!d)
        return -1;
    while ((item = readdir(d)) != NULL) {
        const size_t length = strlen(item->d_name);
        char **more, *path;
        if (length < 5 || strcmp(item->d_name + length - 4, ".vec") != 0)
            continue;
        more = realloc(*paths, (size_t)(count + 1) * sizeof *more);
        path = malloc(strlen(folder) + length + 2);
        if (!more || !path)
            abort();
        sprintf(path, "%s/%s", folder, item->d_name);
        *paths = more;
        more[count++] = path;
    }
    closedir(d);
    if (count)
        qsort(*paths, (size_t)count, sizeof **paths, by_name);
    return count;
}

/* The worst case of a part: inputs, got and want in decimal, and got's bits. */
static void print_case(const lobe_entry *e, const lobe_vectors *v, const lobe_part *part)
{
    const double *truth = v->truth + (size_t)part->row * (size_t)v->outputs;
    const int truths = lobe_truth_count(e), is_sum = part->output == truths;
    lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
    const char *name = lobe_truth_names(e), *plus = "";
    double got = 0.0, want = 0.0;
    int k;
    lobe_evaluate_row(e, v, part->row, in, out);
    for (k = 0; k < part->output && *name; k++) {
        name += strcspn(name, " ");
        name += strspn(name, " ");
    }
    printf("%.*s at", is_sum ? 1 : (int)strcspn(name, " "), is_sum ? "E" : name);
    for (k = 0; k < e->inputs; k++)
        printf(" %.9g", lobe_value_real(e->format, in[k]));
    printf(" (");
    for (k = 0; k < e->inputs; k++)
        printf(k ? " %08x" : "%08x", (unsigned)in[k].bits);
    printf("): got ");
    for (k = 0; k < truths; k++) {
        if (k == part->output || is_sum) {
            got += lobe_answer(e, k, out);
            want += truth[k];
        }
    }
    printf("%.9g (", got);
    for (k = 0; k < e->outputs; k++) {
        if (e->nth ? (k + 1) % e->nth == 0 : k == part->output || is_sum) {
            printf("%s%08x", plus, (unsigned)out[k].bits);
            plus = "+";
        }
    }
    printf(") want %.9g (%a)\n", want, want);
}

static void print_part(const lobe_entry *e, const lobe_vectors *v, const lobe_part *part, int below)
{
    char domain[160];
    double squares = 0.0;
    int k;
    if (part->rows == 0)
        return;
    for (k = 0; k <= lobe_truth_count(e); k++)
        squares = part->squares[k] > squares ? part->squares[k] : squares;
    lobe_domain_text(e, domain, sizeof domain);
    if (strchr(domain, 'x')) /* too long for a column: `list` has it */
        strcpy(domain, below ? "beyond" : "domain");
    else if (below)
        snprintf(domain, sizeof domain, "<%g", e->ranges[0].lo);
    printf("%-14s %-9s %-6s %4d %-9s %7lu %-10.4g %-10.4g %-10.4g %-6s  ", e->model, e->tier,
           lobe_format_names[e->format], e->ops, domain, (unsigned long)part->rows, part->bound, part->worst,
           sqrt(squares / part->rows), part->passed == part->rows ? "ok" : "BROKEN");
    if (part->furnace >= 0.0)
        printf("furnace %.4g of %.4g; ", part->furnace, v->bound_furnace);
    print_case(e, v, part);
}

/* Exit status for one file. */
static int run_file(const char *path)
{
    lobe_vec_file file;
    lobe_vec_error error;
    const lobe_entry *e;
    lobe_verdict verdict;
    int status = 2;
    if (!lobe_vec_load(path, &file, &error)) {
        lobe_vec_complain(path, &error);
        return 2;
    }
    if (lobe_refuse_names(file.vectors.model, file.vectors.tier, lobe_format_names[file.vectors.format])) {
        fprintf(stderr, "%s: refused\n", path);
    } else {
        e = lobe_find_entry(file.vectors.model, file.vectors.tier, file.vectors.format);
        if (lobe_vec_fits(&file, e, &error)) {
            verdict = lobe_judge(e, &file.vectors);
            print_part(e, &file.vectors, &verdict.inside, 0);
            print_part(e, &file.vectors, &verdict.below, 1);
            status = verdict.inside.passed < verdict.inside.rows || verdict.below.passed < verdict.below.rows;
        } else {
            fprintf(stderr, "%s: %s\n", path, error.reason);
        }
    }
    lobe_vec_free(&file);
    return status;
}

int lobe_command_run(int argc, char **argv)
{
    char **found = NULL;
    int i, worst = 0, count = argc;
    for (i = 0; i < argc; i++) {
        if (argv[i][0] == '-') {
            fprintf(stderr, "lobecheck run: unknown option '%s'; it takes file names only\n", argv[i]);
            return 2;
        }
    }
    if (argc == 0) {
        count = find_vectors(VECTOR_FOLDER, &found);
        if (count <= 0) {
            fprintf(stderr, "lobecheck run: no %s/*.vec here: %s\n", VECTOR_FOLDER,
                    count < 0 ? strerror(errno) : "the folder has none");
            return 2;
        }
    }
    printf("%-14s %-9s %-6s %4s %-9s %7s %-10s %-10s %-10s %-6s  %s\n", "model", "tier", "format", "ops", "domain",
           "rows", "stated", "measured", "rms", "verdict", "worst case");
    for (i = 0; i < count; i++) {
        const int status = run_file(found ? found[i] : argv[i]);
        worst = status > worst ? status : worst;
    }
    for (i = 0; found && i < count; i++)
        free(found[i]);
    free(found);
    return worst;
}
