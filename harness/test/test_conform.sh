#!/bin/sh
# harness/ports/conform.sh tells a good target from every kind of bad one, in TAP. The compiler is a stand-in whose
# program prints a report that each case chooses.
cd "$(dirname "$0")/../.." || exit 2
. harness/test/tap.sh
unset LOBE_REQUIRE_ALL PREPARE NEEDS PROGRAM_ARGUMENTS

cat >"$work/compiler" <<'END'
#!/bin/sh
while [ "$1" != -o ]; do shift; done
[ -s "$REPORT" ] || { echo 'error: no report' >&2; exit 1; }
cp "$REPORT" "$2"
END
chmod +x "$work/compiler"

good='echo "vectors split_sum low f32 rows 8 passed 8 worst 0.010000000 at 0 got 0 ok"
echo "vectors split_sum low q30 rows 4 passed 4 worst 0.020000000 at 0 got 0 ok"
echo "hash split_sum low f32 00000000000000aa ok"
echo "hash split_sum low q30 00000000000000bb ok"
echo "conform: ok"'

# ends STATUS PATTERN REPORT [COMPILER]: the table's exit status, and a text that it must hold.
ends() {
    export REPORT="$work/report"
    : >"$REPORT"
    [ -z "$3" ] || printf '%s\n' "$3" >"$REPORT"
    sh harness/ports/conform.sh target "$work/case.row" "${4-$work/compiler}" sh anything
    sh harness/ports/conform.sh table "$work" "$work/case.row" >"$work/table"
    status=$?
    cat "$work/table"
    echo "status $status, expected $1 and /$2/"
    [ $status -eq "$1" ] && grep -qE "$2" "$work/table"
}

# change PATTERN REPLACEMENT: the good report with one difference
change() { printf '%s\n' "$good" | sed "s/$1/$2/"; }

check 'a good target passes' ends 0 '^case +2 +12/12 +0\.020000000 +[0-9a-f]{16} equal .* pass$' "$good"
hash=$(awk '$1 == "case" { print $5 }' "$work/table")
check 'a row out of bound fails' ends 1 '11/12 .* fail$' "$(change 'passed 8\(.*\) ok"' 'passed 7\1 BROKEN"' | sed 's/: ok/: BROKEN/'; echo 'exit 1')"
check 'the broken row is shown' ends 1 '^ +vectors split_sum low f32 .* BROKEN$' "$(cat "$work/report")"
check 'other bits fail' ends 1 ' differs .* fail$' "$(change 'aa ok' 'ac differs' | sed 's/: ok/: BROKEN/'; echo 'exit 1')"
other=$(awk '$1 == "case" { print $5 }' "$work/table")
check 'other bits give another hash' test -n "$hash" -a "$hash" != "$other"
check 'an uncommitted hash fails' ends 1 ' unknown .* fail$' "$(change 'aa ok' 'aa unknown' | sed 's/: ok/: BROKEN/'; echo 'exit 1')"
check 'an entry without vectors fails' ends 1 'fail:an-entry-has-no-vectors$' "$(printf '%s\n' "$good" | grep -v 'vectors.*q30')"
check 'a status that contradicts the report fails' ends 1 ' fail$' "$good
exit 1"
check 'a program that stops early fails' ends 1 'fail:exits-9-without-a-verdict$' 'echo "hash split_sum low f32 aa ok"; exit 9'
check 'an empty registry fails' ends 1 'fail:nothing-ran$' 'echo "conform: ok"'
check 'what does not build fails' ends 1 'fail:does-not-build$' ''
check 'and its message is shown' ends 1 '^ +error: no report$' ''
check 'a missing compiler is no failure' ends 0 'missing:no-such-compiler$' "$good" no-such-compiler
check 'a missing device is no failure' ends 0 'missing:device$' 'exit 3'
export LOBE_REQUIRE_ALL=1
check 'but it is where all are required' ends 1 'missing:no-such-compiler$' "$good" no-such-compiler
unset LOBE_REQUIRE_ALL
export NEEDS=no-such-tool
check 'a missing tool is named' ends 0 'missing:no-such-tool$' "$good"
unset NEEDS
export PREPARE=false
check 'a preparation that fails is a failure' ends 1 'fail:cannot-prepare$' "$good"
unset PREPARE

finish
