#!/bin/sh
# Every command of lobecheck: what it prints, what it refuses, and its exit status.
. harness/test/tap.sh
. harness/test/seal.sh
lobecheck=$PWD/$B/lobecheck
case $B in /*) lobecheck=$B/lobecheck ;; esac

# COLUMNS: rows that are exact in both formats, inside every domain of two inputs.
points() {
    awk -v n="$1" 'BEGIN { for (i = 1; i <= 16; i++) for (j = 1; j <= 16; j++) {
        printf "%g %g", i / 16, j / 16
        for (k = 2; k < n; k++) printf " %g", ((i * (2 * k - 1) + j * k) % 16 + 1) / 16
        print "" } }'
}

# The mirror direction of lights of 30 degrees, as eval asks for them and as the function is asked.
sphere_points() {
    awk -v end="$1" 'BEGIN { for (i = 4; i <= 16; i++) for (j = 2; j <= 16; j++) print i / 16, j / 16, j / 16, end }'
}

# MODEL TIER FORMAT: a file whose truths are what the function answers, moved by $shift.
answers() {
    names=$("$lobecheck" list | awk -v model="$1" '$1 == model { print $9; exit }' | tr ',' ' ')
    count=$(echo "${names%%->*}" | wc -w)
    case $1 in
    sphere_light | sphere_light_schlick)
        sphere_points '3.14159265358979324 0.523598775598298873' >"$work/asked"
        sphere_points '0 0.5' >"$work/points"
        ;;
    sg_light)
        sphere_points '3.14159265358979324 32' >"$work/asked"
        sphere_points '0 0.03125' >"$work/points"
        ;;
    *) points "$count" >"$work/points" && cp "$work/points" "$work/asked" ;;
    esac
    "$lobecheck" eval "$1" --tier "$2" --format "$3" <"$work/asked" >"$work/answers"
    case $1 in
    env_lobes*) # no truth of their own: vectors hold the sum of the weights, every third number
        awk '{ sum = 0; for (i = 3; i <= NF; i += 3) sum += $i; printf "%.9g\n", sum }' "$work/answers" >"$work/sums"
        mv "$work/sums" "$work/answers"
        names="${names%%->*}->E"
        ;;
    esac
    paste -d' ' "$work/points" "$work/answers" |
        awk -v shift="${shift:-0}" -v at="$((count + 1))" '{ $at = sprintf("%.9g", $at + shift); print }' |
        seal "$1" "$2" "$3" "$bound" "${names%%->*}" "${names##*->}"
}

says() { "$lobecheck" "$@" >"$work/out" && grep -qE "$pattern" "$work/out"; }
answer() { [ "$("$lobecheck" eval split_sum --tier low --format "$1" <"$work/in" | wc -l)" -eq "$2" ]; }

# Usage
pattern='lobecheck eval MODEL' check '-h explains' says -h
pattern='lobecheck eval MODEL' check 'run -h explains' says run -h
check 'no command' exits 2 'list run eval hash bench' "$lobecheck"
check 'unknown command' exits 2 "unknown command 'nothing'; allowed: list run eval hash bench" "$lobecheck" nothing
check 'list refuses arguments' exits 2 "unexpected 'all'" "$lobecheck" list all
pattern='^ *split_sum +low +f32 +[0-9]+ +0\.[0-9]+ .*\[0\.[0-9]+,1\].* lobe_split_sum_low_f32$'
check 'list has operations, bound, domain and kernel' says list

# eval
printf '0.5 0.7\n# a comment\n\n0.5,0.7\n0x1p-1 \t 7e-1 # behind\n' >"$work/in"
check 'eval reads blanks, commas, comments and hex' answer f32 3
check 'the same row has the same answer' sh -c "'$lobecheck' eval split_sum --tier low --format f32 <'$work/in' |
    sort -u | wc -l | grep -qx ' *1'"
check 'options may come first, or with =' sh -c \
    "'$lobecheck' eval --format=f32 --tier=low split_sum <'$work/in' | grep -q ' '"
for format in f32 q30; do
    "$lobecheck" list | grep -q "split_sum .*low .*$format" || continue
    printf '%s\n' 'nan nan' 'inf 0.5' '-inf 0.5' '1e999 -1e999' '1e-310 3e38' '-0 0' '2 2' 'NAN -INF' >"$work/in"
    check "eval answers any number in $format" answer $format 8
    check "the answers in $format are in [0, 1]" sh -c "
        '$lobecheck' eval split_sum --tier low --format $format <'$work/in' |
        awk '{ for (i = 1; i <= NF; i++) if (!(\$i >= 0 && \$i <= 1) || \$i ~ /[ni]/) bad = 1 }
             END { exit bad || NR != 8 }'"
done
printf '0.5 0.7\n0.5 x\n' >"$work/in"
check 'eval names the line of what is no number' exits 2 "<stdin>:2: 'x' is not a number" \
    "$lobecheck" eval split_sum --tier low --format f32
check 'and writes nothing' test ! -s "$work/out"
printf '0.5\n' >"$work/in"
check 'a short row' exits 2 '<stdin>:1: 1 numbers; a row of split_sum has 2: roughness n_dot_v' \
    "$lobecheck" eval split_sum --tier low --format f32
printf '0.5 0.7 0.9\n' >"$work/in"
check 'a long row' exits 2 '<stdin>:1: more than 2 numbers' "$lobecheck" eval split_sum --tier low --format f32
printf '0.5 0.7\0\n' >"$work/in"
check 'a NUL byte' exits 2 '<stdin>:1: ' "$lobecheck" eval split_sum --tier low --format f32
awk 'BEGIN { for (i = 0; i < 5000; i++) printf " "; print "" }' >"$work/in"
check 'an endless line' exits 2 '<stdin>:1: a line of more than' \
    "$lobecheck" eval split_sum --tier low --format f32
# A sphere light is asked for by angles: an even function of the azimuth, brightest on the mirror's side; the half angle
# of a hemisphere is the most; anything is answered.
sphere() { "$lobecheck" eval sphere_light --tier high --format "$1" <"$work/in" >"$work/out"; }
for format in f32 q30; do
    printf '%s\n' '.5 .7 .6 3 .2' '.5 .7 .6 -3 .2' '.5 .7 .6 3.28318530717958648 .2' '.5 .7 .6 0 .2' '.5 .7 .6 3.14159265 .2' \
        '.5 .7 .6 3 1.5707963267948966' '.5 .7 .6 3 3' '.5 1 1 0 .2' '.5 1 1 2 .2' '.5 .7 .6 3 0' >"$work/in"
    sphere $format
    check "eval of a sphere light knows its angles in $format" awk '{ y[NR] = $1 + 0 }
        function near(a, b) { return a - b < 2e-6 && b - a < 2e-6 }
        END { exit !(NR == 10 && near(y[1], y[2]) && near(y[1], y[3]) && y[4] < .1 * y[5] && y[5] > y[1] && y[6] == y[7] &&
              y[6] > y[1] && near(y[8], y[9]) && y[10] < 1e-9 && y[1] > .1) }' "$work/out"
    # the mirror direction of a small light: 2 pi (1 - cos) D V l is versine / (2 a2 sqrt(a2 + (1 - a2) v^2)) there
    echo '.5 .6 .6 3.14159265358979324 .001' >"$work/in"
    sphere $format
    check "and its scale in $format" awk '{ want = 5e-7 / (2 * .0625 * sqrt(.0625 + .9375 * .36))
        print $1, want; exit !($1 > .99 * want && $1 < 1.01 * want) }' "$work/out"
    printf '%s\n' 'nan nan nan nan nan' 'inf -inf inf -inf inf' '-1 2 -3 1e300 -7' '.5 nan .5 0 .5' '.5 .5 .5 .5 nan' >"$work/in"
    sphere $format
    check "and any number in $format" awk '$1 >= 0 && $1 <= 1 && $1 !~ /[a-z]/ || /e-/ { n++ } END { exit n != 5 }' "$work/out"
done
printf '.5 .7 .6 3\n' >"$work/in"
check 'a short row of a sphere light' exits 2 'a row of sphere_light has 5: roughness n_dot_v n_dot_l azimuth half_angle' \
    "$lobecheck" eval sphere_light --tier low --format f32
: >"$work/in"
check 'no rows, no answers' exits 0 '' "$lobecheck" eval split_sum --tier low --format f32
check 'unknown model' exits 2 "unknown model 'nothing'; allowed: split_sum" \
    "$lobecheck" eval nothing --tier low --format f32
check 'unknown tier' exits 2 "unknown tier 'nothing' of split_sum; allowed: low" \
    "$lobecheck" eval split_sum --tier nothing --format f32
check 'unknown format' exits 2 "unknown format 'f64'; allowed: f32 q30" \
    "$lobecheck" eval split_sum --tier low --format f64
check 'no tier' exits 2 '--tier is missing' "$lobecheck" eval split_sum --format f32
check 'no format' exits 2 '--format is missing' "$lobecheck" eval split_sum --tier low
check 'no model' exits 2 'MODEL is missing' "$lobecheck" eval --tier low --format f32
check 'an option without value' exits 2 "unexpected '--tier'" "$lobecheck" eval split_sum --format f32 --tier
check 'unknown option' exits 2 "unexpected '--speed'" "$lobecheck" eval split_sum --speed

# run
check 'a file that is not there' exits 2 'missing.vec: cannot be opened' "$lobecheck" run missing.vec
check 'an unknown option of run' exits 2 "unknown option '--all'" "$lobecheck" run --all
check 'a folder without vectors' sh -c "cd '$work' && ! '$lobecheck' run 2>err && grep -q 'no vectors/\*.vec' err"
"$lobecheck" list | awk '!/^#/ { print $1, $2, $3, $5 }' >"$work/entries"
while read -r model tier format max; do
    bound=$max shift=0 answers $model $tier $format >"$work/good.vec"
    shift=$(awk -v m="$max" 'BEGIN { print m < 0.25 ? 3 * m : (1 + m) / 2 }')
    bound=1 answers $model $tier $format >"$work/moved.vec"
    bound=1e-12 shift=0.00001 answers $model $tier $format >"$work/tight.vec"
    shift=0
    check "$model $tier $format passes its own answers" exits 0 '' "$lobecheck" run "$work/good.vec"
    check "$model $tier $format fails a moved truth" exits 1 '' "$lobecheck" run "$work/moved.vec"
    check 'and the row says BROKEN, with the case in hex' \
        grep -qE 'BROKEN.* at .*\([0-9a-f]{8}( [0-9a-f]{8})+\): got .*want .*0x' "$work/out"
    check "$model $tier $format fails a bound that is too small" exits 1 '' "$lobecheck" run "$work/tight.vec"
done <"$work/entries"
bound=1 answers split_sum low f32 >"$work/good.vec"
bound=1 shift=0.75 answers split_sum low f32 >"$work/moved.vec"
shift=0
check 'one broken file of two' exits 1 '' "$lobecheck" run "$work/moved.vec" "$work/good.vec"
check 'and both have their row' sh -c "[ \$(wc -l <'$work/out') -eq 3 ]"
check 'one malformed file of two' exits 2 'missing.vec' "$lobecheck" run missing.vec "$work/moved.vec" "$work/good.vec"
sed '/tier:/s/: .*/: nothing/' "$work/good.vec" >"$work/bad.vec"
check 'a tier that is not here' exits 2 "unknown tier 'nothing'" "$lobecheck" run "$work/bad.vec"
sed '/inputs:/s/: .*/: n_dot_v roughness/' "$work/good.vec" >"$work/bad.vec"
check 'columns in another order' exits 2 "inputs 'n_dot_v roughness'" "$lobecheck" run "$work/bad.vec"
sed '14s/^./7/' "$work/good.vec" >"$work/bad.vec"
check 'an edited row' exits 2 'bad.vec:12: digest' "$lobecheck" run "$work/bad.vec"
sed '3d' "$work/good.vec" >"$work/bad.vec"
check 'a missing key' exits 2 "bad.vec:11: the head ends without the key 'format'" "$lobecheck" run "$work/bad.vec"
head -c 1000 /dev/zero >"$work/bad.vec"
check 'a binary file' exits 2 'bad.vec:1:' "$lobecheck" run "$work/bad.vec"
check 'a folder in place of a file' exits 2 "$work: cannot be" "$lobecheck" run "$work"

