/* The offline side's command line: truth, vectors, fits and emitted formulas of the case studies in cases.c. */
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "case.h"
#include "environment/project_command.h"
#include "prefilter/prefilter_command.h"
#include "fit/bounds.h"
#include "fit/sweep.h"
#if defined(LOBE_WITH_EMIT)
#include "fit/emit.h"
#endif

static const char usage[] =
    "usage: lobefit COMMAND ...\n"
    "  list                      a row a case: name, inputs with their domain, outputs, BRDF\n"
    "  truth CASE                rows of inputs on stdin, rows of true outputs on stdout, 17 significant digits\n"
    "      --threads N           1 to 64, all processors if left out; the bytes do not depend on it\n"
    "      --opencl              evaluate through the OpenCL ICD, with the same bytes\n"
    "      --progress            rate and estimate on stderr also where that is not a terminal\n"
    "  vectors CASE              write the .vec files of every tier and format\n"
    "      --out DIR             into this folder instead of vectors; also --threads, --progress\n"
    "  fit CASE                  fit every tier and write its coefficient header\n"
    "      --tier TIER           this one alone\n"
    "      --out DIR             into DIR/coeffs and DIR/tables instead of models; also --threads, --progress\n"
    "  bounds CASE               measure what ships, write models/coeffs/CASE_bounds.h; --out, --threads, --progress\n"
    "  search CASE               fit the explored forms from scratch and print what each reaches; --csv FILE\n"
    "  emit CASE --to LANGUAGE   c, q30, cl, glsl, hlsl or fpcore; --tier TIER for one tier only\n"
    "  scene PROFILE --budget E  choose tiers for a scene\n"
    "  project FILE              an equirectangular map, RGBE (.hdr) or PFM, as nine SH coefficients a channel\n"
    "      --c NAME              as a C array instead of rows of red green blue\n"
    "      --sun                 the sun as a punctual light (direction, irradiance), the rest as coefficients\n"
    "      --sun-share S         only where it carries this share of the mean irradiance, in [0, 4], 0.5 if left out\n"
    "      --window positive     the least smoothing that leaves no negative irradiance; or hanning, or none\n"
    "      --up y                for a world with y up, middle of the map along -z; z up, along +x if left out\n"
    "  prefilter FILE --out CUBE  a map or six faces (RGBE, PFM) or a cube (DDS, KTX2 of half floats), filtered\n"
    "      --kernel ggx|sg       the split sum's prefilter, or spherical Gaussians; ggx if left out\n"
    "      --size N --mips M     of the cube; 256 and a last mip of side 4 if left out\n"
    "      --format dds|ktx2|raw half floats, or floats without a head; by the file's name, else dds\n"
    "      --curve A             mips against widths, lod = (M - 1) r (A + (1 - A) r); 1 is linear\n"
    "      --fit                 small mips fitted to bilinear lookups instead of exact at texel centres\n"
    "      --up y                as for project; also --threads, --opencl, --progress\n"
    "Rows are numbers separated by white space or commas; # starts a comment, blank lines are skipped.\n"
    "Exit status: 0 all good, 1 a check failed, 2 bad usage or input.\n";

static const char *const commands[] = {"truth", "vectors", "fit", "bounds", "search", "emit", "scene", NULL};

static int refuse(const char *format, ...) __attribute__((format(printf, 1, 2)));

static int refuse(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fputs("lobefit: ", stderr);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
    return 2;
}

static int unknown_case(const char *name)
{
    int i;
    fprintf(stderr, "lobefit: no case '%s'; there are:", name);
    for (i = 0; lobe_case_at(i); i++)
        fprintf(stderr, " %s", lobe_case_at(i)->name);
    fputc('\n', stderr);
    return 2;
}

/* Output that did not reach its file is a failure, also where the disk filled up at the last byte. */
static int finish_output(void)
{
    if (fflush(stdout) != 0 || ferror(stdout))
        return refuse("<stdout>: cannot write: %s", strerror(errno));
    return 0;
}

