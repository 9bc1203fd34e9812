#!/bin/sh
# Everything compiles without a warning by gcc and clang: -Wall -Wextra -Wconversion -Werror.
. harness/test/tap.sh
for compiler in gcc:g++ clang:clang++; do
    cc=${compiler%:*} cxx=${compiler#*:}
    if ! command -v "$cc" >/dev/null; then
        skip "$cc" "$cc is not installed"
        continue
    fi
    dir=$B/warnings-$cc
    rm -rf "$dir"
    check "$cc: the library and the runner" \
        make -s -j2 B="$dir" CC="$cc" CXX="$cxx" WERROR=1 "$dir/liblobe.a" "$dir/lobecheck"
    check "$cc: the offline side" make -s -j2 B="$dir" CC="$cc" CXX="$cxx" WERROR=1 "$dir/lobefit"
done
finish
