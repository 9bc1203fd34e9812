#!/bin/sh
# lobefit vectors: the same bytes twice, rows that are the truth, a head that is complete, and nothing half-written.
cd "$(dirname "$0")/../.." || exit 1
lobefit=build/lobefit
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
n=0 failed=0

result() { # STATUS NAME
    n=$((n + 1))
    if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; failed=$((failed + 1)); fi
}

"$lobefit" vectors split_sum --out "$work/a" --threads 1 > "$work/out" 2> "$work/err" && [ ! -s "$work/err" ] &&
    "$lobefit" vectors split_sum --out "$work/b" --threads 2 && diff -r "$work/a" "$work/b"
result $? "the same bytes on every run and for any number of threads"

[ -f "$work/a/split_sum.low.f32.vec" ] && [ -f "$work/a/split_sum.low.q30.vec" ] &&
    [ -f "$work/a/split_sum.low.f32.below.vec" ]
result $? "a file a tier and format, and one for what is below its domain"

good=0
for f in "$work"/a/*.vec; do
    for key in model tier format inputs outputs brdf domain truth bound_max command seed digest; do
        [ "$(grep -c "^# $key: ." "$f")" -eq 1 ] || { good=1; echo "# $f: key $key"; }
    done
    case $f in *.below.vec) ;; *) [ "$(grep -c '^# bound_rms: .' "$f")" -eq 1 ] || good=1 ;; esac
done
result $good "every head has every key once"

good=0
for f in "$work"/a/*.vec; do
    awk '/^#/ { if (rows) bad = 1; next }
         { rows++
           if (NF != 4) bad = 1
           for (i = 1; i <= 2; i++) { x = $i * 16777216; if (x != int(x) || $i < 0.001 || $i > 1) bad = 1 }
           if (seen[$1 " " $2]++) twice++ }
         END { exit bad || rows < 250 || twice > 3 }' "$f" || { good=1; echo "# $f"; }
done
result $good "about 256 rows of inputs that are multiples of 2^-24 in the domain"

good=0
for f in "$work"/a/*.vec; do
    lo=$(sed -n 's/.*at least one below //p' "$f")
    awk -v lo="${lo:-0}" '!/^#/ { if (lo && !($1 < lo || $2 < lo)) bad = 1; if ($1 == 1 && $2 == 1) corner = 1 }
         END { exit bad || (!lo && !corner) }' "$f" || { good=1; echo "# $f"; }
done
result $good "rows below the domain are below it, and the domain's corner is among the others"

good=0
for f in "$work"/a/*.vec; do
    grep -v '^#' "$f" | cut -d' ' -f1,2 | "$lobefit" truth split_sum > "$work/truth"
    grep -v '^#' "$f" | cut -d' ' -f3,4 | cmp -s - "$work/truth" || good=1
done
result $good "outputs are what lobefit truth says"

# sphere_light: other columns than its truth takes, and .beyond for what is outside on either side.
"$lobefit" vectors sphere_light --out "$work/s" && [ "$(ls "$work/s" | wc -l)" -eq 12 ]
status=$?
for f in "$work"/s/*.vec; do
    case $f in *.beyond.vec) rows=256 ;; *) rows=1024 ;; esac
    [ "$(grep -vc '^#' "$f")" -eq $rows ] || status=1
    for key in model tier format inputs outputs brdf domain truth bound_max command seed digest; do
        [ "$(grep -c "^# $key: ." "$f")" -eq 1 ] || { status=1; echo "# $f: key $key"; }
    done
done
result $status "sphere_light: three tiers in two formats, inside and beyond, with whole heads"

# Rows of every kind as roughness, heights, azimuth and half angle.
grep -hv '^#' "$work/s/sphere_light.low.f32.vec" "$work/s/sphere_light.low.f32.beyond.vec" | awk 'NR % 9 == 1' > "$work/rows"
awk '{ sv = sqrt(1 - $2 * $2); sl = sqrt(1 - $3 * $3); hi = (sv + sl) ^ 2 / 4 - $4; lo = $4 - (sv - sl) ^ 2 / 4
       printf "%.17g %.17g %.17g %.17g %.17g\n", $1, $2, $3, 2 * atan2(sqrt(hi > 0 ? hi : 0), sqrt(lo > 0 ? lo : 0)),
              atan2($5, sqrt(1 - $5 * $5)) }' "$work/rows" | sed 's/3\.14159265358979[0-9]*/3.141592653589793/; s/1\.5707963267948[0-9]*$/1.570796326794896/' |
    "$lobefit" truth sphere_light > "$work/truth" && paste -d' ' "$work/rows" "$work/truth" |
    awk '{ n++; d = $6 - $7; if (d < 0) d = -d; if (d > 1e-6 * $7) bad = 1 } END { exit bad || n < 100 }'
result $? "sphere_light: outputs are what lobefit truth says at the angles"

: > "$work/file"
"$lobefit" vectors split_sum --out "$work/file/x" > "$work/out" 2> "$work/err"
[ $? -eq 2 ] && [ ! -s "$work/out" ] && grep -q "file/x: cannot make the folder" "$work/err"
result $? "a folder that cannot be made is a failure with its name"

"$lobefit" vectors split_sum --out "$work/file" 2> "$work/err"
[ $? -eq 2 ] && grep -q "$work/file/.*cannot write" "$work/err"
result $? "a folder that is a file is a failure"

mkdir -p "$work/c/split_sum.low.f32.vec"
"$lobefit" vectors split_sum --out "$work/c" 2> "$work/err"
[ $? -eq 2 ] && grep -q "split_sum.low.f32.vec: cannot write" "$work/err" && [ -z "$(find "$work/c" -name '*.new*')" ]
result $? "a file that cannot be replaced leaves nothing half-written"

"$lobefit" vectors split_sum --out 2> "$work/err"
[ $? -eq 2 ] && grep -q "out needs a value" "$work/err"
result $? "--out without a folder"

echo "1..$n"
[ $failed -eq 0 ]
