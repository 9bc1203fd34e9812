#include <math.h>
#include "contenders.h"
#include "fresnel.h"
#include "front.h"

typedef lobe_judge_error table[LOBE_FRESNEL_WAYS][LOBE_FRESNEL_F0S][LOBE_FRESNEL_MODELS];

typedef struct front {
    int threads;
    table sum; /* squares */
} front;

static bool judge_one(void *ctx, const char *name, const lobe_environment *map, double dark)
{
    front *f = ctx;
    const lobe_judge_options options = {f->threads, 7, dark};
    table e;
    (void)name;
    if (!lobe_fresnel_judge(map, &options, lobe_contender, LOBE_CONTENDERS, e)) {
        fputs("lobefit: search: not enough memory\n", stderr);
        return false;
    }
    for (int w = 0; w < LOBE_FRESNEL_WAYS; w++)
        for (int k = 0; k < LOBE_FRESNEL_F0S; k++)
            for (int m = 0; m < LOBE_CONTENDERS; m++) {
                f->sum[w][k][m].relative += e[w][k][m].relative * e[w][k][m].relative;
                f->sum[w][k][m].rms += e[w][k][m].rms * e[w][k][m].rms;
            }
    return true;
}

bool lobe_fresnel_front_write(const lobe_held *held, int threads, FILE *out)
{
    front f = {.threads = threads};
    if (!lobe_held_each(held, judge_one, &f))
        return false;
    fputs("model,f0,way,relative,added,rms,rms_added\n", out);
    for (int m = 0; m < LOBE_CONTENDERS; m++)
        for (int k = 0; k < LOBE_FRESNEL_F0S; k++)
            for (int w = 0; w < LOBE_FRESNEL_WAYS; w++) {
                const double n = lobe_held_count(held);
                const lobe_judge_error *e = &f.sum[w][k][m], *one = &f.sum[w][0][m];
                fprintf(out, "%s,%g,%s,%.4f,%.4f,%.4f,%.4f\n", lobe_contender[m].name, lobe_fresnel_f0[k],
                        lobe_fresnel_name[w], sqrt(e->relative / n), sqrt(e->relative / n) - sqrt(one->relative / n),
                        sqrt(e->rms / n), sqrt(e->rms / n) - sqrt(one->rms / n));
            }
    return true;
}
