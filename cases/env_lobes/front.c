#include "front.h"
#include <math.h>
#include <string.h>
#include "adaptive_contender.h"
#include "asg.h"
#include "contenders.h"
#include "gaussians.h"
#include "shape.h"
#include "table_contenders.h"

/* The contenders, a star that is no fan of taps, what are tables, what adapts its number of taps, and env_lobes_sg. */
enum {
    TABLES = LOBE_CONTENDERS + 1,
    ADAPTIVE = TABLES + LOBE_TABLE_CONTENDERS,
    SG = ADAPTIVE + 1,
    MODELS = SG + LOBE_GAUSSIANS
};

typedef struct front {
    int threads;
    FILE *out;
    lobe_asg_star star;
    lobe_judge_model models[MODELS];
    lobe_judge_error sum[MODELS]; /* squares, over the environments that count */
} front;

/* One map's errors and their part of the means. */
static bool judge_one(void *ctx, const char *name, const lobe_environment *map, double dark)
{
    front *f = ctx;
    const lobe_judge_options options = {f->threads, 7, dark};
    lobe_judge_error e[MODELS];
    if (!lobe_judge_environment(map, &options, f->models, MODELS, e)) {
        fputs("lobefit: search: not enough memory\n", stderr);
        return false;
    }
    for (int m = 0; m < MODELS; m++) {
        fprintf(f->out, "%s,%s,%.4f,%.4f,%.4f,%.4f\n", name, f->models[m].name, e[m].relative,
                e[m].relative / e[0].relative, e[m].rms, e[m].rms / e[0].rms);
        f->sum[m].relative += e[m].relative * e[m].relative;
        f->sum[m].rms += e[m].rms * e[m].rms;
    }
    return true;
}

static double asg_at(void *ctx, const double d[3]) { return lobe_asg_at(ctx, d); }

/* The shape over 36 points. */
static void judge_shape(const front *f)
{
    static const double alpha[6] = {.04, .1, .2, .4, .7, 1}, view[6] = {.1, .25, .4, .6, .8, 1};
    for (int m = 0; m < SG; m++) { /* the others': cases/env_lobes_sg/front.csv */
        double sum = 0;
        for (int i = 0; i < 36; i++) {
            const double a = alpha[i / 6], v = view[i % 6];
            double e;
            if (f->models[m].taps) {
                lobe_cell_tap taps[LOBE_CELL_TAPS];
                e = lobe_shape_error(a, v, taps, f->models[m].taps(f->models[m].ctx, a, v, taps));
            } else {
                lobe_asg asg = lobe_asg_fit(a, v, 1, NULL);
                e = lobe_shape_error_of(a, v, asg_at, &asg);
            }
            sum += e * e / 36;
        }
        fprintf(f->out, "shape,%s,%.4f,,,\n", f->models[m].name, sqrt(sum));
    }
}

bool lobe_front_write(const lobe_held *held, int threads, FILE *out)
{
    front f = {.threads = threads, .out = out};
    memcpy(f.models, lobe_contender, sizeof lobe_contender);
    lobe_asg_star_fit(&f.star);
    f.models[LOBE_CONTENDERS] = (lobe_judge_model){"asg", NULL, lobe_asg_star_nodes, &f.star};
    memcpy(f.models + TABLES, lobe_table_contender, sizeof lobe_table_contender);
    f.models[ADAPTIVE] = lobe_adaptive_contender;
    memcpy(f.models + SG, lobe_gaussian, sizeof lobe_gaussian);
    fputs("environment,model,relative,of_split_sum,rms,rms_of_split_sum\n", out);
    if (!lobe_held_each(held, judge_one, &f))
        return false;
    for (int m = 0; m < MODELS; m++) {
        const double n = lobe_held_count(held);
        fprintf(out, "all,%s,%.4f,%.4f,%.4f,%.4f\n", f.models[m].name, sqrt(f.sum[m].relative / n),
                sqrt(f.sum[m].relative / f.sum[0].relative), sqrt(f.sum[m].rms / n), sqrt(f.sum[m].rms / f.sum[0].rms));
    }
    judge_shape(&f);
    fprintf(out, "taps in the mean,%s,%.4f,,,\n", lobe_adaptive_contender.name, lobe_adaptive_contender_mean(1024));
    return lobe_held_texel(judge_one, &f);
}
