#!/bin/sh
# The pictures' program: the same bytes for any number of threads, a file that appears whole or not at all.
: "${B:=build}"
${MAKE:-make} -s "$B/pictures" "$B/lights_picture" "$B/environments_picture" || exit 1
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
n=0 failed=0

result() { # STATUS NAME
    n=$((n + 1))
    if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; failed=$((failed + 1)); fi
}

# refused NAME PATTERN ARGUMENTS...: status 2, the message matches, no picture
refused() {
    name=$1 pattern=$2
    shift 2
    "$B/pictures" "$@" >"$work/out" 2>"$work/err"
    status=$?
    [ $status -eq 2 ] && grep -qE -- "$pattern" "$work/err" && [ ! -e "$work/bad.png" ]
    good=$?
    [ $good -eq 0 ] || { echo "# status $status, said:"; sed 's/^/# /' "$work/err"; }
    result $good "$name"
}

for threads in 1 2 5; do
    "$B/pictures" --size 12 --threads $threads "$work/$threads.png" >"$work/out" 2>&1 || { cat "$work/out"; false; }
    result $? "a small picture with $threads threads"
done
cmp "$work/1.png" "$work/2.png" && cmp "$work/1.png" "$work/5.png"
result $? "the bytes do not depend on the threads"
printf 'text' >"$work/text.hdr"
refused "a bad map" "text.hdr: byte 0: found" --size 12 "$work/bad.png" "$work/text.hdr"
refused "no threads" "'--threads': --threads takes 1 to" --threads 0 "$work/bad.png"
refused "no output" "usage:"
refused "a folder that is not there" "cannot open for writing" --size 12 "$work/none/x.png"
for threads in 1 3; do
    "$B/lights_picture" --size 16 --threads $threads "$work/lights$threads.png" >"$work/out" 2>&1
    result $? "small lights with $threads threads"
done
cmp "$work/lights1.png" "$work/lights3.png"
result $? "the lights' bytes do not depend on the threads"
"$B/lights_picture" --size 7 "$work/bad.png" 2>"$work/err"
[ $? -eq 2 ] && grep -q -- "--size 8 to 1024" "$work/err" && [ ! -e "$work/bad.png" ]
result $? "lights too small are refused"
for threads in 1 3; do
    "$B/environments_picture" --size 24 --cube 16 --threads $threads lamps "$work/around$threads.png" >"$work/out" 2>&1
    result $? "a small room with $threads threads"
done
cmp "$work/around1.png" "$work/around3.png"
result $? "the room's bytes do not depend on the threads"
"$B/environments_picture" --cube 24 sky "$work/bad.png" 2>"$work/err"
[ $? -eq 2 ] && grep -q -- "--cube a power of 2" "$work/err" && [ ! -e "$work/bad.png" ]
result $? "a cube that cannot be halved is refused"
"$B/environments_picture" --size 24 --cube 16 "$work/text.hdr" "$work/bad.png" 2>"$work/err"
[ $? -eq 2 ] && grep -q "text.hdr: byte 0: found" "$work/err" && [ ! -e "$work/bad.png" ]
result $? "a bad map of a room is refused"
echo "1..$n"
[ $failed -eq 0 ]
