#!/bin/sh
# The archive and its header: what they need, what they hold, and what other flags make of them.
. harness/test/tap.sh
lib=$B/liblobe.a

no_undefined() {
    $NM "$lib" | awk '$1 == "U" { need[$2] = 1 } NF == 3 && $2 ~ /[TRDB]/ { have[$3] = 1 }
        END { for (s in need) if (!(s in have) && s !~ /^mem(cpy|set|move)$/) { print "needs", s; bad = 1 } exit bad }'
}
no_memory() { size "$lib" | awk 'NR > 1 && ($2 || $3) { print; bad = 1 } END { exit bad || NR < 2 }'; }
only_lobe_names() { ! $NM -g --defined-only "$lib" | awk 'NF == 3 { print $3 }' | grep -v '^lobe_'; }
one_object_a_tier() { # no object defines functions of two tiers; helpers, a few hundred bytes, may share one
    $NM -g --defined-only "$lib" | awk '/:$/ { object = $0 } NF == 3 && $2 == "T" && $3 ~ /_(low|medium|high|exact|zonal|lambert|table[0-9]+)_/ {
        n = $3; sub(/_(n_)?(f32|q30|q29)$/, "", n); sub(/^lobe_diffuse_(sh_|shape_)?/, "lobe_diffuse_", n); if (object in first && first[object] != n) { print object, n; bad = 1 }
        first[object] = n } END { exit bad }'
}
check 'no undefined symbol' no_undefined
check '0 bytes of data and bss' no_memory
check 'every public name starts with lobe_' only_lobe_names
check 'every tier in its own object' one_object_a_tier

# The table of sizes is for people: text of every object.
size -t "$lib" | awk 'NR > 1 { printf "# text %7d %s\n", $1, $6 }'

strict='-Wall -Wextra -Werror -pedantic'
printf '#include "lobe.h"\nint main(void) { return 0; }\n' >"$work/alone.c"
cp "$work/alone.c" "$work/alone.cpp"
check 'lobe.h alone as C99' $CC -std=c99 $strict -Imodels -c "$work/alone.c" -o "$work/alone.o"
check 'lobe.h alone as C++11' $CXX -std=c++11 $strict -Imodels -c "$work/alone.cpp" -o "$work/alone.o"
check 'linked from C++' sh -c "printf '#include \"lobe.h\"\nint main() {
    return lobe_split_sum_low_f32(0.5f, 0.7f).scale < 0.0f; }\n' >'$work/call.cpp' &&
    $CXX -std=c++11 $strict -Imodels '$work/call.cpp' '$lib' -o '$work/call' && '$work/call'"

# kernels compile alone, one by one, in C and in C++
kernels_alone() {
    for header in core/*.h models/*.h; do
        printf '#include "%s"\nint main(void) { return 0; }\n' "$header" >"$work/header.c"
        cp "$work/header.c" "$work/header.cpp"
        $CC -std=gnu99 -Wall -Wextra -Werror -I. -c "$work/header.c" -o "$work/header.o" || return 1
        $CXX -std=c++11 -Wall -Wextra -Werror -I. -c "$work/header.cpp" -o "$work/header.o" || return 1
    done
}
check 'every header of core and models compiles alone in C99 and C++11' kernels_alone

# A user's fast-math build may lose bits, not bounds. The runner keeps its own flags.
fast=$work/fast
fast_build() {
    mkdir "$fast"
    for source in models/f32/*.c models/q30/*.c models/tables/*.c; do
        [ ! -e "$source" ] || $CC -std=gnu99 -Ofast -c "$source" -o "$fast/$(echo "$source" | tr / _).o" || return 1
    done
    for source in lobecheck run eval hash_check bench bench_table hash_file vec_file rows conform_core hash registry; do
        set -- "$@" "$B/harness/$source.o"
    done
    $CC "$@" "$fast"/*.o -lm -o "$fast/lobecheck"
}
check 'the library builds with -Ofast' fast_build
if [ -e "$fast/lobecheck" ] && ls vectors/*.vec >/dev/null 2>&1; then
    check 'an -Ofast library keeps every bound' "$fast/lobecheck" run
else
    check 'vectors are there for the -Ofast library' false
fi
finish
