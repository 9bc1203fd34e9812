# Cost against error. Called with: in (CSV of join.awk), out (file), brdf, heading; svg or png by the file's end.
set datafile separator ","
if (out[strlen(out)-2:] eq "png") {
    set terminal pngcairo size 1500,1150 font "DejaVu Sans,11" background "white"
} else {
    set terminal svg size 1500,1150 font "DejaVu Sans,11" background "white" enhanced
}
set output out
set multiplot layout 2,2 title heading font ",15" margins 0.06,0.98,0.06,0.92 spacing 0.07,0.09
set logscale xy
set grid back lc rgb "#e4e4e4" lw 1
set border lc rgb "#808080"
set tics textcolor rgb "#404040"
set key top right opaque samplen 2 font ",9"
set format y "10^{%L}"
set ylabel "maximum error of scale, bias, E" offset 1

tier(x)  = strcol("brdf") eq brdf && strcol("kind") eq "tier"  && strcol("format") eq fmt ? x : NaN
table(x) = strcol("brdf") eq brdf && strcol("kind") eq "table" && strcol("format") eq fmt ? x : NaN
star(x)  = strcol("brdf") eq brdf && strcol("kind") eq "star" ? x : NaN
own(x)   = strcol("fitted") eq brdf ? star(x) : NaN
other(x) = strcol("fitted") ne brdf ? star(x) : NaN

do for [panel=1:4] {
    cost = word("operations x86_instructions m4f_instructions m0_instructions", panel)
    fmt = "f32"
    set xlabel (panel == 1 ? "operations (fused multiply-add = 1; exp2, log2, sqrt, division = 4)" : \
                panel == 2 ? "x86-64 instructions (callgrind, gcc -O2)" : \
                panel == 3 ? "Cortex-M4F instructions (icount), not cycles" : \
                             "Cortex-M0 instructions (icount), not cycles: stars in soft float") offset 0,0.3
    set xrange [*:*]
    if (panel < 4) {
        plot in using (other(column(cost))):"max" with points pt 3 ps 1.3 lc rgb "#b08a8a" title "published, for another BRDF", \
             "" using (own(column(cost))):"max" with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" title "published, for this BRDF", \
             "" using (star(column(cost))):"max":(strcol("title")) with labels left offset 0.8,0.3 font ",8" tc rgb "#803030" notitle, \
             "" using (table(column(cost))):"max" with points pt 5 ps 1.1 lc rgb "#707070" title "bilinear table", \
             "" using (table(column(cost))):"max":(sprintf("%d kB", column("bytes") / 1024)) with labels left offset 0.8,-0.4 font ",8" tc rgb "#505050" notitle, \
             "" using (tier(column(cost))):"max" with linespoints pt 7 ps 1.4 lw 2 lc rgb "#1060b0" title "Lobe, float", \
             "" using (tier(column(cost))):"max":(strcol("title")) with labels left offset 0.8,0.5 font ",9" tc rgb "#1060b0" notitle
    } else {
        plot in using (star(column(cost))):"max" with points pt 3 ps 1.3 lc rgb "#b08a8a" title "published, soft float", \
             "" using (star(column(cost))):"max":(strcol("title")) with labels left offset 0.8,0.3 font ",8" tc rgb "#803030" notitle, \
             "" using (tier(column(cost))):"max" with linespoints pt 7 ps 1.1 lw 1 dt 2 lc rgb "#1060b0" title "Lobe, soft float", \
             "" using (fmt = "q30", tier(column(cost))):"max" with linespoints pt 13 ps 1.6 lw 2 lc rgb "#108040" title "Lobe, fixed point q30", \
             "" using (fmt = "q30", tier(column(cost))):"max":(strcol("title")) with labels left offset 0.8,0.5 font ",9" tc rgb "#108040" notitle, \
             "" using (fmt = "q30", table(column(cost))):"max" with points pt 5 ps 1.1 lc rgb "#707070" title "bilinear table, q30"
    }
}
unset multiplot
