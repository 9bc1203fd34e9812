#include "fit_command.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "../case.h"
#include "interrupt.h"

static bool make_folder(const char *path)
{
    if (mkdir(path, 0777) == 0 || errno == EEXIST)
        return true;
    fprintf(stderr, "lobefit: %s: cannot make the folder: %s\n", path, strerror(errno));
    return false;
}

static bool make_folders(lobe_fit_request *request, const char *out)
{
    if (strlen(out) > 3900) {
        fputs("lobefit: fit: the folder's name is too long\n", stderr);
        return false;
    }
    snprintf(request->coeffs, sizeof request->coeffs, "%.3900s/coeffs", out);
    snprintf(request->tables, sizeof request->tables, "%.3900s/tables", out);
    return make_folder(out) && make_folder(request->coeffs) && make_folder(request->tables);
}

static int unknown_tier(const lobe_case *self, const lobe_fit_tier *tiers, int count, const char *name)
{
    int i;
    fprintf(stderr, "lobefit: fit: %s has no fit of tier '%s'; there are:", self->name, name);
    for (i = 0; i < count; i++)
        fprintf(stderr, " %s", tiers[i].tier);
    fputc('\n', stderr);
    return 2;
}

int lobe_fit_command(const lobe_case *self, const lobe_fit_tier *tiers, int count, int argc, char **argv)
{
    lobe_fit_request request;
    const char *out = "models", *only = NULL;
    int i, found = 0;
    request.sweep = lobe_sweep_options_default();
    for (i = 0; i < argc; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : NULL;
        if (strcmp(argv[i], "--progress") == 0) {
            request.sweep.progress = 1;
            continue;
        }
        if (strcmp(argv[i], "--tier") != 0 && strcmp(argv[i], "--out") != 0 && strcmp(argv[i], "--threads") != 0) {
            fprintf(stderr, "lobefit: fit: unknown option '%s'; it takes --tier --out --threads --progress\n", argv[i]);
            return 2;
        }
        if (!value) {
            fprintf(stderr, "lobefit: fit: %s needs a value\n", argv[i]);
            return 2;
        }
        if (strcmp(argv[i], "--threads") == 0) {
            char *rest;
            const long n = strtol(value, &rest, 10);
            if (rest == value || *rest || n < 1 || n > LOBE_SWEEP_THREADS) {
                fprintf(stderr, "lobefit: fit: --threads '%s' is not a whole number in [1, %d]\n", value,
                        LOBE_SWEEP_THREADS);
                return 2;
            }
            request.sweep.threads = (int)n;
        } else {
            *(strcmp(argv[i], "--tier") == 0 ? &only : &out) = value;
        }
        i++;
    }
    for (i = 0; i < count; i++)
        found += !only || strcmp(only, tiers[i].tier) == 0;
    if (!found)
        return unknown_tier(self, tiers, count, only);
    if (!make_folders(&request, out))
        return 2;
    lobe_interrupt_install();
    for (i = 0; i < count; i++) {
        if (only && strcmp(only, tiers[i].tier) != 0)
            continue;
        if (!tiers[i].fit(self, &request))
            return 2;
    }
    return 0;
}
