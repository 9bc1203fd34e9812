#define LOBE_DOUBLE 1
#include "peers_fit.h"
#include <math.h>
#include <stdio.h>
#include "../fit/atomic_file.h"
#include "../fit/coefficients.h"
#include "../fit/nelder_mead.h"
#include "../fit/parallel.h"
#include "objective.h"
#include "peers.h"

static double smooth_point(const double *p, double roughness, lobe_sphere light)
{
    return lobe_peer_smooth_point(roughness, light, p[0], p[1], p[2]);
}
static double wider(const double *p, double roughness, lobe_sphere light)
{
    return lobe_peer_wider(roughness, light, p[0]);
}
static double wider_capped(const double *p, double roughness, lobe_sphere light)
{
    return lobe_peer_wider_capped(roughness, light, p[0], p[1]);
}
static double capped_point(const double *p, double roughness, lobe_sphere light)
{
    return lobe_peer_capped_point(roughness, light, p[0], p[1]);
}

/* Here name is that of the macro, box where the simplex stays; nothing but the error of the cells counts. */
static const lobe_sphere_tier peers[] = {
    {.name = "LOBE_PEER_SMOOTH_POINT",
     .call = smooth_point,
     .count = 3,
     .box = {{.5, 2}, {.01, 2}, {.3, 3}},
     .set_weight = {1, 1}},
    {.name = "LOBE_PEER_WIDER", .call = wider, .count = 1, .box = {{.05, 3}}, .set_weight = {1, 1}},
    {.name = "LOBE_PEER_WIDER_CAPPED",
     .call = wider_capped,
     .count = 2,
     .box = {{.05, 3}, {.1, 3}},
     .set_weight = {1, 1}},
    {.name = "LOBE_PEER_CAPPED_POINT",
     .call = capped_point,
     .count = 2,
     .box = {{.5, 12}, {.1, 3}},
     .set_weight = {1, 1}},
};

/* From the middle of the box. The simplex is deterministic; so is the sum, whatever the number of threads. */
static bool fit(const lobe_sphere_tier *peer, const lobe_sphere_cells cells[2], int threads, double *c, double *value)
{
    lobe_sphere_problem problem;
    lobe_parallel parallel = {lobe_sphere_sum, &problem, peer->count, 1, (size_t)threads};
    lobe_objective objective = {.f = lobe_parallel_eval, .ctx = &parallel, .dim = peer->count};
    lobe_nm_options o = lobe_nm_default();
    double lower[LOBE_SPHERE_MOST], upper[LOBE_SPHERE_MOST];
    lobe_fit_result result;
    size_t i;
    for (i = 0; i < peer->count; i++) {
        lower[i] = peer->box[i][0];
        upper[i] = peer->box[i][1];
        c[i] = .5 * (lower[i] + upper[i]);
    }
    objective.lower = lower;
    objective.upper = upper;
    o.size = .2;
    o.restarts = 1;
    o.value_tolerance = 1e-9;
    o.size_tolerance = 1e-6;
    o.budget = 600;
    if (lobe_sphere_problem_make(&problem, peer, cells, 1))
        result = lobe_nelder_mead(&objective, &o, c);
    else
        result = lobe_fit_no_memory();
    lobe_sphere_problem_free(&problem);
    *value = result.value;
    if (result.status == LOBE_FIT_CONVERGED || result.status == LOBE_FIT_STALLED)
        return true;
    fprintf(stderr, "lobefit: search: %s: %s: %s\n", peer->name, lobe_fit_status_name(result.status), result.reason);
    return false;
}

static bool write_all(const lobe_sphere_cells cells[2], int threads, FILE *out)
{
    size_t i, k;
    fputs("/* Constants of the published forms in peers.h, in their order there.\n"
          " * Generated: lobefit search sphere_light --peers FILE (make sphere-light-peers); do not edit.\n"
          " * Fit: Nelder-Mead on the fit cells, uniform and mixed positions (cells.h), in double.\n"
          " * Metric: relative L2 error of a cell; above each stands the rms over the cells of both sets. */\n"
          "#ifndef LOBE_SPHERE_LIGHT_PEERS_FITTED_H\n#define LOBE_SPHERE_LIGHT_PEERS_FITTED_H\n\n",
          out);
    for (i = 0; i < sizeof peers / sizeof peers[0]; i++) {
        double c[LOBE_SPHERE_MOST], value;
        if (!fit(&peers[i], cells, threads, c, &value))
            return false;
        fprintf(out, "/* %.4f */\n#define %s", sqrt(value / 2), peers[i].name);
        for (k = 0; k < peers[i].count; k++)
            fprintf(out, "%s%#.6g", k ? ", " : " ", c[k]);
        fputs("\n", out);
    }
    fputs("\n#endif\n", out);
    return true;
}

bool lobe_sphere_peers_fit(const lobe_sweep_options *options, const char *path)
{
    lobe_sphere_cells cells[2] = {{.in = NULL}};
    lobe_sweep_options sweep = *options;
    lobe_atomic_file file;
    bool good;
    sweep.label = "truth of the fit cells";
    good = lobe_sphere_cells_make(&cells[0], false, false, &sweep) &&
           lobe_sphere_cells_make(&cells[1], false, true, &sweep);
    if (!good)
        fputs("lobefit: search: not enough memory\n", stderr);
    if (good && (good = lobe_atomic_open(&file, path))) {
        good = write_all(cells, sweep.threads < LOBE_PARALLEL_MAX ? sweep.threads : LOBE_PARALLEL_MAX, file.stream);
        if (good)
            good = lobe_atomic_commit(&file);
        else
            lobe_atomic_abandon(&file);
    }
    lobe_sphere_cells_free(&cells[0]);
    lobe_sphere_cells_free(&cells[1]);
    return good;
}
