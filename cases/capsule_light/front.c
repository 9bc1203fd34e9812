#include "front.h"
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "candidates.h"
#include "judge.h"
#include "operations.h"

static bool run(const lobe_sweep_options *sweep, FILE *out)
{
    int set, i;
    fputs("cells,form,operations,all,view60,view75,worst_cell,worst_energy\n", out);
    for (set = 1; set >= 0; set--) {
        lobe_capsule_cells cells;
        lobe_sweep_options options = *sweep;
        options.label = "truth";
        if (!lobe_capsule_cells_make(&cells, set == 1, &options)) {
            lobe_capsule_cells_free(&cells);
            fputs("lobefit: search: not enough memory\n", stderr);
            return false;
        }
        for (i = 0; lobe_capsule_candidate_at(i); i++) {
            const lobe_capsule_candidate *form = lobe_capsule_candidate_at(i);
            lobe_capsule_score score;
            lobe_capsule_judge(form->call, &cells, &score);
            fprintf(out, "%s,%s,", cells.held ? "held" : "fit", form->name);
#if defined(LOBE_WITH_EMIT)
            fprintf(out, "%d", lobe_capsule_operations(form->name));
#endif
            fprintf(out, ",%.4f,%.4f,%.4f,%.4f,%+.3f\n", score.all, score.view60, score.view75, score.worst,
                    score.energy);
        }
        lobe_capsule_cells_free(&cells);
    }
    return true;
}

/* A whole number in [1, LOBE_SWEEP_THREADS], or 0. */
static int threads_of(const char *text)
{
    char *rest;
    const long n = strtol(text, &rest, 10);
    return rest == text || *rest != '\0' || n < 1 || n > LOBE_SWEEP_THREADS ? 0 : (int)n;
}

static int refuse(const char *path)
{
    fprintf(stderr, "lobefit: search: cannot write '%s': %s\n", path, strerror(errno));
    return 2;
}

int lobe_capsule_front_search(const lobe_case *self, int argc, char **argv)
{
    lobe_sweep_options sweep = lobe_sweep_options_default();
    const char *csv = NULL;
    lobe_atomic_file file;
    int i;
    (void)self;
    for (i = 0; i < argc; i++) {
        const bool value = i + 1 < argc;
        if (!strcmp(argv[i], "--progress")) {
            sweep.progress = 1;
        } else if (!strcmp(argv[i], "--csv") && value) {
            csv = argv[++i];
        } else if (!strcmp(argv[i], "--threads") && value) {
            sweep.threads = threads_of(argv[++i]);
            if (!sweep.threads) {
                fprintf(stderr, "lobefit: search: --threads '%s' is not a whole number in [1, %d]\n", argv[i],
                        LOBE_SWEEP_THREADS);
                return 2;
            }
        } else {
            fprintf(stderr,
                    "lobefit: search: unknown option '%s', or its value is missing; it takes --csv FILE "
                    "--threads N --progress\n",
                    argv[i]);
            return 2;
        }
    }
    if (!csv) {
        if (!run(&sweep, stdout))
            return 1;
        return fflush(stdout) != 0 || ferror(stdout) ? refuse("<stdout>") : 0;
    }
    if (!lobe_atomic_open(&file, csv))
        return refuse(csv);
    if (!run(&sweep, file.stream)) {
        lobe_atomic_abandon(&file);
        return 1;
    }
    return lobe_atomic_commit(&file) ? 0 : refuse(csv);
}
