#!/bin/sh
# The readers of cubes under libFuzzer and the sanitizers: a moment. `make fuzz` runs them as long as wanted.
: "${B:=build}"
seconds=${FUZZ_SECONDS:-${LOBE_REQUIRE_ALL:+5}}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
printf 'int main(void) { return 0; }\n' >"$work/probe.c"
if [ -z "${LOBE_REQUIRE_ALL-}" ] && ! clang -fsanitize=fuzzer-no-link,address "$work/probe.c" -o "$work/probe" 2>"$work/err"; then
    echo 'ok 1 - fuzzing # SKIP clang with its sanitizers is not installed'
    echo '1..1'
    exit 0
fi
failed=0
report() { # STATUS NUMBER NAME
    [ "$1" -eq 0 ] || { failed=1; sed 's/^/# /' "$work/log"; printf 'not '; }
    echo "ok $2 - $3"
}
{ ${MAKE:-make} -s "$B/fuzz/fuzz_cube" && cases/test/fuzz_seeds.sh "$B/lobefit" "$work/seeds"; } >"$work/log" 2>&1
report $? 1 'the fuzzer builds'
"$B/fuzz/fuzz_cube" -max_total_time="${seconds:-2}" -timeout=10 -max_len=4096 -verbosity=0 \
    -artifact_prefix="$B/fuzz/" "$work/seeds/cube" >"$work/log" 2>&1
report $? 2 "any bytes as cubes for ${seconds:-2} s"
echo '1..2'
exit $failed
