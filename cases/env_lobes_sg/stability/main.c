/* `make lobe-experiments`: every experiment's table into a folder.
 * usage: lobe_experiments FOLDER [NAME...] */
#include <string.h>
#include "../../fit/atomic_file.h"
#include "experiment.h"

static const struct {
    const char *name;
    bool (*run)(FILE *out);
} experiments[] = {{"sampling", lobe_experiment_sampling},     {"noise", lobe_experiment_noise},
                   {"optimisers", lobe_experiment_optimisers}, {"starts", lobe_experiment_starts},
                   {"neighbours", lobe_experiment_neighbours}, {"wobble", lobe_experiment_wobble},
                   {"spread", lobe_experiment_spread},         {"amplitude", lobe_experiment_amplitude}};
enum { COUNT = sizeof experiments / sizeof experiments[0] };

static bool wanted(const char *name, int argc, char **argv)
{
    int i;
    for (i = 2; i < argc; i++)
        if (strcmp(argv[i], name) == 0)
            return true;
    return argc == 2;
}

int main(int argc, char **argv)
{
    int i, k;
    if (argc < 2) {
        fputs("usage: lobe_experiments FOLDER [NAME...]\n", stderr);
        return 2;
    }
    for (k = 2; k < argc; k++) {
        for (i = 0; i < COUNT && strcmp(argv[k], experiments[i].name) != 0; i++)
            ;
        if (i == COUNT) {
            fprintf(stderr, "lobe_experiments: no experiment '%s'; there are", argv[k]);
            for (i = 0; i < COUNT; i++)
                fprintf(stderr, " %s", experiments[i].name);
            fputc('\n', stderr);
            return 2;
        }
    }
    for (i = 0; i < COUNT; i++) {
        lobe_atomic_file file;
        char path[4096];
        if (!wanted(experiments[i].name, argc, argv))
            continue;
        fprintf(stderr, "%s\n", experiments[i].name);
        if (snprintf(path, sizeof path, "%s/%s.csv", argv[1], experiments[i].name) >= (int)sizeof path ||
            !lobe_atomic_open(&file, path))
            return 2;
        if (!experiments[i].run(file.stream)) {
            fputs("lobe_experiments: out of memory\n", stderr);
            lobe_atomic_abandon(&file);
            return 2;
        }
        if (!lobe_atomic_commit(&file))
            return 2;
    }
    return 0;
}
