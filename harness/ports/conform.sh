#!/bin/sh
# Builds and runs the conformance program for one target, or prints the table of all.
#
#   conform.sh target ROW 'COMPILER' 'RUNNER' BUILD-ARGUMENTS...   ROW is the file to write, named <target>.row
#   conform.sh table BUILD ROW...                                  exit status 1 when a row does not pass
#
# PREPARE is a command to run first, PROGRAM_ARGUMENTS what the program is given, NEEDS more tools that must be there,
# `header:NAME` for a header that the compiler must find.
# A row file: entries, vectors passed/total, worst error, equal|differs|unknown, verdict, hash of all hashes.
# A target whose compiler or runner is not installed is `missing`, and fails only where LOBE_REQUIRE_ALL is set.

here() { command -v "$1" >/dev/null 2>&1; }

target() {
    row=$1 compiler=$2 runner=$3
    shift 3
    program=${row%.row}.elf log=${row%.row}.log
    rm -f "$row"
    mkdir -p "${row%/*}"
    for tool in ${compiler%% *} ${runner%% *} sha256sum; do
        here "$tool" || { echo "- - - - missing:$tool -" >"$row"; return; }
    done
    for tool in $NEEDS; do
        # shellcheck disable=SC2086
        case $tool in
        header:*) echo "#include <${tool#header:}>" | $compiler -E - >"$log" 2>&1 ;;
        *) here "$tool" ;;
        esac || { echo "- - - - missing:$tool -" >"$row"; return; }
    done
    if [ -n "${PREPARE-}" ] && ! sh -c "$PREPARE" >"$log" 2>&1; then
        echo "- - - - fail:cannot-prepare -" >"$row"
        return
    fi
    # shellcheck disable=SC2086 # the compiler and the runner are commands with their options
    if ! $compiler "$@" -o "$program" >"$log" 2>&1; then
        echo "- - - - fail:does-not-build -" >"$row"
        return
    fi
    case $program in /*) ;; *) program=./$program ;; esac
    # shellcheck disable=SC2086
    timeout 300 $runner "$program" $PROGRAM_ARGUMENTS >>"$log" 2>&1
    status=$?
    awk -v status=$status '
        $1 == "vectors" {
            sets[$2 " " $3 " " $4]
            rows += $6
            passed += $8
            if (worst == "" || worst != "inf" && ($10 == "inf" || $10 + 0 > worst + 0))
                worst = $10
        }
        $1 == "hash" { entries++; names[$2 " " $3 " " $4]; if ($6 != "ok") bits = $6 }
        /^conform: / { verdict = $2 }
        END {
            for (name in names)
                if (!(name in sets))
                    without = 1
            if (verdict == "") {
                print status == 3 ? "- - - - missing:device" : "- - - - fail:exits-" status "-without-a-verdict"
                exit
            }
            result = "pass"
            if (without)
                result = "fail:an-entry-has-no-vectors"
            if (entries == 0)
                result = "fail:nothing-ran"
            if (verdict != "ok" || status)
                result = "fail"
            print entries + 0, passed + 0 "/" rows + 0, worst == "" ? "-" : worst, bits == "" ? "equal" : bits, result
        }' "$log" >"$row"
    # One number for all bits: equal on every target that runs the same entries.
    hash=$(awk '$1 == "hash" { print $2, $3, $4, $5 }' "$log" | sha256sum | cut -c1-16)
    sed -i "s/\$/ $hash/" "$row"
}

# Mean instructions an evaluation over the registry, "f32 / q30", from a file of `make counts`.
instructions() {
    [ -s "$1" ] || { echo -; return; }
    awk -F, 'FNR > 1 && $1 != "peer" && $4 + 0 > 0 { n[$3]++; s[$3] += $4 }
        function mean(f) { return n[f] ? sprintf("%.0f", s[f] / n[f]) : "-" }
        END { print mean("f32") "/" mean("q30") }' "$1"
}

table() {
    build=$1 bad=0
    shift
    format='%-22s %7s %15s %11s  %-16s %-7s %15s  %s\n'
    # shellcheck disable=SC2059
    printf "$format" target entries vectors worst hash bits 'instr. f32/q30' verdict
    for row in "$@"; do
        name=${row##*/} name=${name%.row} count=-
        case $name in
        x86-64-gcc-O2) count=$(instructions "$build/counts_x86.csv") ;;
        cortex-m0) count=$(instructions "$build/counts_m0.csv") ;;
        cortex-m4f) count=$(instructions "$build/counts_m4f.csv") ;;
        esac
        read -r entries vectors worst bits verdict hash <"$row"
        # shellcheck disable=SC2059
        printf "$format" "$name" "$entries" "$vectors" "$worst" "$hash" "$bits" "$count" "$verdict"
        case $verdict in
        pass) ;;
        missing:*) [ -z "${LOBE_REQUIRE_ALL-}" ] || bad=1 ;;
        *)
            bad=1
            grep -aE 'BROKEN|differs|unknown$|[Ee]rror:|ERROR:|warning:|undefined|not found' "${row%.row}.log" |
                head -n 8 | sed 's/^/    /'
            ;;
        esac
    done
    echo 'instructions: mean over the registry, call and return included; f32 / q30'
    return $bad
}

command=$1
shift
case $command in
target) target "$@" ;;
table) table "$@" ;;
*) echo "conform.sh: unknown command '$command'; known: target, table" >&2; exit 2 ;;
esac
