#!/bin/sh
# Every header of core, in one text, through every language that the dialect promises. A compiler that is not
# installed is a skip; CC and CXX name the host's.
cd "$(dirname "$0")/../.." || exit 2
scratch=$(mktemp -d) || exit 2
trap 'rm -rf "$scratch"' EXIT
count=0

# check NAME TOOL COMMAND...: one TAP line.
check()
{
    name=$1 tool=$2
    shift 2
    count=$((count + 1))
    if ! command -v "$tool" >/dev/null 2>&1; then
        echo "ok $count - $name # SKIP $tool is not installed"
    elif "$@" >"$scratch/out" 2>&1; then
        echo "ok $count - $name"
    else
        sed 's/^/# /' "$scratch/out"
        echo "not ok $count - $name"
    fi
}

# q30 is C; the rest is for every language.
shared=$(ls core/*.h | grep -v q30)
for h in $shared; do echo "#include \"$h\""; done >"$scratch/all.h"
cat "$scratch/all.h" >"$scratch/all.cl"
{ cat "$scratch/all.h"; echo '#include "core/q30.h"'; for h in core/q30_*.h; do echo "#include \"$h\""; done; echo 'int main(void) { return 0; }'; } >"$scratch/all.c"
use='lobe_frame f = lobe_frame_around(lobe_vec3_of(o[0], o[1], o[2]));
    lobe_uv uv = lobe_equal_area_encode(f.tangent);
    o[3] = lobe_pow(uv.u, uv.v) + lobe_schlick(o[1], o[2], o[3]) + lobe_smith_v_correlated(o[0], o[1], o[2]);'

strict='-Wall -Wextra -Wconversion -Wno-unused-function -Werror -O1 -I. -c -o'
for scalar in '' -DLOBE_DOUBLE; do
    for cc in gcc clang; do
        check "C99 $cc $scalar" $cc $cc -std=c99 -pedantic $scalar $strict "$scratch/o" "$scratch/all.c"
    done
    for cxx in g++ clang++; do
        check "C++11 $cxx $scalar" $cxx $cxx -x c++ -std=c++11 $scalar $strict "$scratch/o" "$scratch/all.c"
    done
    check "OpenCL C 1.2 $scalar" clang clang -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -fsyntax-only \
        -Wall -Wno-unused-function -Werror $scalar -I. "$scratch/all.cl"
done
check 'Cortex-M0' arm-none-eabi-gcc arm-none-eabi-gcc -std=gnu99 -mcpu=cortex-m0 -mthumb $strict "$scratch/o" \
    "$scratch/all.c"

for version in '450 core' '310 es' '320 es'; do
    {
        echo "#version $version"
        echo '#extension GL_GOOGLE_include_directive : enable'
        echo 'precision highp float; precision highp int; layout(local_size_x = 1) in;'
        cat "$scratch/all.h"
        echo "layout(std430, binding = 0) buffer B { float o[]; }; void main() { $use }"
    } >"$scratch/all.comp"
    check "GLSL $version" glslangValidator glslangValidator -V -I. -S comp -o "$scratch/glsl.spv" "$scratch/all.comp"
done
check 'GLSL to MSL' spirv-cross spirv-cross --msl "$scratch/glsl.spv"
{
    echo '#define LOBE_HLSL'
    cat "$scratch/all.h"
    echo "RWStructuredBuffer<float> o; [numthreads(1, 1, 1)] void main() { $use }"
} >"$scratch/all.hlsl"
check HLSL glslangValidator glslangValidator -D -e main -S comp -V -I. -o "$scratch/hlsl.spv" "$scratch/all.hlsl"

# Metal has no compiler here: clang reads that branch as C++ with the three Metal words it needs.
{
    echo 'typedef unsigned uint; float sqrt(float); template <class T, class F> T as_type(F f)'
    echo '{ T t; __builtin_memcpy(&t, &f, sizeof t); return t; }'
    echo '#define __METAL_VERSION__ 200'
    cat "$scratch/all.h"
} >"$scratch/metal.cpp"
check 'Metal branch as C++' clang++ clang++ -std=c++14 -fsyntax-only -Wall -Wno-unused-function -Werror -I. \
    "$scratch/metal.cpp"
echo "1..$count"
