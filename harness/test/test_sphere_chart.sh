#!/bin/sh
# The committed chart of sphere lights: it is of what ships, no published form of a tier's cost or less comes near, and
# the tiers keep the floors that were asked of them.
. harness/test/tap.sh
csv=harness/chart/sphere_light.csv
front=cases/sphere_light/front.csv
errors=$B/chart/sphere_light.errors

# The columns by their names.
columns='NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }'

same_errors() { awk -F, -v OFS=, '$3 == "tier"' "$csv" | cut -d, -f1-13 | diff - "$errors"; }
check 'the errors can be measured' make -s B="$B" "$errors"
check 'they are those of the chart' same_errors

# The published forms are judged in double by other code: on the tiers the two agree to what float rounds.
judges_agree() {
    awk -F, -v OFS=, '
        FNR == 1 { file++; for (i = 1; i <= NF; i++) at[file, $i] = i; next }
        file == 1 {
            key = $at[1, "form"] OFS $at[1, "positions"]
            for (k in name) have[key, k] = $at[1, k]
            seen[key] = 1
            ops[key] = $at[1, "operations"]
            next
        }
        $at[2, "kind"] == "tier" {
            key = $at[2, "name"] OFS $at[2, "positions"]
            rows++
            if (!seen[key] || ops[key] != $at[2, "operations"]) { print key, "operations", ops[key]; bad = 1 }
            for (k in name) {
                off = have[key, k] - $at[2, k]
                if (off > .0003 || off < -.0003) { print key, k, have[key, k], $at[2, k]; bad = 1 }
            }
        }
        BEGIN { name["all"]; name["view60"]; name["view75"] }
        END { exit bad || rows < 6 }' "$front" "$csv"
}
check 'two judges agree on what ships' judges_agree

# tier NAME: on both sets of positions, against every published form that costs no more
beats() {
    awk -F, -v tier="$1" "$columns"'
        $at["format"] == "f32" && $at["name"] == tier {
            cost = $at["operations"]
            for (k in name) mine[$at["positions"], k] = $at[k]
            found++
        }
        $at["format"] == "double" && $at["operations"] != "" {
            n++
            form[n] = $at["title"]; set[n] = $at["positions"]; price[n] = $at["operations"]
            for (k in name) theirs[n, k] = $at[k]
        }
        BEGIN { name["all"]; name["view60"]; name["view75"] }
        END {
            for (i = 1; i <= n; i++)
                for (k in name)
                    if (price[i] <= cost && !(mine[set[i], k] < theirs[i, k])) { print form[i], set[i], k, theirs[i, k]; bad = 1 }
            exit bad || found != 2 || n < 18
        }' "$csv"
}
for tier in low medium high; do check "$tier against every published form of its cost or less" beats $tier; done

# floors TIER OPERATIONS ALL VIEW60 VIEW75 ENERGY SMALL SAMPLED: every format, both sets. SAMPLED is the energy over 200
# uniform positions, of which one can be all of the light: no floor, but what the case states.
floors() {
    awk -F, -v tier="$1" -v ops="$2" -v all="$3" -v view60="$4" -v view75="$5" -v energy="$6" -v small="$7" -v sampled="$8" "$columns"'
        function hold(k, most) { if (!($at[k] <= most)) { print $at["format"], $at["positions"], k, $at[k], "asked", most; bad = 1 } }
        $at["kind"] == "tier" && $at["name"] == tier {
            rows++
            if ($at["energy"] < 0) $at["energy"] = -$at["energy"]
            hold("operations", ops); hold("all", all); hold("view60", view60); hold("view75", view75)
            hold("energy", $at["positions"] == "mixed" ? energy : sampled); hold("small_over_point", small)
        }
        END { exit bad || rows != 4 }' "$csv"
}
check 'floors of low' floors low 20 .185 .09 .31 .30 1 .42
check 'floors of medium' floors medium 40 .115 .065 .175 .25 .005 .28
check 'floors of high' floors high 110 .05 .03 .08 .20 .005 .20
finish
