#!/bin/sh
# The readers of maps under libFuzzer and the sanitizers: a moment here, 30 seconds where everything is required.
: "${B:=build}"
seconds=${FUZZ_SECONDS:-${LOBE_REQUIRE_ALL:+30}}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
printf 'int main(void) { return 0; }\n' >"$work/probe.c"
if [ -z "${LOBE_REQUIRE_ALL-}" ] && ! clang -fsanitize=fuzzer-no-link,address "$work/probe.c" -o "$work/probe" 2>"$work/err"; then
    echo 'ok 1 - fuzzing # SKIP clang with its sanitizers is not installed'
    echo '1..1'
    exit 0
fi
head='#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n'
mkdir "$work/seeds"
printf "$head"'-Y 2 +X 2\n\2\1\0\207\4\1\0\207\6\1\0\207\10\1\0\207' >"$work/seeds/flat"
printf "$head"'-Y 1 +X 4\n\2\1\0\207\1\1\1\3' >"$work/seeds/old"
printf "$head"'-Y 1 +X 8\n\2\2\0\10\10\2\4\6\10\12\14\16\20\210\1\210\0\210\207' >"$work/seeds/new"
printf 'PF\n1 2\n-1.0\n\0\0\0\100\0\0\0\100\0\0\0\100\0\0\200\77\0\0\200\77\0\0\200\77' >"$work/seeds/pfm"
printf 'Pf\n1 2\n1.0\n\100\0\0\0\77\200\0\0' >"$work/seeds/grey"
failed=0
report() { # STATUS NUMBER NAME
    [ "$1" -eq 0 ] || { failed=1; sed 's/^/# /' "$work/log"; printf 'not '; }
    echo "ok $2 - $3"
}
${MAKE:-make} -s "$B/fuzz/fuzz_environment" >"$work/log" 2>&1
report $? 1 'the fuzzer builds'
"$B/fuzz/fuzz_environment" -max_total_time="${seconds:-3}" -timeout=10 -max_len=4096 -verbosity=0 \
    -artifact_prefix="$B/fuzz/" "$work/seeds" >"$work/log" 2>&1
report $? 2 "any bytes as a map for ${seconds:-3} s"
echo '1..2'
exit $failed
