/* libFuzzer on the row parser: any bytes are parsed or refused with a message, and what is parsed is in its domain. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/rows.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const lobe_column columns[3] = {{"a", 0.001, 1}, {"b", -4, 4}, {"c", 0, 1e9}};
    const int count = size ? data[0] % 3 + 1 : 1;
    lobe_rows rows;
    char error[256];
    size_t i;
    memset(error, 1, sizeof error);
    if (lobe_rows_parse((const char *)data, size, "fuzz", columns, count, &rows, error, sizeof error)) {
        if (!memchr(error, '\0', sizeof error) || rows.values || rows.count)
            abort();
    } else {
        for (i = 0; i < rows.count * (size_t)count; i++) {
            const lobe_column *c = &columns[i % (size_t)count];
            if (!(rows.values[i] >= c->lo && rows.values[i] <= c->hi))
                abort();
        }
    }
    lobe_rows_free(&rows);
    return 0;
}
