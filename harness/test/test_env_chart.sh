#!/bin/sh
# The committed charts of environment lobes and of spherical Gaussian lights: they are of what ships and of the offline
# side's tables, and the tiers keep the floors that were asked of them.
. harness/test/tap.sh
env=harness/chart/env_lobes.csv
sg=harness/chart/sg_light.csv

# The columns by their names.
columns='NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }'

check 'the tables of the charts can be joined' make -s B="$B" "$B/chart/env_lobes.csv" "$B/chart/sg_light.csv"
check 'env_lobes is of costs and errors as they are' diff "$B/chart/env_lobes.csv" $env
check 'sg_light too' diff "$B/chart/sg_light.csv" $sg

# drawn CSV: every name of a row that can be drawn stands in the picture
drawn() {
    awk -F, "$columns"' $at["operations"] != "" && $at["kind"] != "point" { print $at["title"] }' "$1" | sort -u | while read -r title; do
        case $title in lobes*) continue ;; esac # their operations stand there
        grep -q "<text>$title" "${1%.csv}.svg" || { echo "$title is not drawn"; exit 1; }
    done
}
operations_drawn() {
    for n in $(awk -F, "$columns"' $at["kind"] == "tier" || $at["kind"] == "table" { print $at["operations"] }' $env); do
        grep -q "<text>$n</text>" "${env%.csv}.svg" || { echo "$n is not drawn"; return 1; }
    done
}
check 'env_lobes is drawn from it' drawn $env
check 'with the operations of its tiers' operations_drawn
check 'sg_light is drawn from its own' drawn $sg

# floor MODEL NAME COLUMN MOST
floor() {
    awk -F, -v model="$1" -v name="$2" -v column="$3" -v most="$4" "$columns"'
        $at["model"] == model && $at["name"] == name { seen = 1; if (!($at[column] > 0 && $at[column] <= most)) bad = $at[column] }
        END { if (bad || !seen) { print name, column, bad, "asked", most; exit 1 } }' $env
}
check '1 tap' floor env_lobes lobes1 relative .30
check '2 taps' floor env_lobes lobes2 relative .18
check '4 taps' floor env_lobes lobes4 relative .12
check '8 taps' floor env_lobes lobes8 relative .08
check 'the shape of 8 taps' floor env_lobes lobes8 shape .20
check '8 spherical Gaussians' floor env_lobes_sg lobes8 rms .25

# A tier looks up no more often than its name says; more lookups are never worse.
sorted() {
    awk -F, "$columns"'
        $at["kind"] == "tier" {
            n = substr($at["name"], 6)
            if (!($at["lookups"] > n - .5 && $at["lookups"] <= n) || $at["model"] == last && !($at["rms"] < rms)) { print; bad = 1 }
            last = $at["model"]; rms = $at["rms"]; rows++
        }
        END { exit bad || rows < 8 }' $env
}
check 'every further lookup is worth it' sorted

# beats: every tier of sg_light against all forms that are not ours, of any cost
beats() {
    awk -F, "$columns"'
        $at["kind"] != "tier" { theirs[++n] = $at["all"]; near[n] = $at["smooth"]; set[n] = $at["positions"] }
        $at["kind"] == "tier" { ours[++m] = $at["all"]; smooth[m] = $at["smooth"]; where[m] = $at["positions"] }
        END {
            for (i = 1; i <= m; i++) {
                if (!(ours[i] <= .28 && smooth[i] <= .15)) { print ours[i], smooth[i]; bad = 1 }
                for (k = 1; k <= n; k++)
                    if (set[k] == where[i] && !(ours[i] < theirs[k] && smooth[i] < near[k])) { print ours[i], theirs[k]; bad = 1 }
            }
            exit bad || m < 4 || n < 8
        }' $sg
}
check 'sg_light keeps its floors, and is better than what is published' beats
finish
