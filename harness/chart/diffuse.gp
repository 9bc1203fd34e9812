# Cost of diffuse_sh against what it loses. Called with in (CSV of diffuse_join.awk), out.
set datafile separator ","
set terminal svg size 1500,1150 font "DejaVu Sans,11" background "white" noenhanced
set output out
set multiplot layout 2,2 title "Burley diffuse under order-3 spherical harmonics: roughness and NdotV in [0, 1]" font ",15" \
    margins 0.07,0.98,0.06,0.92 spacing 0.08,0.09
set logscale y
set grid back lc rgb "#e4e4e4" lw 1
set border lc rgb "#808080"
set tics textcolor rgb "#404040"
set key top right opaque samplen 2 font ",9"
set yrange [1e-8:5]

# Rows of a kind with a number for the cost; the front apart from the zonal lobes, which it passes.
rows(kind, like, cost, error) = sprintf("<awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } \
    $at[\"kind\"] == \"%s\" && $at[\"format\"] == \"f32\" && $at[\"%s\"] != \"\" && ($at[\"name\"] ~ /zonal/) == %d \
    { print $at[\"%s\"], $at[\"%s\"], $at[\"title\"] }' %s | sort -t, -n", kind, cost, like, cost, error, in)

do for [panel=1:4] {
    cost = word("operations operations m4f_instructions m4f_radiance", panel)
    error = word("light_rms furnace_max light_rms light_rms", panel)
    set format y "%g"
    set ylabel (panel == 2 ? "white furnace, largest relative error" : \
                "radiance over random lighting, relative rms") offset 1
    set xlabel (panel < 3 ? "operations for the nine coefficients (fused multiply-add = 1; sqrt, division = 4)" : \
                panel == 3 ? "Cortex-M4F instructions (icount), nine coefficients in the local frame" : \
                             "Cortex-M4F instructions (icount), world space to RGB") offset 0,0.3
    if (panel < 4) { set xrange [0:*] } else { set xrange [*:*] }
    set offsets graph 0.05, graph 0.2, graph 0, graph 0
    front = rows("tier", 0, cost, error)
    zonal = rows("tier", 1, cost, error)
    star = rows("star", 1, cost, error)
    lambert = rows("star", 0, cost, error)
    # a name that would stand on another goes to the left
    side = front." | grep low"
    front_names = front." | grep -v low"
    if (panel < 4) {
        plot lambert using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" title "Lambert, and the printed zonal fit", \
             lambert using 1:2:3 with labels left offset 0.8,0.4 font ",9" tc rgb "#c02020" notitle, \
             star using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" notitle, \
             star using 1:2:3 with labels right offset 0.5,0.9 font ",9" tc rgb "#c02020" notitle, \
             zonal using 1:2 with points pt 5 ps 1.1 lc rgb "#707070" title "Lobe, one zonal lobe", \
             zonal using 1:2:3 with labels right offset -0.9,-0.4 font ",9" tc rgb "#505050" notitle, \
             front using 1:2 with linespoints pt 7 ps 1.4 lw 2 lc rgb "#1060b0" title "Lobe, float", \
             side using 1:2:3 with labels right offset -0.9,-0.4 font ",10" tc rgb "#1060b0" notitle, \
             front_names using 1:2:3 with labels left offset 0.9,0.4 font ",10" tc rgb "#1060b0" notitle
    } else {
        plot star using 1:2 with points pt 3 ps 1.6 lw 2 lc rgb "#c02020" title "printed zonal fit", \
             star using 1:2:3 with labels left offset 0.8,0.6 font ",9" tc rgb "#c02020" notitle, \
             front using 1:2 with linespoints pt 7 ps 1.4 lw 2 lc rgb "#1060b0" title "Lobe, float", \
             front using 1:2:3 with labels left offset 0.9,0.4 font ",10" tc rgb "#1060b0" notitle
    }
}
unset multiplot
