/* 1 to 6 taps into a prefiltered environment, as many as a point needs: 2.2 in the mean over (roughness, n_dot_v).
 *
 * need is one sum over the twelve products of env_lobes.h and three with roughness. Taps are read up to the first whole
 * number above it: tap k stands where need > k - 1, and its gate min(1, need - (k - 1)) is a factor of its weight, so
 * it comes in with weight 0 and nothing jumps. The gates are five more terms of every shift, width and part: taps make
 * room for one that comes. The first tap has what the others leave of the albedo. Taps that are not read have weight 0,
 * and the first's angle and width. */
#ifndef LOBE_ENV_LOBES_ADAPTIVE_H
#define LOBE_ENV_LOBES_ADAPTIVE_H
#include "env_lobes.h"
#include "coeffs/env_lobes_adaptive.h"

LOBE_STRUCT(lobe_env_fan6)
{
    lobe_env_tap t0;
    lobe_env_tap t1;
    lobe_env_tap t2;
    lobe_env_tap t3;
    lobe_env_tap t4;
    lobe_env_tap t5;
};

/* How far each tap but the first has come in, and how many there are to read. */
LOBE_STRUCT(lobe_env_gates)
{
    lobe_real g1;
    lobe_real g2;
    lobe_real g3;
    lobe_real g4;
    lobe_real g5;
    lobe_real count;
};

LOBE_FN lobe_env_gates lobe_env_gates_at(lobe_real need)
{
    LOBE_LET g1 = lobe_saturate(need);
    LOBE_LET g2 = lobe_saturate(need - LOBE_R(1.0));
    LOBE_LET g3 = lobe_saturate(need - LOBE_R(2.0));
    LOBE_LET g4 = lobe_saturate(need - LOBE_R(3.0));
    LOBE_LET g5 = lobe_saturate(need - LOBE_R(4.0));
    LOBE_LET n1 = lobe_select(g1, LOBE_R(1.0), LOBE_R(0.0));
    LOBE_LET n2 = lobe_select(g2, LOBE_R(1.0), LOBE_R(0.0));
    LOBE_LET n3 = lobe_select(g3, LOBE_R(1.0), LOBE_R(0.0));
    LOBE_LET n4 = lobe_select(g4, LOBE_R(1.0), LOBE_R(0.0));
    LOBE_LET n5 = lobe_select(g5, LOBE_R(1.0), LOBE_R(0.0));
    LOBE_LET count = LOBE_R(1.0) + n1 + n2 + n3 + n4 + n5;
    lobe_env_gates gate;
    gate.g1 = g1;
    gate.g2 = g2;
    gate.g3 = g3;
    gate.g4 = g4;
    gate.g5 = g5;
    gate.count = count;
    return gate;
}

/* What the gates add to a quantity. */
LOBE_FN lobe_real lobe_env_gated(lobe_env_gates gate, lobe_real sum, lobe_real c1, lobe_real c2, lobe_real c3,
                                 lobe_real c4, lobe_real c5)
{
    LOBE_LET x = sum + c1 * gate.g1 + c2 * gate.g2 + c3 * gate.g3 + c4 * gate.g4 + c5 * gate.g5;
    return x;
}

LOBE_FN lobe_env_gates lobe_env_adaptive_gates(LOBE_COEFFS lobe_env_point at, lobe_real roughness)
{
    LOBE_LET plain =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C0, LOBE_ENV_LOBES_ADAPTIVE_C1, LOBE_ENV_LOBES_ADAPTIVE_C2,
                     LOBE_ENV_LOBES_ADAPTIVE_C3, LOBE_ENV_LOBES_ADAPTIVE_C4, LOBE_ENV_LOBES_ADAPTIVE_C5,
                     LOBE_ENV_LOBES_ADAPTIVE_C6, LOBE_ENV_LOBES_ADAPTIVE_C7, LOBE_ENV_LOBES_ADAPTIVE_C8,
                     LOBE_ENV_LOBES_ADAPTIVE_C9, LOBE_ENV_LOBES_ADAPTIVE_C10, LOBE_ENV_LOBES_ADAPTIVE_C11);
    LOBE_LET r = lobe_saturate(roughness);
    LOBE_LET need = plain + r * (LOBE_ENV_LOBES_ADAPTIVE_C12 + LOBE_ENV_LOBES_ADAPTIVE_C13 * at.f1 +
                                 LOBE_ENV_LOBES_ADAPTIVE_C14 * at.f3);
    return lobe_env_gates_at(need);
}

