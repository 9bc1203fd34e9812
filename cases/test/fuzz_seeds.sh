#!/bin/sh
# Writes first inputs for the fuzzers of maps and cubes: fuzz_seeds.sh LOBEFIT FOLDER. FOLDER/map gets RGBE in its three
# spellings and PFM, FOLDER/cube a cube of each format with all its mips, and six faces in one picture.
set -eu
lobefit=$1 map=$2/map cube=$2/cube
mkdir -p "$map" "$cube"
head='#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n'
printf "$head"'-Y 2 +X 2\n\2\1\0\207\4\1\0\207\6\1\0\207\10\1\0\207' >"$map/flat"
printf "$head"'-Y 1 +X 4\n\2\1\0\207\1\1\1\3' >"$map/old"
printf "$head"'-Y 1 +X 8\n\2\2\0\10\10\2\4\6\10\12\14\16\20\210\1\210\0\210\207' >"$map/new"
printf 'PF\n1 2\n-1.0\n\0\0\0\100\0\0\0\100\0\0\0\100\0\0\200\77\0\0\200\77\0\0\200\77' >"$map/pfm"
printf 'Pf\n1 2\n1.0\n\100\0\0\0\77\200\0\0' >"$map/grey"
printf 'PF\n2 1\n-1\n\0\0\200\77\0\0\200\77\0\0\200\77\0\0\0\77\0\0\0\77\0\0\0\77' >"$cube/small.pfm"
for format in dds ktx2; do
    "$lobefit" prefilter "$cube/small.pfm" --size 4 --mips 2 --out "$cube/cube.$format" >"$cube/log"
done
rm "$cube/log"
printf 'Pf\n4 3\n1.0\n' >"$cube/cross.pfm"
for i in 1 2 3 4 5 6 7 8 9 10 11 12; do printf '\77\200\0\0'; done >>"$cube/cross.pfm"
printf "$head"'-Y 1 +X 6\n\2\1\0\207\1\1\1\5' >"$cube/strip.hdr"
