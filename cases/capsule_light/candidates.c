#define LOBE_DOUBLE 1
#include "candidates.h"
#include <stddef.h>
#include "../../models/capsule_light_high.h"
#include "peers.h"
#include "row.h"

#define CALL(name, ...)                                                                                                \
    static double call_##name(const double *row) { return __VA_ARGS__; }
CALL(point, lobe_peer_capsule_point(row[0], lobe_capsule_of_row(row)))
CALL(karis_half, lobe_peer_capsule_karis(row[0], lobe_capsule_of_row(row), 1.0 / 2))
CALL(karis_third, lobe_peer_capsule_karis(row[0], lobe_capsule_of_row(row), 1.0 / 3))
CALL(low, lobe_capsule_light_low(row[0], lobe_capsule_of_row(row)))
CALL(medium, lobe_capsule_light_medium(row[0], lobe_capsule_of_row(row)))
CALL(high, lobe_capsule_light_high(row[0], lobe_capsule_of_row(row)))

static const lobe_capsule_candidate candidates[] = {
    {"point", call_point}, {"Karis 1/2", call_karis_half}, {"Karis 1/3", call_karis_third},
    {"low", call_low},     {"medium", call_medium},        {"high", call_high},
};

const lobe_capsule_candidate *lobe_capsule_candidate_at(int i)
{
    return i >= 0 && (size_t)i < sizeof candidates / sizeof candidates[0] ? &candidates[i] : NULL;
}
