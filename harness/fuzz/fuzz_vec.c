/* libFuzzer: any bytes as a vector file. Each input is parsed as it is, and once more with its digest put right,
 * since no mutation finds a digest by luck. What is accepted is judged too. */
#include "../hash.h"
#include "../vec_file.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void parse(const char *text, size_t size)
{
    lobe_vec_file file;
    lobe_vec_error error;
    const lobe_entry *e;
    memset(&error, 0, sizeof error);
    if (!lobe_vec_parse(text, size, &file, &error)) {
        if (error.line == 0 || !error.reason[0])
            abort(); /* a refusal names its line and its reason */
        return;
    }
    e = lobe_find_entry(file.vectors.model, file.vectors.tier, file.vectors.format);
    if (e && lobe_vec_fits(&file, e, &error)) {
        const lobe_verdict v = lobe_judge(e, &file.vectors);
        if (v.inside.rows + v.below.rows != file.vectors.rows || v.inside.passed > v.inside.rows)
            abort();
    }
    lobe_vec_free(&file);
}

/* Overwrites the digest in the head with that of the rows. */
static void repair(char *text, size_t size)
{
    static const char key[] = "# digest: ";
    const size_t length = sizeof key - 1;
    char *value = NULL, hex[17];
    size_t at = 0;
    while (at < size && text[at] == '#') {
        const char *end = memchr(text + at, '\n', size - at);
        if (size - at > length + 16 && memcmp(text + at, key, length) == 0)
            value = text + at + length;
        if (!end)
            return;
        at = (size_t)(end - text) + 1;
    }
    snprintf(hex, sizeof hex, "%016llx", (unsigned long long)lobe_fnv1a(LOBE_FNV_START, text + at, size - at));
    if (value)
        memcpy(value, hex, 16);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = malloc(size ? size : 1);
    if (!text)
        return 0;
    memcpy(text, data, size);
    parse(text, size);
    repair(text, size);
    parse(text, size);
    free(text);
    return 0;
}
