/* lobecheck: proves the library against its vectors, hashes and stated bounds, on any machine. */
#include "command.h"
#include <stdio.h>
#include <string.h>

static const struct {
    const char *name;
    int (*command)(int argc, char **argv);
} commands[] = {{"list", lobe_command_list},
                {"run", lobe_command_run},
                {"eval", lobe_command_eval},
                {"hash", lobe_command_hash},
                {"bench", lobe_command_bench}};
enum { COMMANDS = sizeof commands / sizeof commands[0] };

static const char usage[] =
    "lobecheck list                  a row a model, tier and format: operations, stated bound, domain, kernel\n"
    "lobecheck run [FILE...]         checks vector files (default: vectors/*.vec), a row a file\n"
    "lobecheck eval MODEL --tier T --format f32|q30\n"
    "                                rows of inputs on standard input, rows of outputs on standard output;\n"
    "                                any number is answered, nan and inf too; q30 takes real numbers;\n"
    "                                sphere_light: roughness, n.v, n.l of its centre, azimuth from view to\n"
    "                                light (pi: the mirror's side) and half angle in radians;\n"
    "                                sg_light: the same of its axis, and its sharpness last;\n"
    "                                env_lobes, env_lobes_sg: angle, width and weight of each tap\n"
    "lobecheck hash [--write] [--file FILE]\n"
    "                                compares each function's bits with vectors/hashes.txt, or writes that\n"
    "lobecheck bench [MODEL]         nanoseconds an evaluation on this machine, scalar and array\n"
    "Rows are separated by blanks or commas; '#' starts a comment.\n"
    "Exit status: 0 all good, 1 a check failed, 2 bad usage or input.\n";

const char *lobe_option(int argc, char **argv, int *i, const char *name)
{
    const size_t length = strlen(name);
    if (strncmp(argv[*i], name, length) != 0)
        return NULL;
    if (argv[*i][length] == '=')
        return argv[*i] + length + 1;
    if (argv[*i][length] != 0 || *i + 1 >= argc)
        return NULL;
    return argv[++*i];
}

static int listed(size_t i, const char *model)
{
    size_t k;
    for (k = 0; k < i; k++) {
        const lobe_entry *e = &lobe_entries[k];
        if (!model ? lobe_same(e->model, lobe_entries[i].model)
                   : lobe_same(e->model, model) && lobe_same(e->tier, lobe_entries[i].tier))
            return 1;
    }
    return 0;
}

int lobe_refuse_names(const char *model, const char *tier, const char *format)
{
    size_t i;
    int model_known = 0, tier_known = tier == NULL;
    for (i = 0; i < lobe_entry_count; i++) {
        const int same = lobe_same(lobe_entries[i].model, model);
        model_known |= same;
        tier_known |= same && tier && lobe_same(lobe_entries[i].tier, tier);
    }
    if (!model_known) {
        fprintf(stderr, "lobecheck: unknown model '%s'; allowed:", model);
        for (i = 0; i < lobe_entry_count; i++)
            if (!listed(i, NULL))
                fprintf(stderr, " %s", lobe_entries[i].model);
    } else if (!tier_known) {
        fprintf(stderr, "lobecheck: unknown tier '%s' of %s; allowed:", tier, model);
        for (i = 0; i < lobe_entry_count; i++)
            if (lobe_same(lobe_entries[i].model, model) && !listed(i, model))
                fprintf(stderr, " %s", lobe_entries[i].tier);
    } else if (format && lobe_format_named(format) == LOBE_FORMATS) {
        fprintf(stderr, "lobecheck: unknown format '%s'; allowed: f32 q30", format);
    } else if (format && tier && !lobe_find_entry(model, tier, lobe_format_named(format))) {
        fprintf(stderr, "lobecheck: %s %s does not exist in %s", model, tier, format);
    } else {
        return 0;
    }
    fputc('\n', stderr);
    return 2;
}

const char *lobe_domain_text(const lobe_entry *entry, char *text, size_t size)
{
    size_t length = 0;
    int k, alike = 1;
    for (k = 1; k < entry->inputs; k++)
        alike &= entry->ranges[k].lo == entry->ranges[0].lo && entry->ranges[k].hi == entry->ranges[0].hi;
    text[0] = 0;
    for (k = 0; k < (alike ? 1 : entry->inputs) && length < size; k++)
        length += (size_t)snprintf(text + length, size - length, k ? "x[%g,%g]" : "[%g,%g]", entry->ranges[k].lo,
                                   entry->ranges[k].hi);
    return text;
}

int lobe_command_list(int argc, char **argv)
{
    size_t i;
    if (argc > 0) {
        fprintf(stderr, "lobecheck list: unexpected '%s'; it takes no arguments\n", argv[0]);
        return 2;
    }
    printf("# %-14s %-9s %-6s %4s %-11s %-11s %-11s %-12s %-32s %s\n", "model", "tier", "format", "ops", "max", "rms",
           "max below", "domain", "inputs -> outputs", "kernel");
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        char domain[160], columns[160];
        lobe_domain_text(e, domain, sizeof domain);
        if (e->nth)
            snprintf(columns, sizeof columns, "%s->%dx(angle width weight)", e->input_names, e->outputs / e->nth);
        else
            snprintf(columns, sizeof columns, "%s->%s", e->input_names, e->output_names);
        for (char *c = columns; *c; c++)
            if (*c == ' ')
                *c = ',';
        printf("  %-14s %-9s %-6s %4d %-11.4g %-11.4g %-11.4g %-12s %-32s %s%s%s\n", e->model, e->tier,
               lobe_format_names[e->format], e->ops, e->max, e->rms, e->below_max, domain, columns, e->kernel,
               e->prefilter ? " " : "", e->prefilter ? e->prefilter : "");
    }
    return 0;
}

int main(int argc, char **argv)
{
    int i, status = 2;
    for (i = 1; i < argc; i++) {
        if (strcmp(argv[i], "-h") == 0 || strcmp(argv[i], "--help") == 0) {
            fputs(usage, stdout);
            return 0;
        }
    }
    for (i = 0; i < COMMANDS && argc > 1; i++)
        if (strcmp(argv[1], commands[i].name) == 0)
            break;
    if (argc < 2 || i == COMMANDS) {
        fprintf(stderr, argc < 2 ? "lobecheck: no command" : "lobecheck: unknown command '%s'", argv[argc > 1]);
        fputs("; allowed: list run eval hash bench (lobecheck -h explains)\n", stderr);
        return 2;
    }
    status = commands[i].command(argc - 2, argv + 2);
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fputs("lobecheck: standard output cannot be written\n", stderr);
        return 2;
    }
    return status;
}
