#!/bin/sh
# Writes first inputs for the fuzzers: seeds.sh FOLDER. Heads with a few rows of every vector file, and rows of every
# kind that eval knows.
set -eu
mkdir -p "$1/vec" "$1/rows"
for file in vectors/*.vec; do
    [ ! -e "$file" ] || head -n 24 "$file" >"$1/vec/$(basename "$file")"
done
cat >"$1/vec/small.vec" <<END
# model: split_sum
# tier: low
# format: f32
# inputs: roughness n_dot_v
# outputs: scale bias
# brdf: seed
# domain: seed
# truth: seed
# bound_max: 1
# bound_rms: 1
# command: seed
# seed: 0
# digest: 0000000000000000
0.5 0x1p-2 0.75,0.125 # behind
END
n=0
for row in '0.5 0.7' '0x1p-3,1e-5' 'nan inf' '-inf,-0 # behind' '1e999 -1e-999' '0.5,,1' '# nothing'; do
    n=$((n + 1))
    printf '0%s' "$row" >"$1/rows/$n"
done
