/* libFuzzer: any bytes as a row for eval. The first byte chooses the entry, the rest is the row; whatever numbers
 * it holds, the answer is finite and in [0, 1]. */
#include "../registry.h"
#include "../rows.h"
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const lobe_entry *e;
    double numbers[LOBE_MAX_INPUTS];
    lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
    char reason[LOBE_REASON_SIZE] = "", quoted[8];
    char *line;
    int count, k;
    if (size == 0)
        return 0;
    e = &lobe_entries[data[0] % lobe_entry_count];
    line = malloc(size); /* exactly the row, so that a step beyond it is seen */
    if (!line)
        return 0;
    memcpy(line, data + 1, size - 1);
    lobe_quote(line, size - 1, quoted, sizeof quoted);
    if (strlen(quoted) >= sizeof quoted)
        abort();
    count = lobe_read_row(line, size - 1, numbers, e->inputs, reason);
    if (count > e->inputs || (count < 0 && !reason[0]))
        abort();
    if (count == e->inputs) {
        for (k = 0; k < count; k++)
            in[k] = lobe_value_nearest(e->format, numbers[k]);
        e->call(in, out);
        for (k = 0; k < e->outputs; k++) {
            /* one number or a sum is a reflectance; coefficients have signs; taps have angles and sharpnesses, to 6e5
             */
            const double y = lobe_value_real(e->format, out[k]), most = e->nth ? 1e7 : 1.0;
            if (!(y >= (e->outputs == 1 || e->sums ? 0.0 : -most) && y <= most))
                abort();
        }
    }
    free(line);
    return 0;
}
