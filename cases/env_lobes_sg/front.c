#include "front.h"
#include <math.h>
#include <string.h>
#include "../fit/atomic_file.h"
#include "fit.h"
#include "layers.h"
#include "lights.h"
#include "scenes.h"
#include "shipped.h"

/* The seed paper's: one sharpness, weights that are positive and even about the middle. */
#define SEED_HELD (1u << LOBE_SG_TILT | 1u << LOBE_SG_LEAN | 1u << LOBE_SG_RIM | 1u << LOBE_SG_FLARE)

static int shipped(const void *ctx, double alpha, double n_dot_v, double energy, lobe_sg *lobes)
{
    return lobe_sg_shipped(*(const int *)ctx, sqrt(alpha), n_dot_v, energy, lobes);
}

static int seed(const void *ctx, double alpha, double n_dot_v, double energy, lobe_sg *lobes)
{
    lobe_sg_lobes_at(alpha, n_dot_v, ctx, LOBE_SG_MOST, energy, lobes);
    return LOBE_SG_MOST;
}

static int printed(const void *ctx, double alpha, double n_dot_v, double energy, lobe_sg *lobes)
{
    lobe_sg_lobes_at(alpha, n_dot_v, ctx, LOBE_SG_MOST, energy, lobes);
    lobe_sg_weigh_printed(lobes, LOBE_SG_MOST, energy);
    return LOBE_SG_MOST;
}

static bool put(FILE *out, const char *name, int lobes, const lobe_sg_scenes *s, const lobe_env_spectrum *spectra,
                lobe_sg_model model, const void *ctx, double split)
{
    double by_light[LOBE_SG_HELD], shape;
    const double error = lobe_sg_scenes_error(s, spectra, LOBE_SG_HELD, model, ctx, by_light, &shape);
    int i;
    fprintf(out, "%s,%d,%.4f,%.4f,", name, lobes, error, error / split);
    if (lobes)
        fprintf(out, "%.4f", shape);
    for (i = 0; i < LOBE_SG_HELD; i++)
        fprintf(out, ",%.4f", by_light[i]);
    fputc('\n', out);
    return error >= 0;
}

static bool write_rows(FILE *out, const lobe_sweep_options *sweep)
{
    static const int counts[] = {1, 2, 4, 8};
    lobe_env_spectrum spectra[LOBE_SG_HELD];
    lobe_sg_scenes s = {0};
    double c[LOBE_SG_COEFFICIENTS], star[LOBE_SG_COEFFICIENTS], radiance, shape, split = -1;
    size_t i;
    bool good = lobe_sg_lights_held(spectra) &&
                lobe_sg_scenes_make(&s, true, spectra, LOBE_SG_HELD, 0, sweep->threads) &&
                lobe_env_sg_solve(LOBE_SG_MOST, SEED_HELD, sweep, c, &radiance, &shape) == 0 &&
                lobe_env_sg_solve(LOBE_SG_MOST, SEED_HELD | 1u << LOBE_SG_TAPER | LOBE_SG_PRINTED, sweep, star,
                                  &radiance, &shape) == 0;
    if (good)
        split = lobe_sg_scenes_error(&s, spectra, LOBE_SG_HELD, lobe_sg_split_sum, NULL, NULL, NULL);
    fputs("# relative rms of radiance over 30 points and all orientations; the last five by environment\n"
          "model,lobes,radiance,of_split_sum,shape,sky,lamps,checker,clouds,texel\n",
          out);
    good =
        good && split > 0 && put(out, "split sum", 0, &s, spectra, lobe_sg_split_sum, NULL, split) &&
        put(out, "seed paper's two layers, refitted", LOBE_SG_MOST, &s, spectra, seed, c, split) &&
        put(out, "the same with the amplitude as printed (quartic)", LOBE_SG_MOST, &s, spectra, printed, star, split);
    for (i = 0; good && i < sizeof counts / sizeof counts[0]; i++)
        good = put(out, "env_lobes_sg", counts[i], &s, spectra, shipped, &counts[i], split);
    lobe_sg_scenes_free(&s);
    return good;
}

int lobe_env_sg_search(const lobe_case *self, int argc, char **argv)
{
    const lobe_sweep_options sweep = lobe_sweep_options_default();
    lobe_atomic_file file;
    if (argc != 2 || strcmp(argv[0], "--csv") != 0) {
        fprintf(stderr, "lobefit: search %s: it takes --csv FILE\n", self->name);
        return 2;
    }
    if (!lobe_atomic_open(&file, argv[1]))
        return 2;
    if (!write_rows(file.stream, &sweep)) {
        fputs("lobefit: search: not enough memory, or interrupted\n", stderr);
        lobe_atomic_abandon(&file);
        return 2;
    }
    return lobe_atomic_commit(&file) ? 0 : 2;
}