typedef struct options {
    lobe_sweep_options sweep;
    int opencl;
    const char *folder;
} options;

/* 0, or 2 after a message. accepts lists the options that this command has. */
static int parse_options(const char *command, const char *accepts, int argc, char **argv, options *o)
{
    int i;
    o->sweep = lobe_sweep_options_default();
    o->opencl = 0;
    o->folder = "vectors";
    for (i = 0; i < argc; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : NULL;
        char found[32];
        snprintf(found, sizeof found, "%.24s ", argv[i]);
        if (strlen(argv[i]) > 20 || !strstr(accepts, found))
            return refuse("%s: unknown option '%s'; it takes %s", command, argv[i], accepts);
        if (strcmp(argv[i], "--opencl") == 0) {
            o->opencl = 1;
        } else if (strcmp(argv[i], "--progress") == 0) {
            o->sweep.progress = 1;
        } else if (!value) {
            return refuse("%s: %s needs a value", command, argv[i]);
        } else if (strcmp(argv[i], "--threads") == 0) {
            char *rest;
            const long n = strtol(value, &rest, 10);
            if (rest == value || *rest != '\0' || n < 1 || n > LOBE_SWEEP_THREADS)
                return refuse("%s: --threads '%s' is not a whole number in [1, %d]", command, value,
                              LOBE_SWEEP_THREADS);
            o->sweep.threads = (int)n;
            i++;
        } else {
            o->folder = value;
            i++;
        }
    }
    return 0;
}

static int list(void)
{
    int i, k;
    for (i = 0; lobe_case_at(i); i++) {
        const lobe_case *c = lobe_case_at(i);
        printf("%s\t", c->name);
        for (k = 0; k < c->input_count; k++)
            printf("%s[%.9g,%.9g] ", c->inputs[k].name, c->inputs[k].lo, c->inputs[k].hi);
        printf("->");
        for (k = 0; k < c->output_count; k++)
            printf(" %s", c->outputs[k]);
        printf("\t%s\t%s\terror %s\n", c->brdf, c->integral, c->accuracy);
    }
    return finish_output();
}

static int truth(const lobe_case *c, int argc, char **argv)
{
    options o;
    lobe_rows rows;
    char error[1024];
    double *out;
    size_t i;
    int k, status = parse_options("truth", "--threads --opencl --progress ", argc, argv, &o);
    if (status)
        return status;
    if (o.opencl && !c->truth_opencl)
        return refuse("truth: --opencl is not available for %s", c->name);
    if (lobe_rows_read(stdin, "<stdin>", c->inputs, c->input_count, &rows, error, sizeof error))
        return refuse("%s", error);
    for (i = 0; c->refuse && i < rows.count; i++) {
        const char *reason = c->refuse(rows.values + i * (size_t)c->input_count);
        if (reason) {
            lobe_rows_free(&rows);
            return refuse("<stdin>: row %zu: %s", i + 1, reason);
        }
    }
    out = malloc((rows.count * (size_t)c->output_count + 1) * sizeof *out);
    if (!out) {
        lobe_rows_free(&rows);
        return refuse("truth: not enough memory for %zu rows", rows.count);
    }
    if (o.opencl)
        status = c->truth_opencl(rows.values, out, rows.count, error, sizeof error);
    else
        lobe_sweep(c->truth, rows.values, c->input_count, out, c->output_count, rows.count, &o.sweep);
    if (status) {
        refuse("%s", error);
    } else {
        for (i = 0; i < rows.count; i++) {
            for (k = 0; k < c->output_count; k++)
                printf("%.17g%c", out[i * (size_t)c->output_count + (size_t)k], k + 1 < c->output_count ? ' ' : '\n');
        }
        status = finish_output();
    }
    free(out);
    lobe_rows_free(&rows);
    return status;
}

