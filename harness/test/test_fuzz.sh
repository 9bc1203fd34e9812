#!/bin/sh
# The parsers under libFuzzer and the sanitizers: a moment. `make fuzz` runs them as long as wanted.
. harness/test/tap.sh
seconds=${FUZZ_SECONDS:-${LOBE_REQUIRE_ALL:+8}}
printf 'int main(void) { return 0; }\n' >"$work/probe.c"
if [ -z "${LOBE_REQUIRE_ALL-}" ] && ! clang -fsanitize=address "$work/probe.c" -o "$work/probe" 2>"$work/err"; then
    skip 'fuzzing' 'clang with its sanitizers is not installed'
else
    check 'the fuzzers build' ${MAKE:-make} -s "$B/fuzz/fuzz_vec" "$B/fuzz/fuzz_rows"
    harness/fuzz/seeds.sh "$work/seeds"
    for parser in vec rows; do
        check "any bytes as $parser for ${seconds:-3} s" "$B/fuzz/fuzz_$parser" -max_total_time="${seconds:-3}" \
            -timeout=10 -max_len=8192 -verbosity=0 -artifact_prefix="$B/fuzz/" "$work/seeds/$parser"
    done
fi
finish
