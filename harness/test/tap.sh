# TAP for shell tests: `. harness/test/tap.sh`, then check NAME COMMAND..., last `finish`.
# B, CC, CXX, AR and NM come from the Makefile.
: "${B:=build}" "${CC:=cc}" "${CXX:=c++}" "${NM:=nm}"
tap_count=0 tap_failed=0
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT

# Passes where the command succeeds; shows what it printed where it does not.
check() {
    tap_name=$1
    shift
    tap_count=$((tap_count + 1))
    if "$@" >"$work/tap.log" 2>&1; then
        printf 'ok %d - %s\n' $tap_count "$tap_name"
    else
        printf 'not ok %d - %s\n' $tap_count "$tap_name"
        sed 's/^/# /' "$work/tap.log"
        tap_failed=$((tap_failed + 1))
    fi
}

skip() {
    tap_count=$((tap_count + 1))
    printf 'ok %d - %s # SKIP %s\n' $tap_count "$1" "$2"
}

# exits STATUS WORDS COMMAND...: the command ends with that status and prints something with these words on
# standard error ('' for any or none). Standard input is $work/in where that exists.
exits() {
    want=$1 words=$2
    shift 2
    [ -e "$work/in" ] || : >"$work/in"
    "$@" <"$work/in" >"$work/out" 2>"$work/err"
    got=$?
    cat "$work/out" "$work/err"
    [ $got -eq "$want" ] || { echo "exit status $got, expected $want"; return 1; }
    [ "$want" -ne 2 ] || [ -s "$work/err" ] || { echo "says nothing on standard error"; return 1; }
    [ -z "$words" ] || grep -qF -- "$words" "$work/err" || { echo "does not say: $words"; return 1; }
}

finish() {
    printf '1..%d\n' $tap_count
    [ $tap_failed -eq 0 ]
    exit
}
