/* E, the directional albedo of GGX (height-correlated Smith, F = 1), and 1/E, what a single-scattering lobe is
 * multiplied with to pass the white furnace.
 *
 * With a = roughness^2 and s = v / (k a + v), which runs from 0 at grazing views to 1 at a mirror:
 *     1/E = 1 + s (1 - s) Q(a, s),   Q a polynomial: an outer Horner scheme in a, whose rows are polynomials in s.
 * E = 1 at both ends of s, so the prefactor takes the edges off the polynomial's hands; the furnace error f E - 1 is
 * linear in every coefficient but k. How long each row is was searched (cases/energy/README.md); 2s - 1 for s, and
 * 2a - 1 for a, keep the coefficients small. 1/E and not E is the polynomial, since a shader that compensates then
 * needs one division. 1e-20 keeps w positive at roughness = v = 0, where s is 0 and the result exactly 1.
 *
 * Operations: 1/E as stated at each kernel, E four more. Errors: models/coeffs/energy_bounds.h. */
#ifndef LOBE_ENERGY_H
#define LOBE_ENERGY_H
#include "../core/scalar.h"
#include "coeffs/energy_low.h"
#include "coeffs/energy_medium.h"
#include "coeffs/energy_high.h"

/* 16 operations. Rows of 3 1 1 1 3 coefficients. */
LOBE_FN lobe_real lobe_energy_inverse_low(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-20);
    LOBE_LET w = LOBE_ENERGY_LOW_C0 * a + v;
    LOBE_LET s = v / w;
    LOBE_LET t = s - s * s;
    LOBE_LET q4 = (LOBE_ENERGY_LOW_C9 * s + LOBE_ENERGY_LOW_C8) * s + LOBE_ENERGY_LOW_C7;
    LOBE_LET q3 = q4 * a + LOBE_ENERGY_LOW_C6;
    LOBE_LET q2 = q3 * a + LOBE_ENERGY_LOW_C5;
    LOBE_LET q1 = q2 * a + LOBE_ENERGY_LOW_C4;
    LOBE_LET row0 = (LOBE_ENERGY_LOW_C3 * s + LOBE_ENERGY_LOW_C2) * s + LOBE_ENERGY_LOW_C1;
    LOBE_LET q0 = q1 * a + row0;
    LOBE_LET f = LOBE_R(1.0) + t * q0;
    return f;
}

LOBE_FN lobe_real lobe_energy_low(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET e = LOBE_R(1.0) / lobe_energy_inverse_low(LOBE_COEFFS_HERE roughness, n_dot_v);
    return lobe_saturate(e);
}

/* 36 operations. Rows of 11 1 3 4 6 3 coefficients, in 2s - 1. */
LOBE_FN lobe_real lobe_energy_inverse_medium(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-20);
    LOBE_LET w = LOBE_ENERGY_MEDIUM_C0 * a + v;
    LOBE_LET s = v / w;
    LOBE_LET t = s - s * s;
    LOBE_LET u = LOBE_R(2.0) * s - LOBE_R(1.0);
    LOBE_LET q5 = (LOBE_ENERGY_MEDIUM_C28 * u + LOBE_ENERGY_MEDIUM_C27) * u + LOBE_ENERGY_MEDIUM_C26;
    LOBE_LET row4a = ((LOBE_ENERGY_MEDIUM_C25 * u + LOBE_ENERGY_MEDIUM_C24) * u + LOBE_ENERGY_MEDIUM_C23) * u +
                     LOBE_ENERGY_MEDIUM_C22;
    LOBE_LET row4 = (row4a * u + LOBE_ENERGY_MEDIUM_C21) * u + LOBE_ENERGY_MEDIUM_C20;
    LOBE_LET q4 = q5 * a + row4;
    LOBE_LET row3 = ((LOBE_ENERGY_MEDIUM_C19 * u + LOBE_ENERGY_MEDIUM_C18) * u + LOBE_ENERGY_MEDIUM_C17) * u +
                    LOBE_ENERGY_MEDIUM_C16;
    LOBE_LET q3 = q4 * a + row3;
    LOBE_LET row2 = (LOBE_ENERGY_MEDIUM_C15 * u + LOBE_ENERGY_MEDIUM_C14) * u + LOBE_ENERGY_MEDIUM_C13;
    LOBE_LET q2 = q3 * a + row2;
    LOBE_LET q1 = q2 * a + LOBE_ENERGY_MEDIUM_C12;
    LOBE_LET row0a =
        ((LOBE_ENERGY_MEDIUM_C11 * u + LOBE_ENERGY_MEDIUM_C10) * u + LOBE_ENERGY_MEDIUM_C9) * u + LOBE_ENERGY_MEDIUM_C8;
    LOBE_LET row0b = ((row0a * u + LOBE_ENERGY_MEDIUM_C7) * u + LOBE_ENERGY_MEDIUM_C6) * u + LOBE_ENERGY_MEDIUM_C5;
    LOBE_LET row0c = ((row0b * u + LOBE_ENERGY_MEDIUM_C4) * u + LOBE_ENERGY_MEDIUM_C3) * u + LOBE_ENERGY_MEDIUM_C2;
    LOBE_LET row0 = row0c * u + LOBE_ENERGY_MEDIUM_C1;
    LOBE_LET q0 = q1 * a + row0;
    LOBE_LET f = LOBE_R(1.0) + t * q0;
    return f;
}

LOBE_FN lobe_real lobe_energy_medium(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET e = LOBE_R(1.0) / lobe_energy_inverse_medium(LOBE_COEFFS_HERE roughness, n_dot_v);
    return lobe_saturate(e);
}

