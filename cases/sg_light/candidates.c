#define LOBE_DOUBLE 1
#include "candidates.h"
#include <stddef.h>
#include "../../models/sg_light_high.h"
#include "peers.h"
#include "row.h"

static double point(const double row[5]) { return lobe_sg_punctual(row[0], lobe_sg_of_row(row)); }
static double sg_warp(const double row[5]) { return lobe_peer_sg_warp(row[0], lobe_sg_of_row(row)); }
static double asg_warp(const double row[5]) { return lobe_peer_asg_warp(row[0], lobe_sg_of_row(row)); }
static double asg_refitted(const double row[5]) { return lobe_peer_asg_refitted(row[0], lobe_sg_of_row(row)); }
static double low(const double row[5]) { return lobe_sg_light_low(row[0], lobe_sg_of_row(row)); }
static double medium(const double row[5]) { return lobe_sg_light_medium(row[0], lobe_sg_of_row(row)); }
static double high(const double row[5]) { return lobe_sg_light_high(row[0], lobe_sg_of_row(row)); }

static const lobe_sg_candidate candidates[] = {
    {"point", point}, {"SG warp", sg_warp}, {"ASG warp", asg_warp}, {"ASG warp refitted", asg_refitted},
    {"low", low},     {"medium", medium},   {"high", high},
};

const lobe_sg_candidate *lobe_sg_candidate_at(int i)
{
    return i >= 0 && (size_t)i < sizeof candidates / sizeof candidates[0] ? &candidates[i] : NULL;
}
