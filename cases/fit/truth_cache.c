#include "truth_cache.h"
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "digest.h"

#define PROBES 256

/* Rows spread over all of them, computed anew, agree with the kept ones. */
static bool still_true(const lobe_case *c, const double *in, const double *out, size_t n)
{
    const size_t outputs = (size_t)c->output_count, inputs = (size_t)c->input_count;
    double now[LOBE_CASE_COLUMNS];
    size_t i;
    for (i = 0; i < PROBES; i++) {
        const size_t row = (i * n / PROBES + i * i) % n;
        c->truth(in + row * inputs, now, 1);
        if (memcmp(now, out + row * outputs, outputs * sizeof *now) != 0)
            return false;
    }
    return true;
}

void lobe_truth_cached(const lobe_case *c, const double *in, double *out, size_t n, const lobe_sweep_options *options)
{
    const size_t inputs = n * (size_t)c->input_count, outputs = n * (size_t)c->output_count;
    const uint64_t digest = lobe_digest(LOBE_DIGEST_START, in, inputs * sizeof *in);
    char path[256], temporary[300];
    bool good = false;
    FILE *f;
    snprintf(path, sizeof path, "build/truth/%s.%016" PRIx64, c->name, digest);
    f = fopen(path, "rb");
    if (f) {
        good = fread(out, sizeof *out, outputs, f) == outputs && fgetc(f) == EOF && still_true(c, in, out, n);
        fclose(f);
    }
    if (good)
        return;
    lobe_sweep(c->truth, in, c->input_count, out, c->output_count, n, options);
    mkdir("build", 0777);
    mkdir("build/truth", 0777);
    snprintf(temporary, sizeof temporary, "%s.new", path);
    f = fopen(temporary, "wb");
    if (f) {
        good = fwrite(out, sizeof *out, outputs, f) == outputs;
        good = fclose(f) == 0 && good;
        if (!good || rename(temporary, path) != 0)
            remove(temporary);
    }
}
