#!/bin/sh
# `make conform` as TAP: every vector and every hash on every target, a result a target.
. harness/test/tap.sh
make -s conform B="$B" >"$work/out" 2>&1
status=$?
awk '$1 == "target" { on = 1; next } /^instructions:/ { on = 0 } on && /^[a-z]/ { print $1, $NF }' "$work/out" >"$work/rows"
check 'targets ran' [ -s "$work/rows" ]
while read -r target verdict; do
    case $verdict in
    missing:*) skip "$target" "${verdict#missing:} is missing" ;;
    *) check "$target" [ "$verdict" = pass ] ;;
    esac
done <"$work/rows"
check 'make conform agrees' [ $status -eq 0 ]
[ $status -eq 0 ] || sed 's/^/# /' "$work/out"
finish
