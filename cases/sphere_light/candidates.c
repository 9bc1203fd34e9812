#define LOBE_DOUBLE 1
#include "candidates.h"
#include <stddef.h>
#include "../../models/sphere_light_high.h"
#include "ltc.h"
#include "peers.h"
#include "peers_fitted.h"
#include "row.h"

#define CALL(name, ...)                                                                                                \
    static double call_##name(const double row[5]) { return __VA_ARGS__; }
CALL(point, lobe_sphere_light_punctual(row[0], lobe_sphere_of_row(row)))
CALL(karis_half, lobe_peer_karis(row[0], lobe_sphere_of_row(row), 1.0 / 2))
CALL(karis_third, lobe_peer_karis(row[0], lobe_sphere_of_row(row), 1.0 / 3))
CALL(smooth_printed, lobe_peer_smooth_point(row[0], lobe_sphere_of_row(row), .962406, .375892, .962406))
CALL(smooth_refitted, lobe_peer_smooth_point(row[0], lobe_sphere_of_row(row), LOBE_PEER_SMOOTH_POINT))
CALL(wider, lobe_peer_wider(row[0], lobe_sphere_of_row(row), LOBE_PEER_WIDER))
CALL(wider_capped, lobe_peer_wider_capped(row[0], lobe_sphere_of_row(row), LOBE_PEER_WIDER_CAPPED))
CALL(capped_point, lobe_peer_capped_point(row[0], lobe_sphere_of_row(row), LOBE_PEER_CAPPED_POINT))
CALL(low, lobe_sphere_light_low(row[0], lobe_sphere_of_row(row)))
CALL(medium, lobe_sphere_light_medium(row[0], lobe_sphere_of_row(row)))
CALL(high, lobe_sphere_light_high(row[0], lobe_sphere_of_row(row)))

static double by_ltc(const double row[5], double (*light)(const double cell[LOBE_LTC_VALUES], const double row[5]))
{
    double cell[LOBE_LTC_VALUES];
    lobe_ltc_at(row[0], row[1], cell);
    return light(cell, row);
}
CALL(ltc_ellipse, by_ltc(row, lobe_ltc_clipped_ellipse))
CALL(ltc_sphere, by_ltc(row, lobe_ltc_clipped_sphere))

enum { LTC_BYTES = 4 * LOBE_LTC_NUMBERS };

static const lobe_sphere_candidate candidates[] = {
    {"point", call_point, 0},
    {"Karis 1/2", call_karis_half, 0},
    {"Karis 1/3", call_karis_third, 0},
    {"smoothed point as printed", call_smooth_printed, 0},
    {"smoothed point refitted", call_smooth_refitted, 0},
    {"wider lobe", call_wider, 0},
    {"wider lobe capped", call_wider_capped, 0},
    {"capped point", call_capped_point, 0},
    {"LTC exact clip", call_ltc_ellipse, LTC_BYTES},
    {"LTC round cone clip", call_ltc_sphere, LTC_BYTES},
    {"low", call_low, 0},
    {"medium", call_medium, 0},
    {"high", call_high, 0},
};

const lobe_sphere_candidate *lobe_sphere_candidate_at(int i)
{
    return i >= 0 && (size_t)i < sizeof candidates / sizeof candidates[0] ? &candidates[i] : NULL;
}