/* How many taps there are to read, from the first on. */
LOBE_FN lobe_real lobe_env_adaptive_count(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v)
{
    lobe_env_point at = lobe_env_point_of(roughness, n_dot_v);
    lobe_env_gates gate = lobe_env_adaptive_gates(LOBE_COEFFS_HERE at, roughness);
    return gate.count;
}

/* The weights sum to albedo. */
LOBE_FN lobe_env_fan6 lobe_env_adaptive_fan(LOBE_COEFFS lobe_real roughness, lobe_real n_dot_v, lobe_real albedo)
{
    lobe_env_point at = lobe_env_point_of(roughness, n_dot_v);
    lobe_env_gates gate = lobe_env_adaptive_gates(LOBE_COEFFS_HERE at, roughness);
    LOBE_LET e = lobe_saturate(albedo);
    LOBE_LET shift_sum0 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C15, LOBE_ENV_LOBES_ADAPTIVE_C16, LOBE_ENV_LOBES_ADAPTIVE_C17,
                     LOBE_ENV_LOBES_ADAPTIVE_C18, LOBE_ENV_LOBES_ADAPTIVE_C19, LOBE_ENV_LOBES_ADAPTIVE_C20,
                     LOBE_ENV_LOBES_ADAPTIVE_C21, LOBE_ENV_LOBES_ADAPTIVE_C22, LOBE_ENV_LOBES_ADAPTIVE_C23,
                     LOBE_ENV_LOBES_ADAPTIVE_C24, LOBE_ENV_LOBES_ADAPTIVE_C25, LOBE_ENV_LOBES_ADAPTIVE_C26);
    LOBE_LET shift0 =
        lobe_env_gated(gate, shift_sum0, LOBE_ENV_LOBES_ADAPTIVE_C27, LOBE_ENV_LOBES_ADAPTIVE_C28,
                       LOBE_ENV_LOBES_ADAPTIVE_C29, LOBE_ENV_LOBES_ADAPTIVE_C30, LOBE_ENV_LOBES_ADAPTIVE_C31);
    LOBE_LET wide_sum0 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C32, LOBE_ENV_LOBES_ADAPTIVE_C33, LOBE_ENV_LOBES_ADAPTIVE_C34,
                     LOBE_ENV_LOBES_ADAPTIVE_C35, LOBE_ENV_LOBES_ADAPTIVE_C36, LOBE_ENV_LOBES_ADAPTIVE_C37,
                     LOBE_ENV_LOBES_ADAPTIVE_C38, LOBE_ENV_LOBES_ADAPTIVE_C39, LOBE_ENV_LOBES_ADAPTIVE_C40,
                     LOBE_ENV_LOBES_ADAPTIVE_C41, LOBE_ENV_LOBES_ADAPTIVE_C42, LOBE_ENV_LOBES_ADAPTIVE_C43);
    LOBE_LET wide0 =
        lobe_env_gated(gate, wide_sum0, LOBE_ENV_LOBES_ADAPTIVE_C44, LOBE_ENV_LOBES_ADAPTIVE_C45,
                       LOBE_ENV_LOBES_ADAPTIVE_C46, LOBE_ENV_LOBES_ADAPTIVE_C47, LOBE_ENV_LOBES_ADAPTIVE_C48);
    LOBE_LET shift_sum1 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C49, LOBE_ENV_LOBES_ADAPTIVE_C50, LOBE_ENV_LOBES_ADAPTIVE_C51,
                     LOBE_ENV_LOBES_ADAPTIVE_C52, LOBE_ENV_LOBES_ADAPTIVE_C53, LOBE_ENV_LOBES_ADAPTIVE_C54,
                     LOBE_ENV_LOBES_ADAPTIVE_C55, LOBE_ENV_LOBES_ADAPTIVE_C56, LOBE_ENV_LOBES_ADAPTIVE_C57,
                     LOBE_ENV_LOBES_ADAPTIVE_C58, LOBE_ENV_LOBES_ADAPTIVE_C59, LOBE_ENV_LOBES_ADAPTIVE_C60);
    LOBE_LET shift1 =
        lobe_env_gated(gate, shift_sum1, LOBE_ENV_LOBES_ADAPTIVE_C61, LOBE_ENV_LOBES_ADAPTIVE_C62,
                       LOBE_ENV_LOBES_ADAPTIVE_C63, LOBE_ENV_LOBES_ADAPTIVE_C64, LOBE_ENV_LOBES_ADAPTIVE_C65);
    LOBE_LET wide_sum1 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C66, LOBE_ENV_LOBES_ADAPTIVE_C67, LOBE_ENV_LOBES_ADAPTIVE_C68,
                     LOBE_ENV_LOBES_ADAPTIVE_C69, LOBE_ENV_LOBES_ADAPTIVE_C70, LOBE_ENV_LOBES_ADAPTIVE_C71,
                     LOBE_ENV_LOBES_ADAPTIVE_C72, LOBE_ENV_LOBES_ADAPTIVE_C73, LOBE_ENV_LOBES_ADAPTIVE_C74,
                     LOBE_ENV_LOBES_ADAPTIVE_C75, LOBE_ENV_LOBES_ADAPTIVE_C76, LOBE_ENV_LOBES_ADAPTIVE_C77);
    LOBE_LET wide1 =
        lobe_env_gated(gate, wide_sum1, LOBE_ENV_LOBES_ADAPTIVE_C78, LOBE_ENV_LOBES_ADAPTIVE_C79,
                       LOBE_ENV_LOBES_ADAPTIVE_C80, LOBE_ENV_LOBES_ADAPTIVE_C81, LOBE_ENV_LOBES_ADAPTIVE_C82);
    LOBE_LET part_sum1 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C83, LOBE_ENV_LOBES_ADAPTIVE_C84, LOBE_ENV_LOBES_ADAPTIVE_C85,
                     LOBE_ENV_LOBES_ADAPTIVE_C86, LOBE_ENV_LOBES_ADAPTIVE_C87, LOBE_ENV_LOBES_ADAPTIVE_C88,
                     LOBE_ENV_LOBES_ADAPTIVE_C89, LOBE_ENV_LOBES_ADAPTIVE_C90, LOBE_ENV_LOBES_ADAPTIVE_C91,
                     LOBE_ENV_LOBES_ADAPTIVE_C92, LOBE_ENV_LOBES_ADAPTIVE_C93, LOBE_ENV_LOBES_ADAPTIVE_C94);
    LOBE_LET part1 =
        lobe_env_gated(gate, part_sum1, LOBE_ENV_LOBES_ADAPTIVE_C95, LOBE_ENV_LOBES_ADAPTIVE_C96,
                       LOBE_ENV_LOBES_ADAPTIVE_C97, LOBE_ENV_LOBES_ADAPTIVE_C98, LOBE_ENV_LOBES_ADAPTIVE_C99);
    LOBE_LET shift_sum2 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C100, LOBE_ENV_LOBES_ADAPTIVE_C101, LOBE_ENV_LOBES_ADAPTIVE_C102,
                     LOBE_ENV_LOBES_ADAPTIVE_C103, LOBE_ENV_LOBES_ADAPTIVE_C104, LOBE_ENV_LOBES_ADAPTIVE_C105,
                     LOBE_ENV_LOBES_ADAPTIVE_C106, LOBE_ENV_LOBES_ADAPTIVE_C107, LOBE_ENV_LOBES_ADAPTIVE_C108,
                     LOBE_ENV_LOBES_ADAPTIVE_C109, LOBE_ENV_LOBES_ADAPTIVE_C110, LOBE_ENV_LOBES_ADAPTIVE_C111);
    LOBE_LET shift2 =
        lobe_env_gated(gate, shift_sum2, LOBE_ENV_LOBES_ADAPTIVE_C112, LOBE_ENV_LOBES_ADAPTIVE_C113,
                       LOBE_ENV_LOBES_ADAPTIVE_C114, LOBE_ENV_LOBES_ADAPTIVE_C115, LOBE_ENV_LOBES_ADAPTIVE_C116);
    LOBE_LET wide_sum2 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C117, LOBE_ENV_LOBES_ADAPTIVE_C118, LOBE_ENV_LOBES_ADAPTIVE_C119,
                     LOBE_ENV_LOBES_ADAPTIVE_C120, LOBE_ENV_LOBES_ADAPTIVE_C121, LOBE_ENV_LOBES_ADAPTIVE_C122,
                     LOBE_ENV_LOBES_ADAPTIVE_C123, LOBE_ENV_LOBES_ADAPTIVE_C124, LOBE_ENV_LOBES_ADAPTIVE_C125,
                     LOBE_ENV_LOBES_ADAPTIVE_C126, LOBE_ENV_LOBES_ADAPTIVE_C127, LOBE_ENV_LOBES_ADAPTIVE_C128);
    LOBE_LET wide2 =
        lobe_env_gated(gate, wide_sum2, LOBE_ENV_LOBES_ADAPTIVE_C129, LOBE_ENV_LOBES_ADAPTIVE_C130,
                       LOBE_ENV_LOBES_ADAPTIVE_C131, LOBE_ENV_LOBES_ADAPTIVE_C132, LOBE_ENV_LOBES_ADAPTIVE_C133);
    LOBE_LET part_sum2 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C134, LOBE_ENV_LOBES_ADAPTIVE_C135, LOBE_ENV_LOBES_ADAPTIVE_C136,
                     LOBE_ENV_LOBES_ADAPTIVE_C137, LOBE_ENV_LOBES_ADAPTIVE_C138, LOBE_ENV_LOBES_ADAPTIVE_C139,
                     LOBE_ENV_LOBES_ADAPTIVE_C140, LOBE_ENV_LOBES_ADAPTIVE_C141, LOBE_ENV_LOBES_ADAPTIVE_C142,
                     LOBE_ENV_LOBES_ADAPTIVE_C143, LOBE_ENV_LOBES_ADAPTIVE_C144, LOBE_ENV_LOBES_ADAPTIVE_C145);
    LOBE_LET part2 =
        lobe_env_gated(gate, part_sum2, LOBE_ENV_LOBES_ADAPTIVE_C146, LOBE_ENV_LOBES_ADAPTIVE_C147,
                       LOBE_ENV_LOBES_ADAPTIVE_C148, LOBE_ENV_LOBES_ADAPTIVE_C149, LOBE_ENV_LOBES_ADAPTIVE_C150);
    LOBE_LET shift_sum3 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C151, LOBE_ENV_LOBES_ADAPTIVE_C152, LOBE_ENV_LOBES_ADAPTIVE_C153,
                     LOBE_ENV_LOBES_ADAPTIVE_C154, LOBE_ENV_LOBES_ADAPTIVE_C155, LOBE_ENV_LOBES_ADAPTIVE_C156,
                     LOBE_ENV_LOBES_ADAPTIVE_C157, LOBE_ENV_LOBES_ADAPTIVE_C158, LOBE_ENV_LOBES_ADAPTIVE_C159,
                     LOBE_ENV_LOBES_ADAPTIVE_C160, LOBE_ENV_LOBES_ADAPTIVE_C161, LOBE_ENV_LOBES_ADAPTIVE_C162);
    LOBE_LET shift3 =
        lobe_env_gated(gate, shift_sum3, LOBE_ENV_LOBES_ADAPTIVE_C163, LOBE_ENV_LOBES_ADAPTIVE_C164,
                       LOBE_ENV_LOBES_ADAPTIVE_C165, LOBE_ENV_LOBES_ADAPTIVE_C166, LOBE_ENV_LOBES_ADAPTIVE_C167);
    LOBE_LET wide_sum3 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C168, LOBE_ENV_LOBES_ADAPTIVE_C169, LOBE_ENV_LOBES_ADAPTIVE_C170,
                     LOBE_ENV_LOBES_ADAPTIVE_C171, LOBE_ENV_LOBES_ADAPTIVE_C172, LOBE_ENV_LOBES_ADAPTIVE_C173,
                     LOBE_ENV_LOBES_ADAPTIVE_C174, LOBE_ENV_LOBES_ADAPTIVE_C175, LOBE_ENV_LOBES_ADAPTIVE_C176,
                     LOBE_ENV_LOBES_ADAPTIVE_C177, LOBE_ENV_LOBES_ADAPTIVE_C178, LOBE_ENV_LOBES_ADAPTIVE_C179);
    LOBE_LET wide3 =
        lobe_env_gated(gate, wide_sum3, LOBE_ENV_LOBES_ADAPTIVE_C180, LOBE_ENV_LOBES_ADAPTIVE_C181,
                       LOBE_ENV_LOBES_ADAPTIVE_C182, LOBE_ENV_LOBES_ADAPTIVE_C183, LOBE_ENV_LOBES_ADAPTIVE_C184);
    LOBE_LET part_sum3 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C185, LOBE_ENV_LOBES_ADAPTIVE_C186, LOBE_ENV_LOBES_ADAPTIVE_C187,
                     LOBE_ENV_LOBES_ADAPTIVE_C188, LOBE_ENV_LOBES_ADAPTIVE_C189, LOBE_ENV_LOBES_ADAPTIVE_C190,
                     LOBE_ENV_LOBES_ADAPTIVE_C191, LOBE_ENV_LOBES_ADAPTIVE_C192, LOBE_ENV_LOBES_ADAPTIVE_C193,
                     LOBE_ENV_LOBES_ADAPTIVE_C194, LOBE_ENV_LOBES_ADAPTIVE_C195, LOBE_ENV_LOBES_ADAPTIVE_C196);
    LOBE_LET part3 =
        lobe_env_gated(gate, part_sum3, LOBE_ENV_LOBES_ADAPTIVE_C197, LOBE_ENV_LOBES_ADAPTIVE_C198,
                       LOBE_ENV_LOBES_ADAPTIVE_C199, LOBE_ENV_LOBES_ADAPTIVE_C200, LOBE_ENV_LOBES_ADAPTIVE_C201);
    LOBE_LET shift_sum4 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C202, LOBE_ENV_LOBES_ADAPTIVE_C203, LOBE_ENV_LOBES_ADAPTIVE_C204,
                     LOBE_ENV_LOBES_ADAPTIVE_C205, LOBE_ENV_LOBES_ADAPTIVE_C206, LOBE_ENV_LOBES_ADAPTIVE_C207,
                     LOBE_ENV_LOBES_ADAPTIVE_C208, LOBE_ENV_LOBES_ADAPTIVE_C209, LOBE_ENV_LOBES_ADAPTIVE_C210,
                     LOBE_ENV_LOBES_ADAPTIVE_C211, LOBE_ENV_LOBES_ADAPTIVE_C212, LOBE_ENV_LOBES_ADAPTIVE_C213);
    LOBE_LET shift4 =
        lobe_env_gated(gate, shift_sum4, LOBE_ENV_LOBES_ADAPTIVE_C214, LOBE_ENV_LOBES_ADAPTIVE_C215,
                       LOBE_ENV_LOBES_ADAPTIVE_C216, LOBE_ENV_LOBES_ADAPTIVE_C217, LOBE_ENV_LOBES_ADAPTIVE_C218);
    LOBE_LET wide_sum4 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C219, LOBE_ENV_LOBES_ADAPTIVE_C220, LOBE_ENV_LOBES_ADAPTIVE_C221,
                     LOBE_ENV_LOBES_ADAPTIVE_C222, LOBE_ENV_LOBES_ADAPTIVE_C223, LOBE_ENV_LOBES_ADAPTIVE_C224,
                     LOBE_ENV_LOBES_ADAPTIVE_C225, LOBE_ENV_LOBES_ADAPTIVE_C226, LOBE_ENV_LOBES_ADAPTIVE_C227,
                     LOBE_ENV_LOBES_ADAPTIVE_C228, LOBE_ENV_LOBES_ADAPTIVE_C229, LOBE_ENV_LOBES_ADAPTIVE_C230);
    LOBE_LET wide4 =
        lobe_env_gated(gate, wide_sum4, LOBE_ENV_LOBES_ADAPTIVE_C231, LOBE_ENV_LOBES_ADAPTIVE_C232,
                       LOBE_ENV_LOBES_ADAPTIVE_C233, LOBE_ENV_LOBES_ADAPTIVE_C234, LOBE_ENV_LOBES_ADAPTIVE_C235);
    LOBE_LET part_sum4 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C236, LOBE_ENV_LOBES_ADAPTIVE_C237, LOBE_ENV_LOBES_ADAPTIVE_C238,
                     LOBE_ENV_LOBES_ADAPTIVE_C239, LOBE_ENV_LOBES_ADAPTIVE_C240, LOBE_ENV_LOBES_ADAPTIVE_C241,
                     LOBE_ENV_LOBES_ADAPTIVE_C242, LOBE_ENV_LOBES_ADAPTIVE_C243, LOBE_ENV_LOBES_ADAPTIVE_C244,
                     LOBE_ENV_LOBES_ADAPTIVE_C245, LOBE_ENV_LOBES_ADAPTIVE_C246, LOBE_ENV_LOBES_ADAPTIVE_C247);
    LOBE_LET part4 =
        lobe_env_gated(gate, part_sum4, LOBE_ENV_LOBES_ADAPTIVE_C248, LOBE_ENV_LOBES_ADAPTIVE_C249,
                       LOBE_ENV_LOBES_ADAPTIVE_C250, LOBE_ENV_LOBES_ADAPTIVE_C251, LOBE_ENV_LOBES_ADAPTIVE_C252);
    LOBE_LET shift_sum5 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C253, LOBE_ENV_LOBES_ADAPTIVE_C254, LOBE_ENV_LOBES_ADAPTIVE_C255,
                     LOBE_ENV_LOBES_ADAPTIVE_C256, LOBE_ENV_LOBES_ADAPTIVE_C257, LOBE_ENV_LOBES_ADAPTIVE_C258,
                     LOBE_ENV_LOBES_ADAPTIVE_C259, LOBE_ENV_LOBES_ADAPTIVE_C260, LOBE_ENV_LOBES_ADAPTIVE_C261,
                     LOBE_ENV_LOBES_ADAPTIVE_C262, LOBE_ENV_LOBES_ADAPTIVE_C263, LOBE_ENV_LOBES_ADAPTIVE_C264);
    LOBE_LET shift5 =
        lobe_env_gated(gate, shift_sum5, LOBE_ENV_LOBES_ADAPTIVE_C265, LOBE_ENV_LOBES_ADAPTIVE_C266,
                       LOBE_ENV_LOBES_ADAPTIVE_C267, LOBE_ENV_LOBES_ADAPTIVE_C268, LOBE_ENV_LOBES_ADAPTIVE_C269);
    LOBE_LET wide_sum5 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C270, LOBE_ENV_LOBES_ADAPTIVE_C271, LOBE_ENV_LOBES_ADAPTIVE_C272,
                     LOBE_ENV_LOBES_ADAPTIVE_C273, LOBE_ENV_LOBES_ADAPTIVE_C274, LOBE_ENV_LOBES_ADAPTIVE_C275,
                     LOBE_ENV_LOBES_ADAPTIVE_C276, LOBE_ENV_LOBES_ADAPTIVE_C277, LOBE_ENV_LOBES_ADAPTIVE_C278,
                     LOBE_ENV_LOBES_ADAPTIVE_C279, LOBE_ENV_LOBES_ADAPTIVE_C280, LOBE_ENV_LOBES_ADAPTIVE_C281);
    LOBE_LET wide5 =
        lobe_env_gated(gate, wide_sum5, LOBE_ENV_LOBES_ADAPTIVE_C282, LOBE_ENV_LOBES_ADAPTIVE_C283,
                       LOBE_ENV_LOBES_ADAPTIVE_C284, LOBE_ENV_LOBES_ADAPTIVE_C285, LOBE_ENV_LOBES_ADAPTIVE_C286);
    LOBE_LET part_sum5 =
        lobe_env_sum(at, LOBE_ENV_LOBES_ADAPTIVE_C287, LOBE_ENV_LOBES_ADAPTIVE_C288, LOBE_ENV_LOBES_ADAPTIVE_C289,
                     LOBE_ENV_LOBES_ADAPTIVE_C290, LOBE_ENV_LOBES_ADAPTIVE_C291, LOBE_ENV_LOBES_ADAPTIVE_C292,
                     LOBE_ENV_LOBES_ADAPTIVE_C293, LOBE_ENV_LOBES_ADAPTIVE_C294, LOBE_ENV_LOBES_ADAPTIVE_C295,
                     LOBE_ENV_LOBES_ADAPTIVE_C296, LOBE_ENV_LOBES_ADAPTIVE_C297, LOBE_ENV_LOBES_ADAPTIVE_C298);
    LOBE_LET part5 =
        lobe_env_gated(gate, part_sum5, LOBE_ENV_LOBES_ADAPTIVE_C299, LOBE_ENV_LOBES_ADAPTIVE_C300,
                       LOBE_ENV_LOBES_ADAPTIVE_C301, LOBE_ENV_LOBES_ADAPTIVE_C302, LOBE_ENV_LOBES_ADAPTIVE_C303);
    LOBE_LET s1 = lobe_select(gate.g1, shift1, shift0);
    LOBE_LET l1 = lobe_select(gate.g1, wide1, wide0);
    LOBE_LET s2 = lobe_select(gate.g2, shift2, shift0);
    LOBE_LET l2 = lobe_select(gate.g2, wide2, wide0);
    LOBE_LET s3 = lobe_select(gate.g3, shift3, shift0);
    LOBE_LET l3 = lobe_select(gate.g3, wide3, wide0);
    LOBE_LET s4 = lobe_select(gate.g4, shift4, shift0);
    LOBE_LET l4 = lobe_select(gate.g4, wide4, wide0);
    LOBE_LET s5 = lobe_select(gate.g5, shift5, shift0);
    LOBE_LET l5 = lobe_select(gate.g5, wide5, wide0);
    LOBE_LET w1 = e * (gate.g1 * part1);
    LOBE_LET w2 = e * (gate.g2 * part2);
    LOBE_LET w3 = e * (gate.g3 * part3);
    LOBE_LET w4 = e * (gate.g4 * part4);
    LOBE_LET w5 = e * (gate.g5 * part5);
    LOBE_LET w0 = e - (w1 + w2 + w3 + w4 + w5);
    lobe_env_fan6 fan;
    fan.t0 = lobe_env_tap_of(at, shift0, wide0, w0);
    fan.t1 = lobe_env_tap_of(at, s1, l1, w1);
    fan.t2 = lobe_env_tap_of(at, s2, l2, w2);
    fan.t3 = lobe_env_tap_of(at, s3, l3, w3);
    fan.t4 = lobe_env_tap_of(at, s4, l4, w4);
    fan.t5 = lobe_env_tap_of(at, s5, l5, w5);
    return fan;
}

#endif
