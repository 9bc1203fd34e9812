#!/bin/sh
# `lobefit prefilter`: files of every format, bytes that do not depend on threads, and that a bad file or option says why,
# exits 2 and leaves what was there.
: "${B:=build}"
lobefit=$B/lobefit
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
n=0 failed=0

result() { # STATUS NAME
    n=$((n + 1))
    if [ "$1" -eq 0 ]; then echo "ok $n - $2"; else echo "not ok $n - $2"; failed=$((failed + 1)); fi
}

# refused NAME PATTERN ARGUMENTS...: status 2, the message matches, nothing on standard output, the old file stands
refused() {
    name=$1 pattern=$2
    shift 2
    echo old >"$work/kept.dds"
    "$lobefit" prefilter "$@" >"$work/out" 2>"$work/err"
    status=$?
    [ $status -eq 2 ] && [ ! -s "$work/out" ] && grep -qE -- "$pattern" "$work/err" &&
        [ "$(cat "$work/kept.dds")" = old ] && [ "$(ls "$work" | grep -c '\.new\.')" -eq 0 ]
    good=$?
    [ $good -eq 0 ] || { echo "# status $status, said:"; sed 's/^/# /' "$work/err"; }
    result $good "$name"
}

# 8 x 4 texels: a gradient.
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n' >"$work/map.hdr"
for i in 0 1 2 3 4 5 6 7; do
    for j in 1 2 3 4; do printf "\\1${i}0\\20${j}\\0${j}0\\202"; done
done >>"$work/map.hdr"
to="--out $work/kept.dds"

refused "no file" "which file\? FILE.hdr" $to
refused "no target" "where to\? --out FILE" "$work/map.hdr"
refused "a file that is not there" "missing.hdr: cannot be opened: No such file" "$work/missing.hdr" $to
refused "two files" "one word too many" "$work/map.hdr" "$work/map.hdr" $to
refused "unknown option" "unknown option '--fast'; it takes --out" "$work/map.hdr" $to --fast
refused "option without its value" "--size needs a value" "$work/map.hdr" $to --size
refused "unknown kernel" "--kernel 'phong' is not one of: ggx sg" "$work/map.hdr" $to --kernel phong
refused "an empty kernel" "--kernel '' is not one of" "$work/map.hdr" $to --kernel ''
refused "unknown format" "--format 'exr' is not one of: dds ktx2 raw" "$work/map.hdr" $to --format exr
refused "no size" "--size '0' is not a whole number in \[1, 4096\]" "$work/map.hdr" $to --size 0
refused "a size that is none" "--size '64k' is not a whole number" "$work/map.hdr" $to --size 64k
refused "too large a size" "--size '99999999999999999999'" "$work/map.hdr" $to --size 99999999999999999999
refused "too many mips" "--mips 9 is more than the 6 of a size of 32" "$work/map.hdr" $to --size 32 --mips 9
refused "no threads" "--threads '0' is not a whole number in \[1, 64\]" "$work/map.hdr" $to --threads 0
refused "a curve that folds" "--curve '2.5' is not a number in \[1, 2\]" "$work/map.hdr" $to --curve 2.5
refused "a curve that is none" "--curve 'nan' is not" "$work/map.hdr" $to --curve nan
refused "unknown axis" "--up 'x' is not one of: z y" "$work/map.hdr" $to --up x
refused "a folder that is not there" "nowhere/x.dds: cannot open for writing" "$work/map.hdr" --out "$work/nowhere/x.dds" \
    --size 4
printf 'text' >"$work/text.hdr"
refused "no map at all" "text.hdr: byte 0: found bytes 0x74 0x65, expected" "$work/text.hdr" $to
head -c 70 "$work/map.hdr" >"$work/cut.hdr"
refused "a map cut short" "cut.hdr: byte 70: found the end of the file in row 0, expected 4 rows" "$work/cut.hdr" $to

head -c 30 "$work/map.hdr" >"$work/headless.hdr"
refused "a map cut in its head" "headless.hdr: byte 30: found the end of the file" "$work/headless.hdr" $to
: >"$work/empty.hdr"
refused "an empty file" "empty.hdr: byte 0: found a file of 0 bytes, expected" "$work/empty.hdr" $to
refused "a folder as the map" "cannot be read: Is a directory" "$work" $to
printf 'PF\n0 1\n-1\n' >"$work/none.pfm"
refused "a map without texels" "none.pfm: byte 3: found width '0', expected a whole number" "$work/none.pfm" $to
printf 'PF\n3 2\n-1\n' >"$work/sides.pfm"
head -c 72 /dev/zero >>"$work/sides.pfm"
refused "sides of no layout" "sides.pfm: found 3 x 2 texels, expected sides as 2 : 1 .* 6 : 1, 1 : 6, 4 : 3 or 3 : 4" \
    "$work/sides.pfm" $to
refused "a file as the folder" "map.hdr/x.dds: cannot open for writing" "$work/map.hdr" --out "$work/map.hdr/x.dds" --size 4
mkdir "$work/folder.dds"
refused "a folder as the target" "folder.dds: cannot write: Is a directory" "$work/map.hdr" --out "$work/folder.dds" --size 4
if [ "$(id -u)" -ne 0 ]; then
    chmod 555 "$work/folder.dds"
    refused "a folder that may not be written" "x.dds: cannot open for writing: Permission denied" "$work/map.hdr" \
        --out "$work/folder.dds/x.dds" --size 4
