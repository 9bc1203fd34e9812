#!/bin/sh
# What is committed is what the fitter writes: a part of `make fit`, small enough for every run, into another folder,
# with one thread and with two.
cd "$(dirname "$0")/../.." || exit 1
lobefit=build/lobefit
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
n=0 failed=0

result() { # STATUS NAME
    n=$((n + 1))
    if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; failed=$((failed + 1)); fi
}

same() { # NAME FILE...: each file of the work folder equals the committed one
    name=$1 status=0
    shift
    for file; do
        cmp "$work/$file" "models/$file" || status=1
    done
    result $status "$name"
}

refused() { # NAME PATTERN ARGUMENTS...
    name=$1 pattern=$2
    shift 2
    "$lobefit" "$@" >"$work/said" 2>&1
    status=$?
    [ $status -eq 2 ] && grep -q -- "$pattern" "$work/said"
    result $? "$name"
}

for threads in 1 2; do
    for tier in low medium; do
        "$lobefit" fit energy --tier $tier --out "$work" --threads $threads
        same "energy $tier, $threads threads" coeffs/energy_$tier.h
    done
    for model in split_sum split_sum_sep; do
        "$lobefit" fit $model --tier low --out "$work" --threads $threads
        same "$model low, $threads threads" coeffs/${model}_low.h
    done
    "$lobefit" fit split_sum --tier table32 --out "$work" --threads $threads
    same "split_sum table32, $threads threads" tables/split_sum_table32_f32.c tables/split_sum_table32_u16.c
    "$lobefit" fit diffuse_sh --out "$work" --threads $threads
    same "diffuse_sh, $threads threads" coeffs/diffuse_sh_exact.h coeffs/diffuse_sh_low.h coeffs/diffuse_sh_medium.h \
        coeffs/diffuse_sh_zonal.h coeffs/diffuse_sh_zonal_low.h
    "$lobefit" fit sphere_diffuse --out "$work" --threads $threads
    same "sphere_diffuse, $threads threads" coeffs/sphere_diffuse_low.h coeffs/sphere_diffuse_medium.h
    "$lobefit" fit sphere_light --tier low --out "$work" --threads $threads
    same "sphere_light low, $threads threads" coeffs/sphere_light_low.h
    "$lobefit" fit capsule_light --tier low --out "$work" --threads $threads
    same "capsule_light low, $threads threads" coeffs/capsule_light_low.h
    rm -rf "$work/coeffs" "$work/tables"
done

# The others of env_lobes and env_lobes_sg take minutes, and so do their bounds where no truth is kept.
"$lobefit" fit env_lobes_sg --tier lobes1 --out "$work" --threads 2
same "env_lobes_sg lobes1" coeffs/env_lobes_sg_lobes1.h

# The slow ones once: that one thread has the same bytes is seen above.
"$lobefit" fit sphere_light --out "$work" --threads 2
same "sphere_light" coeffs/sphere_light_low.h coeffs/sphere_light_medium.h coeffs/sphere_light_high.h \
    coeffs/sphere_light_schlick.h

mkdir "$work/q30"
for tier in low medium high; do
    "$lobefit" emit energy --tier $tier --to q30 >"$work/q30/energy_$tier.c"
done
same "energy, integer kernels" q30/energy_low.c q30/energy_medium.c q30/energy_high.c

for tier in exact medium low zonal zonal_low; do
    "$lobefit" emit diffuse_sh --tier $tier --to q30 >"$work/q30/diffuse_sh_$tier.c"
done
same "diffuse_sh, integer kernels" q30/diffuse_sh_exact.c q30/diffuse_sh_medium.c q30/diffuse_sh_low.c \
    q30/diffuse_sh_zonal.c q30/diffuse_sh_zonal_low.c
"$lobefit" bounds diffuse_sh --out "$work"
same "diffuse_sh, bounds" coeffs/diffuse_sh_bounds.h
"$lobefit" vectors diffuse_sh --out "$work/vectors" && status=0 || status=1
for file in vectors/diffuse_sh.*.vec; do cmp "$file" "$work/$file" || status=1; done
result $status "diffuse_sh, vectors"
# Their bounds take minutes and are left to make fit.
"$lobefit" vectors capsule_light --out "$work/vectors" && status=0 || status=1
for file in vectors/capsule_light.*.vec; do cmp "$file" "$work/$file" || status=1; done
result $status "capsule_light, vectors"
"$lobefit" vectors sphere_light --out "$work/vectors" && status=0 || status=1
for file in vectors/sphere_light.*.vec; do cmp "$file" "$work/$file" || status=1; done
result $status "sphere_light, vectors"
"$lobefit" vectors sphere_light_schlick --out "$work/vectors" && status=0 || status=1
for file in vectors/sphere_light_schlick.*.vec; do cmp "$file" "$work/$file" || status=1; done
result $status "sphere_light_schlick, vectors"
"$lobefit" bounds sphere_diffuse --out "$work"
same "sphere_diffuse, bounds" coeffs/sphere_diffuse_bounds.h
"$lobefit" vectors sphere_diffuse --out "$work/vectors" && status=0 || status=1
for file in vectors/sphere_diffuse.*.vec; do cmp "$file" "$work/$file" || status=1; done
result $status "sphere_diffuse, vectors"
for model in env_lobes env_lobes_sg; do
    "$lobefit" vectors $model --out "$work/vectors" && status=0 || status=1
    for file in vectors/$model.*.vec; do cmp "$file" "$work/$file" || status=1; done
    result $status "$model, vectors"
done

# make fit knows every model that ships, and bounds are what it writes.
measured=$(printf 'include cases/fit_rules.mk\nshow:\n\t@echo $(MEASURED_MODELS)\n' | MAKEFLAGS= make -s -f - show)
for model in $(sed -n 's/^[A-Z0-9_]*_F32(\([a-z0-9_]*\),.*/\1/p' harness/registry_rows.h | sort -u); do
    case " $measured " in *" $model "*) status=0 ;; *) status=1 ;; esac
    result $status "make fit measures $model"
    grep -q "^/\* Generated, not edited: build/lobefit bounds $model\$" models/coeffs/${model}_bounds.h
    result $? "bounds of $model are generated"
done

refused "fit of an unknown tier" "no fit of tier 'tiny'; there are: low" fit energy --tier tiny
refused "fit of an unknown tier of a light" "sphere_light has no fit of tier 'tiny'; there are: low medium high schlick" \
    fit sphere_light --tier tiny
refused "fit with an unknown option" "unknown option '--fast'" fit energy --fast
refused "fit without a value" "tier needs a value" fit energy --tier
refused "fit with no threads" "threads '0' is not a whole number" fit energy --threads 0
refused "fit into what is no folder" "cannot make the folder" fit energy --tier low --out "$work/said/deeper"
refused "bounds of what does not ship" "nothing of split_sum_kibl ships" bounds split_sum_kibl

# An interrupted or failed fit leaves what was there: the folder holds nothing but the old file.
mkdir -p "$work/full/coeffs"
echo old >"$work/full/coeffs/energy_low.h"
(ulimit -f 0; trap '' XFSZ; "$lobefit" fit energy --tier low --out "$work/full") >"$work/said" 2>&1
status=$?
[ $status -eq 2 ] && [ "$(cat "$work/full/coeffs/energy_low.h")" = old ] && [ "$(ls "$work/full/coeffs")" = energy_low.h ]
result $? "a fit that cannot be written leaves the old one"

echo "1..$n"
[ $failed -eq 0 ]
