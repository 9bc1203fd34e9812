/* Generated, not edited: lobefit emit split_sum_sep --tier high --to q30
 * Digest of the formula with its coefficients: 6c7df974ae7dbde3 (FNV-1a 64 of `lobefit emit --to c`).
 *
 * split_sum_sep, high, in 32-bit integers: inputs Q30, held at [0, 1]; results Q30 in [0, 1]. Each local's scale
 * stands beside it. Every product and shift rounds to nearest, ties up.
 * Difference to the same formula in double over [.02, 1], 1024 x 1024 points:
 *   1.22e-07 (2^-23.0) in bias at 0x3f43a7f4 0x01d4f01d: got 0x012f9de6, want 0.018531420203.
 * Difference to the same formula in double over [0, 1], 511 x 511 points, uniform in the logarithm:
 *   1.29e-07 (2^-22.9) in scale at 0x3e1e1e1e 0x0000bc3c: got 0x274f403a, want 0.614211961149.
 * Proved by interval analysis: no value leaves 32 bits; the difference is at most 9.59e-06 over
 * [.02, 1] and 1.25e-05 over [0, 1]. */
#include "../lobe.h"
#include "../../core/q30.h"

lobe_dfg_q30 lobe_split_sum_sep_high_q30(int32_t roughness, int32_t n_dot_v)
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
    const int32_t t1 = 281474977 >> (18 - up);              /* Q30 */
    const int32_t t3 = lobe_q_mul(r_up, r_up, 30);          /* Q30 */
    const int32_t t4 = t1 + t3;                             /* Q30 */
    const int32_t t5 = lobe_q_shift_right(t4, up);          /* Q30 */
    const int32_t t7 = lobe_q_mul(t5, -792112128, 31);      /* Q32 */
    const int32_t t9 = t7 + 1732584194;                     /* Q32 */
    const int32_t t10 = lobe_q_mul(t5, t9, 31);             /* Q31 */
    const int32_t t12 = t10 - 1716240385;                   /* Q31 */
    const int32_t t13 = lobe_q_mul(t5, t12, 30);            /* Q31 */
    const int32_t t15 = t13 + 1773222657;                   /* Q31 */
    const int32_t t16 = lobe_q_mul(t5, t15, 30);            /* Q31 */
    const int32_t t18 = t16 - 34610008;                     /* Q31 */
    const int32_t t19 = lobe_q_mul(t5, t18, 31);            /* Q30 */
    const int32_t t21 = t19 + 69761448;                     /* Q30 */
    const int32_t t23 = lobe_q_shift_right(v_up, 2);        /* Q28 */
    const int32_t t25 = lobe_q_mul(t5, 1601509499, 31);     /* Q29 */
    const int32_t t27 = t25 + 1026670974;                   /* Q29 */
    const int32_t t28 = lobe_q_mul(t4, t27, 31);            /* Q28 */
    const int32_t t29 = t23 + t28;                          /* Q28 */
    const lobe_q_inverse t30 = lobe_q_reciprocal(t29);      /* mantissa and shift */
    const int32_t t31 = lobe_q_ratio(t23, t30);             /* Q30 */
    const int32_t t32 = lobe_q_mul(t5, t5, 30);             /* Q30 */
    const int32_t t34 = lobe_q_mul(t5, 667041280, 31);      /* Q30 */
    const int32_t t36 = t34 - 229475056;                    /* Q30 */
    const int32_t t37 = lobe_q_mul(t5, t36, 31);            /* Q29 */
    const int32_t t39 = t37 - 1437205890;                   /* Q29 */
    const int32_t t40 = lobe_q_mul(t5, t39, 31);            /* Q28 */
    const int32_t t42 = t40 + 1187118849;                   /* Q28 */
    const int32_t t43 = lobe_q_mul(t32, t42, 29);           /* Q29 */
    const int32_t t45 = t43 + 210473008;                    /* Q29 */
    const int32_t t46 = lobe_q_mul(t5, t45, 30);            /* Q29 */
    const int32_t t48 = t46 + 113320248;                    /* Q29 */
    const int32_t t49 = lobe_q_mul(t5, t32, 30);            /* Q30 */
    const int32_t t51 = lobe_q_mul(t49, 416600607, 31);     /* Q27 */
    const int32_t t53 = t51 - 1132917504;                   /* Q27 */
    const int32_t t54 = lobe_q_mul(t5, t53, 29);            /* Q28 */
    const int32_t t56 = t54 + 1127305985;                   /* Q28 */
    const int32_t t57 = lobe_q_mul(t32, t56, 29);           /* Q29 */
    const int32_t t59 = t57 + 473815872;                    /* Q29 */
    const int32_t t61 = lobe_q_mul(t5, -1123812479, 30);    /* Q25 */
    const int32_t t63 = t61 + 1811854465;                   /* Q25 */
    const int32_t t64 = lobe_q_mul(t5, t63, 29);            /* Q26 */
    const int32_t t66 = t64 - 1022500737;                   /* Q26 */
    const int32_t t67 = lobe_q_mul(t49, t66, 28);           /* Q28 */
    const int32_t t69 = t67 - 890582785;                    /* Q28 */
    const int32_t t71 = lobe_q_mul(t5, 2028961791, 30);     /* Q26 */
    const int32_t t73 = t71 - 1959226239;                   /* Q26 */
    const int32_t t74 = lobe_q_mul(t5, t73, 30);            /* Q26 */
    const int32_t t76 = t74 + 1257846013;                   /* Q26 */
    const int32_t t78 = lobe_q_mul(t5, -1224112511, 30);    /* Q24 */
    const int32_t t80 = t78 + 1325945600;                   /* Q24 */
    const int32_t t81 = lobe_q_mul(t5, t80, 30);            /* Q24 */
    const int32_t t83 = t81 - 1132499584;                   /* Q24 */
    const int32_t t85 = lobe_q_mul(t5, 1614048384, 31);     /* Q24 */
    const int32_t t87 = t85 - 1228108289;                   /* Q24 */
    const int32_t t88 = lobe_q_mul(t5, t87, 30);            /* Q24 */
    const int32_t t90 = t88 + 1772299129;                   /* Q24 */
    const int32_t t92 = lobe_q_mul(t5, 768871872, 31);      /* Q24 */
    const int32_t t94 = t92 - 1247859199;                   /* Q24 */
    const int32_t t96 = lobe_q_mul(t31, 659855425, 31);     /* Q24 */
    const int32_t t97 = t94 + t96;                          /* Q24 */
    const int32_t t98 = lobe_q_mul(t31, t97, 30);           /* Q24 */
    const int32_t t99 = t90 + t98;                          /* Q24 */
    const int32_t t100 = lobe_q_mul(t31, t99, 30);          /* Q24 */
    const int32_t t101 = t83 + t100;                        /* Q24 */
    const int32_t t102 = lobe_q_mul(t31, t101, 28);         /* Q26 */
    const int32_t t103 = t76 + t102;                        /* Q26 */
    const int32_t t104 = lobe_q_mul(t31, t103, 28);         /* Q28 */
    const int32_t t105 = t69 + t104;                        /* Q28 */
    const int32_t t106 = lobe_q_mul(t31, t105, 29);         /* Q29 */
    const int32_t t107 = t59 + t106;                        /* Q29 */
    const int32_t t108 = lobe_q_mul(t31, t107, 30);         /* Q29 */
    const int32_t t109 = t48 + t108;                        /* Q29 */
    const int32_t t110 = lobe_q_mul(t31, t109, 29);         /* Q30 */
    const int32_t t111 = t21 + t110;                        /* Q30 */
    const int32_t t112 = 1073741824 - t31;                  /* Q30 */
    const int32_t t113 = lobe_q_mul(t111, t112, 30);        /* Q30 */
    const int32_t t114 = 1073741824 - t113;                 /* Q30 */
    const int32_t t115 = lobe_q_min(t114, 1073741824);      /* Q30 */
    const int32_t t116 = lobe_q_shift_right(t29, up);       /* Q28 */
    const int32_t t117 = lobe_q_mul(t31, t31, 30);          /* Q30 */
    const int32_t t119 = lobe_q_mul(t117, 738164800, 31);   /* Q29 */
    const int32_t t121 = t119 - 1416896257;                 /* Q29 */
    const int32_t t122 = lobe_q_mul(t117, t121, 31);        /* Q28 */
    const int32_t t124 = t122 + 1220785280;                 /* Q28 */
    const int32_t t125 = lobe_q_mul(t117, t124, 30);        /* Q28 */
    const int32_t t127 = t125 - 1154011649;                 /* Q28 */
    const int32_t t128 = lobe_q_mul(t31, t127, 29);         /* Q29 */
    const int32_t t130 = t128 + 1451064193;                 /* Q29 */
    const int32_t t133 = lobe_q_mul(t31, -788573696, 31);   /* Q26 */
    const int32_t t135 = t133 + 1270811647;                 /* Q26 */
    const int32_t t136 = lobe_q_mul(t31, t135, 29);         /* Q27 */
    const int32_t t138 = t136 - 1385496709;                 /* Q27 */
    const int32_t t139 = lobe_q_mul(t31, t138, 31);         /* Q26 */
    const int32_t t141 = t139 - 1014317824;                 /* Q26 */
    const int32_t t142 = lobe_q_mul(t31, t141, 29);         /* Q27 */
    const int32_t t144 = t142 + 602163072;                  /* Q27 */
    const int32_t t145 = lobe_q_mul(t31, t144, 31);         /* Q26 */
    const int32_t t147 = t145 + 1332732157;                 /* Q26 */
    const int32_t t148 = lobe_q_mul(t31, t147, 29);         /* Q27 */
    const int32_t t150 = t148 - 1610418174;                 /* Q27 */
    const int32_t t152 = lobe_q_mul(t31, -1140071554, 30);  /* Q26 */
    const int32_t t154 = t152 + 1769367424;                 /* Q26 */
    const int32_t t155 = lobe_q_mul(t31, t154, 30);         /* Q26 */
    const int32_t t157 = t155 + 801773825;                  /* Q26 */
    const int32_t t158 = lobe_q_mul(t31, t157, 30);         /* Q26 */
    const int32_t t160 = t158 - 477574496;                  /* Q26 */
    const int32_t t161 = lobe_q_mul(t31, t160, 31);         /* Q25 */
    const int32_t t163 = t161 - 1582087295;                 /* Q25 */
    const int32_t t164 = lobe_q_mul(t31, t163, 30);         /* Q25 */
    const int32_t t166 = t164 + 1145394431;                 /* Q25 */
    const int32_t t168 = lobe_q_mul(t117, -1111054339, 31); /* Q25 */
    const int32_t t170 = t168 + 84783352;                   /* Q25 */
    const int32_t t171 = lobe_q_mul(t31, t170, 31);         /* Q24 */
    const int32_t t173 = t171 + 1201563775;                 /* Q24 */
    const int32_t t174 = lobe_q_mul(t31, t173, 30);         /* Q24 */
    const int32_t t176 = t174 - 1138618751;                 /* Q24 */
    const int32_t t178 = lobe_q_mul(t31, -1133310464, 30);  /* Q24 */
    const int32_t t180 = t178 + 1492565505;                 /* Q24 */
    const int32_t t182 = lobe_q_mul(t31, 1199376768, 31);   /* Q24 */
    const int32_t t184 = t182 - 1212065792;                 /* Q24 */
    const int32_t t186 = lobe_q_mul(t31, -542951552, 31);   /* Q25 */
    const int32_t t188 = t186 + 1101648257;                 /* Q25 */
    const int32_t t190 = lobe_q_mul(r, -427984768, 31);     /* Q25 */
    const int32_t t191 = t188 + t190;                       /* Q25 */
    const int32_t t192 = lobe_q_mul(r, t191, 31);           /* Q24 */
    const int32_t t193 = t184 + t192;                       /* Q24 */
    const int32_t t194 = lobe_q_mul(r, t193, 30);           /* Q24 */
    const int32_t t195 = t180 + t194;                       /* Q24 */
    const int32_t t196 = lobe_q_mul(r, t195, 30);           /* Q24 */
    const int32_t t197 = t176 + t196;                       /* Q24 */
    const int32_t t198 = lobe_q_mul(r, t197, 29);           /* Q25 */
    const int32_t t199 = t166 + t198;                       /* Q25 */
    const int32_t t200 = lobe_q_mul(r, t199, 28);           /* Q27 */
    const int32_t t201 = t150 + t200;                       /* Q27 */
    const int32_t t202 = lobe_q_mul(r, t201, 28);           /* Q29 */
    const int32_t t203 = t130 + t202;                       /* Q29 */
    const int32_t t204 = lobe_q_mul(t116, t203, 27);        /* Q30 */
    const int32_t t205 = 1073741824 - t204;                 /* Q30 */
    const int32_t t206 = lobe_q_max(t205, 0);               /* Q30 */
    const int32_t t207 = lobe_q_mul(t206, t206, 30);        /* Q30 */
    const int32_t t208 = lobe_q_mul(t207, t207, 29);        /* Q31 */
    const int32_t t209 = lobe_q_mul(t206, t208, 30);        /* Q31 */
    const int32_t t210 = lobe_q_mul(t115, t209, 31);        /* Q30 */
    const int32_t t211 = t115 - t210;                       /* Q30 */
    lobe_dfg_q30 d;
    d.scale = t211;
    d.bias = t210;
    return d;
}

void lobe_split_sum_sep_high_n_q30(const int32_t *roughness, const int32_t *n_dot_v, int32_t *scale, int32_t *bias,
                                   size_t n)
{
    size_t i;
    for (i = 0; i < n; i++) {
        const lobe_dfg_q30 d = lobe_split_sum_sep_high_q30(roughness[i], n_dot_v[i]);
        scale[i] = d.scale;
        bias[i] = d.bias;
    }
}
