/* What every tier of diffuse_sh and every published stand-in loses, as CSV.
 *
 *   diffuse grid      prints the points: 33 x 33 of roughness and NdotV in [0, 1], edges included
 *   diffuse           reads rows of roughness, NdotV and the nine true coefficients on stdin
 * Columns: model, name, format, kind (tier, star), title, operations, then relative errors. Light is the radiance over
 * random order-3 lighting, whose mean square error is |c - c_true|^2: rms over the points, and the worst point's.
 * Furnace is coefficient 0: rms and maximum. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../peers/diffuse.h"
#include "../registry.h"

enum { SIDE = 33, POINTS = SIDE * SIDE };

static double at[POINTS][2], truth[POINTS][9];

typedef void model_function(const void *of, double roughness, double n_dot_v, double c[9]);

static void entry_at(const void *of, double roughness, double n_dot_v, double c[9])
{
    const lobe_entry *e = of;
    lobe_value in[LOBE_MAX_INPUTS], out[LOBE_MAX_OUTPUTS];
    int k;
    in[0] = lobe_value_nearest(e->format, roughness);
    in[1] = lobe_value_nearest(e->format, n_dot_v);
    e->call(in, out);
    for (k = 0; k < 9; k++)
        c[k] = lobe_value_real(e->format, out[k]);
}

static void seed_at(const void *of, double roughness, double n_dot_v, double c[9])
{
    const lobe_sh9 a = peer_zonal_2015((float)roughness, (float)n_dot_v);
    const float all[9] = {a.c0, a.c1, a.c2, a.c3, a.c4, a.c5, a.c6, a.c7, a.c8};
    int k;
    (void)of;
    for (k = 0; k < 9; k++)
        c[k] = (double)all[k];
}

static void print_errors(model_function *model, const void *of)
{
    double wrong = 0.0, total = 0.0, light_max = 0.0, furnace = 0.0, furnace_max = 0.0;
    int i, k;
    for (i = 0; i < POINTS; i++) {
        double c[9], miss = 0.0, all = 0.0, f;
        model(of, at[i][0], at[i][1], c);
        for (k = 0; k < 9; k++) {
            miss += (c[k] - truth[i][k]) * (c[k] - truth[i][k]);
            all += truth[i][k] * truth[i][k];
        }
        wrong += miss;
        total += all;
        light_max = fmax(light_max, sqrt(miss / all));
        f = c[0] / truth[i][0] - 1.0;
        furnace += f * f;
        furnace_max = fmax(furnace_max, fabs(f));
    }
    printf(",%.3e,%.3e,%.3e,%.3e\n", sqrt(wrong / total), light_max, sqrt(furnace / POINTS), furnace_max);
}

static int read_rows(void)
{
    char text[1024];
    int i = 0, k;
    while (fgets(text, sizeof text, stdin)) {
        const char *rest = text;
        int used = 0;
        if (i == POINTS)
            break;
        for (k = 0; k < 11; k++, rest += used)
            if (sscanf(rest, "%lf%n", k < 2 ? &at[i][k] : &truth[i][k - 2], &used) != 1) {
                fprintf(stderr, "diffuse: <stdin>:%d: expected 11 numbers\n", i + 1);
                return 2;
            }
        i++;
    }
    if (i == POINTS && feof(stdin))
        return 0;
    fprintf(stderr, "diffuse: <stdin>: expected %d rows, those of `diffuse grid`\n", (int)POINTS);
    return 2;
}

int main(int argc, char **argv)
{
    size_t i;
    int k;
    if (argc == 2 && !strcmp(argv[1], "grid")) {
        for (k = 0; k < POINTS; k++)
            printf("%.17g %.17g\n", (k / SIDE) / (SIDE - 1.0), (k % SIDE) / (SIDE - 1.0));
        return 0;
    }
    if (argc != 1) {
        fprintf(stderr, "usage: diffuse grid | diffuse <rows\n");
        return 2;
    }
    if (read_rows())
        return 2;
    for (i = 0; i < lobe_entry_count; i++) {
        const lobe_entry *e = &lobe_entries[i];
        if (!lobe_same(e->model, "diffuse_sh"))
            continue;
        printf("diffuse_sh,%s,%s,%s,%s,%d", e->tier, lobe_format_names[e->format], e->ops ? "tier" : "star",
               e->ops ? e->tier : "Lambert", e->ops);
        print_errors(entry_at, e);
    }
    printf("peer,zonal_2015,f32,star,Iwanicki-Pesce 2015,48");
    print_errors(seed_at, NULL);
    return 0;
}
