/* Burley's diffuse lobe, tier by tier, as nine coefficients in the world of the lighting: what ships, in float. */
#ifndef LOBE_ENVIRONMENT_LOBES_H
#define LOBE_ENVIRONMENT_LOBES_H

typedef enum lobe_diffuse_tier {
    LOBE_DIFFUSE_EXACT,
    LOBE_DIFFUSE_MEDIUM,
    LOBE_DIFFUSE_LOW,
    LOBE_DIFFUSE_ZONAL,
    LOBE_DIFFUSE_ZONAL_LOW,
    LOBE_DIFFUSE_SEED, /* Iwanicki and Pesce's zonal fit as printed, without the second division by pi */
    LOBE_DIFFUSE_LAMBERT,
    LOBE_DIFFUSE_TIERS
} lobe_diffuse_tier;

extern const char *const lobe_diffuse_tier_name[LOBE_DIFFUSE_TIERS];

/* Unit normal n and unit view (towards the eye) with n.view >= 0. */
void lobe_diffuse_lobe(lobe_diffuse_tier tier, double roughness, const double n[3], const double view[3], double c[9]);

/* Radiance from a lobe and lighting sh[channel][index]; not clamped. */
void lobe_diffuse_light(const double c[9], double sh[3][9], double rgb[3]);

#endif
