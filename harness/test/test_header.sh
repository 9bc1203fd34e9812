#!/bin/sh
# models/lobe.h with its parts states the errors and costs that were measured: the figures in the comment above a tier's
# function are those of the registry, which has them from models/coeffs/*_bounds.h.
. harness/test/tap.sh
"$B/lobecheck" list | awk '$3 == "f32" && $1 != "#" { print $1, $2, $4, $5, $7, $10 }' >"$work/tiers"
check 'there are tiers' [ -s "$work/tiers" ]

# comment FUNCTION: the last comment before its declaration, on one line
comment() {
    awk -v name=" $1(" '/^\/\*/ { text = "" } { line = $0 } /^ ?\/?\*/ { text = text " " $0 } index(" " line, name) { print text; exit }' models/lobe*.h
}
# cells MODEL TIER: what is stated of scenes, where a model is judged by them
cells() {
    prefix=$(printf 'LOBE_%s_%s_F32_CELLS' "$1" "$2" | tr '[:lower:]' '[:upper:]')
    sed -n "s/^#define $prefix\([A-Z0-9_]*\) /cells\1:/p" "models/coeffs/${1}_bounds.h" | grep -v 'EXCESS:0$'
}
while read -r model tier ops max below function; do
    comment "$function" >"$work/comment"
    for figure in "max:$max" "ops:$ops" "below:$below" $(cells "$model" "$tier"); do
        value=${figure#*:}
        # a table's stand in one comment for all, without what is below
        case $tier:$figure in table*:below:*) continue ;; esac
        pattern=$(printf '%s' "$value" | sed 's/^0\././; s/\./[.]/; s/^/(^|[^0-9.])0?/; s/$/([^0-9]|$)/')
        check "$function states ${figure%%:*} $value" grep -qE -- "$pattern" "$work/comment"
    done
done <"$work/tiers"
finish