/* 73 operations. Rows of 11 11 7 8 15 7 5 coefficients, in 2s - 1 and 2a - 1. */
LOBE_FN lobe_real lobe_energy_inverse_high(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET v = lobe_saturate(n_dot_v);
    LOBE_LET a = r * r + LOBE_R(1e-20);
    LOBE_LET w = LOBE_ENERGY_HIGH_C0 * a + v;
    LOBE_LET s = v / w;
    LOBE_LET t = s - s * s;
    LOBE_LET u = LOBE_R(2.0) * s - LOBE_R(1.0);
    LOBE_LET b = LOBE_R(2.0) * a - LOBE_R(1.0);
    LOBE_LET row6a =
        ((LOBE_ENERGY_HIGH_C64 * u + LOBE_ENERGY_HIGH_C63) * u + LOBE_ENERGY_HIGH_C62) * u + LOBE_ENERGY_HIGH_C61;
    LOBE_LET q6 = row6a * u + LOBE_ENERGY_HIGH_C60;
    LOBE_LET row5a =
        ((LOBE_ENERGY_HIGH_C59 * u + LOBE_ENERGY_HIGH_C58) * u + LOBE_ENERGY_HIGH_C57) * u + LOBE_ENERGY_HIGH_C56;
    LOBE_LET row5 = ((row5a * u + LOBE_ENERGY_HIGH_C55) * u + LOBE_ENERGY_HIGH_C54) * u + LOBE_ENERGY_HIGH_C53;
    LOBE_LET q5 = q6 * b + row5;
    LOBE_LET row4a =
        ((LOBE_ENERGY_HIGH_C52 * u + LOBE_ENERGY_HIGH_C51) * u + LOBE_ENERGY_HIGH_C50) * u + LOBE_ENERGY_HIGH_C49;
    LOBE_LET row4b = ((row4a * u + LOBE_ENERGY_HIGH_C48) * u + LOBE_ENERGY_HIGH_C47) * u + LOBE_ENERGY_HIGH_C46;
    LOBE_LET row4c = ((row4b * u + LOBE_ENERGY_HIGH_C45) * u + LOBE_ENERGY_HIGH_C44) * u + LOBE_ENERGY_HIGH_C43;
    LOBE_LET row4d = ((row4c * u + LOBE_ENERGY_HIGH_C42) * u + LOBE_ENERGY_HIGH_C41) * u + LOBE_ENERGY_HIGH_C40;
    LOBE_LET row4 = (row4d * u + LOBE_ENERGY_HIGH_C39) * u + LOBE_ENERGY_HIGH_C38;
    LOBE_LET q4 = q5 * b + row4;
    LOBE_LET row3a =
        ((LOBE_ENERGY_HIGH_C37 * u + LOBE_ENERGY_HIGH_C36) * u + LOBE_ENERGY_HIGH_C35) * u + LOBE_ENERGY_HIGH_C34;
    LOBE_LET row3b = ((row3a * u + LOBE_ENERGY_HIGH_C33) * u + LOBE_ENERGY_HIGH_C32) * u + LOBE_ENERGY_HIGH_C31;
    LOBE_LET row3 = row3b * u + LOBE_ENERGY_HIGH_C30;
    LOBE_LET q3 = q4 * b + row3;
    LOBE_LET row2a =
        ((LOBE_ENERGY_HIGH_C29 * u + LOBE_ENERGY_HIGH_C28) * u + LOBE_ENERGY_HIGH_C27) * u + LOBE_ENERGY_HIGH_C26;
    LOBE_LET row2 = ((row2a * u + LOBE_ENERGY_HIGH_C25) * u + LOBE_ENERGY_HIGH_C24) * u + LOBE_ENERGY_HIGH_C23;
    LOBE_LET q2 = q3 * b + row2;
    LOBE_LET row1a =
        ((LOBE_ENERGY_HIGH_C22 * u + LOBE_ENERGY_HIGH_C21) * u + LOBE_ENERGY_HIGH_C20) * u + LOBE_ENERGY_HIGH_C19;
    LOBE_LET row1b = ((row1a * u + LOBE_ENERGY_HIGH_C18) * u + LOBE_ENERGY_HIGH_C17) * u + LOBE_ENERGY_HIGH_C16;
    LOBE_LET row1c = ((row1b * u + LOBE_ENERGY_HIGH_C15) * u + LOBE_ENERGY_HIGH_C14) * u + LOBE_ENERGY_HIGH_C13;
    LOBE_LET row1 = row1c * u + LOBE_ENERGY_HIGH_C12;
    LOBE_LET q1 = q2 * b + row1;
    LOBE_LET row0a =
        ((LOBE_ENERGY_HIGH_C11 * u + LOBE_ENERGY_HIGH_C10) * u + LOBE_ENERGY_HIGH_C9) * u + LOBE_ENERGY_HIGH_C8;
    LOBE_LET row0b = ((row0a * u + LOBE_ENERGY_HIGH_C7) * u + LOBE_ENERGY_HIGH_C6) * u + LOBE_ENERGY_HIGH_C5;
    LOBE_LET row0c = ((row0b * u + LOBE_ENERGY_HIGH_C4) * u + LOBE_ENERGY_HIGH_C3) * u + LOBE_ENERGY_HIGH_C2;
    LOBE_LET row0 = row0c * u + LOBE_ENERGY_HIGH_C1;
    LOBE_LET q0 = q1 * b + row0;
    LOBE_LET f = LOBE_R(1.0) + t * q0;
    return f;
}

LOBE_FN lobe_real lobe_energy_high(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    LOBE_LET e = LOBE_R(1.0) / lobe_energy_inverse_high(LOBE_COEFFS_HERE roughness, n_dot_v);
    return lobe_saturate(e);
}

#endif
