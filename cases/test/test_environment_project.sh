#!/bin/sh
# `lobefit project`: what it prints, and that a bad file or option says why, exits 2 and prints nothing else.
: "${B:=build}" "${CC:=cc}"
lobefit=$B/lobefit
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
n=0 failed=0

result() { # STATUS NAME
    n=$((n + 1))
    if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; failed=$((failed + 1)); fi
}

# refused NAME PATTERN ARGUMENTS...: status 2, the message matches, standard output is empty
refused() {
    name=$1 pattern=$2
    shift 2
    "$lobefit" project "$@" >"$work/out" 2>"$work/err"
    status=$?
    [ $status -eq 2 ] && [ ! -s "$work/out" ] && grep -qE -- "$pattern" "$work/err"
    good=$?
    [ $good -eq 0 ] || { echo "# status $status, said:"; sed 's/^/# /' "$work/err"; }
    result $good "$name"
}

head='#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n'
# 4 x 2 texels of radiance 1, 2, .5.
printf "$head"'-Y 2 +X 4\n' >"$work/even.hdr"
for i in 1 2 3 4 5 6 7 8; do printf '\100\200\040\202'; done >>"$work/even.hdr"
# The same in PFM: little-endian floats.
printf 'PF\n4 2\n-1\n' >"$work/even.pfm"
for i in 1 2 3 4 5 6 7 8; do printf '\000\000\200\077\000\000\000\100\000\000\000\077'; done >>"$work/even.pfm"

refused "no file" "which file\? FILE.hdr"
refused "a file that is not there" "missing.hdr: cannot be opened: No such file" "$work/missing.hdr"
refused "a folder" "$work: " "$work"
refused "two files" "one word too many" "$work/even.hdr" "$work/even.hdr"
refused "unknown option" "unknown option '--fast'; it takes --c" "$work/even.hdr" --fast
refused "option without its value" "--c needs a value" "$work/even.hdr" --c
refused "a name that is none in C" "--c '2x' is not a C name" "$work/even.hdr" --c 2x
refused "a name with text behind it" "--c 'a;b' is not a C name" "$work/even.hdr" --c 'a;b'
refused "unknown window" "--window 'hamming' is not one of none, positive, hanning" "$work/even.hdr" --window hamming
refused "unknown axis" "--up 'x' is not one of y, z" "$work/even.hdr" --up x
refused "a share that is none" "--sun-share 'nan' is not a number in \[0, 4\]" "$work/even.hdr" --sun --sun-share nan

printf 'text' >"$work/text.hdr"
refused "no map at all" "text.hdr: byte 0: found bytes 0x74 0x65, expected #\? \(RGBE\) or PF" "$work/text.hdr"
: >"$work/empty.hdr"
refused "an empty file" "empty.hdr: byte 0: found a file of 0 bytes, expected" "$work/empty.hdr"
head -c 60 "$work/even.hdr" >"$work/cut.hdr"
refused "a map cut short" "cut.hdr: byte 60: found the end of the file in row 0, expected 2 rows" "$work/cut.hdr"
printf "$head"'-Y 1 +X 8\n\2\2\0\10\211\1' >"$work/run.hdr"
refused "a run that leaves its row" "run.hdr: byte 49: found a run of 9 texels, expected 1 to 8" "$work/run.hdr"
printf 'PF\n1 1\n-1\n\000\000\300\177\000\000\000\000\000\000\000\000' >"$work/nan.pfm"
refused "a texel that is no number" "nan.pfm: byte 10: found -?nan, expected a finite number" "$work/nan.pfm"
printf 'PF\n1 1\n-1\n\000\000\200\277\000\000\000\000\000\000\000\000' >"$work/minus.pfm"
refused "a window where none helps" "minus.pfm: the mean radiance of a channel is negative" "$work/minus.pfm" \
    --window positive

# 1, 2 and .5 times sqrt(4 pi) = 3.5449077018 in band 0, nothing else.
for file in even.hdr even.pfm; do
    "$lobefit" project "$work/$file" >"$work/out" 2>"$work/err" && [ ! -s "$work/err" ] && awk '
        /^#/ { next }
        { rows++; for (k = 1; k <= 3; k++) { w = rows == 1 ? 3.5449077018 * (k == 3 ? .5 : k) : 0
          if (NF != 3 || ($k - w)^2 > 1e-16) bad = 1 } }
        END { exit bad || rows != 9 }' "$work/out"
    result $? "$file: band 0 only"
done

# What is printed as C compiles, and holds the same numbers.
"$lobefit" project "$work/even.hdr" --sun --window positive --up y --c even_map >"$work/map.h" && cat >"$work/map.c" <<'END' &&
#include <stdio.h>
#include "map.h"
int main(void)
{
    for (int k = 0; k < 9; k++)
        printf("%.9g %.9g %.9g\n", even_map[0][k], even_map[1][k], even_map[2][k]);
    return even_map_sun_irradiance[0] != 0.0f || even_map_sun_direction[1] != 1.0f;
}
END
    $CC -std=c99 -Wall -Wextra -Werror "$work/map.c" -o "$work/map" && "$work/map" >"$work/c" &&
    "$lobefit" project "$work/even.hdr" --up y | grep -v '^#' >"$work/text" && awk '
        NR == FNR { for (k = 1; k <= 3; k++) c[FNR, k] = $k; next }
        { for (k = 1; k <= 3; k++) if ((c[FNR, k] - $k)^2 > 1e-12) bad = 1 } END { exit bad || FNR != 9 }' \
        "$work/c" "$work/text"
result $? "C output compiles and agrees with the text"

"$lobefit" project "$work/even.hdr" --sun | grep -q '^# sun: none; no spot carries 0.5 of the mean irradiance'
result $? "no sun in an even map"
"$lobefit" -h | grep -q 'project FILE'
result $? "lobefit -h knows it"
"$lobefit" project "$work/even.hdr" >/dev/full 2>"$work/err"
[ $? -eq 2 ] && grep -q 'cannot write' "$work/err"
result $? "a full disk is a failure"

# The maps beside the checkout: order 3 with the sun taken out is brightest towards the sun's side, and what leaves the
# map as a light leaves band 0: sqrt(4 pi) times the mean radiance, so irradiance / sqrt(4 pi) in all.
data=../shared/data/environments
if [ ! -d "$data" ]; then
    n=$((n + 1))
    echo "ok $n - sky.hdr gives up its sun # SKIP no $data"
else
    "$lobefit" project "$data/sky.hdr" >"$work/with" && "$lobefit" project "$data/sky.hdr" --sun >"$work/without" && awk '
        /^# sun_irradiance:/ { for (k = 1; k <= 3; k++) sun[k] = $(k + 2) }
        /^# sun_direction:/ { length2 = $3^2 + $4^2 + $5^2; up = $5 }
        /^#/ { next }
        FNR == NR && !first { for (k = 1; k <= 3; k++) band[k] = $k; first = 1 }
        FNR != NR && !second { for (k = 1; k <= 3; k++) rest[k] = $k; second = 1 }
        END {
            for (k = 1; k <= 3; k++)
                if (!(sun[k] > 1) || (band[k] - rest[k] - sun[k] / 3.5449077018)^2 > 1e-10 * band[k]^2) bad = 1
            exit bad || (length2 - 1)^2 > 1e-12 || up < .5
        }' "$work/with" "$work/without"
    result $? "sky.hdr gives up its sun, and nothing is lost"
fi

echo "1..$n"
[ $failed -eq 0 ]
