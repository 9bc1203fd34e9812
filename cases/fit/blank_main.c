/* Stand-ins for generated headers, so that lobefit compiles after a tier or a coefficient was added; the fit then
 * writes the real ones.
 *     blank coeffs FOLDER MODEL TIER COUNT      MODEL_TIER.h, all zero
 *     blank bounds FOLDER MODEL TIER...         MODEL_bounds.h, all 2, which every error is below */
#include <stdlib.h>
#include <string.h>
#include "atomic_file.h"
#include "coefficients.h"

static int bounds(const char *folder, const char *model, int tiers, char **tier)
{
    static const char *const names[] = {"F32_MAX", "F32_RMS", "F32_BELOW_MAX", "F32_FURNACE", "F32_BELOW_FURNACE",
                                        "Q30_MAX", "Q30_RMS", "Q30_BELOW_MAX", "Q30_FURNACE", "Q30_BELOW_FURNACE"};
    lobe_atomic_file file;
    char path[4096], prefix[128];
    int i;
    size_t k;
    if (snprintf(path, sizeof path, "%s/%s_bounds.h", folder, model) >= (int)sizeof path ||
        !lobe_atomic_open(&file, path))
        return 2;
    fputs("/* Stands in until the first measurement: build/lobefit bounds writes this file. */\n", file.stream);
    for (i = 0; i < tiers; i++) {
        snprintf(prefix, sizeof prefix, "LOBE_%s_%s", model, tier[i]);
        for (k = 0; k < sizeof names / sizeof names[0] + 2; k++) {
            fputs("#define ", file.stream);
            lobe_put_upper(file.stream, prefix);
            if (k == 0)
                fputs("_DOMAIN_LO 0.02\n", file.stream);
            else if (k == 1)
                fputs("_OPS 0\n", file.stream);
            else
                fprintf(file.stream, "_%s 2.0\n", names[k - 2]);
        }
    }
    return lobe_atomic_commit(&file) ? 0 : 2;
}

int main(int argc, char **argv)
{
    lobe_coefficients c = {0};
    char *rest = NULL;
    if (argc > 4 && strcmp(argv[1], "bounds") == 0)
        return bounds(argv[2], argv[3], argc - 4, argv + 4);
    if (argc == 6 && strcmp(argv[1], "coeffs") == 0)
        c.count = strtoul(argv[5], &rest, 10);
    if (!rest || *rest || c.count < 1 || c.count > 1000) {
        fputs("usage: blank coeffs FOLDER MODEL TIER COUNT | blank bounds FOLDER MODEL TIER...\n"
              "COUNT is a whole number in [1, 1000]\n",
              stderr);
        return 2;
    }
    c.model = argv[3];
    c.tier = argv[4];
    return lobe_coefficients_write(&c, argv[2]) ? 0 : 2;
}
