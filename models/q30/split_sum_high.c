/* Generated, not edited: lobefit emit split_sum --tier high --to q30
 * Digest of the formula with its coefficients: 6169d0a67d15d7ac (FNV-1a 64 of `lobefit emit --to c`).
 *
 * split_sum, high, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   9.32e-08 (2^-23.4) in scale at 0x40000000 0x0271e427: got 0x35b400b8, want 0.839111406269.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   1.14e-07 (2^-23.1) in scale at 0x40000000 0x000007c4: got 0x3d0d171f, want 0.953923855546.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 1.31e-05 over
 * [.02, 1] and 1.73e-05 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30_log2.h"

lobe_dfg_q30 lobe_split_sum_high_q30(int32_t roughness, int32_t n_dot_v)
{
    const int32_t r = lobe_q_saturate(roughness);
    const int32_t v = lobe_q_saturate(n_dot_v);
    /* v / (v + k r^2) keeps its value when r grows by 8 and v by 64: that keeps its precision near 0. */
    int32_t r_up = r, v_up = v;
    int up = 0;
    while (up < 18 && r_up < 1 << 27 && v_up < 1 << 24) {
        r_up <<= 3;
        v_up <<= 6;
        up += 6;
    }
    const int32_t t2 = lobe_q_shift_right(v_up, 1);        /* Q29 */
    const int32_t t3 = 281474977 >> (18 - up);             /* Q30 */
    const int32_t t5 = lobe_q_mul(r_up, r_up, 30);         /* Q30 */
    const int32_t t6 = t3 + t5;                            /* Q30 */
    const int32_t t7 = lobe_q_shift_right(t6, up);         /* Q30 */
    const int32_t t9 = lobe_q_mul(t7, 1090674947, 31);     /* Q29 */
    const int32_t t11 = t9 + 1061113665;                   /* Q29 */
    const int32_t t12 = lobe_q_mul(t6, t11, 30);           /* Q29 */
    const int32_t t13 = t2 + t12;                          /* Q29 */
    const lobe_q_inverse t14 = lobe_q_reciprocal(t13);     /* mantissa and shift */
    const int32_t t15 = lobe_q_ratio(t2, t14);             /* Q30 */
    const int32_t t16 = 1073741824 - t15;                  /* Q30 */
    const int32_t t17 = lobe_q_mul(t15, t16, 30);          /* Q30 */
    const int32_t t18 = lobe_q_mul(t15, t15, 30);          /* Q30 */
    const int32_t t19 = lobe_q_mul(t18, t18, 30);          /* Q30 */
    const int32_t t21 = lobe_q_mul(t15, 908543041, 31);    /* Q24 */
    const int32_t t23 = t21 - 1728254088;                  /* Q24 */
    const int32_t t24 = lobe_q_mul(t15, t23, 31);          /* Q23 */
    const int32_t t26 = t24 + 1399643137;                  /* Q23 */
    const int32_t t27 = lobe_q_mul(t15, t26, 29);          /* Q24 */
    const int32_t t29 = t27 - 1531846145;                  /* Q24 */
    const int32_t t30 = lobe_q_mul(t19, t29, 29);          /* Q25 */
    const int32_t t32 = t30 + 13459968;                    /* Q25 */
    const int32_t t34 = lobe_q_mul(t18, -997187777, 31);   /* Q27 */
    const int32_t t36 = t34 + 521149055;                   /* Q27 */
    const int32_t t37 = lobe_q_mul(t15, t36, 31);          /* Q26 */
    const int32_t t39 = lobe_q_mul(t19, 1314490752, 30);   /* Q27 */
    const int32_t t41 = t39 - 6355799;                     /* Q27 */
    const int32_t t43 = lobe_q_mul(t15, -1955248257, 30);  /* Q25 */
    const int32_t t45 = t43 + 1639737473;                  /* Q25 */
    const int32_t t46 = lobe_q_mul(t15, t45, 29);          /* Q26 */
    const int32_t t48 = t46 - 1501983873;                  /* Q26 */
    const int32_t t49 = lobe_q_mul(t18, t48, 31);          /* Q25 */
    const int32_t t51 = t49 - 61069720;                    /* Q25 */
    const int32_t t53 = lobe_q_mul(t18, 1505417089, 30);   /* Q25 */
    const int32_t t55 = t53 - 32076820;                    /* Q25 */
    const int32_t t57 = lobe_q_mul(t18, -1170708609, 30);  /* Q25 */
    const int32_t t59 = t57 - 24286096;                    /* Q25 */
    const int32_t t61 = lobe_q_mul(t15, 434690336, 31);    /* Q26 */
    const int32_t t62 = lobe_q_mul(t7, t61, 31);           /* Q25 */
    const int32_t t63 = t59 + t62;                         /* Q25 */
    const int32_t t64 = lobe_q_mul(t7, t63, 30);           /* Q25 */
    const int32_t t65 = t55 + t64;                         /* Q25 */
    const int32_t t66 = lobe_q_mul(t7, t65, 30);           /* Q25 */
    const int32_t t67 = t51 + t66;                         /* Q25 */
    const int32_t t68 = lobe_q_mul(t7, t67, 28);           /* Q27 */
    const int32_t t69 = t41 + t68;                         /* Q27 */
    const int32_t t70 = lobe_q_mul(t7, t69, 31);           /* Q26 */
    const int32_t t71 = t37 + t70;                         /* Q26 */
    const int32_t t72 = lobe_q_mul(t7, t71, 31);           /* Q25 */
    const int32_t t73 = t32 + t72;                         /* Q25 */
    const int32_t t74 = lobe_q_mul(t7, t7, 30);            /* Q30 */
    const int32_t t76 = lobe_q_mul(t74, -95354416, 31);    /* Q27 */
    const int32_t t78 = t76 - 228855056;                   /* Q27 */
    const int32_t t79 = lobe_q_mul(t74, t78, 31);          /* Q26 */
    const int32_t t81 = lobe_q_mul(t7, -417031489, 31);    /* Q27 */
    const int32_t t83 = t81 - 88146568;                    /* Q27 */
    const int32_t t84 = lobe_q_mul(t74, t83, 31);          /* Q26 */
    const int32_t t86 = t84 - 14210211;                    /* Q26 */
    const int32_t t88 = lobe_q_mul(t7, -1737657984, 31);   /* Q27 */
    const int32_t t90 = t88 + 882596288;                   /* Q27 */
    const int32_t t91 = lobe_q_mul(t7, t90, 31);           /* Q26 */
    const int32_t t93 = lobe_q_mul(t18, -1859871358, 30);  /* Q26 */
    const int32_t t94 = t91 + t93;                         /* Q26 */
    const int32_t t95 = lobe_q_mul(t15, t94, 30);          /* Q26 */
    const int32_t t96 = t86 + t95;                         /* Q26 */
    const int32_t t97 = lobe_q_mul(t15, t96, 30);          /* Q26 */
    const int32_t t98 = t79 + t97;                         /* Q26 */
    const int32_t t100 = lobe_q_max(t15, 1074);            /* Q30 */
    const int32_t t101 = lobe_q_log2(t100) - 2013265920;   /* Q26 */
    const int32_t t102 = lobe_q_mul(t98, t101, 27);        /* Q25 */
    const int32_t t103 = t73 + t102;                       /* Q25 */
    const int32_t t104 = lobe_q_mul(t17, t103, 25);        /* Q30 */
    const int32_t t105 = 1073741824 - t104;                /* Q30 */
    const int32_t t106 = lobe_q_min(t105, 1073741824);     /* Q30 */
    const int32_t t107 = lobe_q_shift_right(t13, up);      /* Q29 */
    const int32_t t109 = lobe_q_mul(t15, 1681092097, 31);  /* Q29 */
    const int32_t t111 = t109 - 1455933054;                /* Q29 */
    const int32_t t112 = lobe_q_mul(t18, t111, 29);        /* Q30 */
    const int32_t t114 = t112 - 259252560;                 /* Q30 */
    const int32_t t115 = lobe_q_mul(t15, t114, 31);        /* Q29 */
    const int32_t t117 = t115 + 1959937663;                /* Q29 */
    const int32_t t118 = lobe_q_mul(t18, t117, 30);        /* Q29 */
    const int32_t t120 = t118 - 2001143681;                /* Q29 */
    const int32_t t121 = lobe_q_mul(t15, t120, 30);        /* Q29 */
    const int32_t t123 = t121 + 1323475328;                /* Q29 */
    const int32_t t126 = lobe_q_mul(t15, 1169286399, 30);  /* Q28 */
    const int32_t t128 = t126 - 532600257;                 /* Q28 */
    const int32_t t129 = lobe_q_mul(t15, t128, 31);        /* Q27 */
    const int32_t t131 = t129 - 1352297471;                /* Q27 */
    const int32_t t132 = lobe_q_mul(t18, t131, 31);        /* Q26 */
    const int32_t t134 = t132 + 1229603711;                /* Q26 */
    const int32_t t135 = lobe_q_mul(t15, t134, 29);        /* Q27 */
    const int32_t t137 = t135 - 1435612294;                /* Q27 */
    const int32_t t139 = lobe_q_mul(t15, -1648804863, 31); /* Q27 */
    const int32_t t141 = t139 + 1913543678;                /* Q27 */
    const int32_t t142 = lobe_q_mul(t18, t141, 31);        /* Q26 */
    const int32_t t144 = t142 + 455989088;                 /* Q26 */
    const int32_t t145 = lobe_q_mul(t15, t144, 31);        /* Q25 */
    const int32_t t147 = t145 - 1421658623;                /* Q25 */
    const int32_t t148 = lobe_q_mul(t15, t147, 29);        /* Q26 */
    const int32_t t150 = t148 + 1967350525;                /* Q26 */
    const int32_t t152 = lobe_q_mul(t15, -1513993340, 30); /* Q27 */
    const int32_t t154 = t152 + 1214225664;                /* Q27 */
    const int32_t t155 = lobe_q_mul(t15, t154, 31);        /* Q26 */
    const int32_t t157 = t155 - 704305025;                 /* Q26 */
    const int32_t t158 = lobe_q_mul(t15, t157, 31);        /* Q25 */
    const int32_t t160 = t158 + 1846424449;                /* Q25 */
    const int32_t t161 = lobe_q_mul(t15, t160, 30);        /* Q25 */
    const int32_t t163 = t161 - 1822366975;                /* Q25 */
    const int32_t t165 = lobe_q_mul(t15, -1239673215, 31); /* Q24 */
    const int32_t t167 = t165 + 1085712896;                /* Q24 */
    const int32_t t169 = lobe_q_mul(t15, 383931936, 31);   /* Q26 */
    const int32_t t171 = t169 + 668224192;                 /* Q26 */
    const int32_t t172 = lobe_q_mul(t15, t171, 31);        /* Q25 */
    const int32_t t174 = t172 - 1577574143;                /* Q25 */
    const int32_t t176 = lobe_q_mul(r, -431209600, 31);    /* Q26 */
    const int32_t t178 = t176 + 1267966077;                /* Q26 */
    const int32_t t179 = lobe_q_mul(r, t178, 31);          /* Q25 */
    const int32_t t180 = t174 + t179;                      /* Q25 */
    const int32_t t181 = lobe_q_mul(r, t180, 31);          /* Q24 */
    const int32_t t182 = t167 + t181;                      /* Q24 */
    const int32_t t183 = lobe_q_mul(r, t182, 29);          /* Q25 */
    const int32_t t184 = t163 + t183;                      /* Q25 */
    const int32_t t185 = lobe_q_mul(r, t184, 29);          /* Q26 */
    const int32_t t186 = t150 + t185;                      /* Q26 */
    const int32_t t187 = lobe_q_mul(r, t186, 29);          /* Q27 */
    const int32_t t188 = t137 + t187;                      /* Q27 */
    const int32_t t189 = lobe_q_mul(r, t188, 28);          /* Q29 */
    const int32_t t190 = t123 + t189;                      /* Q29 */
    const int32_t t191 = lobe_q_mul(t107, t190, 28);       /* Q30 */
    const int32_t t192 = 1073741824 - t191;                /* Q30 */
    const int32_t t193 = lobe_q_max(t192, 0);              /* Q30 */
    const int32_t t194 = lobe_q_mul(t193, t193, 30);       /* Q30 */
    const int32_t t195 = lobe_q_mul(t194, t194, 29);       /* Q31 */
    const int32_t t196 = lobe_q_mul(t193, t195, 30);       /* Q31 */
    const int32_t t197 = lobe_q_mul(t106, t196, 31);       /* Q30 */
    const int32_t t198 = t106 - t197;                      /* Q30 */
    lobe_dfg_q30 d;
    d.scale = t198;
    d.bias = t197;
    return d;
}

void lobe_split_sum_high_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                               size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        const lobe_dfg_q30 d = lobe_split_sum_high_q30(roughness[i], n_dot_v[i]);
        scale[i] = d.scale;
        bias[i] = d.bias;
    }
}
