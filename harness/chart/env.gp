# Lookups of an environment against what they miss. Called with in (CSV of env_join.awk), out (file; svg or png).
set datafile separator ","
if (out[strlen(out)-2:] eq "png") {
    set terminal pngcairo size 1600,640 font "DejaVu Sans,11" background "white" noenhanced
} else {
    set terminal svg size 1600,640 font "DejaVu Sans,11" background "white" noenhanced
}
set output out
set multiplot layout 1,3 title "GGX under light from all around: 30 points, alpha .04 to 1 by NdotV .05 to 1, environments that no fit has seen" \
    font ",15" margins 0.045,0.99,0.1,0.88 spacing 0.05,0.06
set logscale xy
set grid back lc rgb "#e4e4e4" lw 1
set border lc rgb "#808080"
set tics textcolor rgb "#404040"
set key bottom left Left reverse opaque samplen 2 font ",9"
set xrange [0.3:13]
set xtics (1, 2, 4, 8)

# Rows of a kind and model with a number for the error. The label has the operations where they are known, and the name
# where the number of lookups does not tell the tier. No row: a point beyond the axis, since gnuplot warns of none.
rows(kind, model, error) = sprintf("<awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } \
    $at[\"kind\"] == \"%s\" && $at[\"model\"] == \"%s\" && $at[\"%s\"] != \"\" { ops = $at[\"operations\"]; n++; \
    print $at[\"lookups\"], 100 * $at[\"%s\"], ops == \"\" ? $at[\"title\"] : $at[\"kind\"] != \"adaptive\" ? ops : $at[\"title\"] \": \" ops } \
    END { if (!n) print \"1e9,1,\" }' %s | sort -t, -n", \
    kind, model, error, error, in)
asked(list) = sprintf("<echo '%s' | tr ' ' '\\n'", list)

do for [panel=1:3] {
    set xlabel (panel == 2 ? "lookups of the filtered environment; numbers at the points: operations, of which the albedo takes 77" : "")
    error = word("relative rms shape", panel)
    set title (panel == 1 ? "radiance, relative at every orientation" : \
               panel == 2 ? "radiance, rms over all orientations" : "shape of the lobe, relative L2") offset 0,-0.4
    set ylabel (panel < 3 ? "per cent of the split sum's error" : "per cent") offset 2
    if (panel == 1) { set yrange [3:150]; set ytics (4, 6, 8, 10, 15, 20, 30, 40, 60, 80, 100) }
    if (panel == 2) { set yrange [10:150]; set ytics (10, 15, 20, 30, 40, 60, 80, 100) }
    if (panel == 3) { set yrange [10:90]; set ytics (10, 15, 20, 30, 40, 60, 80) }
    floor = asked(panel == 1 ? "1,30 2,18 4,12 8,8" : panel == 2 ? "8,25" : "8,20")
    star = rows("star", "env_lobes", error)
    fan = rows("star", "env_lobes_sg", error)
    tier = rows("tier", "env_lobes", error)
    sg = rows("tier", "env_lobes_sg", error)
    adaptive = rows("adaptive", "env_lobes", error)
    table = rows("table", "env_lobes", error)
    # kinds that have no row leave no trace in the key either
    there(kind) = system(sprintf("awk -F, '$3 == \"%s\"' %s | wc -l", kind, in)) + 0
    plot floor using 1:2 with linespoints pt 10 ps 1.2 lw 1 dt 3 lc rgb "#707070" title \
             (panel == 1 ? "asked of env_lobes" : panel == 2 ? "asked of env_lobes_sg" : "asked of env_lobes, 8 lookups"), \
         star using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" title "split sum, and published ideas", \
         star using 1:2:3 with labels right offset -1,0.25 font ",9" tc rgb "#c02020" notitle, \
         fan using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" notitle, \
         fan using 1:2:3 with labels center offset -5,1 font ",9" tc rgb "#c02020" notitle, \
         sg using 1:2 with linespoints pt 5 ps 1.1 lw 2 lc rgb "#2a8a3c" title (panel == 1 ? "" : "env_lobes_sg, spherical Gaussians"), \
         sg using 1:2:3 with labels left offset 0.7,0.6 font ",9" tc rgb "#2a8a3c" notitle, \
         tier using 1:2 with linespoints pt 7 ps 1.4 lw 2 lc rgb "#1060b0" title "env_lobes, the split sum's own filter", \
         tier using 1:2:3 with labels right offset -0.8,-0.7 font ",10" tc rgb "#1060b0" notitle, \
         table using 1:2 with points pt 4 ps 2 lw 2 lc rgb "#101010" title (there("table") ? "env_lobes, 16 x 16 tables" : ""), \
         table using 1:2:3 with labels right offset -0.8,-2.2 font ",9" tc rgb "#101010" notitle, \
         adaptive using 1:2 with points pt 9 ps 1.8 lc rgb "#8030a0" title (there("adaptive") ? "env_lobes, adaptive" : ""), \
         adaptive using 1:2:3 with labels right offset -1.2,-0.1 font ",10" tc rgb "#8030a0" notitle
}
unset multiplot
