#define LOBE_DOUBLE 1
#include "candidates.h"
#include <math.h>
#include <stddef.h>
#include "../../models/sphere_light_high.h"
#include "peers.h"

static lobe_sphere sphere_of(const double row[5])
{
    const double v = row[1], l = row[2], sv = sqrt(1 - v * v), sl = sqrt(1 - l * l), half = sin(.5 * row[4]);
    const double cross = sin(.5 * (3.14159265358979323846 - row[3])), apart = sv - sl;
    lobe_sphere s;
    s.n_dot_v = v;
    s.n_dot_l = l;
    s.tangent2 = .25 * apart * apart + sv * sl * cross * cross; /* (sv^2 + sl^2 + 2 sv sl cos(azimuth)) / 4 */
    s.sine = sin(row[4]);
    s.versine = 2 * half * half;
    return s;
}

#define CALL(name, ...)                                                                                                \
    static double call_##name(const double row[5]) { return __VA_ARGS__; }
CALL(point, lobe_sphere_light_punctual(row[0], sphere_of(row)))
CALL(karis_half, lobe_peer_karis(row[0], sphere_of(row), 1.0 / 2))
CALL(karis_third, lobe_peer_karis(row[0], sphere_of(row), 1.0 / 3))
CALL(smooth_printed, lobe_peer_smooth_point(row[0], sphere_of(row), .962406, .375892, .962406))
CALL(smooth_refitted, lobe_peer_smooth_point(row[0], sphere_of(row), 1.00564, .20785, 1.62536))
CALL(wider, lobe_peer_wider(row[0], sphere_of(row), .730015, 1e9))
CALL(wider_capped, lobe_peer_wider(row[0], sphere_of(row), .509488, .636822))
CALL(capped_point, lobe_peer_capped_point(row[0], sphere_of(row), 4.40, 1))
CALL(low, lobe_sphere_light_low(row[0], sphere_of(row)))
CALL(medium, lobe_sphere_light_medium(row[0], sphere_of(row)))
CALL(high, lobe_sphere_light_high(row[0], sphere_of(row)))

static const lobe_sphere_candidate candidates[] = {
    {"point", call_point},
    {"Karis 1/2", call_karis_half},
    {"Karis 1/3", call_karis_third},
    {"smoothed point as printed", call_smooth_printed},
    {"smoothed point refitted", call_smooth_refitted},
    {"wider lobe", call_wider},
    {"wider lobe capped", call_wider_capped},
    {"capped point", call_capped_point},
    {"low", call_low},
    {"medium", call_medium},
    {"high", call_high},
};

const lobe_sphere_candidate *lobe_sphere_candidate_at(int i)
{
    return i >= 0 && (size_t)i < sizeof candidates / sizeof candidates[0] ? &candidates[i] : NULL;
}
