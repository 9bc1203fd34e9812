#!/bin/sh
# The committed chart of diffuse_sh: its errors are what the library gives now, and its instruction counts keep the
# floor, exact at most twice the printed zonal fit.
. harness/test/tap.sh
csv=harness/chart/diffuse_sh.csv
errors=$B/chart/diffuse_sh.errors

same_errors() { sed 1d "$csv" | cut -d, -f1-10 | diff - "$errors"; }
# ratio COLUMN: exact against the seed, both in f32
ratio() {
    awk -F, -v column="$1" '
        NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        $at["format"] == "f32" { cost[$at["name"]] = $at[column] }
        END { if (!(cost["exact"] > 0 && cost["zonal_2015"] > 0 && cost["exact"] <= 2 * cost["zonal_2015"])) {
            print column, cost["exact"], cost["zonal_2015"]; exit 1 } }' "$csv"
}
check 'the errors can be measured' make -s B="$B" "$errors"
check 'they are those of the chart' same_errors
check 'exact costs at most twice the seed on Cortex-M4F' ratio m4f_instructions
check 'and from world space to RGB' ratio m4f_radiance
finish