# hash
check 'hash --write' exits 0 '' "$lobecheck" hash --write --file "$work/hashes.txt"
check 'hash of what was written' exits 0 '' "$lobecheck" hash --file="$work/hashes.txt"
check 'and every row is OK' sh -c "! grep -v 'OK$' '$work/out'"
sed '$s/ [0-9a-f]*$/ 0123456789abcdef/' "$work/hashes.txt" >"$work/other.txt"
check 'another hash' exits 1 '' "$lobecheck" hash --file "$work/other.txt"
check 'and the row says so' grep -q 'differs from 0123456789abcdef' "$work/out"
sed '$d' "$work/hashes.txt" >"$work/other.txt"
check 'a hash that is not committed' exits 1 '' "$lobecheck" hash --file "$work/other.txt"
{ cat "$work/hashes.txt"; echo 'gone low f32 0123456789abcdef'; } >"$work/other.txt"
check 'a hash of nothing' exits 1 '' "$lobecheck" hash --file "$work/other.txt"
printf '# head\nsplit_sum low f64 0123456789abcdef\n' >"$work/other.txt"
check 'a malformed line' exits 2 'other.txt:2: the format is neither' "$lobecheck" hash --file "$work/other.txt"
check 'no such hash file' exits 2 'cannot be opened' "$lobecheck" hash --file "$work/none.txt"
check 'an output that cannot be written' exits 2 'cannot be written' \
    "$lobecheck" hash --write --file "$work/none/hashes.txt"
check 'an unknown option of hash' exits 2 "unexpected '--fast'" "$lobecheck" hash --fast

# bench
check 'bench' exits 0 '' "$lobecheck" bench split_sum
check 'and times the low tier' grep -qE '^split_sum +low +f32 +[0-9]+ +[0-9.]+ \([0-9.]+\.\.[0-9.]+\)' "$work/out"
check 'bench of an unknown model' exits 2 "unknown model 'nothing'" "$lobecheck" bench nothing
[ ! -w /dev/full ] || check 'a full disk' sh -c "'$lobecheck' list >/dev/full; [ \$? -eq 2 ]"
finish
