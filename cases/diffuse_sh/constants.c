/* The constants of the exact tier: each is a rational number times the constant of its basis polynomial (README.md).
 * With P_k = 1 / (k + 1) and E_k = int l^k (1 - l)^5 dl = k! 5! / (k + 6)!, in fractions of 64-bit integers. */
#include "fit.h"
#include <inttypes.h>
#include <math.h>
#include "../fit/atomic_file.h"

typedef struct fraction {
    int64_t n, d; /* in lowest terms, d > 0 */
} fraction;

static int64_t divisor(int64_t a, int64_t b)
{
    while (b) {
        const int64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a < 0 ? -a : a;
}

static fraction reduced(int64_t n, int64_t d)
{
    const int64_t g = divisor(n, d);
    const fraction f = {n / g, d / g};
    return f;
}

/* (a m + b n) / d */
static fraction mix(fraction a, int64_t m, fraction b, int64_t n, int64_t d)
{
    return reduced(a.n * m * b.d + b.n * n * a.d, a.d * b.d * d);
}

static fraction power_mean(int k) { return reduced(1, k + 1); }

static fraction edge_mean(int k)
{
    fraction e = {1, 6};
    int i;
    for (i = 1; i <= k; i++)
        e = reduced(e.n * i, e.d * (i + 6));
    return e;
}

/* a0 .. a2 and b0 .. b5 of the moment k. */
static void zonal(int k, fraction a[3], fraction b[6])
{
    const fraction p = power_mean(k), p1 = power_mean(k + 1), e = edge_mean(k), e1 = edge_mean(k + 1),
                   e2 = edge_mean(k + 2);
    a[0] = mix(p, 2, e, -1, 2);
    a[1] = e;
    a[2] = e1;
    b[0] = mix(p, -2, e, 1, 4);
    b[1] = mix(p, 1, e, -1, 1);
    b[2] = mix(e, 3, e2, -1, 2);
    b[3] = mix(p1, 1, e1, -1, 1);
    b[4] = mix(e1, 2, e1, 0, 1);
    b[5] = mix(e2, 3, e, -1, 2);
}

static void tangent(int k, fraction t[4])
{
    const fraction lost = mix(power_mean(k), 1, power_mean(k + 2), -1, 1);
    t[0] = mix(edge_mean(k), 1, edge_mean(k + 2), -1, 1);
    t[1] = mix(lost, 1, t[0], -1, 1);
    t[2] = mix(t[0], 2, t[0], 0, 1);
    t[3] = mix(edge_mean(k + 1), 2, edge_mean(k + 3), -2, 1);
}

static void put(FILE *f, char letter, const fraction *of, int count, long double basis, const char *name)
{
    int i;
    for (i = 0; i < count; i++) {
        fprintf(f, "#define LOBE_DIFFUSE_SH_%c", letter);
        if (count > 1)
            fprintf(f, "%d", i);
        fprintf(f, " LOBE_R(%#.17Lg) /* %" PRId64 "/%" PRId64 " %s */\n",
                (long double)of[i].n / (long double)of[i].d * basis, of[i].n, of[i].d, name);
    }
}

static void put_all(FILE *f)
{
    const long double pi = 3.14159265358979323846264338327950288L;
    fraction a[4][3], b[4][6], t[3][4], band2[3], band2_w[6], q;
    int k, i;
    for (k = 1; k <= 3; k++)
        zonal(k, a[k], b[k]);
    for (k = 1; k <= 2; k++)
        tangent(k, t[k]);
    for (i = 0; i < 3; i++)
        band2[i] = mix(a[3][i], 3, a[1][i], -1, 1);
    for (i = 0; i < 6; i++)
        band2_w[i] = mix(b[3][i], 3, b[1][i], -1, 1);
    q = mix(mix(edge_mean(1), 1, edge_mean(3), -2, 1), 1, edge_mean(5), 1, 2);
    put(f, 'A', a[1], 3, 1 / sqrtl(pi), "/ sqrt(pi)");
    put(f, 'B', b[1], 6, 1 / sqrtl(pi), "/ sqrt(pi)");
    put(f, 'D', a[2], 3, sqrtl(3 / pi), "sqrt(3 / pi)");
    put(f, 'E', b[2], 6, sqrtl(3 / pi), "sqrt(3 / pi)");
    put(f, 'F', band2, 3, sqrtl(5 / pi) / 2, "sqrt(5 / pi) / 2");
    put(f, 'G', band2_w, 6, sqrtl(5 / pi) / 2, "sqrt(5 / pi) / 2");
    put(f, 'T', t[1], 4, sqrtl(3 / pi) / 2, "sqrt(3 / pi) / 2");
    put(f, 'U', t[2], 4, sqrtl(15 / pi) / 2, "sqrt(15 / pi) / 2");
    put(f, 'Q', &q, 1, sqrtl(15 / pi) / 4, "sqrt(15 / pi) / 4");
}

bool lobe_diffuse_constants(const lobe_case *self, const lobe_fit_request *request)
{
    lobe_atomic_file file;
    char path[4200];
    (void)self;
    snprintf(path, sizeof path, "%s/diffuse_sh_exact.h", request->coeffs);
    if (!lobe_atomic_open(&file, path))
        return false;
    fputs("/* Generated, not edited: build/lobefit fit diffuse_sh --tier exact\n"
          " * The constants of lobe_diffuse_shape_exact, without a fit: each is the rational number at its right times "
          "the\n"
          " * constant of its basis polynomial (cases/diffuse_sh/README.md). */\n"
          "#ifndef LOBE_COEFFS_DIFFUSE_SH_EXACT_H\n#define LOBE_COEFFS_DIFFUSE_SH_EXACT_H\n\n",
          file.stream);
    put_all(file.stream);
    fputs("\n#endif\n", file.stream);
    return lobe_atomic_commit(&file);
}
