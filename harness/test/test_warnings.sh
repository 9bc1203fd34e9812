#!/bin/sh
# Everything compiles without a warning by gcc and clang: -Wall -Wextra -Wconversion -Werror.
. harness/test/tap.sh
# Clang finds what it warns of before it optimises, gcc some of it after.
for compiler in gcc:g++:-O2 clang:clang++:-O0; do
    cc=${compiler%%:*} level=${compiler##*:} cxx=${compiler#*:}
    cxx=${cxx%:*}
    if ! command -v "$cc" >/dev/null; then
        skip "$cc" "$cc is not installed"
        continue
    fi
    dir=$B/warnings-$cc
    rm -rf "$dir"
    check "$cc: the library and the runner" \
        make -s -j2 B="$dir" CC="$cc" CXX="$cxx" WERROR=1 CFLAGS="$level" "$dir/liblobe.a" "$dir/lobecheck"
    check "$cc: the offline side" \
        make -s -j2 B="$dir" CC="$cc" CXX="$cxx" WERROR=1 CFLAGS="$level" CASES_OPT="$level" "$dir/lobefit"
done
finish
