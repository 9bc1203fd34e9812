#!/bin/sh
# The readers of cubes under libFuzzer and the sanitizers: a moment here, 30 seconds where everything is required.
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
# One cube of each format, with all its mips.
mkdir "$work/seeds"
printf 'PF\n2 1\n-1\n\0\0\200\77\0\0\200\77\0\0\200\77\0\0\0\77\0\0\0\77\0\0\0\77' >"$work/map.pfm"
for format in dds ktx2; do
    "$B/lobefit" prefilter "$work/map.pfm" --size 4 --mips 2 --out "$work/seeds/cube.$format" >"$work/log" 2>&1 || exit 1
done
failed=0
report() { # STATUS NUMBER NAME
    [ "$1" -eq 0 ] || { failed=1; sed 's/^/# /' "$work/log"; printf 'not '; }
    echo "ok $2 - $3"
}
${MAKE:-make} -s "$B/fuzz/fuzz_cube" >"$work/log" 2>&1
report $? 1 'the fuzzer builds'
"$B/fuzz/fuzz_cube" -max_total_time="${seconds:-3}" -timeout=10 -max_len=4096 -verbosity=0 \
    -artifact_prefix="$B/fuzz/" "$work/seeds" >"$work/log" 2>&1
report $? 2 "any bytes as a cube for ${seconds:-3} s"
echo '1..2'
exit $failed
