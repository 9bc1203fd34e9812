#!/bin/sh
# The library, the runner and their unit tests under the address and undefined-behaviour sanitizers.
. harness/test/tap.sh
san=$B/sanitize
flags='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all'
units=$(sed -n -e ':more' -e '/\\$/{N;s/\\\n//;b more' -e '}' -e 's/^UNIT_TESTS := //p' harness/harness.mk)
programs=
for unit in $units; do programs="$programs $san/test/test_$unit"; done
check 'builds' ${MAKE:-make} -s B="$san" CFLAGS="$flags" "$san/lobecheck" "$san/embed_vectors" $programs
for unit in $units; do
    check "test_$unit" "$san/test/test_$unit"
done
check 'every vector file' "$san/lobecheck" run
check 'every hash' "$san/lobecheck" hash
finish
