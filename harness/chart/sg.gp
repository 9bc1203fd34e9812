# Cost of light from a spherical Gaussian against what it misses. Called with in (CSV of sg_join.awk), out (file; svg or
# png).
set datafile separator ","
if (out[strlen(out)-2:] eq "png") {
    set terminal pngcairo size 1500,1050 font "DejaVu Sans,11" background "white" noenhanced
} else {
    set terminal svg size 1500,1050 font "DejaVu Sans,11" background "white" noenhanced
}
set output out
set multiplot layout 2,2 title "One spherical Gaussian of light under GGX, relative L2 error over 216 held-out cells: alpha .06 to .85, NdotV .07 to .9, sharpness 5 to 2896" \
    font ",15" margins 0.07,0.98,0.07,0.9 spacing 0.1,0.1
set logscale y
set grid back lc rgb "#e4e4e4" lw 1
set border lc rgb "#808080"
set tics textcolor rgb "#404040"
set key top right opaque samplen 2 font ",9"
set xrange [-4:118]
set xtics 0, 10
set format y "%g %%"

rows(kind, set, error) = sprintf("<awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } \
    $at[\"kind\"] == \"%s\" && $at[\"positions\"] == \"%s\" && $at[\"operations\"] != \"\" \
    { print $at[\"operations\"], 100 * $at[\"%s\"], $at[\"title\"] }' %s | sort -t, -n", kind, set, error, in)

do for [panel=1:4] {
    set xlabel (panel < 3 ? "" : "operations beyond a punctual light (fused multiply-add 1; division, root, exp2, log2 4)") offset 0,0.3
    positions = word("uniform mixed uniform mixed", panel)
    error = word("all all smooth smooth", panel)
    set title (panel < 3 ? "all cells" : "alpha to .25 and NdotV from .4") offset 0,-0.4
    set ylabel (positions eq "uniform" ? "lights even over the sky" : "half of the lights near the mirror") offset 0.5
    set yrange [(panel < 3 ? 3 : 2):(panel == 1 ? 150 : panel == 2 ? 1500 : panel == 3 ? 150 : 900)]
    ask = panel < 3 ? 28 : 15
    star = rows("star", positions, error)
    point = rows("point", positions, error)
    tier = rows("tier", positions, error)
    plot ask with lines lw 1 dt 3 lc rgb "#707070" title sprintf("asked: %g %%", ask), \
         point using 1:2 with points pt 2 ps 1.3 lw 2 lc rgb "#404040" title "a punctual light", \
         star using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" title "published, and a refit of it", \
         star using 1:2:3 with labels left offset 0.8,0.5 font ",9" tc rgb "#c02020" notitle, \
         tier using 1:2 with linespoints pt 7 ps 1.4 lw 2 lc rgb "#1060b0" title "Lobe", \
         tier using 1:2:3 with labels left offset 0.6,0.7 font ",10" tc rgb "#1060b0" notitle
}
unset multiplot
