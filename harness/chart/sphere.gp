# Cost of a sphere light against what it misses. Called with in (CSV of sphere_join.awk), out (file; svg or png).
set datafile separator ","
if (out[strlen(out)-2:] eq "png") {
    set terminal pngcairo size 1500,1150 font "DejaVu Sans,11" background "white"
} else {
    set terminal svg size 1500,1150 font "DejaVu Sans,11" background "white" noenhanced
}
set output out
set multiplot layout 2,2 title "Sphere lights under GGX, relative L2 error over 294 held-out cells: alpha .06 to .85, half angle 1.5 to 42 degrees, view 10 to 83" \
    font ",15" margins 0.08,0.98,0.06,0.93 spacing 0.1,0.06
set logscale y
set grid back lc rgb "#e4e4e4" lw 1
set border lc rgb "#808080"
set tics textcolor rgb "#404040"
set key top right opaque samplen 2 font ",9"
set xrange [-3:118]
set xtics 0, 10
set format y "%g %%"

# Rows of a kind, as percent. The exact clip of the table has no count of its own: it
# stands at that of the round cone, the least it can cost.
rows(kind, format, set, error) = sprintf("<awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } \
    $at[\"kind\"] == \"table\" && $at[\"operations\"] != \"\" { least = $at[\"operations\"] } \
    $at[\"kind\"] == \"%s\" && $at[\"format\"] == \"%s\" && $at[\"positions\"] == \"%s\" { \
        n++; x[n] = $at[\"operations\"]; e[n] = 100 * $at[\"%s\"]; t[n] = $at[\"title\"] } \
    END { for (i = 1; i <= n; i++) if (t[i] !~ /both/) print x[i] == \"\" ? least : x[i], e[i], t[i] }' %s | sort -t, -n", \
    kind, format, set, error, in)
# What was asked of low, medium and high.
asked(low, medium, high) = sprintf("<printf '0,%g\n20,%g\n\n20,%g\n40,%g\n\n40,%g\n110,%g\n'", \
    low, low, medium, medium, high, high)

do for [panel=1:4] {
    set xlabel (panel < 3 ? "" : "operations beyond a punctual light (fused multiply-add 1; division, root, exp2, log2 4)") offset 0,0.3
    positions = word("uniform mixed uniform uniform", panel)
    error = word("all all view60 view75", panel)
    set ylabel (panel == 1 ? "all cells, lights even over the sky" : \
                panel == 2 ? "all cells, half of the lights near the mirror" : \
                panel == 3 ? "view to 60 degrees, lights even over the sky" : \
                             "view from 75 degrees, lights even over the sky") offset 0
    set yrange [word("1.5 1.5 0.7 2.5", panel):word("1500 2500 700 2500", panel)]
    star = rows("star", "double", positions, error)
    point = rows("point", "double", positions, error)
    table = rows("table", "double", positions, error)
    tier = rows("tier", "f32", positions, error)
    # so that their names stand apart
    round = table." | grep round"
    exact = table." | grep exact"
    smooth = star." | grep smoothed"
    other = star." | grep -v smoothed"
    floor = panel < 3 ? asked(18.5, 11.5, 5.0) : panel == 3 ? asked(9, 6.5, 3) : asked(31, 17.5, 8)
    plot floor using 1:2 with lines lw 1 dt 3 lc rgb "#707070" title "asked of low, medium, high", \
         point using 1:2 with points pt 2 ps 1.3 lw 2 lc rgb "#404040" title "a punctual light", \
         other using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" title "published, and simple ideas", \
         other using 1:2:3 with labels left offset 0.8,0.35 font ",9" tc rgb "#c02020" notitle, \
         smooth using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" notitle, \
         smooth using 1:2:3 with labels center offset 0,0.9 font ",9" tc rgb "#c02020" notitle, \
         round using 1:2 with points pt 5 ps 1.3 lc rgb "#707070" title "linearly transformed cosines (LTC), and 3 fetches from 20 kB", \
         round using 1:2:3 with labels right offset -0.9,0.5 font ",9" tc rgb "#505050" notitle, \
         exact using 1:2 with points pt 4 ps 1.3 lc rgb "#707070" notitle, \
         exact using 1:2:3 with labels right offset -0.9,-0.5 font ",9" tc rgb "#505050" notitle, \
         tier using 1:2 with linespoints pt 7 ps 1.4 lw 2 lc rgb "#1060b0" title "Lobe, float", \
         tier using 1:2:3 with labels left offset 0.3,0.8 font ",10" tc rgb "#1060b0" notitle
}
unset multiplot
