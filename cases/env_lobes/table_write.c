#include "table_write.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include "../fit/atomic_file.h"
#include "../fit/coefficients.h"

void lobe_env_table_round(double *table, int taps)
{
    const int numbers = lobe_env_table_numbers(taps);
    for (int i = 0; i < numbers * LOBE_ENV_TABLE_NODES; i++) {
        const double unit = lobe_env_table_unit(i % numbers % 3);
        table[i] = floor(table[i] / unit + 0.5) * unit;
    }
}

static void put_head(FILE *f, const lobe_env_table_text *t, uint64_t digest)
{
    fprintf(f, "/* Generated, not edited: build/lobefit fit env_lobes --tier lobes%d_table%d\n", t->taps,
            LOBE_ENV_TABLE_SIDE);
    fprintf(f, " * BRDF     %s\n", t->brdf);
    fprintf(f, " * domain   alpha in [.02, 1], n_dot_v in [.03, 1]; nodes beyond follow their neighbours\n");
    fprintf(f, " * layout   lobe_split_sum_table_texel in models/split_sum_table.h, digest %016" PRIx64 "\n", digest);
    fprintf(f, " * grid     %s\n", t->grid);
    fprintf(f, " * metric   %s\n", t->metric);
    fprintf(f, " * error    rms of the three from alpha .04 on: %.4f, %.4f, %.4f\n", t->error[LOBE_CELL_SAMPLES],
            t->error[LOBE_CELL_SPECTRA], t->error[LOBE_CELL_SHAPE]);
    fprintf(f, " * values   a node a paragraph, n_dot_v running fastest: of every tap its shift, width and part in\n");
    fprintf(f, " *          turn, the last without a part, in 2048ths, 8192nds and 4096ths\n");
    fprintf(f, " * seed     1 */\n#include \"../lobe.h\"\n\n");
}

bool lobe_env_table_write(const lobe_env_table_text *t, const char *folder)
{
    const int numbers = lobe_env_table_numbers(t->taps);
    lobe_atomic_file file;
    char path[4200];
    uint64_t digest;
    snprintf(path, sizeof path, "%s/env_lobes%d_table%d_i16.c", folder, t->taps, LOBE_ENV_TABLE_SIDE);
    if (!lobe_kernel_digest("models/split_sum_table.h", "lobe_split_sum_table_texel", &digest) ||
        !lobe_atomic_open(&file, path))
        return false;
    put_head(file.stream, t, digest);
    fprintf(file.stream, "const int16_t lobe_env_lobes%d_table%d_i16[%d * %d * %d] = {\n", t->taps, LOBE_ENV_TABLE_SIDE,
            numbers, LOBE_ENV_TABLE_SIDE, LOBE_ENV_TABLE_SIDE);
    for (int node = 0; node < LOBE_ENV_TABLE_NODES; node++)
        for (int k = 0; k < numbers; k++)
            fprintf(file.stream, "%s%.0f,%s", k % 12 ? " " : "    ",
                    t->table[node * numbers + k] / lobe_env_table_unit(k % 3),
                    k % 12 == 11 || k == numbers - 1 ? "\n" : "");
    fputs("};\n", file.stream);
    return lobe_atomic_commit(&file);
}
