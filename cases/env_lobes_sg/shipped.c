#define LOBE_DOUBLE 1
#include "shipped.h"
#include "../../models/env_lobes_sg.h"

static void put(lobe_env_tap tap, lobe_sg *lobe)
{
    lobe->angle = tap.angle;
    lobe->sharpness = tap.width;
    lobe->weight = tap.weight;
}

int lobe_sg_shipped(int count, double roughness, double n_dot_v, double albedo, lobe_sg *lobes)
{
    if (count == 1) {
        put(lobe_env_lobes_sg_lobes1(roughness, n_dot_v, albedo), lobes);
    } else if (count == 2) {
        const lobe_env_sg2 f = lobe_env_lobes_sg_lobes2(roughness, n_dot_v, albedo);
        put(f.t0, &lobes[0]);
        put(f.t1, &lobes[1]);
    } else if (count == 4) {
        const lobe_env_sg4 f = lobe_env_lobes_sg_lobes4(roughness, n_dot_v, albedo);
        put(f.t0, &lobes[0]);
        put(f.t1, &lobes[1]);
        put(f.t2, &lobes[2]);
        put(f.t3, &lobes[3]);
    } else {
        const lobe_env_sg8 f = lobe_env_lobes_sg_lobes8(roughness, n_dot_v, albedo);
        put(f.t0, &lobes[0]);
        put(f.t1, &lobes[1]);
        put(f.t2, &lobes[2]);
        put(f.t3, &lobes[3]);
        put(f.t4, &lobes[4]);
        put(f.t5, &lobes[5]);
        put(f.t6, &lobes[6]);
        put(f.t7, &lobes[7]);
    }
    return count;
}
