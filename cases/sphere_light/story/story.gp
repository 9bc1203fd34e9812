# From free parameters to closed forms. Called with in (cells.csv), out.
set terminal svg size 1400,1250 font "DejaVu Sans,11" background "white" noenhanced
set output out
set multiplot layout 3,3 title "Sphere light, medium: three parameters set free, tied together, and written in closed form" \
    font ",15" margins 0.06,0.93,0.05,0.93 spacing 0.07,0.09
set grid back lc rgb "#e4e4e4" lw 1
set border lc rgb "#808080"
set tics textcolor rgb "#404040"
alphas = ".05 .1 .2 .35 .5 .7 1"
colour(a) = word("#440154 #443983 #31688e #21918c #35b779 #90d743 #d8b800", a)
names = "reach knee plateau"
coefficient(i) = real(system(sprintf("sed -n 's/.*MEDIUM_C%d LOBE_R(\\(.*\\))/\\1/p' models/coeffs/sphere_light_medium.h", i)))
c2 = coefficient(2); c3 = coefficient(3); c6 = coefficient(6); c7 = coefficient(7); c8 = coefficient(8); c9 = coefficient(9)
# where the parameter matters by more than a fifth of a point
free(alpha, k) = sprintf("<awk -F, '$1 == %s && $%d > .002 { print $2 * (.92 + .027 * $1 * 6), $%d, cos($3 * 3.14159265 / 180) }' %s", alpha, 6 + k, 3 + k, in)
pair(alpha, k) = sprintf("<awk -F, '$1 == %s && !seen[$3]++ { print cos($3 * 3.14159265 / 180), $%d }' %s | sort -n", alpha, 12 + k, in)
set key top right font ",9" samplen 1.5 opaque
do for [k=1:3] {
    set title sprintf("%s, free in every cell (where it matters)", word(names, k))
    set xlabel "half angle, degrees" offset 0,0.4
    set logscale x
    set xrange [0.8:60]
    set yrange [*:*]
    if (k == 1) { set yrange [0:20] }
    if (k == 2) { set yrange [-2:4] }
    if (k == 3) { set yrange [0:1.2] }
    plot for [i=1:7] free(word(alphas, i), k) using 1:2:(0.35 + 0.5 * $3) with points pt 7 ps variable lc rgb colour(i) title "alpha ".word(alphas, i)
}
unset logscale x
do for [k=1:3] {
    set title sprintf("%s, one for all half angles; lines: closed form", word(names, k))
    set xlabel "n.v" offset 0,0.4
    set xrange [0:1]
    set yrange [*:*]
    if (k == 1) { set yrange [0:16]; f(a, v) = c2 + c3 * v }
    if (k == 2) { set yrange [-1:3]; f(a, v) = c6 + c7 * a + c8 * v }
    if (k == 3) { set yrange [0:1]; f(a, v) = c9 }
    plot for [i=1:7] pair(word(alphas, i), k) using 1:2 with points pt 7 ps 0.9 lc rgb colour(i) title "alpha ".word(alphas, i), \
         for [i=1:7] f(word(alphas, i) + 0, x) with lines lw 1.2 lc rgb colour(i) notitle
}
errors(c) = sprintf("<awk -F, 'NR > 1 { k = $1 \",\" $2; s[k] += $%d * $%d; n[k]++ } END { split(\".05 .1 .2 .35 .5 .7 1\", a, \" \"); \
    split(\"1 2.5 5 10 20 30 45\", h, \" \"); for (i = 1; i <= 7; i++) for (j = 1; j <= 7; j++) { k = (a[i] + 0) \",\" (h[j] + 0); print j, i, 100 * sqrt(s[k] / n[k]) } }' %s", c, c, in)
set palette defined (0 "#f7fbf2", 0.4 "#b7dfb0", 0.7 "#fee08b", 1 "#f46d43")
set cbrange [0:16]
unset key
set xrange [0.5:7.5]
set yrange [0.5:7.5]
set ytics (".05" 1, ".1" 2, ".2" 3, ".35" 4, ".5" 5, ".7" 6, "1" 7)
set xtics ("1" 1, "2.5" 2, "5" 3, "10" 4, "20" 5, "30" 6, "45" 7)
set xlabel "half angle, degrees" offset 0,0.4
set ylabel "alpha" offset 1
titles = "'error, per cent: free in every cell' 'one for all half angles' 'closed forms: medium'"
do for [c=1:3] {
    set title word(titles, c)
    if (c == 3) { set colorbox user origin 0.945,0.05 size 0.012,0.24 } else { unset colorbox }
    plot errors(9 + c) using 1:2:3 with image pixels, "" using 1:2:(sprintf("%.1f", $3)) with labels font ",8" tc rgb "#202020"
}
unset multiplot
