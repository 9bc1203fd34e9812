#include "adaptive.h"
#include <math.h>
#include <string.h>
#include "orientations.h"

enum { GATES = LOBE_ADAPTIVE_GATES, TERMS = LOBE_ADAPTIVE_TERMS };

int lobe_adaptive_first(int tap, int quantity)
{
    return LOBE_ADAPTIVE_NEEDS + TERMS * (tap ? 3 * tap - 1 + quantity : quantity);
}

static double sum(const double *c, const double *term, int n)
{
    double s = 0;
    for (int i = 0; i < n; i++)
        s += c[i] * term[i];
    return s;
}

void lobe_adaptive_need_terms(const lobe_fan_point *point, double term[LOBE_ADAPTIVE_NEEDS])
{
    const double r = sqrt(point->alpha);
    memcpy(term, point->term, sizeof point->term);
    term[LOBE_FAN_TERMS] = r;
    term[LOBE_FAN_TERMS + 1] = r * point->term[1];
    term[LOBE_FAN_TERMS + 2] = r * point->term[3];
}

double lobe_adaptive_need(const lobe_fan_point *point, const double *p)
{
    double term[LOBE_ADAPTIVE_NEEDS];
    lobe_adaptive_need_terms(point, term);
    return sum(p, term, LOBE_ADAPTIVE_NEEDS);
}

/* ln(1 + e^z), and its slope */
static double ramp(double z) { return z > 30 ? z : log1p(exp(fmax(z, -700))); }
static double rise(double z) { return 1 / (1 + exp(fmin(-z, 700))); }

static double gate(double x, double softness)
{
    return softness > 0 ? softness * (ramp(x / softness) - ramp((x - 1) / softness)) : fmin(1, fmax(0, x));
}

static double gate_slope(double x, double softness)
{
    return softness > 0 ? rise(x / softness) - rise((x - 1) / softness) : x > 0 && x < 1;
}

void lobe_adaptive_taps(const lobe_fan_point *point, const double *p, double softness, lobe_adaptive_fan *fan)
{
    /* what training knows: environments have no finer detail, and no tap looks further (orientations.h) */
    const double least = log(1.01 * LOBE_ORIENTATION_T_LO), most = log(0.9 * LOBE_ORIENTATION_T_HI);
    double rest = 1;
    memcpy(fan->term, point->term, sizeof point->term);
    memset(fan->term_by_need, 0, sizeof fan->term_by_need);
    fan->need = lobe_adaptive_need(point, p);
    fan->count = 1;
    for (int k = 0; k < GATES; k++) {
        fan->term[LOBE_FAN_TERMS + k] = gate(fan->need - k, softness);
        fan->term_by_need[LOBE_FAN_TERMS + k] = gate_slope(fan->need - k, softness);
        /* e^-12 of a tap is none */
        if (fan->need - k > -12 * softness)
            fan->count = k + 2;
    }
    fan->weight_by_need[0] = 0;
    for (int i = 0; i < fan->count; i++) {
        const double *shift = p + lobe_adaptive_first(i, 0), *wide = p + lobe_adaptive_first(i, 1),
                     *part = wide + TERMS;
        const double width = sum(wide, fan->term, TERMS), power = exp2(fmin(8, width));
        const double log_t = log(point->alpha * (0.3 + power));
        const double angle = point->theta + point->reach * sum(shift, fan->term, TERMS);
        lobe_cell_tap *tap = &fan->tap[i];
        tap->log_t = fmin(most, fmax(least, log_t));
        tap->angle = fmin(LOBE_ORIENTATION_ANGLE_HI, fmax(LOBE_ORIENTATION_ANGLE_LO, angle));
        fan->log_t_by_width[i] = tap->log_t == log_t && width < 8 ? power / (0.3 + power) * 0.69314718055994531 : 0;
        fan->angle_by_shift[i] = tap->angle == angle ? point->reach : 0;
        fan->log_t_by_need[i] = fan->log_t_by_width[i] * sum(wide, fan->term_by_need, TERMS);
        fan->angle_by_need[i] = fan->angle_by_shift[i] * sum(shift, fan->term_by_need, TERMS);
        fan->gate[i] = 1;
        if (i) {
            const double open = fan->term[LOBE_FAN_TERMS + i - 1], own = sum(part, fan->term, TERMS);
            fan->gate[i] = open;
            tap->weight = open * own;
            fan->weight_by_need[i] =
                fan->term_by_need[LOBE_FAN_TERMS + i - 1] * own + open * sum(part, fan->term_by_need, TERMS);
            fan->weight_by_need[0] -= fan->weight_by_need[i];
            rest -= tap->weight;
        }
    }
    fan->tap[0].weight = rest;
}

double lobe_adaptive_mean_taps(const double *p, int side)
{
    double taps = 0;
    for (int i = 0; i < side * side; i++) {
        const double r = (i / side + 0.5) / side;
        const lobe_fan_point point = lobe_fan_point_of(r * r, (i % side + 0.5) / side);
        const double need = lobe_adaptive_need(&point, p);
        taps += 1 + fmin(GATES, fmax(0, ceil(need)));
    }
    return taps / (side * side);
}
