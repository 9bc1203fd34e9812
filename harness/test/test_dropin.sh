#!/bin/sh
# What `make dist` and `make install` give to others, in TAP: the two files compile alone and reproduce the committed
# hashes; the shader text serves an example in each language; a program builds against the installed tree.
cd "$(dirname "$0")/../.." || exit 2
. harness/test/tap.sh

# needs NAME TOOL...: 1, and a skipped (or, in CI, failed) test, where a tool is not installed.
needs() {
    name=$1
    shift
    for tool in "$@"; do
        command -v "$tool" >/dev/null 2>&1 && continue
        if [ -n "${LOBE_REQUIRE_ALL-}" ]; then
            check "$name: $tool is missing" false
        else
            skip "$name" "$tool is missing"
        fi
        return 1
    done
}

check "make dist" make -s dist
cp "$B/dist/lobe.c" "$work/first.c"
cp "$B/dist/lobe.shader.h" "$work/first.shader.h"
rm -f "$B"/dist/lobe.*
check "make dist again" make -s dist
check "lobe.c has the same bytes twice" cmp "$work/first.c" "$B/dist/lobe.c"
check "lobe.shader.h has the same bytes twice" cmp "$work/first.shader.h" "$B/dist/lobe.shader.h"
# A path of this machine, or an include that was not resolved, would tie the files to this checkout.
foreign() { ! grep -nE '^ *# *include "' "$1" | grep -v '"lobe\.h"'; }
check "lobe.c includes only lobe.h and the system" foreign "$B/dist/lobe.c"
check "lobe.shader.h includes no file" foreign "$B/dist/lobe.shader.h"

for way in gcc:gcc-c99 clang:clang-c99 g++:gcc-c++11 clang++:clang-c++11; do
    needs "lobe.c by ${way#*:}" "${way%%:*}" || continue
    check "lobe.c compiles alone by ${way#*:}" make -s "$B/dropin/${way#*:}.o"
    check "lobe.c by ${way#*:} links with lobecheck" make -s "$B/dropin/lobecheck-${way#*:}"
    check "lobe.c by ${way#*:} reproduces the committed hashes" "$B/dropin/lobecheck-${way#*:}" hash
done

example() { cp "harness/dist/example.$1" "$work" && (cd "$work" && shift && "$@"); }
cp "$B/dist/lobe.shader.h" "$work"
: >"$work/metal_stdlib"
cp harness/test/metal_shim.h "$work"
if needs "example shaders" glslangValidator spirv-val; then
    check "example.comp as GLSL 450" example comp glslangValidator -V -I. example.comp -o c.spv
    check "example.comp is valid SPIR-V" spirv-val "$work/c.spv"
    check "example.frag as GLSL ES 310" example frag glslangValidator -V -I. example.frag -o f.spv
    check "example.frag is valid SPIR-V" spirv-val "$work/f.spv"
    check "example.hlsl as HLSL" example hlsl glslangValidator -D -V -e main -S frag -I. example.hlsl -o h.spv
    check "example.hlsl is valid SPIR-V" spirv-val "$work/h.spv"
fi
if needs "example kernels" clang clang++; then
    check "example.cl as OpenCL C 1.2" example cl clang -x cl -cl-std=CL1.2 -Xclang -finclude-default-header \
        -fsyntax-only -Wall -Wextra -Werror -Wno-unused-function example.cl
    # No Metal compiler runs here: clang reads it as C++14, with Metal's own words defined away.
    check "example.metal as C++14" example metal clang++ -x c++ -std=c++14 -D__METAL_VERSION__=200 -Ddevice= \
        -Dkernel= -include metal_shim.h -I. -fsyntax-only -Wall -Wextra -Werror -Wno-unknown-attributes \
        -Wno-ignored-attributes -Wno-unused-function example.metal
fi

check "make install" make -s install PREFIX=/opt/lobe DESTDIR="$work/root"
for file in lib/liblobe.a lib/pkgconfig/lobe.pc include/lobe.h include/lobe/lobe.shader.h \
    include/lobe/core/dialect.h include/lobe/models/split_sum.h; do
    check "installs $file" test -s "$work/root/opt/lobe/$file"
done
if needs "a program against the installed tree" pkg-config gcc g++; then
    export PKG_CONFIG_SYSROOT_DIR="$work/root" PKG_CONFIG_PATH="$work/root/opt/lobe/lib/pkgconfig"
    # shellcheck disable=SC2046
    check "a C program builds by pkg-config" gcc -std=c99 -Wall -Wextra -Werror harness/dist/example.c \
        $(pkg-config --cflags --libs lobe) -o "$work/example"
    check "it runs" "$work/example"
    # shellcheck disable=SC2046
    check "it builds as C++ too" g++ -x c++ -std=c++11 -Wall -Wextra -Werror harness/dist/example.c -x none \
        $(pkg-config --cflags --libs lobe) -o "$work/example++"
    # shellcheck disable=SC2046
    printf '#include <lobe/models/split_sum.h>\nint main(void) { return !(lobe_split_sum_low(0.5f, 0.5f).scale > 0); }\n' \
        >"$work/kernel.c"
    # shellcheck disable=SC2046
    check "an installed kernel header compiles inline" gcc -std=c99 -Wall -Wextra -Werror "$work/kernel.c" \
        $(pkg-config --cflags lobe) -o "$work/kernel"
    check "and runs" "$work/kernel"
fi

finish
