#!/bin/sh
# Vectors as arrays, and the program for targets without files, built for this host.
. harness/test/tap.sh
. harness/test/seal.sh
parts="conform.o conform_report.o port_stdio.o conform_core.o hash.o registry.o"
objects=
for part in $parts; do objects="$objects $B/harness/$part"; done

printf '0.5 0.5\n1 0.25\n0.125 1\n' >"$work/in"
"$B/lobecheck" eval split_sum --tier low --format f32 <"$work/in" | paste -d' ' "$work/in" - |
    seal split_sum low f32 0.01 'roughness n_dot_v' 'scale bias' >"$work/good.vec"
"$B/lobecheck" eval split_sum --tier low --format f32 <"$work/in" | paste -d' ' "$work/in" - |
    awk 'NR == 2 { $4 = sprintf("%.9g", $4 + 0.5) } { print }' |
    seal split_sum low f32 1 'roughness n_dot_v' 'scale bias' >"$work/moved.vec"
"$B/lobecheck" hash --write --file "$work/hashes.txt"
sed '$s/[0-9a-f]*$/0123456789abcdef/' "$work/hashes.txt" >"$work/wrong.txt"
rm "$work/in"

# conform NAME ARGUMENTS...: builds the program with these vectors
conform() {
    name=$1
    shift
    "$B/embed_vectors" "$@" >"$work/$name.c" &&
        $CC -std=gnu99 -Wall -Wextra -Werror -Iharness "$work/$name.c" $objects "$B/liblobe.a" -o "$work/$name"
}
check 'good vectors as a program' conform good --hashes "$work/hashes.txt" "$work/good.vec"
check 'it passes' exits 0 '' "$work/good"
check 'with every row' grep -qE '^vectors split_sum low f32 rows 3 passed 3 worst 0\.00000000. at .* ok$' "$work/out"
check 'and every hash' sh -c "grep -q '^hash' '$work/out' && ! grep '^hash' '$work/out' | grep -v ' ok$'"
check 'the hashes are those of lobecheck' sh -c "grep ^hash '$work/out' | awk '{ print \$2, \$3, \$4, \$5 }' |
    sort | diff - '$work/sorted'" -- "$(grep -v '^#' "$work/hashes.txt" | sort >"$work/sorted")"
check 'and last comes the verdict' sh -c "[ \"\$(tail -n 1 '$work/out')\" = 'conform: ok' ]"
check 'moved vectors as a program' conform moved --hashes "$work/hashes.txt" "$work/moved.vec"
check 'it fails' exits 1 '' "$work/moved"
check 'at the moved row' grep -qE 'rows 3 passed 2 worst 0\.(5000000|4999999).. at 3f800000 3e800000 got .* BROKEN$' "$work/out"
check 'a wrong hash as a program' conform wrong --hashes "$work/wrong.txt" "$work/good.vec"
check 'it fails too' exits 1 '' "$work/wrong"
check 'at the hash' grep -q '^hash .* differs$' "$work/out"
check 'every second row' conform half --every 2 "$work/good.vec"
check 'two of three are left; hashes are unknown' sh -c "'$work/half' >'$work/out'; [ \$? -eq 1 ] &&
    grep -q 'rows 2 passed 2' '$work/out' && grep -q '^hash .* unknown$' '$work/out'"
check 'no files' exits 2 'embed_vectors [--every' "$B/embed_vectors"
check 'a missing file, and nothing written' sh -c "
    '$B/embed_vectors' '$work/good.vec' missing.vec >'$work/out' 2>'$work/err'
    [ \$? -eq 2 ] && [ ! -s '$work/out' ] && grep -q 'missing.vec: cannot be opened' '$work/err'"
check '--every 0' exits 2 '--every N (1' "$B/embed_vectors" --every 0 "$work/good.vec"
check 'malformed hashes' exits 2 'good.vec:' "$B/embed_vectors" --hashes "$work/good.vec" "$work/good.vec"
finish
