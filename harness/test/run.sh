#!/bin/sh
# Runs test programs and scripts that speak TAP, and ends with one line: N passed, N failed, N skipped.
# A program that dies, or reports nothing, counts as a failure of its own.
# Usage: harness/test/run.sh TEST...
passed=0 failed=0 skipped=0
for t in "$@"; do
    printf '# %s\n' "$t"
    out=$(CMOCKA_MESSAGE_OUTPUT=TAP "$t" 2>&1)
    status=$?
    printf '%s\n' "$out"
    s=$(printf '%s\n' "$out" | grep -cE '^ok .*# *(SKIP|skip)')
    p=$(printf '%s\n' "$out" | grep -cE '^ok ')
    f=$(printf '%s\n' "$out" | grep -cE '^not ok ')
    if [ $status -ne 0 ] && [ "$f" -eq 0 ] || [ $((p + f)) -eq 0 ]; then
        printf 'not ok - %s exits %d after %d results\n' "$t" $status $((p + f))
        f=$((f + 1))
    fi
    passed=$((passed + p - s)) failed=$((failed + f)) skipped=$((skipped + s))
done
printf '%d passed, %d failed, %d skipped\n' $passed $failed $skipped
[ $failed -eq 0 ]
