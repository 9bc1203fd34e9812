#!/bin/sh
# README's table of tiers: bounds from models/coeffs, instructions from the committed charts, bytes from the library.
# Usage: harness/readme_table.sh LIBLOBE.A        (from the root of the repository)
set -eu
size "$1" | awk '
    function macro(name) { return (model_macro name) in bound ? bound[model_macro name] : "-" }
    FILENAME == "-" {
        if ($6 != "") { name = $6; sub(/\.o.*/, "", name); if (!(name in bytes)) bytes[name] = $1 }
        next
    }
    FILENAME ~ /bounds\.h$/ { if ($1 == "#define") bound[$2] = $3; next }
    FILENAME ~ /diffuse_sh\.csv$/ {
        split($0, c, ","); at = c[1] SUBSEP c[2] SUBSEP c[3]
        ops[at] = c[6]; light[at] = c[7]; furnace_max[at] = c[10]; x86[at] = c[11]; m4[at] = c[12]; m0[at] = c[13]
        next
    }
    FILENAME ~ /sphere_light\.csv$/ {
        split($0, c, ","); at = "sphere_light" SUBSEP c[1] SUBSEP c[2]
        x86[at] = c[14]; m4[at] = c[15]; m0[at] = c[16]
        next
    }
    FILENAME ~ /\.csv$/ { split($0, c, ","); rms[c[1], c[2], c[3]] = c[15]; x86[c[1], c[2], c[3]] = c[16]; m4[c[1], c[2], c[3]] = c[17]; m0[c[1], c[2], c[3]] = c[18]; next }
    /^SH9_(CONSTANT_)?F32/ {
        sub(/^[A-Z0-9_]+\(/, ""); gsub(/[ )]/, ""); split($0, row, ",")
        at = row[1] SUBSEP row[2] SUBSEP
        printf "| `%s` | %s | %d | %.3g %% | %.3g %% | %s | %s | %s | %s |\n", row[1], row[2], ops[at "f32"], 100 * light[at "f32"],
            100 * furnace_max[at "f32"], x86[at "f32"], m4[at "f32"], m0[at "q30"] == "" ? "-" : m0[at "q30"], bytes[row[1] "_" row[2]]
        next
    }
    /^SPHERE_F32/ {
        sub(/^[A-Z0-9_]+\(/, ""); gsub(/[ )]/, ""); split($0, row, ",")
        at = row[1] SUBSEP row[2] SUBSEP; model_macro = row[3]
        printf "| `%s` | %s | %d | %.3g %% | %.3g %% | %.3g %% | %.3g %% | %s | %s | %s | %s |\n", row[1], row[2],
            macro("_OPS"), 100 * macro("_F32_CELLS"), 100 * macro("_F32_CELLS_VIEW60"), 100 * macro("_F32_CELLS_VIEW75"),
            100 * macro("_F32_CELLS_ENERGY"), x86[at "f32"], m4[at "f32"], m0[at "q30"], bytes[row[1] "_" row[2]]
        next
    }
    /^DFG_F32|^ENERGY_F32/ {
        sub(/^[A-Z0-9_]+\(/, ""); gsub(/[ )]/, ""); split($0, row, ",")
        model = row[1]; tier = row[2]; model_macro = row[3]
        max = macro("_F32_FURNACE"); furnace = max != "-"
        if (!furnace) max = macro("_F32_MAX")
        below = furnace ? macro("_F32_BELOW_FURNACE") : macro("_F32_BELOW_MAX")
        if (furnace) label = model ", 1/E"; else label = model
        operations = furnace ? macro("_INVERSE_OPS") : macro("_OPS")
        size = tier ~ /^table/ ? substr(tier, 6) ^ 2 * 8 : bytes[model "_" tier (furnace ? "_inverse" : "")]
        q30 = m0[model, tier, "q30"]
        printf "| `%s` | %s | %d | %s | %s | %s | %s | %s | %s | %s |\n", label, tier, operations, max, furnace ? rms[model, tier, "f32"] + 0 : macro("_F32_RMS"), below,
            x86[model, tier, "f32"], m4[model, tier, "f32"], q30 == "" ? "-" : q30, size
    }' - models/coeffs/*_bounds.h harness/chart/split_sum.csv harness/chart/split_sum_sep.csv harness/chart/energy.csv \
    harness/chart/diffuse_sh.csv harness/chart/sphere_light.csv harness/registry_rows.h