static int vectors(const lobe_case *c, int argc, char **argv)
{
    options o;
    char error[1024];
    const int status = parse_options("vectors", "--out --threads --progress ", argc, argv, &o);
    if (status)
        return status;
    if (!c->vectors)
        return refuse("vectors: not available for %s yet", c->name);
    return lobe_vectors_write(c, o.folder, &o.sweep, error, sizeof error) ? refuse("%s", error) : 0;
}

static int emit(const lobe_case *c, int argc, char **argv)
{
#if defined(LOBE_WITH_EMIT)
    const char *language = NULL, *only = NULL, *model, *tier;
    int i, found = 0;
    for (i = 0; i + 1 < argc; i += 2) {
        if (strcmp(argv[i], "--to") == 0)
            language = argv[i + 1];
        else if (strcmp(argv[i], "--tier") == 0)
            only = argv[i + 1];
        else
            return refuse("emit: unknown option '%s'; it takes --to --tier", argv[i]);
    }
    if (i < argc)
        return refuse("emit: '%s' needs a value, or is unknown; it takes --to --tier", argv[i]);
    if (!language)
        return refuse("emit: which language? --to c, q30, cl, glsl, hlsl or fpcore");
    for (i = 0; lobe_emit_list(i, &model, &tier) == 0; i++) {
        if (strcmp(model, c->name) == 0 && (!only || strcmp(only, tier) == 0)) {
            const int status = lobe_emit(model, tier, language, stdout);
            if (status)
                return status;
            found++;
        }
    }
    if (!found)
        return only ? refuse("emit: %s has no formula of tier '%s'", c->name, only)
                    : refuse("emit: not available for %s yet", c->name);
    return finish_output();
#else
    (void)argc;
    (void)argv;
    return refuse("emit: not available for %s yet", c->name);
#endif
}

static int hook(const char *command, lobe_command_fn f, const lobe_case *c, int argc, char **argv)
{
    return f ? f(c, argc, argv) : refuse("%s: not available for %s yet", command, c->name);
}

int main(int argc, char **argv)
{
    const char *command = argc > 1 ? argv[1] : NULL;
    const lobe_case *c;
    int i;
    if (!command) {
        fputs(usage, stderr);
        return 2;
    }
    for (i = 1; i < argc; i++) {
        if (strcmp(argv[i], "-h") == 0 || strcmp(argv[i], "--help") == 0) {
            fputs(usage, stdout);
            return finish_output();
        }
    }
    if (strcmp(command, "list") == 0)
        return argc == 2 ? list() : refuse("list: '%s' is one word too many", argv[2]);
    if (strcmp(command, "project") == 0)
        return lobe_project_command(argc - 2, argv + 2);
    if (strcmp(command, "prefilter") == 0)
        return lobe_prefilter_command(argc - 2, argv + 2);
    for (i = 0; commands[i] && strcmp(commands[i], command) != 0; i++)
        ;
    if (!commands[i])
        return refuse("unknown command '%s'; try lobefit -h", command);
    if (strcmp(command, "scene") == 0 || (strcmp(command, "search") == 0 && argc > 2 && argv[2][0] == '-'))
        return refuse("%s: not available yet", command);
    if (argc < 3)
        return refuse("%s: which case? `lobefit list` names them", command);
    c = lobe_case_find(argv[2]);
    if (!c)
        return unknown_case(argv[2]);
    argc -= 3;
    argv += 3;
    if (strcmp(command, "truth") == 0)
        return truth(c, argc, argv);
    if (strcmp(command, "vectors") == 0)
        return vectors(c, argc, argv);
    if (strcmp(command, "emit") == 0)
        return emit(c, argc, argv);
    if (strcmp(command, "fit") == 0)
        return hook(command, c->fit, c, argc, argv);
    if (strcmp(command, "bounds") == 0)
        return c->bounds ? c->bounds(c, argc, argv) : lobe_bounds_command(c, argc, argv);
    return hook(command, c->search, c, argc, argv);
}
