#include "truth_env_lobes.h"
#include <math.h>
#include "response.h"

void lobe_truth_env_lobes_rows(const double *in, double *out, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        const double *row = in + 4 * i, sine = sqrt((1 - row[2]) * (1 + row[2]));
        const double l[3] = {sine * cos(row[3]), sine * sin(row[3]), row[2]};
        out[2 * i] = lobe_response(row[0] * row[0], row[1], l);
        out[2 * i + 1] = lobe_response_schlick(row[0] * row[0], row[1], l);
    }
}
