#!/bin/sh
# Writes every f32 kernel as a program for a device: FOLDER/<kernel>.comp and .spv (Vulkan), FOLDER/<kernel>.cl.
# Usage: device_kernels.sh FOLDER SHADER_TEXT glsl|cl HEADER...      (from the root of the repository)
set -eu
folder=$1 text=$2 language=$3
shift 3
mkdir -p "$folder"
rm -f "$folder"/*."$language" "$folder"/*.comp "$folder"/*.spv "$folder/kernels.txt"
describe() { awk -v want="$1" -v kernel="${2-}" -f harness/ports/kernels.awk harness/registry_rows.h "$files"; }
files=$folder/all.txt
cat "$@" >"$files"
describe list >"$folder/kernels.new"
[ -s "$folder/kernels.new" ] || { echo "device_kernels.sh: no kernel found" >&2; exit 1; }
while read -r kernel _; do
    if [ "$language" = glsl ]; then
        { echo '#version 450'; cat "$text"; describe glsl "$kernel"; } >"$folder/$kernel.comp"
        glslangValidator -V "$folder/$kernel.comp" -o "$folder/$kernel.spv" >"$folder/log.txt" ||
            { cat "$folder/log.txt" >&2; exit 1; }
    else
        { cat "$text"; describe cl "$kernel"; } >"$folder/$kernel.cl"
    fi
done <"$folder/kernels.new"
mv "$folder/kernels.new" "$folder/kernels.txt"
