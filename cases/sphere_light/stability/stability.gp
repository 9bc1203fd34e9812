# Where sphere lights fail. Called with in (CSV of the failure map), out.
set terminal svg size 1500,1330 font "DejaVu Sans,10" background "white" noenhanced
set output out
models = "'point' 'Karis 1/2' 'smoothed point as printed' 'wider lobe capped' 'LTC exact clip' 'low' 'medium' 'high'"
views = "0 30 60 75 85 89"
set multiplot layout 8,6 title "Sphere lights, F = 1: relative L2 error in per cent over 120 light positions a cell; \
the frame is the stated domain" font ",14" margins 0.105,0.925,0.05,0.93 spacing 0.008,0.014
set palette defined (0 "#f7fbf2", 0.25 "#b7dfb0", 0.5 "#fee08b", 0.7 "#f46d43", 0.85 "#d7302a", 1 "#a50026")
set logscale cb
set cbrange [1:1000]
set cbtics ("1 %%" 1, "3" 3, "10" 10, "30" 30, "100" 100, "300" 300, "1000" 1000)
unset key
set tics scale 0.3
set xrange [0.5:9.5]
set yrange [0.5:8.5]
# column (half angle), row (alpha), per cent
cells(model, view) = sprintf("<awk -F, -v OFS=' ' 'BEGIN { split(\".0025 .01 .05 .1 .2 .4 .7 1\", a, \" \"); \
    split(\".1 .5 1 2.5 6 15 45 70 90\", s, \" \"); for (i in a) row[a[i] + 0] = i; for (i in s) col[s[i] + 0] = i } \
    $1 == \"%s\" && $4 == %s { print col[$3 + 0], row[$2 + 0], 100 * $5 }' %s", model, view, in)
do for [m=1:words(models)] {
    do for [v=1:6] {
        if (m == 1) { set title sprintf("view %s", word(views, v)) offset 0,-0.8 } else { unset title }
        if (v == 1) {
            set ytics (".0025" 1, ".01" 2, ".05" 3, ".1" 4, ".2" 5, ".4" 6, ".7" 7, "1" 8)
            set ylabel word(models, m)."\nalpha" offset 1
        } else { set ytics ("" 1); unset ylabel }
        if (m == words(models)) {
            set xtics (".1" 1, ".5" 2, "1" 3, "2.5" 4, "6" 5, "15" 6, "45" 7, "70" 8, "90" 9)
            set xlabel "half angle, degrees" offset 0,0.5
        } else { set xtics ("" 1); unset xlabel }
        if (v == 6 && m == 1) { set colorbox user origin 0.94,0.1 size 0.015,0.8 } else { unset colorbox }
        unset object
        if (v < 6) { set object 1 rectangle from 0.5,2.5 to 7.5,8.5 front fillstyle empty border lc rgb "#202020" lw 1.5 }
        plot cells(word(models, m), word(views, v)) using 1:2:($3 < 1 ? 1 : $3) with image pixels, \
             "" using 1:($3 < 0.95 ? NaN : $2):(sprintf($3 < 9.95 ? "%.1f" : "%.0f", $3)) with labels font ",6.5" tc rgb "#202020"
    }
}
unset multiplot
