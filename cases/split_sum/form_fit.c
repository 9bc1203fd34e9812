/* The tiers with a closed form. What is fitted is the kernel that ships. */
#define LOBE_DOUBLE 1
#define LOBE_FIT 1
#include "form_fit.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../../models/split_sum.h"
#include "../../models/split_sum_sep.h"
#include "../fit/coefficients.h"
#include "form.h"

static void judge(const lobe_form *f, const lobe_fit_grid *g, const double *c, lobe_coefficients *out)
{
    double sum = 0, errors[LOBE_FORM_CHANNELS];
    size_t r;
    int k;
    for (r = 0; r < g->count; r++) {
        lobe_form_errors(f, c, g, r, errors);
        for (k = 0; k < LOBE_FORM_CHANNELS; k++) {
            sum += errors[k] * errors[k];
            if (fabs(errors[k]) > out->max) {
                out->max = fabs(errors[k]);
                out->at[0] = g->at[2 * r];
                out->at[1] = g->at[2 * r + 1];
            }
        }
    }
    out->rms = sqrt(sum / (double)(LOBE_FORM_CHANNELS * g->count));
}

static bool fit_form(const lobe_case *self, const lobe_fit_request *request, const lobe_form *f)
{
    char grid[80], domain[80];
    double c[LOBE_FORM_COEFFICIENTS];
    lobe_coefficients out = {0};
    lobe_fit_grid coarse = {0}, fine = {0};
    bool good = lobe_fit_grid_make(&coarse, f->coarse, f->lo, self, &request->sweep) &&
                lobe_fit_grid_make(&fine, f->fine, f->lo, self, &request->sweep);
    out.seed = f->starts > 0;
    good = good && lobe_form_solve(f, &coarse, &fine, out.seed, request->sweep.progress, c);
    if (good) {
        snprintf(grid, sizeof grid, "%d x %d, denser toward the edges, low roughness and grazing views", f->fine,
                 f->fine);
        snprintf(domain, sizeof domain, "roughness, n_dot_v in [%g, 1]", f->lo);
        out.model = self->name;
        out.tier = f->name;
        out.brdf = self->brdf;
        out.domain = domain;
        out.grid = grid;
        out.metric = "absolute error of scale, bias and E";
        out.kernel = f->kernel;
        out.source = strcmp(self->name, "split_sum") ? "models/split_sum_sep.h" : "models/split_sum.h";
        out.values = c;
        out.count = f->count;
        judge(f, &fine, c, &out);
        good = lobe_coefficients_write(&out, request->coeffs);
    }
    lobe_fit_grid_free(&coarse);
    lobe_fit_grid_free(&fine);
    return good;
}

/* clang-format off */
#define TIER(model, tier, ...)                                                              \
    bool lobe_fit_##model##_##tier(const lobe_case *self, const lobe_fit_request *request)  \
    {                                                                                       \
        static const lobe_form f = {.name = #tier, .kernel = "lobe_" #model "_" #tier,      \
                                    .call = lobe_##model##_##tier, .lo = 0.02, __VA_ARGS__}; \
        return fit_form(self, request, &f);                                                 \
    }
#define PROGRAM(model, tier, n, tries) TIER(model, tier, .count = n, .coarse = 14, .fine = 60, .starts = tries)
#define W_FORM(model, tier, soft, n, k, u)                                                  \
    TIER(model, tier, .count = n, .ridge = soft, .coarse = 26, .fine = 52, .bends = k, .constant_of_u = u, \
         .first_of_e = 0.5)
/* clang-format on */
PROGRAM(split_sum, low, 13, 400)
W_FORM(split_sum, medium, 1e-6, 27, 2, 17)
W_FORM(split_sum, high, 1e-7, 56, 2, 28)
PROGRAM(split_sum_sep, low, 17, 4000)
W_FORM(split_sum_sep, medium, 1e-6, 25, 1, 13)
W_FORM(split_sum_sep, high, 1e-7, 63, 2, 34)
