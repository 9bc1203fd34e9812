/* The kernels on a device: each must give the bits that the library gives on this host, over the hash's inputs
 * and the embedded vectors. Then the device's own results are judged and hashed, and reported in the lines of
 * conform_report.h.
 *
 *   device_main FOLDER     what device_kernels.sh wrote: kernels.txt, and a program for each kernel in it
 *
 * Tables are textures on a device: their tiers have no kernel to run.
 *
 * Exit status 0 all equal, 1 something differs, 2 bad usage, 3 no device. */
#include "../conform_core.h"
#include "../hash.h"
#include "device.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Results of the device, which lobe_judge takes for an entry's own, row by row. */
static const lobe_value *replay_from;
static int replay_outputs;

static void replay(const lobe_value *in, lobe_value *out)
{
    (void)in;
    memcpy(out, replay_from, sizeof *out * (size_t)replay_outputs);
    replay_from += replay_outputs;
}

static int same_entry(const lobe_entry *e, lobe_format format, const char *model, const char *tier)
{
    return format == e->format && lobe_same(model, e->model) && lobe_same(tier, e->tier);
}

/* The inputs of every embedded vector of the entry, into `in` where that is not NULL. Returns how many rows. */
static size_t vector_rows(const lobe_entry *e, lobe_value *in)
{
    size_t i, n = 0;
    for (i = 0; i < lobe_embedded_count; i++) {
        const lobe_vectors *v = &lobe_embedded[i];
        if (!same_entry(e, v->format, v->model, v->tier))
            continue;
        if (in)
            memcpy(in + n * (size_t)e->inputs, v->in, sizeof *in * v->rows * (size_t)e->inputs);
        n += v->rows;
    }
    return n;
}

static int judge(const lobe_entry *e, const lobe_value *out)
{
    lobe_entry device = *e;
    size_t i;
    int failed = 0;
    device.call = replay;
    replay_from = out;
    replay_outputs = e->outputs;
    for (i = 0; i < lobe_embedded_count; i++) {
        const lobe_vectors *v = &lobe_embedded[i];
        lobe_verdict verdict;
        uint32_t passed;
        if (!same_entry(e, v->format, v->model, v->tier))
            continue;
        verdict = lobe_judge(&device, v);
        passed = verdict.inside.passed + verdict.below.passed;
        printf("vectors %s %s f32 rows %lu passed %lu worst %.9f %s\n", e->model, e->tier, (unsigned long)v->rows,
               (unsigned long)passed, verdict.inside.worst, passed == v->rows ? "ok" : "BROKEN");
        failed |= passed != v->rows;
    }
    return failed;
}

static int check_hash(const lobe_entry *e, const lobe_value *out)
{
    uint64_t hash = LOBE_FNV_START;
    const char *verdict = "unknown";
    size_t i;
    for (i = 0; i < LOBE_HASH_COUNT * (size_t)e->outputs; i++)
        hash = lobe_fnv1a_word(hash, out[i].bits);
    for (i = 0; i < lobe_embedded_hash_count; i++) {
        const lobe_known_hash *known = &lobe_embedded_hashes[i];
        if (same_entry(e, known->format, known->model, known->tier))
            verdict = known->hash == hash ? "ok" : "differs";
    }
    printf("hash %s %s f32 %016llx %s\n", e->model, e->tier, (unsigned long long)hash, verdict);
    return strcmp(verdict, "ok") != 0;
}

static int compare_with_host(const lobe_entry *e, const lobe_value *in, const lobe_value *out, size_t rows)
{
    size_t i, different = 0;
    for (i = 0; i < rows; i++) {
        lobe_value want[LOBE_MAX_OUTPUTS];
        const lobe_value *x = in + i * (size_t)e->inputs, *got = out + i * (size_t)e->outputs;
        e->call(x, want);
        if (memcmp(want, got, sizeof *got * (size_t)e->outputs) == 0)
            continue;
        if (different++ == 0)
            printf("BROKEN %s %s at %08lx %08lx device %08lx host %08lx\n", e->model, e->tier, (unsigned long)x[0].bits,
                   (unsigned long)x[e->inputs > 1].bits, (unsigned long)got[0].bits, (unsigned long)want[0].bits);
    }
    if (different)
        printf("BROKEN %s %s differs from the host in %lu of %lu rows\n", e->model, e->tier, (unsigned long)different,
               (unsigned long)rows);
    return different != 0;
}

static int check(const lobe_entry *e, const char *path)
{
    const size_t rows = LOBE_HASH_COUNT + vector_rows(e, NULL);
    lobe_value *in = malloc(sizeof *in * rows * (size_t)e->inputs);
    lobe_value *out = malloc(sizeof *out * rows * (size_t)e->outputs);
    const char *bad = "out of memory";
    uint32_t i;
    int failed = 1;
    if (in && out) {
        for (i = 0; i < LOBE_HASH_COUNT; i++)
            lobe_hash_inputs(e, i, in + (size_t)i * (size_t)e->inputs);
        vector_rows(e, in + LOBE_HASH_COUNT * (size_t)e->inputs);
        bad = device_run(path, &in->f, (unsigned)e->inputs, &out->f, (unsigned)e->outputs, rows);
    }
    if (bad)
        printf("BROKEN %s %s: %s\n", e->model, e->tier, bad);
    else
        failed = compare_with_host(e, in, out, rows) | judge(e, out + LOBE_HASH_COUNT * (size_t)e->outputs) |
                 check_hash(e, out);
    free(in);
    free(out);
    return failed;
}

/* The f32 entry whose public function is `kernel` with _f32 behind it. */
static const lobe_entry *entry_of(const char *kernel)
{
    const size_t length = strlen(kernel);
    size_t i;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        if (e->format == LOBE_F32 && strncmp(e->kernel, kernel, length) == 0 && lobe_same(e->kernel + length, "_f32"))
            return e;
    }
    return NULL;
}

static int check_all(const char *folder, FILE *list)
{
    char line[256], kernel[256], path[1024];
    int failed = 0;
    while (fgets(line, sizeof line, list)) {
        const lobe_entry *e = NULL;
        int inputs = 0, outputs = 0;
        if (sscanf(line, "%255s %d %d", kernel, &inputs, &outputs) == 3)
            e = entry_of(kernel);
        snprintf(path, sizeof path, "%s/%s.%s", folder, kernel, device_suffix);
        /* A program of another shape would write past its rows. */
        if (!e || e->inputs != inputs || e->outputs != outputs)
            failed |=
                printf("BROKEN %s with %d inputs, %d outputs is not in the registry\n", kernel, inputs, outputs) != 0;
        else
            failed |= check(e, path);
    }
    printf("conform: %s\n", failed ? "BROKEN" : "ok");
    return failed;
}

int main(int argc, char **argv)
{
    const char *bad;
    char path[1024];
    FILE *list;
    int failed;
    if (argc != 2) {
        fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
        return 2;
    }
    snprintf(path, sizeof path, "%s/kernels.txt", argv[1]);
    list = fopen(path, "r");
    if (!list) {
        perror(path);
        return 2;
    }
    bad = device_open();
    if (bad) {
        fprintf(stderr, "%s: %s\n", argv[0], bad);
        fclose(list);
        return 3;
    }
    printf("device %s\n", device_name());
    failed = check_all(argv[1], list);
    fclose(list);
    device_close();
    return failed;
}
