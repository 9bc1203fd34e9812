/* `lobefit bounds sphere_diffuse`: what ships, measured against the truth over more points than any fit has seen, into
 * models/coeffs/sphere_diffuse_bounds.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "../fit/bound_header.h"
#include "../fit/emit.h"
#include "../fit/fit_command.h"
#include "../fit/random.h"
#include "fit.h"
#include "shipped.h"
#include "truth_sphere_diffuse.h"

enum { SIDE = 1024, RANDOM = 1 << 22 };

typedef struct worst {
    double value, n_dot_l, sine;
} worst;

typedef struct measured {
    worst absolute, part; /* the second of sine^2, where that is at least 2^-20 */
    double rms;
} measured;

/* The nearest number that the format has. */
static double exact(const lobe_sphere_diffuse_shipped *s, double x)
{
    return strcmp(s->format, "f32") == 0 ? (double)(float)x : floor(x * 1073741824.0 + 0.5) / 1073741824.0;
}

static void keep(worst *w, double value, double c, double s)
{
    if (value > w->value) {
        w->value = value;
        w->n_dot_l = c;
        w->sine = s;
    }
}

static double compare(const lobe_sphere_diffuse_shipped *m, double n_dot_l, double sine, measured *out)
{
    const double c = exact(m, fmin(1, fmax(-1, n_dot_l))), s = exact(m, fmin(1, fmax(0, sine)));
    const double truth = lobe_truth_sphere_diffuse(c, s), y = m->call(c, s);
    /* what q30 gives in plain Q30 is what the vectors hold it to */
    const double plain = strcmp(m->format, "f32") == 0 ? y : floor(y * 1073741824.0 + 0.5) / 1073741824.0;
    keep(&out->absolute, fabs(plain - truth), c, s);
    if (s >= 0x1p-10)
        keep(&out->part, fabs(y - truth) / (s * s), c, s);
    return (plain - truth) * (plain - truth);
}

/* A walk uphill from what was found, by halved steps. */
static void climb(const lobe_sphere_diffuse_shipped *m, const worst *from, measured *out)
{
    double step = 1.0 / SIDE;
    int turn, i;
    for (turn = 0; turn < 12; turn++, step *= 0.5) {
        const double c = from->n_dot_l, s = from->sine;
        for (i = -1; i <= 1; i += 2) {
            compare(m, c + i * step * s, s, out);
            compare(m, c + i * step * c, s + i * step * s, out);
        }
    }
}

static measured measure(const lobe_sphere_diffuse_shipped *m)
{
    const double pi = 3.14159265358979323846;
    measured out = {{0, 0, 0}, {0, 0, 0}, 0};
    lobe_random random;
    double sum = 0;
    int i, k;
    for (i = 1; i <= SIDE; i++)
        for (k = 0; k <= SIDE; k++) {
            const double s = i == SIDE ? 1 : sin(pi / 2 * i / SIDE);
            compare(m, s * cos(pi * k / SIDE), s, &out);
            sum += compare(m, 2.0 * k / SIDE - 1, s, &out);
        }
    out.rms = sqrt(sum / (SIDE * (SIDE + 1.0)));
    /* Off the lattice: any light, small ones, and those of nearly half the sky. */
    lobe_random_seed(&random, 5, 0);
    for (i = 0; i < RANDOM; i++) {
        const double u = lobe_random_unit(&random), v = lobe_random_unit(&random), u2 = u * u, u4 = u2 * u2;
        const double s = i % 3 == 0 ? sin(pi / 2 * u) : i % 3 == 1 ? u4 : 1 - u4 * u2;
        compare(m, i % 2 ? s * sin(pi * (v - 0.5)) : 2 * v - 1, s, &out);
    }
    climb(m, &out.absolute, &out);
    climb(m, &out.part, &out);
    return out;
}

static bool put_tier(FILE *f, const lobe_sphere_diffuse_shipped *m)
{
    const measured w = measure(m);
    lobe_op_count count = {0, 0};
    if (strcmp(m->format, "f32") == 0) {
        if (lobe_emit_count_sphere_diffuse(m->tier, &count) != 0)
            return false;
        lobe_put_bound(f, "sphere_diffuse", m->tier, NULL, "OPS", count.fused);
    }
    fprintf(f, "/* %s, %s: max %.6e at %.9g %.9g, rms %.6e;\n", m->tier, m->format, w.absolute.value,
            w.absolute.n_dot_l, w.absolute.sine, w.rms);
    fprintf(f, " *   of sine^2: %.6e at %.9g %.9g */\n", w.part.value, w.part.n_dot_l, w.part.sine);
    lobe_put_bound(f, "sphere_diffuse", m->tier, m->format, "MAX", lobe_rounded_up(w.absolute.value));
    lobe_put_bound(f, "sphere_diffuse", m->tier, m->format, "RMS", lobe_rounded_up(w.rms));
    lobe_put_bound(f, "sphere_diffuse", m->tier, m->format, "OF_SINE2", lobe_rounded_up(w.part.value));
    return true;
}

static bool write_all(const lobe_case *self, const lobe_fit_request *request)
{
    lobe_atomic_file file;
    char path[4200];
    bool good = true;
    int i;
    (void)self;
    snprintf(path, sizeof path, "%s/sphere_diffuse_bounds.h", request->coeffs);
    if (!lobe_atomic_open(&file, path))
        return false;
    fputs(
        "/* Generated, not edited: build/lobefit bounds sphere_diffuse\n"
        " * What ships, measured against the closed form in double, which is within 2e-15 sine^2 of the truth, on\n"
        " * n_dot_l in [-1, 1] and sine in [0, 1]: 1024 half angles by 1025 heights, twice, 2^22 random points, and a\n"
        " * walk uphill from each maximum. MAX is absolute, of q30 rounded to plain Q30; RMS over the half angles and\n"
        " * uniform heights; OF_SINE2 the largest part of sine^2, the overhead light, for sine from 2^-10, of q30 "
        "with\n"
        " * its block exponent. Witnesses are n_dot_l and sine. Macros are rounded up. */\n",
        file.stream);
    for (i = 0; good && lobe_sphere_diffuse_shipped_at(i); i++)
        good = put_tier(file.stream, lobe_sphere_diffuse_shipped_at(i));
    if (good)
        return lobe_atomic_commit(&file);
    lobe_atomic_abandon(&file);
    return false;
}

int lobe_sphere_diffuse_bounds(const lobe_case *self, int argc, char **argv)
{
    static const lobe_fit_tier all[] = {{"all", write_all}};
    return lobe_fit_command(self, all, 1, argc, argv);
}
