#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "fit_diffuse.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../../models/sg_diffuse.h"
#include "../fit/coefficients.h"
#include "../fit/fit_command.h"
#include "../fit/least_squares.h"
#include "truth_sg.h"

enum { SHARPNESSES = 27, HEIGHTS = 41, COUNT = 4 };

typedef struct grid {
    double versine[SHARPNESSES], truth[SHARPNESSES][HEIGHTS];
} grid;

static double height(int k) { return -1 + 2.0 * k / (HEIGHTS - 1); }

static void residuals(void *ctx, const double *params, size_t count, double *values)
{
    const grid *g = ctx;
    size_t n;
    int i, k;
    for (n = 0; n < count; n++)
        for (i = 0; i < SHARPNESSES; i++)
            for (k = 0; k < HEIGHTS; k++) {
                const double y = lobe_sg_diffuse_high(params + COUNT * n, height(k), g->versine[i]);
                *values++ = (y - g->truth[i][k]) / g->truth[i][HEIGHTS - 1];
            }
}

static bool fit_high(const lobe_case *self, const lobe_fit_request *request)
{
    static grid g;
    static double off[SHARPNESSES * HEIGHTS];
    double c[COUNT] = {.3, 1.6, .82, 1};
    lobe_residuals problem = {.f = residuals, .ctx = &g, .dim = COUNT, .rows = SHARPNESSES * HEIGHTS};
    const lobe_ls_options options = lobe_ls_default();
    lobe_coefficients out;
    lobe_fit_result result;
    char error[200];
    double most = 0, squares = 0;
    int i, k, worst = 0;
    (void)self;
    memset(&out, 0, sizeof out);
    for (i = 0; i < SHARPNESSES; i++) {
        const double sharpness = .5 * pow(8192, i / (SHARPNESSES - 1.0));
        g.versine[i] = 1 / sharpness;
        for (k = 0; k < HEIGHTS; k++)
            g.truth[i][k] = lobe_truth_sg_irradiance(height(k), sharpness, 1e-8);
    }
    result = lobe_least_squares(&problem, &options, c);
    if (result.status != LOBE_FIT_CONVERGED && result.status != LOBE_FIT_STALLED) {
        fprintf(stderr, "lobefit: fit sg_diffuse high: %s: %s; the old coefficients stand\n",
                lobe_fit_status_name(result.status), result.reason);
        return false;
    }
    for (i = 0; i < COUNT; i++)
        c[i] = lobe_coefficient_rounded(c[i]);
    residuals(&g, c, 1, off);
    for (i = 0; i < SHARPNESSES * HEIGHTS; i++) {
        squares += off[i] * off[i];
        if (fabs(off[i]) > most) {
            most = fabs(off[i]);
            worst = i;
        }
    }
    snprintf(error, sizeof error,
             "max %.3e of what the light gives overhead, at sharpness %.4g, height %.2f; rms %.2e,\n"
             " *          in double on that grid",
             most, 1 / g.versine[worst / HEIGHTS], height(worst % HEIGHTS), sqrt(squares / (SHARPNESSES * HEIGHTS)));
    out.model = "sg_diffuse";
    out.tier = "high";
    out.brdf = "Lambert, base colour 1";
    out.domain = "sharpness .5 to 4096, n_dot_l -1 to 1";
    out.grid = "27 sharpnesses, 41 heights";
    out.metric = "error over what the light gives overhead, least squares";
    out.error = error;
    out.kernel = "lobe_sg_diffuse_high";
    out.source = "models/sg_diffuse.h";
    out.values = c;
    out.count = COUNT;
    return lobe_coefficients_write(&out, request->coeffs);
}

int lobe_sg_diffuse_fit(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"high", fit_high}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