fi

bytes() { wc -c <"$1" | tr -d ' '; }
for kernel in ggx sg; do
    "$lobefit" prefilter "$work/map.hdr" --kernel $kernel --size 16 --out "$work/$kernel.dds" --threads 1 >"$work/out" &&
        "$lobefit" prefilter "$work/map.hdr" --kernel $kernel --size 16 --out "$work/three.dds" --threads 3 >"$work/out3" &&
        cmp -s "$work/$kernel.dds" "$work/three.dds" && cmp -s "$work/out" "$work/out3"
    result $? "$kernel: the same bytes from one thread and three"
    # 16, 8 and 4 texels a side; a last width of 1.
    [ "$(bytes "$work/$kernel.dds")" -eq $((148 + 48 * (256 + 64 + 16))) ] &&
        grep -v '^#' "$work/out" | awk 'NF != 3 || $1 != NR - 1 || $2 != 32 / 2^NR { bad = 1 } { last = $3 }
            END { exit bad || NR != 3 || last != 1 }'
    result $? "$kernel: sizes and the printed scale"
done
"$lobefit" prefilter "$work/map.hdr" --size 16 --mips 2 --out "$work/map.ktx2" >"$work/out" &&
    [ "$(head -c 7 "$work/map.ktx2" | tail -c 6)" = 'KTX 20' ] && grep -aq LobePrefilter "$work/map.ktx2"
result $? "the format comes from the name"
"$lobefit" prefilter "$work/map.hdr" --size 16 --format raw --out "$work/map.bin" >"$work/out" &&
    [ "$(bytes "$work/map.bin")" -eq $((72 * (256 + 64 + 16))) ]
result $? "raw floats without a head"
"$lobefit" prefilter "$work/ggx.dds" --size 16 --mips 1 --out "$work/a.raw" >"$work/out" &&
    "$lobefit" prefilter "$work/map.ktx2" --size 16 --mips 1 --out "$work/b.raw" >"$work/out" &&
    cmp -s "$work/a.raw" "$work/b.raw"
result $? "a cube read from DDS is the cube read from KTX2"
# The six faces one under another, from the raw floats of the same cube: PFM has its rows from the bottom.
"$lobefit" prefilter "$work/ggx.dds" --size 8 --mips 1 --out "$work/small.dds" >"$work/out"
"$lobefit" prefilter "$work/small.dds" --size 8 --mips 1 --out "$work/small.raw" >"$work/out"
printf 'PF\n8 48\n-1\n' >"$work/faces.pfm"
row=47
while [ $row -ge 0 ]; do
    dd if="$work/small.raw" bs=96 skip=$row count=1 2>/dev/null
    row=$((row - 1))
done >>"$work/faces.pfm"
"$lobefit" prefilter "$work/small.dds" --size 16 --out "$work/a.dds" >"$work/out" &&
    "$lobefit" prefilter "$work/faces.pfm" --size 16 --out "$work/b.dds" >"$work/out" &&
    cmp -s "$work/a.dds" "$work/b.dds" && grep -q '^# source: faces.pfm, 8 x 8 texels, six faces' "$work/out"
result $? "six faces in one picture give the bytes of their cube"
refused "turned faces" "--up is for equirectangular maps; .*faces.pfm is a cube" "$work/faces.pfm" $to --up y
refused "a turned cube" "--up is for equirectangular maps" "$work/ggx.dds" $to --up y
head -c 1000 "$work/ggx.dds" >"$work/cut.dds"
refused "a cube cut short" "cut.dds: byte 1000: found 852 bytes of texels, expected 16128" "$work/cut.dds" $to
head -c 1000 "$work/map.ktx2" >"$work/cut.ktx2"
refused "a KTX2 cut short" "cut.ktx2: byte 1000: found a file of 1000 bytes, expected 48 for each" "$work/cut.ktx2" $to

# Ctrl-C: the old file stays, nothing is left beside it. (A shell's background job ignores SIGINT, hence the detour.)
echo old >"$work/kept.dds"
if command -v timeout >/dev/null && timeout --version >/dev/null 2>&1; then
    timeout -s INT 1 "$lobefit" prefilter "$work/map.hdr" --size 4096 --out "$work/kept.dds" >"$work/out" 2>"$work/err"
    grep -q 'interrupted; .*kept.dds is as it was' "$work/err" && [ "$(cat "$work/kept.dds")" = old ] &&
        [ "$(ls "$work" | grep -c '\.new\.')" -eq 0 ] && [ ! -s "$work/out" ]
    result $? "interrupted, it leaves the old file"
fi
"$lobefit" prefilter "$work/map.hdr" --size 8 --out "$work/x.dds" >/dev/full 2>"$work/err"
[ $? -eq 2 ] && grep -q 'cannot write' "$work/err"
result $? "a full disk is a failure"
"$lobefit" -h | grep -q 'prefilter FILE'
result $? "lobefit -h knows it"
echo "1..$n"
[ $failed -eq 0 ]
