#include "table_write.h"
#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include "../fit/atomic_file.h"
#include "../fit/coefficients.h"

enum { A_LINE = 5 }; /* texels */

void lobe_table_round_f32(double *texels, int n)
{
    int i;
    for (i = 0; i < 2 * n; i++)
        texels[i] = floor(texels[i] * 1e6 + 0.5) / 1e6;
}

void lobe_table_round_u16(double *texels, int n)
{
    int i;
    for (i = 0; i < n; i++) {
        double scale = floor(texels[2 * i] * 65535 + 0.5), bias = floor(texels[2 * i + 1] * 65535 + 0.5);
        while (scale + bias > 65534)
            *(scale > bias ? &scale : &bias) -= 1;
        texels[2 * i] = scale / 65535;
        texels[2 * i + 1] = bias / 65535;
    }
}

static void put_head(FILE *f, const lobe_table_text *t, const char *format, uint64_t digest)
{
    fprintf(f, "/* Generated, not edited: build/lobefit fit %s --tier table%d\n", t->model, t->side);
    fprintf(f, " * BRDF     %s\n", t->brdf);
    fprintf(
        f,
        " * domain   roughness, n_dot_v in [.02, 1]; texels below it follow the truth at a fiftieth of the weight\n");
    fprintf(f, " * layout   lobe_split_sum_table_texel in models/split_sum_table.h, digest %016" PRIx64 "\n", digest);
    fprintf(f, " * grid     %d points a cell along each axis\n", t->per);
    fprintf(f, " * error    scale max %.4g rms %.4g, bias max %.4g rms %.4g, on that grid;\n", t->max[0], t->rms[0],
            t->max[1], t->rms[1]);
    fprintf(f, " *          what ships is measured on a finer one: models/coeffs/%s_bounds.h\n", t->model);
    fprintf(f, " * values   scale and bias in turn, n_dot_v running fastest; %s\n", format);
    fprintf(f, " * seed     0, nothing in this fit is random */\n#include \"../lobe.h\"\n\n");
}

bool lobe_table_write(const lobe_table_text *t, lobe_table_format format, const char *folder)
{
    const char *suffix = format == LOBE_TABLE_F32 ? "f32" : "u16";
    const int n = t->side * t->side;
    lobe_atomic_file file;
    char path[4200];
    uint64_t digest;
    int i;
    snprintf(path, sizeof path, "%s/%s_table%d_%s.c", folder, t->model, t->side, suffix);
    if (!lobe_kernel_digest("models/split_sum_table.h", "lobe_split_sum_table_texel", &digest) ||
        !lobe_atomic_open(&file, path))
        return false;
    put_head(file.stream, t, format == LOBE_TABLE_F32 ? "exact to the six decimals" : "in 65535ths", digest);
    fprintf(file.stream, "const %s lobe_%s_table%d_texels_%s[2 * %d * %d] = {\n",
            format == LOBE_TABLE_F32 ? "float" : "uint16_t", t->model, t->side, suffix, t->side, t->side);
    for (i = 0; i < n; i++) {
        const char *before = i % A_LINE ? " " : "    ", *after = i % A_LINE == A_LINE - 1 || i == n - 1 ? "\n" : "";
        if (format == LOBE_TABLE_F32)
            fprintf(file.stream, "%s%.6ff, %.6ff,%s", before, t->texels[2 * i], t->texels[2 * i + 1], after);
        else
            fprintf(file.stream, "%s%.0f, %.0f,%s", before, t->texels[2 * i] * 65535, t->texels[2 * i + 1] * 65535,
                    after);
    }
    fputs("};\n", file.stream);
    return lobe_atomic_commit(&file);
}
