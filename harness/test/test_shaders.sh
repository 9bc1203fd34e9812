#!/bin/sh
# Every kernel header through every shading language, in TAP: GLSL 450, GLSL ES 310 and 320, HLSL, OpenCL C 1.2,
# Metal (read as C++ with a shim, and written by spirv-cross), C99 and C++11. New headers are found by themselves.
# Also: `precise` covers each operation, so that a shader gives the library's bits.
cd "$(dirname "$0")/../.." || exit 2
. harness/test/tap.sh
root=$(pwd)

missing=
for tool in glslangValidator spirv-val spirv-dis spirv-cross clang gcc g++; do
    command -v $tool >/dev/null 2>&1 || missing="$missing $tool"
done
if [ -n "$missing" ]; then
    if [ -n "${LOBE_REQUIRE_ALL-}" ]; then
        check "tools are missing:$missing" false
    else
        skip shaders "missing:$missing"
    fi
    finish
fi

# A compute shader that includes the header and calls nothing of it; --keep-uncalled compiles it all the same.
shader() {
    echo "#version $1"
    case $1 in *es) printf 'precision highp float;\nprecision highp int;\n' ;; esac
    echo '#extension GL_GOOGLE_include_directive : require'
    echo "#include \"$2\""
    printf 'layout(local_size_x = 1) in;\nvoid main() {}\n'
}

glsl() { # VERSION HEADER OUT
    shader "$1" "$2" >"$work/s.comp"
    glslangValidator --keep-uncalled -V -I"$root" -I"$work" "$work/s.comp" -o "$3" && spirv-val "$3"
}

hlsl() { # HEADER OUT
    printf '#include "%s"\n[numthreads(1, 1, 1)] void main() {}\n' "$1" >"$work/s.hlsl"
    # -Od: its optimiser would drop what main does not call
    glslangValidator --keep-uncalled -Od -D -V -e main -S comp -DLOBE_HLSL=1 -I"$root" -I"$work" "$work/s.hlsl" \
        -o "$2" && spirv-val "$2"
}

# Functions in a module; HLSL adds one around main.
functions() { spirv-dis "$1" | grep -c ' = OpFunction '; }
same_functions() { [ "$(functions "$1")" -eq $(($(functions "$2") - 1)) ]; }

# Fails, and prints the operations, when a float operation may be contracted or reassociated.
all_precise() {
    spirv-dis "$1" | awk '
        /OpDecorate %[^ ]+ NoContraction/ { precise[$2] }
        /OpName / { name[$2] = $3 }
        / = OpFunction / { function_name = name[$1] }
        $2 == "=" && $3 ~ /^OpF(Add|Sub|Mul|Div)$/ && !($1 in precise) { print function_name ": " $0; bad = 1 }
        END { exit bad }'
}

back() { # SPIRV KIND
    case $2 in
    msl) spirv-cross --msl --msl-version 20000 "$1" --output "$work/b.metal" ;;
    essl) spirv-cross --es --version 310 "$1" --output "$work/b.comp" && glslangValidator "$work/b.comp" ;;
    hlsl) spirv-cross --hlsl --shader-model 50 "$1" --output "$work/b.hlsl" &&
        glslangValidator -D -V -e main -S comp "$work/b.hlsl" -o "$work/b.spv" ;;
    esac
}

opencl() {
    clang -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -fsyntax-only -Wall -Wextra -Werror \
        -Wno-unused-function "$@"
}

host() { # COMPILER LANGUAGE STANDARD HEADER OPTIONS...
    compiler=$1 language=$2 standard=$3 header=$4
    shift 4
    echo "#include \"$header\"" >"$work/h.inc"
    "$compiler" -x "$language" -std="$standard" -fsyntax-only -Wall -Wextra -Wpedantic -Werror -I"$root" "$@" "$work/h.inc"
}

for header in $(sh harness/dist/shader_headers.sh "$CC"); do
    check "$header GLSL 450" glsl 450 "$header" "$work/450.spv"
    check "$header GLSL 450 precise throughout" all_precise "$work/450.spv"
    check "$header GLSL ES 310" glsl '310 es' "$header" "$work/310.spv"
    check "$header GLSL ES 320" glsl '320 es' "$header" "$work/320.spv"
    check "$header GLSL ES 320 precise throughout" all_precise "$work/320.spv"
    check "$header HLSL" hlsl "$header" "$work/hlsl.spv"
    check "$header HLSL has GLSL's functions" same_functions "$work/450.spv" "$work/hlsl.spv"
    check "$header HLSL precise throughout" all_precise "$work/hlsl.spv"
    check "$header OpenCL C 1.2" opencl "$header"
    check "$header OpenCL C 1.2 double" opencl -DLOBE_DOUBLE "$header"
    check "$header Metal as C++14" host clang++ c++ c++14 "$header" -D__METAL_VERSION__=200 -include harness/test/metal_shim.h
    check "$header C99" host gcc c c99 "$header"
    check "$header C99 double" host gcc c c99 "$header" -DLOBE_DOUBLE
    check "$header C++11" host g++ c++ c++11 "$header"
done

# The one-file text, with a caller, through spirv-cross and back.
text=$B/dist/lobe.shader.h
check "$text is made" make -s "$text"
if [ -s "$text" ]; then
    awk -v want=list -f harness/ports/kernels.awk harness/registry_rows.h "$text" >"$work/kernels"
    check "$text has kernels" test -s "$work/kernels"
    while read -r kernel _; do
        {
            echo '#version 450'
            cat "$text"
            awk -v want=glsl -v kernel="$kernel" -f harness/ports/kernels.awk harness/registry_rows.h "$text"
        } >"$work/k.comp"
        check "$kernel to SPIR-V" glslangValidator -V "$work/k.comp" -o "$work/k.spv"
        check "$kernel precise throughout" all_precise "$work/k.spv"
        check "$kernel to Metal by spirv-cross" back "$work/k.spv" msl
        check "$kernel to HLSL and back" back "$work/k.spv" hlsl
    done <"$work/kernels"
fi

# The check above is worth something only if it catches a kernel that breaks the rule.
cat >"$work/careless.h" <<'END'
#include "core/dialect.h"
LOBE_FN lobe_real careless(lobe_real x, lobe_real y) { return x * y + LOBE_R(1.0); }
END
careless() { "$@" "$work/c.spv" && ! all_precise "$work/c.spv"; }
check "arithmetic outside LOBE_LET is caught in GLSL" careless glsl 450 careless.h
check "arithmetic outside LOBE_LET is caught in HLSL" careless hlsl careless.h

finish
