#!/bin/sh
# Writes one file of instruction counts, by running the counting program on the emulated chip or under callgrind.
# Usage: count.sh chip|callgrind CSV 'COMPILER' 'RUNNER' BUILD-ARGUMENTS...
set -eu
how=$1 csv=$2 compiler=$3 runner=$4
shift 4
name=${csv##*/}
program=${csv%/*}/ports/${name%.csv}.elf
rm -f "$csv"
for tool in ${compiler%% *} ${runner%% *}; do
    if ! command -v "$tool" >/dev/null 2>&1; then
        echo "count.sh: $csv is not written: $tool is missing" >&2
        [ -z "${LOBE_REQUIRE_ALL-}" ]
        exit
    fi
done
mkdir -p "${csv%/*}/ports"
# shellcheck disable=SC2086 # the compiler and the runner are commands with their options
$compiler "$@" -o "$program"
if [ "$how" = chip ]; then
    # QEMU writes what a chip prints to standard error.
    # shellcheck disable=SC2086
    $runner "$program" >"$csv.new" 2>&1 || { cat "$csv.new" >&2; rm -f "$csv.new"; exit 1; }
else
    # Inclusive cost of each function over its calls (256 by the program), and one for the call itself.
    # shellcheck disable=SC2086
    $runner --callgrind-out-file="$csv.callgrind" "$program" >"$csv.names" 2>"$csv.log"
    callgrind_annotate --inclusive=yes --threshold=100 "$csv.callgrind" >"$csv.costs"
    # How often each was called: some are also called by others.
    awk '
        function name(text,    id) { id = text; sub(/\).*/, ")", id); sub(/^[^)]*\) ?/, "", text); if (text != "") known[id] = text; return known[id] }
        /^fn=/ { name(substr($0, 4)) }
        /^cfn=/ { callee = name(substr($0, 5)) }
        /^calls=/ { split(substr($0, 7), c, " "); calls[callee] += c[1] }
        END { for (k in calls) print k, calls[k] }' "$csv.callgrind" >"$csv.calls"
    awk -F, -v often="$csv.calls" '
        BEGIN { while ((getline line < often) > 0) { split(line, c, " "); calls[c[1]] = c[2] } }
        NR == FNR {
            if (match($0, /:[a-z0-9_]+_(f32|q30)( |$)/)) {
                name = substr($0, RSTART + 1, RLENGTH - 1)
                sub(/ $/, "", name)
                cost = $0
                sub(/^ +/, "", cost)
                sub(/ \(.*/, "", cost)
                gsub(/,/, "", cost)
                costs[name] = cost + 0
            }
            next
        }
        FNR == 1 { print; next }
        {
            name = ($1 == "peer" ? "" : "lobe_") $1 "_" $2 "_" $3
            # where the function is not called after its model and tier
            if ($2 ~ /^lobes[0-9]+(_table[0-9]+)?$/) name = "lobe_" $1 substr($2, 6) "_" $3
            if ($1 == "sphere_light_schlick") name = "lobe_sphere_light_" ($2 == "high" ? "high_lit" : "schlick") "_" $3
            if (!(name in costs)) {
                print "count.sh: callgrind does not know " name >"/dev/stderr"
                exit 1
            }
            printf "%s,%s,%s,%.0f\n", $1, $2, $3, costs[name] / (name in calls ? calls[name] : 256) + 1
        }' "$csv.costs" "$csv.names" >"$csv.new"
    rm -f "$csv.callgrind" "$csv.calls" "$csv.names" "$csv.costs" "$csv.log"
fi
mv "$csv.new" "$csv"
