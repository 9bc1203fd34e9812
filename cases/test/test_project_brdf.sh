#!/bin/sh
# Any BRDF as one header: those that come with the case, a user's own, and bad ones. TAP.
cd "$(dirname "$0")/../.." || exit 1
B=${B:-build}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
n=0 failed=0

result() { # STATUS NAME
    n=$((n + 1))
    if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; failed=$((failed + 1)); fi
}

# Burley, through the general integrator, is what the case's own truth says.
agree() { # ROUGHNESS NDOTV
    echo "$1 $2" | "$B/lobefit" truth diffuse_sh >"$work/case" && "$B/project_burley" truth "$1" "$2" >"$work/general" &&
        awk 'NR == FNR { for (i = 1; i <= 9; i++) want[i] = $i; next } FNR == 1 {
            for (i = 1; i <= 9; i++) if (($i - want[i]) ^ 2 > 1e-26) exit 1; exit !NF }' "$work/case" "$work/general"
}
for at in '0 0' '0.5 0.3' '1 0' '1 1' '0.25 0.97'; do
    agree ${at% *} ${at#* }
    result $? "burley at $at is the case's truth"
done

# The two integrators of each, worst over the table; kinks and quotients included.
for brdf in burley lambert oren_nayar eon; do
    "$B/project_$brdf" table >"$work/table"
    awk '/integrators agree to/ { found = 1; if ($NF > 1e-12) exit 1 } END { exit !found }' "$work/table"
    result $? "$brdf: two integrators agree to 1e-12"
done

# The degree 3 fit of EON is as good as its README says, and compiles as a shape of diffuse_sh.
"$B/project_eon" fit 3 eon >"$work/eon_shape.h"
awk '/Random order-3 lighting/ { found = 1; if ($5 + 0 > 0.1) exit 1 } END { exit !found }' "$work/eon_shape.h"
result $? "eon at degree 3 is within .1 % rms"
printf '#include "eon_shape.h"\nint main(void) { const lobe_diffuse_shape s = lobe_eon_shape(0.5f, 0.5f);
    return !(s.c00 > 0.281f && s.c00 < 0.283f); }\n' >"$work/call.c"
${CC:-cc} -std=gnu99 -Wall -Wextra -Werror -Imodels "$work/call.c" -o "$work/call" && "$work/call"
result $? "the fit compiles and reflects what EON does"

# A user's own file.
cat >"$work/flat.h" <<'END'
#include "core/scalar.h"
LOBE_FN lobe_real my_flat(lobe_real l, lobe_real v, lobe_real c, lobe_real r)
{
    LOBE_LET f = LOBE_R(0.5) + LOBE_R(0.0) * (l + v + c + r);
    return f;
}
END
make -s project-brdf B="$B" BRDF="$work/flat.h" BRDF_NAME=my_flat >"$work/log" 2>&1 &&
    "$B/project_flat" truth 0.3 0.4 | awk 'NR == 1 { d = $1 - 0.5 * 3.14159265358979 * 0.28209479177387814; exit d * d > 1e-26 }'
result $? "a user's BRDF of 1/2 reflects pi/2"
rm -f "$B/project_flat"

refused() { # NAME ARGUMENTS...
    name=$1
    shift
    "$B/project_eon" "$@" >"$work/out" 2>"$work/said"
    [ $? -eq 2 ] && [ -s "$work/said" ] && [ ! -s "$work/out" ]
    result $? "refuses $name"
}
refused 'a roughness of 2' truth 2 0.5
refused 'a word for a number' truth 0.5 x
refused 'half a degree' fit 2.5 eon
refused 'a degree of 8' fit 8 eon
refused 'a name that is none' fit 3 'my brdf'
refused 'no command'
echo "1..$n"
[ $failed -eq 0 ]
