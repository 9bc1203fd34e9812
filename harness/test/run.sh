#!/bin/sh
# Runs test programs and scripts that speak TAP, and ends with one line: N passed, N failed, N skipped.
# A program that dies, or reports nothing, counts as a failure of its own.
# Usage: harness/test/run.sh TEST...
# Two run at a time: scripts that call make, which would build the same files twice, one after another in one lane, all
# others in the other. Each says how long it took; results appear in the order of the arguments.
results=$(mktemp -d) || exit 2
lanes=
trap 'kill $lanes 2>/dev/null; rm -rf "$results"' EXIT
trap 'exit 130' INT TERM

calls_make() { case $1 in *.sh) grep -qE '(^|[^a-z])make |MAKE' "$1" ;; *) false ;; esac }

run_lane() {
    wanted=$1 i=0
    shift
    for t in "$@"; do
        i=$((i + 1))
        if calls_make "$t"; then lane='make'; else lane='plain'; fi
        [ "$lane" = "$wanted" ] || continue
        start=$(date +%s)
        CMOCKA_MESSAGE_OUTPUT=TAP "$t" >"$results/$i.out" 2>&1
        status=$?
        echo "$status $(($(date +%s) - start))" >"$results/$i.new"
        mv "$results/$i.new" "$results/$i.status"
    done
}

run_lane make "$@" &
lanes=$!
run_lane plain "$@" &
lanes="$lanes $!"

alive() { for lane in $lanes; do kill -0 "$lane" 2>/dev/null && return; done; return 1; }

passed=0 failed=0 skipped=0 n=0
for t in "$@"; do
    n=$((n + 1))
    until [ -e "$results/$n.status" ]; do
        alive || [ -e "$results/$n.status" ] || { : >>"$results/$n.out"; echo 255 0 >"$results/$n.status"; }
        sleep 0.2
    done
    read -r status seconds <"$results/$n.status"
    printf '# %s\n' "$t"
    cat "$results/$n.out"
    printf '# %d s\n' "$seconds"
    s=$(grep -cE '^ok .*# *(SKIP|skip)' "$results/$n.out")
    p=$(grep -cE '^ok ' "$results/$n.out")
    f=$(grep -cE '^not ok ' "$results/$n.out")
    if [ "$status" -ne 0 ] && [ "$f" -eq 0 ] || [ $((p + f)) -eq 0 ]; then
        printf 'not ok - %s exits %d after %d results\n' "$t" "$status" $((p + f))
        f=$((f + 1))
    fi
    passed=$((passed + p - s)) failed=$((failed + f)) skipped=$((skipped + s))
done
printf '%d passed, %d failed, %d skipped\n' $passed $failed $skipped
[ $failed -eq 0 ]
