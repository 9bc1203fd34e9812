#!/bin/sh
# What lobefit emits, given to the compilers of each language, and emitted C run against the kernel.
# Usage: test_emit_languages.sh LOBEFIT FPCORE-TEST FOLDER; CC is taken from the environment.
lobefit=$1 fpcore=$2 dir=$3
cc=${CC:-cc}
number=0 failed=0
mkdir -p "$dir"

result() { # status, name
    number=$((number + 1))
    if [ "$1" -eq 0 ]; then
        echo "ok $number - $2"
    else
        failed=$((failed + 1))
        echo "not ok $number - $2"
        sed 's/^/# /' "$dir/log" | head -n 20
    fi
}

skip() { # reason, name
    number=$((number + 1))
    echo "ok $number - $2 # SKIP $1"
}

shader() { # stage, options, name
    if command -v glslangValidator >/dev/null 2>&1; then
        # shellcheck disable=SC2086
        glslangValidator $2 -S "$1" -o "$dir/out.spv" "$4" >"$dir/log" 2>&1
        result $? "$3"
    else
        skip "glslangValidator is missing" "$3"
    fi
}

for header in models/coeffs/*_low.h models/coeffs/*_medium.h models/coeffs/*_high.h models/coeffs/*_exact.h \
    models/coeffs/*_zonal.h; do
    [ -f "$header" ] || continue
    name=$(basename "$header" .h)
    case $name in sphere_* | capsule_* | sg_*) continue ;; esac # lights of a size are not emitted
    case $name in *_zonal_low) tier=zonal_low ;; *) tier=${name##*_} ;; esac
    model=${name%_"$tier"}
    one=$dir/$name
    for to in c cl glsl es hlsl fpcore; do
        # es is GLSL ES: the same text with precisions
        "$lobefit" emit "$model" --tier "$tier" --to "$to" >"$one.$to" 2>"$dir/log" || result 1 "$name: emits $to"
    done

    pair=2 outputs= kernels=$model
    case $name in
    energy*) pair= outputs=-DENERGY ;;
    diffuse_sh_zonal*) pair=9 outputs=-DSH9 kernels=diffuse_zonal ;;
    diffuse_sh*) pair=9 outputs=-DSH9 ;;
    esac
    mv "$one.c" "$one.emitted.c"
    # shellcheck disable=SC2086
    $cc -std=gnu99 -ffp-contract=off -fno-math-errno -O2 -Wall -Wextra -Werror "-Dlobe_$name=emitted" -I. -c \
        "$one.emitted.c" -o "$one.o" >"$dir/log" 2>&1 &&
        $cc -std=gnu99 -ffp-contract=off -fno-math-errno -O2 $outputs "-DKERNEL=lobe_$name" -DEMITTED=emitted \
            "-DHEADER=\"../../models/$kernels.h\"" cases/test/test_emit_bits.c "$one.o" -lm -o "$one.run" >"$dir/log" 2>&1 &&
        "$one.run" >"$dir/log" 2>&1
    result $? "$name: emitted C has the bits of the kernel"

    if command -v clang >/dev/null 2>&1; then
        clang -x cl -cl-std=CL1.2 -Xclang -finclude-default-header -fsyntax-only "$one.cl" >"$dir/log" 2>&1
        result $? "$name: emitted OpenCL C compiles"
    else
        skip "clang is missing" "$name: emitted OpenCL C compiles"
    fi

    nine='t.x, t.y, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]'
    [ "$pair" != 9 ] || body="void main() { vec2 t = gl_FragCoord.xy; float c[9]; lobe_$name($nine);
                     o = vec4(c[0], c[2], c[3], c[8]); }"
    [ "$pair" = 9 ] || body="void main() { vec2 t = gl_FragCoord.xy; o = vec4(lobe_$name(t.x, t.y)${pair:+, 0.0, 0.0}); }"
    { echo '#version 450'; echo 'layout(location = 0) out vec4 o;'; cat "$one.glsl"; echo "$body"; } >"$one.frag"
    shader frag "-V" "$name: emitted GLSL compiles" "$one.frag"
    { echo '#version 320 es'; echo 'layout(location = 0) out highp vec4 o;'; cat "$one.es"
      echo "$body" | sed 's/vec2 t/highp vec2 t/; s/float c\[9\]/highp float c[9]/'; } >"$one.es.frag"
    shader frag "-V" "$name: emitted GLSL ES compiles" "$one.es.frag"
    case $pair in
    9) main="float c[9]; lobe_$name($nine); return float4(c[0], c[2], c[3], c[8]);" ;;
    2) main="return float4(lobe_$name(t.x, t.y), 0.0, 0.0);" ;;
    *) main="return (float4)(lobe_$name(t.x, t.y));" ;;
    esac
    { cat "$one.hlsl"; echo "float4 main(float2 t : TEXCOORD0) : SV_Target { $main }"; } >"$one.frag.hlsl"
    shader frag "-D -V -e main" "$name: emitted HLSL compiles" "$one.frag.hlsl"

    "$fpcore" "$model" "$tier" <"$one.fpcore" >"$dir/log" 2>&1
    result $? "$name: emitted FPCore gives the formula's values"

    if [ -f "models/q30/$name.c" ]; then
        "$lobefit" emit "$model" --tier "$tier" --to q30 >"$one.q30" 2>"$dir/log" &&
            cmp "$one.q30" "models/q30/$name.c" >>"$dir/log" 2>&1
        result $? "$name: models/q30/$name.c is what lobefit emits"
    else
        echo "models/q30/$name.c is missing: make emit-q30 writes it" >"$dir/log"
        result 1 "$name: models/q30/$name.c is there"
    fi
done
# Bad usage: a message, status 2, and nothing on standard output.
refused() { # name, arguments
    what=$1
    shift
    "$lobefit" emit "$@" >"$dir/out" 2>"$dir/log"
    [ $? -eq 2 ] && [ ! -s "$dir/out" ] && [ -s "$dir/log" ]
    result $? "refuses $what"
}
refused 'an unknown language' split_sum --to cobol
refused 'an unknown tier' split_sum --tier middling --to c
refused 'an unknown case' split_hair --to c
refused 'no language' split_sum
echo "1..$number"
[ $failed -eq 0 ]
