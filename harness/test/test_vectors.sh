#!/bin/sh
# The committed vectors and hashes: every tier and format has its own, and this build keeps them.
. harness/test/tap.sh

"$B/lobecheck" list | awk '!/^#/ { print $1 "." $2 "." $3, $5 }' >"$work/entries"
while read -r name max; do
    check "vectors/$name.vec is there" test -s "vectors/$name.vec"
    # An edited or stale bound would let a wrong function pass. 1 % is for how the two were printed.
    stated() {
        awk -v max="$max" '/^# bound_max: / { d = $3 / max; good = d > 0.99 && d < 1.01 } END { exit !good }' \
            "vectors/$name.vec"
    }
    check "vectors/$name.vec states the bound of the library" stated
    enough() { [ "$(grep -vc '^#' "vectors/$name.vec")" -ge 200 ]; }
    check "vectors/$name.vec has at least 200 rows" enough
    case $name in
    energy.low.*) floor=0.0125 ;;
    energy.medium.*) floor=0.006 ;;
    energy.high.*) floor=0.003 ;;
    *) continue ;;
    esac
    furnace() {
        awk -v floor=$floor '/^# bound_furnace: / { good = $3 > 0 && $3 <= floor } END { exit !good }' \
            "vectors/$name.vec"
    }
    check "vectors/$name.vec holds 1/E to the furnace's floor $floor" furnace
done <"$work/entries"
check 'this build keeps every bound' exits 0 '' "$B/lobecheck" run
check 'this build has every committed hash' exits 0 '' "$B/lobecheck" hash
truths() { # both formats of a tier are judged by the same truth
    for f32 in vectors/*.f32.vec; do
        grep -v '^#' "$f32" >"$work/f32"
        grep -v '^#' "${f32%.f32.vec}.q30.vec" | cmp - "$work/f32" || return 1
    done
}
check 'f32 and q30 have the same rows' truths
finish
