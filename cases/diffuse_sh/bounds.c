/* `lobefit bounds diffuse_sh`: what ships, measured against the closed form in double over more points than any fit has
 * seen, into models/coeffs/diffuse_sh_bounds.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/bound_header.h"
#include "../fit/emit.h"
#include "../fit/random.h"
#include "closed_form.h"
#include "fit.h"
#include "shipped.h"

enum { SIDE = 1024, RANDOM = 1 << 23 };

typedef struct measured {
    double max, at[2], rms;
    int coefficient;
} measured;

/* The nearest number that the format has. */
static double exact(const lobe_diffuse_shipped *s, double x)
{
    return strcmp(s->format, "f32") == 0 ? (double)(float)x : floor(x * 1073741824.0 + 0.5) / 1073741824.0;
}

/* The sum of squares at a point. */
static double compare(const lobe_diffuse_shipped *s, double r, double v, measured *m)
{
    double c[9], e[9], sum = 0;
    int k;
    lobe_diffuse_closed_form(r, v, e);
    s->call(r, v, c);
    for (k = 0; k < 9; k++) {
        const double d = fabs(c[k] - e[k]);
        sum += d * d;
        if (d > m->max) {
            m->max = d;
            m->at[0] = r;
            m->at[1] = v;
            m->coefficient = k;
        }
    }
    return sum;
}

static measured measure(const lobe_diffuse_shipped *s)
{
    measured m = {0, {0, 0}, 0, 0};
    lobe_random random;
    double sum = 0, step = 1.0 / SIDE;
    int i, turn;
    for (i = 0; i <= SIDE * SIDE + 2 * SIDE; i++)
        sum += compare(s, (i / (SIDE + 1)) / (double)SIDE, (i % (SIDE + 1)) / (double)SIDE, &m);
    m.rms = sqrt(sum / ((SIDE + 1.0) * (SIDE + 1.0) * 9));
    /* Off the lattice, half of them next to NdotV = 0 or 1. */
    lobe_random_seed(&random, 5, 0);
    for (i = 0; i < RANDOM; i++) {
        const double r = lobe_random_unit(&random), u = lobe_random_unit(&random);
        const double v = i % 4 == 1 ? u * u * u * u : i % 4 == 2 ? 1 - u * u * u * u : u;
        compare(s, exact(s, r), exact(s, v), &m);
    }
    /* The lattice may have missed the top by half a step. */
    for (turn = 0; turn < 12; turn++, step *= 0.5) {
        const double at[2] = {m.at[0], m.at[1]};
        for (i = 0; i < 4; i++) {
            const double r = exact(s, at[0] + (i < 2 ? (i ? step : -step) : 0)),
                         v = exact(s, at[1] + (i < 2   ? 0
                                               : i > 2 ? step
                                                       : -step));
            if (r >= 0 && r <= 1 && v >= 0 && v <= 1)
                compare(s, r, v, &m);
        }
    }
    return m;
}

static bool put_tier(FILE *f, const lobe_diffuse_shipped *s)
{
    const measured m = measure(s);
    const lobe_diffuse_score score = lobe_diffuse_judge(s->call);
    lobe_op_count count = {0, 0};
    if (strcmp(s->format, "f32") == 0) {
        if (!s->constant && lobe_emit_count("diffuse_sh", s->tier, &count) != 0)
            return false;
        lobe_put_bound(f, "diffuse_sh", s->tier, NULL, "OPS", count.fused);
        lobe_put_bound(f, "diffuse_sh", s->tier, NULL, "DOMAIN_LO", 0);
    }
    fprintf(f, "/* %s, %s: max %.6e in c%d at %.9g %.9g, rms %.6e;\n", s->tier, s->format, m.max, m.coefficient,
            m.at[0], m.at[1], m.rms);
    fprintf(f, " *   light rms %.4e, at the worst point %.4e; furnace rms %.4e, max %.4e */\n", score.light,
            score.light_max, score.furnace_rms, score.furnace_max);
    lobe_put_bound(f, "diffuse_sh", s->tier, s->format, "MAX", lobe_rounded_up(m.max));
    lobe_put_bound(f, "diffuse_sh", s->tier, s->format, "RMS", lobe_rounded_up(m.rms));
    lobe_put_bound(f, "diffuse_sh", s->tier, s->format, "LIGHT", lobe_rounded_up(score.light));
    lobe_put_bound(f, "diffuse_sh", s->tier, s->format, "FURNACE_RMS", lobe_rounded_up(score.furnace_rms));
    lobe_put_bound(f, "diffuse_sh", s->tier, s->format, "FURNACE_MAX", lobe_rounded_up(score.furnace_max));
    return true;
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    lobe_atomic_file file;
    char path[4200];
    bool good = true;
    int i;
    snprintf(path, sizeof path, "%s/diffuse_sh_bounds.h", request->coeffs);
    if (!lobe_atomic_open(&file, path))
        return false;
    fprintf(
        file.stream,
        "/* Generated, not edited: build/lobefit bounds diffuse_sh\n"
        " * What ships, measured against the closed form in double (%s),\n"
        " * which is within 2e-14 of the truth. MAX over the nine coefficients, on [0, 1]: a grid of 1025 x 1025, "
        "2^23\n"
        " * random points, and a walk uphill from the maximum; RMS over the nine and the grid. LIGHT and FURNACE: see\n"
        " * cases/diffuse_sh/metric.h. Witnesses are roughness and n_dot_v. Macros are rounded up. */\n",
        self->brdf);
    for (i = 0; good && lobe_diffuse_shipped_at(i); i++)
        good = put_tier(file.stream, lobe_diffuse_shipped_at(i));
    if (good)
        return lobe_atomic_commit(&file);
    lobe_atomic_abandon(&file);
    return false;
}

int lobe_diffuse_bounds(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
