# Cost against error. Called with in (CSV of join.awk), out (file; svg or png by its end), brdf, heading, and
# optionally front (CSV of lobefit search).
set datafile separator ","
if (out[strlen(out)-2:] eq "png") {
    set terminal pngcairo size 1500,1150 font "DejaVu Sans,11" background "white"
} else {
    set terminal svg size 1500,1150 font "DejaVu Sans,11" background "white" noenhanced
}
set output out
set multiplot layout 2,2 title heading font ",15" margins 0.06,0.98,0.06,0.92 spacing 0.07,0.09
set logscale xy
set grid back lc rgb "#e4e4e4" lw 1
set border lc rgb "#808080"
set tics textcolor rgb "#404040"
set xtics (3, 5, 10, 15, 20, 30, 40, 60, 100, 150, 200, 300, 500, 1000, 2000, 5000, 10000, 20000)
set key top right opaque samplen 2 font ",9"
set format y "%g"
set ylabel (brdf eq "energy" ? "maximum furnace error, f E - 1" : "maximum error of scale, bias, E") offset 1

# Only rows with a number stay, so that a line joins them.
rows(kind, format, cost, own) = sprintf("<awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } \
    $at[\"kind\"] == \"%s\" && $at[\"format\"] == \"%s\" && $at[\"%s\"] > 0 && (\"%s\" == \"\" || ($at[\"fitted\"] == $1) == (\"%s\" == \"own\")) \
    { print $at[\"%s\"], $at[\"max\"], $at[\"title\"], int($at[\"bytes\"] / 1024) \" kB\" }' %s", kind, format, cost, own, own, cost, in)
# Where a name stands, so that names stand apart.
left_of(rows) = rows." | grep -E 'Karis|Iwanicki'"
below(rows) = rows." | grep ".(brdf eq "split_sum" ? "HDRP" : "MaterialX")
right_of(rows) = rows." | grep -vE 'Karis|Iwanicki|".(brdf eq "split_sum" ? "HDRP" : "MaterialX")."'"
explored = "<awk -F, -v OFS=, 'NR > 1 && $12 != \"\" { print $2, $6 }' ".(exists("front") ? front : "/dev/null")

