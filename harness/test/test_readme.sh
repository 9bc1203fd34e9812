#!/bin/sh
# README: its commands work, its examples are the files that other tests compile, its table is what was measured.
. harness/test/tap.sh

# Every line of the sh block.
awk '/^```sh$/ { on = 1; next } /^```$/ { on = 0 } on' README.md >"$work/commands"
check 'README shows commands' [ -s "$work/commands" ]
while read -r line; do
    check "$line" sh -ec "$(printf '%s' "$line" | sed "s#build/#$B/#g")"
done <"$work/commands"

# Every code block of another language is one of the examples, word for word.
awk -v out="$work/block" '/^```(c|glsl|hlsl|metal)$/ { on = 1; n++; next } /^```$/ { on = 0 } on { print >(out n) }' README.md
blocks=0
for example in harness/dist/example.*; do
    found=no
    for block in "$work"/block*; do cmp -s "$block" "$example" && found=yes; done
    check "README has ${example##*/}" [ $found = yes ]
    blocks=$((blocks + 1))
done
check 'and no other code' [ "$(ls "$work"/block* | wc -l)" = $blocks ]

# The last column, bytes of code, depends on the compiler.
columns() { sed 's/|[^|]*|$/|/'; }
harness/readme_table.sh "$B/liblobe.a" | columns >"$work/measured"
grep -E '^\| `(split_sum|split_sum_sep|energy|diffuse_sh|sphere_light)[^|]*` \| [a-z0-9_]+ \| [0-9]+ \|' README.md | columns >"$work/stated"
check 'the table is what was measured' diff "$work/measured" "$work/stated"
for figure in $(grep -oE '\]\([a-z][^)]*\)' README.md | tr -d '])('); do
    check "README links to $figure, which exists" [ -e "$figure" ]
done
finish
