/* Generated, not edited: lobefit emit energy --tier high --to q30
 * Digest of the formula with its coefficients: 16b3cfa1ef5b3e75 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * energy, high, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   1.78e-08 (2^-25.7) in energy at 0x05051850 0x0147ae14: got 0x3cd7af7a, want 0.950664377687.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   1.63e-08 (2^-25.9) in energy at 0x00169697 0x000010f1: got 0x3ac0ef34, want 0.918025764133.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 4.33e-06 over
 * [.02, 1] and 1.52e-05 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"

int32_t lobe_energy_high_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    /* v / (v + k r^2) keeps its value when r grows by 8 and v by 64: that keeps its precision near 0. */
    int32_t r_up = r, v_up = v;
    int up = 0;
    while (up < 30 && r_up < 1 << 27 && v_up < 1 << 24) {
        r_up <<= 3;
        v_up <<= 6;
        up += 6;
    }
    const int32_t t4 = lobe_q_mul(r_up, r_up, 30);                           /* Q30 */
    const int32_t t6 = lobe_q_mul(t4, 1205939199, 31);                       /* Q30 */
    const int32_t t7 = v_up + t6;                                            /* Q30 */
    const lobe_q_inverse t8 = lobe_q_reciprocal(t7);                         /* mantissa and shift */
    const int32_t t9 = lobe_q_ratio(v_up, t8);                               /* Q30 */
    const int32_t t11 = t9 - 536870912;                                      /* Q29 */
    const int32_t t22 = lobe_q_mul(t11, 1509195775, 30);                     /* Q28 */
    const int32_t t23 = 958879616 + t22;                                     /* Q28 */
    const int32_t t24 = lobe_q_mul(t11, t23, 29);                            /* Q28 */
    const int32_t t25 = -394670496 + t24;                                    /* Q28 */
    const int32_t t26 = lobe_q_mul(t11, t25, 29);                            /* Q28 */
    const int32_t t27 = -976163520 + t26;                                    /* Q28 */
    const int32_t t28 = lobe_q_mul(t11, t27, 28);                            /* Q29 */
    const int32_t t29 = -690620159 + t28;                                    /* Q29 */
    const int32_t t30 = lobe_q_mul(t11, t29, 29);                            /* Q29 */
    const int32_t t31 = -147987616 + t30;                                    /* Q29 */
    const int32_t t32 = lobe_q_mul(t11, t31, 28);                            /* Q30 */
    const int32_t t33 = -34633500 + t32;                                     /* Q30 */
    const int32_t t34 = lobe_q_mul(t11, t33, 29);                            /* Q30 */
    const int32_t t35 = 737443072 + t34;                                     /* Q30 */
    const int32_t t36 = lobe_q_mul(t11, t35, 29);                            /* Q30 */
    const int32_t t37 = 1553578491 + t36;                                    /* Q30 */
    const int32_t t38 = lobe_q_mul(t11, t37, 30);                            /* Q29 */
    const int32_t t39 = 828296383 + t38;                                     /* Q29 */
    const int32_t t40 = lobe_q_mul(t11, t39, 31);                            /* Q27 */
    const int32_t t41 = 176642432 + t40;                                     /* Q27 */
    const int32_t t42 = lobe_q_shift_right(t4, up);                          /* Q30 */
    const int32_t t44 = t42 - 536870912;                                     /* Q29 */
    const int32_t t56 = lobe_q_mul(t11, 1360119935, 30);                     /* Q27 */
    const int32_t t57 = 519010912 + t56;                                     /* Q27 */
    const int32_t t58 = lobe_q_mul(t11, t57, 29);                            /* Q27 */
    const int32_t t59 = -824319233 + t58;                                    /* Q27 */
    const int32_t t60 = lobe_q_mul(t11, t59, 29);                            /* Q27 */
    const int32_t t61 = -910183616 + t60;                                    /* Q27 */
    const int32_t t62 = lobe_q_mul(t11, t61, 28);                            /* Q28 */
    const int32_t t63 = -28147506 + t62;                                     /* Q28 */
    const int32_t t64 = lobe_q_mul(t11, t63, 29);                            /* Q28 */
    const int32_t t65 = 731202369 + t64;                                     /* Q28 */
    const int32_t t66 = lobe_q_mul(t11, t65, 28);                            /* Q29 */
    const int32_t t67 = 1710737534 + t66;                                    /* Q29 */
    const int32_t t68 = lobe_q_mul(t11, t67, 30);                            /* Q28 */
    const int32_t t69 = 891119423 + t68;                                     /* Q28 */
    const int32_t t70 = lobe_q_mul(t11, t69, 30);                            /* Q27 */
    const int32_t t71 = 457762656 + t70;                                     /* Q27 */
    const int32_t t72 = lobe_q_mul(t11, t71, 29);                            /* Q27 */
    const int32_t t73 = 365765440 + t72;                                     /* Q27 */
    const int32_t t74 = lobe_q_mul(t11, t73, 29);                            /* Q27 */
    const int32_t t75 = 271793056 + t74;                                     /* Q27 */
    const int32_t t83 = lobe_q_mul(t11, 1232492674, 30);                     /* Q28 */
    const int32_t t84 = 1506404736 + t83;                                    /* Q28 */
    const int32_t t85 = lobe_q_mul(t11, t84, 30);                            /* Q27 */
    const int32_t t86 = 874139329 + t85;                                     /* Q27 */
    const int32_t t87 = lobe_q_mul(t11, t86, 30);                            /* Q26 */
    const int32_t t88 = 356352736 + t87;                                     /* Q26 */
    const int32_t t89 = lobe_q_mul(t11, t88, 29);                            /* Q26 */
    const int32_t t90 = 268391632 + t89;                                     /* Q26 */
    const int32_t t91 = lobe_q_mul(t11, t90, 29);                            /* Q26 */
    const int32_t t92 = 179624096 + t91;                                     /* Q26 */
    const int32_t t93 = lobe_q_mul(t11, t92, 29);                            /* Q26 */
    const int32_t t94 = 92968200 + t93;                                      /* Q26 */
    const int32_t t103 = lobe_q_mul(t11, 1552376703, 31);                    /* Q26 */
    const int32_t t104 = 818491455 + t103;                                   /* Q26 */
    const int32_t t105 = lobe_q_mul(t11, t104, 29);                          /* Q26 */
    const int32_t t106 = 664935936 + t105;                                   /* Q26 */
    const int32_t t107 = lobe_q_mul(t11, t106, 30);                          /* Q25 */
    const int32_t t108 = 205169696 + t107;                                   /* Q25 */
    const int32_t t109 = lobe_q_mul(t11, t108, 29);                          /* Q25 */
    const int32_t t110 = 159034240 + t109;                                   /* Q25 */
    const int32_t t111 = lobe_q_mul(t11, t110, 29);                          /* Q25 */
    const int32_t t112 = 104159432 + t111;                                   /* Q25 */
    const int32_t t113 = lobe_q_mul(t11, t112, 29);                          /* Q25 */
    const int32_t t114 = 52244712 + t113;                                    /* Q25 */
    const int32_t t115 = lobe_q_mul(t11, t114, 29);                          /* Q25 */
    const int32_t t116 = 14916240 + t115;                                    /* Q25 */
    const int32_t t132 = lobe_q_mul(t11, 1356495238, 29);                    /* Q27 */
    const int32_t t133 = -498344736 + t132;                                  /* Q27 */
    const int32_t t134 = lobe_q_mul(t11, t133, 30);                          /* Q26 */
    const int32_t t135 = -1991142013 + t134;                                 /* Q26 */
    const int32_t t136 = lobe_q_mul(t11, t135, 29);                          /* Q26 */
    const int32_t t137 = 531713056 + t136;                                   /* Q26 */
    const int32_t t138 = lobe_q_mul(t11, t137, 30);                          /* Q25 */
    const int32_t t139 = 1197639168 + t138;                                  /* Q25 */
    const int32_t t140 = lobe_q_mul(t11, t139, 28);                          /* Q26 */
    const int32_t t141 = -373723136 + t140;                                  /* Q26 */
    const int32_t t142 = lobe_q_mul(t11, t141, 29);                          /* Q26 */
    const int32_t t143 = -1472098558 + t142;                                 /* Q26 */
    const int32_t t144 = lobe_q_mul(t11, t143, 28);                          /* Q27 */
    const int32_t t145 = 698769088 + t144;                                   /* Q27 */
    const int32_t t146 = lobe_q_mul(t11, t145, 30);                          /* Q26 */
    const int32_t t147 = 1182041471 + t146;                                  /* Q26 */
    const int32_t t148 = lobe_q_mul(t11, t147, 29);                          /* Q26 */
    const int32_t t149 = 724429631 + t148;                                   /* Q26 */
    const int32_t t150 = lobe_q_mul(t11, t149, 29);                          /* Q26 */
    const int32_t t151 = 294788096 + t150;                                   /* Q26 */
    const int32_t t152 = lobe_q_mul(t11, t151, 30);                          /* Q25 */
    const int32_t t153 = 81904816 + t152;                                    /* Q25 */
    const int32_t t154 = lobe_q_mul(t11, t153, 29);                          /* Q25 */
    const int32_t t155 = 56469084 + t154;                                    /* Q25 */
    const int32_t t156 = lobe_q_mul(t11, t155, 29);                          /* Q25 */
    const int32_t t157 = 25431582 + t156;                                    /* Q25 */
    const int32_t t158 = lobe_q_mul(t11, t157, 29);                          /* Q25 */
    const int32_t t159 = 5961244 + t158;                                     /* Q25 */
    const int32_t t167 = lobe_q_mul(t11, 1093703039, 30);                    /* Q28 */
    const int32_t t168 = 1323780864 + t167;                                  /* Q28 */
    const int32_t t169 = lobe_q_mul(t11, t168, 30);                          /* Q27 */
    const int32_t t170 = 497929280 + t169;                                   /* Q27 */
    const int32_t t171 = lobe_q_mul(t11, t170, 29);                          /* Q27 */
    const int32_t t172 = 157173456 + t171;                                   /* Q27 */
    const int32_t t173 = lobe_q_mul(t11, t172, 29);                          /* Q27 */
    const int32_t t174 = 58903392 + t173;                                    /* Q27 */
    const int32_t t175 = lobe_q_mul(t11, t174, 29);                          /* Q27 */
    const int32_t t176 = 29134672 + t175;                                    /* Q27 */
    const int32_t t177 = lobe_q_mul(t11, t176, 29);                          /* Q27 */
    const int32_t t178 = 5189494 + t177;                                     /* Q27 */
    const int32_t t184 = lobe_q_mul(t11, 1259225471, 30);                    /* Q30 */
    const int32_t t185 = 659261951 + t184;                                   /* Q30 */
    const int32_t t186 = lobe_q_mul(t11, t185, 29);                          /* Q30 */
    const int32_t t187 = 127823896 + t186;                                   /* Q30 */
    const int32_t t188 = lobe_q_mul(t11, t187, 29);                          /* Q30 */
    const int32_t t189 = 5201314 + t188;                                     /* Q30 */
    const int32_t t190 = lobe_q_mul(t11, t189, 30);                          /* Q29 */
    const int32_t t191 = 5311646 + t190;                                     /* Q29 */
    const int32_t t192 = lobe_q_mul(t44, t191, 31);                          /* Q27 */
    const int32_t t193 = t178 + t192;                                        /* Q27 */
    const int32_t t194 = lobe_q_mul(t44, t193, 31);                          /* Q25 */
    const int32_t t195 = t159 + t194;                                        /* Q25 */
    const int32_t t196 = lobe_q_mul(t44, t195, 29);                          /* Q25 */
    const int32_t t197 = t116 + t196;                                        /* Q25 */
    const int32_t t198 = lobe_q_mul(t44, t197, 28);                          /* Q26 */
    const int32_t t199 = t94 + t198;                                         /* Q26 */
    const int32_t t200 = lobe_q_mul(t44, t199, 28);                          /* Q27 */
    const int32_t t201 = t75 + t200;                                         /* Q27 */
    const int32_t t202 = lobe_q_mul(t44, t201, 29);                          /* Q27 */
    const int32_t t203 = t41 + t202;                                         /* Q27 */
    const int32_t t204 = lobe_q_mul(t9, t9, 30);                             /* Q30 */
    const int32_t t205 = t9 - t204;                                          /* Q30 */
    const int32_t t206 = lobe_q_mul(t203, t205, 28);                         /* Q29 */
    const int32_t t207 = 536870912 + t206;                                   /* Q29 */
    const lobe_q_inverse t208 = lobe_q_reciprocal(t207);                     /* mantissa and shift */
    const int32_t t209 = lobe_q_shift_right(t208.mantissa, t208.shift - 58); /* Q29 */
    const int32_t t210 = lobe_q_min(t209, 536870912);                        /* Q29 */
    const int32_t t211 = t210 * 2;                                           /* Q30 */
    return t211;
}

void lobe_energy_high_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *e, size_t n)
{
    size_t i;
    for (i = 0; i < n; i++)
        e[i] = lobe_energy_high_q30(roughness[i], n_dot_v[i]);
}
