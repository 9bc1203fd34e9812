#!/bin/sh
# The command line of lobefit: what it answers, and that bad input says why, exits 2 and prints nothing else.
cd "$(dirname "$0")/../.." || exit 1
lobefit=build/lobefit
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
n=0 failed=0

result() { # STATUS NAME
    n=$((n + 1))
    if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; failed=$((failed + 1)); fi
}

# refused NAME PATTERN INPUT ARGUMENTS...: status 2, the message matches, standard output is empty
refused() {
    name=$1 pattern=$2 input=$3
    shift 3
    printf "$input" | "$lobefit" "$@" > "$work/out" 2> "$work/err"
    status=$?
    [ $status -eq 2 ] && [ ! -s "$work/out" ] && grep -qE -- "$pattern" "$work/err"
    good=$?
    [ $good -eq 0 ] || { echo "# status $status, said:"; sed 's/^/# /' "$work/err"; }
    result $good "$name"
}

refused "no command" "usage:" ""
refused "unknown command" "unknown command 'nothing'" "" nothing
refused "part of a command's name" "unknown command 'trut'" "" trut
refused "empty command" "unknown command ''" "" ""
refused "truth without a case" "which case" "" truth
refused "unknown case" "no case 'nothing'.*split_sum_sep" "" truth nothing
refused "list takes nothing" "one word too many" "" list all
refused "unknown option" "unknown option '--fast'.*--threads" "" truth split_sum --fast
refused "an option that another command has" "unknown option '--out'" "" truth split_sum --out x
refused "option without its value" "threads needs a value" "" truth split_sum --threads
refused "no threads" "threads '0' is not a whole number in \[1, 64\]" "" truth split_sum --threads 0
refused "too many threads" "threads '65'" "" truth split_sum --threads 65
refused "threads that are no number" "threads '2x'" "" truth split_sum --threads 2x
refused "scene is not there yet" "not available yet" "" scene mobile --budget 1
refused "search in a file is not there yet" "not available yet" "" search --csv x.csv
refused "a hook that is empty" "search: not available for split_sum_kibl yet" "" search split_sum_kibl
refused "vectors of a case without models" "vectors: not available for split_sum_kibl yet" "" vectors split_sum_kibl
refused "emit of a case without models" "emit: not available for split_sum_kibl yet" "" emit split_sum_kibl --to c

row() { refused "row refused: $1" "<stdin>:2: .*$2" "0.5 0.5\n$1\n" truth "${3:-split_sum}"; }
row "nan 0.5" "roughness 'nan' is not a decimal number, allowed range \[0.001, 1\]"
row "0.5 inf" "n_dot_v 'inf'"
row "0.5 x" "n_dot_v 'x'"
row "0.5" "1 number in the row, expected 2: roughness in \[0.001, 1\], n_dot_v in \[0.001, 1\]"
row "0.5 0.7 1 2 3" "5 numbers in the row"
row "0.5 2.0" "n_dot_v '2.0' is out of its domain, allowed range \[0.001, 1\]"
row "0.0009 0.5" "roughness '0.0009' is out of its domain"
row "0x0.8p0 0.5" "'0x0.8p0'"
row "0xzz 0.5" "'0xzz'"
row "0.5,,0.5" "empty field"
row "-0.5 0.5" "'-0.5'" energy
row "0.5 1.0000001" "'1.0000001'" split_sum_sep
row "0.5 0" "n_dot_v '0'" split_sum_kibl

sphere() { refused "sphere light refused: $1" "<stdin>:2: .*$2" "0.5 0.5 0.5 1 0.1\n$1\n" truth sphere_light; }
sphere "0.04 0.5 0.5 1 0.1" "roughness '0.04' is out of its domain, allowed range \[0.05, 1\]"
sphere "0.5 0.5 -1.1 1 0.1" "n_dot_l '-1.1' is out of its domain"
sphere "0.5 0.5 0.5 3.2 0.1" "azimuth '3.2' is out of its domain"
sphere "0.5 0.5 0.5 1 0" "sigma '0' is out of its domain"
sphere "0.5 0.5 0.5 1" "4 numbers in the row, expected 5"
refused "search of sphere_light, unknown option" "unknown option '--out'" "" search sphere_light --out x
refused "search of sphere_light, no threads" "threads '0' is not a whole number" "" search sphere_light --threads 0
refused "search into a folder that is not there" "cannot write" "" search sphere_light --csv "$work/none/x.csv"

"$lobefit" -h > "$work/h1" 2> "$work/err" && "$lobefit" truth --help > "$work/h2" && grep -q '^usage:' "$work/h1" &&
    cmp -s "$work/h1" "$work/h2" && [ ! -s "$work/err" ]
result $? "-h explains on standard output"

"$lobefit" list > "$work/list"
[ "$(cut -f1 "$work/list" | tr '\n' ' ')" = "split_sum split_sum_sep energy diffuse_sh sphere_light sphere_light_schlick sphere_diffuse capsule_light env_lobes sg_light sg_diffuse env_lobes_sg split_sum_kibl " ]
result $? "list names the cases"