do for [panel=1:4] {
    cost = word("operations x86_instructions m4f_instructions m0_instructions", panel)
    set xlabel (panel == 1 ? "operations (fused multiply-add = 1; exp2, log2, sqrt, division = 4)" : \
                panel == 2 ? "x86-64 instructions (callgrind, gcc -O2, no fused multiply-add)" : \
                panel == 3 ? "Cortex-M4F instructions (icount), not cycles" : \
                             "Cortex-M0 instructions (icount), not cycles: published formulas in soft float") offset 0,0.3
    lo = 0.0 + word(brdf eq "energy" ? "2 30 40 300" : "11 38 44 250", panel)
    hi = 0.0 + word(brdf eq "energy" ? "140 400 500 30000" : "120 450 600 30000", panel)
    set xrange [lo:hi]
    set yrange [brdf eq "energy" ? 2e-5 : 5e-5 : 6]
    own = rows("star", "f32", cost, "own")
    other = rows("star", "f32", cost, "other")
    table = rows("table", panel == 4 ? "q30" : "f32", cost, "")
    tier = rows("tier", "f32", cost, "")
    tier_q30 = rows("tier", "q30", cost, "")
    if (panel == 1 && exists("front")) {
        plot other using 1:2 with points pt 3 ps 1.2 lc rgb "#b08a8a" title "published, for another BRDF", \
             right_of(other) using 1:2:3 with labels left offset 0.7,0.35 font ",8" tc rgb "#806060" notitle, \
             left_of(other) using 1:2:3 with labels right offset -0.8,0 font ",8" tc rgb "#806060" notitle, \
             below(other) using 1:2:3 with labels center offset 0,-0.9 font ",8" tc rgb "#806060" notitle, \
             own using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" title "published, for this BRDF", \
             right_of(own) using 1:2:3 with labels left offset 0.8,0.35 font ",9" tc rgb "#c02020" notitle, \
             left_of(own) using 1:2:3 with labels right offset -0.8,0 font ",9" tc rgb "#c02020" notitle, \
             below(own) using 1:2:3 with labels center offset 0,-0.9 font ",9" tc rgb "#c02020" notitle, \
             explored using 1:2 with linespoints pt 6 ps 0.8 lw 1 dt 3 lc rgb "#7090c0" title "explored at those costs", \
             table using 1:2 with points pt 5 ps 1.1 lc rgb "#707070" title "Lobe, bilinear table", \
             table using 1:2:4 with labels right offset -0.8,0 font ",8" tc rgb "#505050" notitle, \
             tier using 1:2 with linespoints pt 7 ps 1.4 lw 2 lc rgb "#1060b0" title "Lobe, float", \
             tier using 1:2:3 with labels left offset 0.9,0.4 font ",10" tc rgb "#1060b0" notitle
    } else { if (panel < 4) {
        plot other using 1:2 with points pt 3 ps 1.2 lc rgb "#b08a8a" title "published, for another BRDF", \
             right_of(other) using 1:2:3 with labels left offset 0.7,0.35 font ",8" tc rgb "#806060" notitle, \
             left_of(other) using 1:2:3 with labels right offset -0.8,0 font ",8" tc rgb "#806060" notitle, \
             below(other) using 1:2:3 with labels center offset 0,-0.9 font ",8" tc rgb "#806060" notitle, \
             own using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" title "published, for this BRDF", \
             right_of(own) using 1:2:3 with labels left offset 0.8,0.35 font ",9" tc rgb "#c02020" notitle, \
             left_of(own) using 1:2:3 with labels right offset -0.8,0 font ",9" tc rgb "#c02020" notitle, \
             below(own) using 1:2:3 with labels center offset 0,-0.9 font ",9" tc rgb "#c02020" notitle, \
             table using 1:2 with points pt 5 ps 1.1 lc rgb "#707070" title "Lobe, bilinear table", \
             table using 1:2:4 with labels right offset -0.8,0 font ",8" tc rgb "#505050" notitle, \
             tier using 1:2 with linespoints pt 7 ps 1.4 lw 2 lc rgb "#1060b0" title "Lobe, float", \
             tier using 1:2:3 with labels left offset 0.9,0.4 font ",10" tc rgb "#1060b0" notitle
    } else {
        plot other using 1:2 with points pt 3 ps 1.2 lc rgb "#b08a8a" title "published, for another BRDF", \
             right_of(other) using 1:2:3 with labels left offset 0.7,0.35 font ",8" tc rgb "#806060" notitle, \
             left_of(other) using 1:2:3 with labels right offset -0.8,0 font ",8" tc rgb "#806060" notitle, \
             below(other) using 1:2:3 with labels center offset 0,-0.9 font ",8" tc rgb "#806060" notitle, \
             own using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" title "published, for this BRDF", \
             right_of(own) using 1:2:3 with labels left offset 0.8,0.35 font ",9" tc rgb "#c02020" notitle, \
             left_of(own) using 1:2:3 with labels right offset -0.8,0 font ",9" tc rgb "#c02020" notitle, \
             below(own) using 1:2:3 with labels center offset 0,-0.9 font ",9" tc rgb "#c02020" notitle, \
             tier using 1:2 with linespoints pt 7 ps 1.1 lw 1 dt 2 lc rgb "#1060b0" title "Lobe, soft float", \
             table using 1:2 with points pt 5 ps 1.1 lc rgb "#707070" title "Lobe, bilinear table, q30", \
             table using 1:2:4 with labels right offset -0.8,0 font ",8" tc rgb "#505050" notitle, \
             tier_q30 using 1:2 with linespoints pt 13 ps 1.7 lw 2 lc rgb "#108040" title "Lobe, fixed point q30", \
             tier_q30 using 1:2:3 with labels left offset 0.9,0.4 font ",10" tc rgb "#108040" notitle
    } }
}
unset multiplot
