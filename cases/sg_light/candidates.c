#define LOBE_DOUBLE 1
#include "candidates.h"
#include <stddef.h>
#include "../../models/sg_light_high.h"
#include "peers.h"
#include "row.h"

static double point(const double row[5]) { return lobe_sg_punctual(row[0], lobe_sg_of_row(row)); }
static double medium(const double row[5]) { return lobe_sg_light_medium(row[0], lobe_sg_of_row(row)); }
static double high(const double row[5]) { return lobe_sg_light_high(row[0], lobe_sg_of_row(row)); }

static const lobe_sg_candidate candidates[] = {
    {"point", point},
    {"SG warp", lobe_peer_sg_warp},
    {"ASG warp", lobe_peer_asg_warp},
    {"ASG warp refitted", lobe_peer_asg_refitted},
    {"medium", medium},
    {"high", high},
};

const lobe_sg_candidate *lobe_sg_candidate_at(int i)
{
    return i >= 0 && (size_t)i < sizeof candidates / sizeof candidates[0] ? &candidates[i] : NULL;
}