printf '# head\n0.5 0.7\n\n  1 , 1 # tail\n.25,5e-1\r\n' | "$lobefit" truth split_sum > "$work/out"
[ $? -eq 0 ] && [ "$(awk 'NF == 2' "$work/out" | wc -l)" -eq 3 ] && [ "$(wc -l < "$work/out")" -eq 3 ] &&
    sed -n 2p "$work/out" | awk '{ d = $1 + $2 - (1 - log(2)); exit !(d < 1e-14 && d > -1e-14) }'
result $? "rows in every spelling, one output row each"

printf '1 1\n' | "$lobefit" truth energy | awk 'NF != 1 { exit 1 } { d = $1 - (1 - log(2)); exit !(d < 1e-14 && d > -1e-14) }'
result $? "energy has one column"

printf '# nothing\n\n' | "$lobefit" truth split_sum > "$work/out" && [ ! -s "$work/out" ]
result $? "no rows in, no rows out"

awk 'BEGIN { for (i = 0; i < 500; i++) print 0.001 + 0.999 * (i % 23) / 22, 0.001 + 0.999 * i / 499 }' > "$work/rows"
for case in split_sum split_sum_sep energy split_sum_kibl; do
    "$lobefit" truth $case --threads 1 < "$work/rows" > "$work/one" &&
        "$lobefit" truth $case --threads 2 --progress < "$work/rows" > "$work/two" 2> /dev/null &&
        [ "$(wc -l < "$work/one")" -eq 500 ] && cmp -s "$work/one" "$work/two"
    result $? "$case: the same bytes with one thread and two"
done

awk 'BEGIN { for (i = 0; i < 60; i++) print 0.1 + 0.015 * i, 0.1 + 0.9 * (i % 7) / 6, (i % 11) / 10 - 0.2, 0.05 * i, 0.01 + 0.02 * i }' \
    > "$work/spheres"
"$lobefit" truth sphere_light --threads 1 < "$work/spheres" > "$work/one" &&
    "$lobefit" truth sphere_light --threads 2 < "$work/spheres" > "$work/two" &&
    [ "$(awk 'NF == 1' "$work/one" | wc -l)" -eq 60 ] && cmp -s "$work/one" "$work/two"
result $? "sphere_light: one column, the same bytes with one thread and two"

"$lobefit" truth split_sum < "$work/rows" 2> "$work/err" > /dev/null && [ ! -s "$work/err" ]
result $? "no progress line where standard error is no terminal"

"$lobefit" truth split_sum < "$work/rows" > /dev/full 2> "$work/err"
[ $? -eq 2 ] && grep -q 'stdout.*cannot write' "$work/err"
result $? "a full disk is a failure"

"$lobefit" truth split_sum < . > "$work/out" 2> "$work/err"
[ $? -eq 2 ] && [ ! -s "$work/out" ] && grep -q '<stdin>: cannot read' "$work/err"
result $? "an input that cannot be read is a failure"

# OpenCL: an ICD that is registered must work; with none to be found the reason is said.
if ls /etc/OpenCL/vendors/*.icd > /dev/null 2>&1; then
    "$lobefit" truth split_sum < "$work/rows" > "$work/c" &&
        "$lobefit" truth split_sum --opencl < "$work/rows" > "$work/cl" && cmp -s "$work/c" "$work/cl"
    result $? "--opencl gives the bytes of plain C"
    printf '0.5 0.5\n' | OCL_ICD_VENDORS=$work/none "$lobefit" truth split_sum --opencl > "$work/out" 2> "$work/err"
    [ $? -eq 2 ] && [ ! -s "$work/out" ] && grep -q 'OpenCL: no platform' "$work/err"
    result $? "no ICD is said, with status 2"
    mkdir "$work/path"
    printf '0.5 0.5\n' | PATH=$work/path "$lobefit" truth split_sum --opencl > "$work/out" 2> "$work/err"
    status=$?
    # only PoCL needs ld
    if grep -q . "$work/err"; then [ $status -eq 2 ] && grep -q 'linker ld' "$work/err"; else [ $status -eq 0 ]; fi
    result $? "PoCL without ld on PATH is said, with status 2"
    printf '0.5 0.5\n' | POCL_CACHE_DIR=/proc/none "$lobefit" truth split_sum --opencl > "$work/out" 2> "$work/err"
    status=$?
    if grep -q . "$work/err"; then [ $status -eq 2 ] && grep -q 'set POCL_CACHE_DIR' "$work/err"; else [ $status -eq 0 ]; fi
    result $? "a kernel cache that cannot be written is said, with status 2"
else
    for name in "--opencl gives the bytes of plain C" "no ICD is said" "PoCL without ld is said" "a cache that cannot be written is said"; do
        n=$((n + 1))
        echo "ok $n - $name # SKIP no OpenCL driver is registered"
    done
fi
echo "1..$n"
[ $failed -eq 0 ]
