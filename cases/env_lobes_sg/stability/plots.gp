# The experiments' tables as pictures. Run in this folder: gnuplot plots.gp
set terminal svg size 900,420 font "DejaVu Sans,11" background "white" noenhanced
set datafile separator ","
set key top right samplen 2 spacing 1.1
set grid lc rgb "#dddddd"
set tics scale 0.4
array colour[4] = ["#1b6ca8", "#d1495b", "#66a182", "#8d6a9f"]
strategies = "'uniform' 'visible normals' 'mixture'"

# Uniform sampling that misses narrow lobes.
set output "sampling.svg"
set multiplot layout 1,2 title "Samples of the objective, n.v = .5, fan of 4 SGs"
set logscale x
set xrange [50:5200]
set xlabel "samples"
set ylabel "error of the fan fitted on them / best possible, - 1"
set logscale y
set yrange [0.0003:3]
part(a, s) = sprintf("<awk -F, '$1 == %s && $3 == \"%s\"' sampling.csv", a, s)
do for [k=1:2] {
    a = word(".04 .3", k)
    set title sprintf("alpha %s", a)
    plot for [i=1:3] part(a, word(strategies, i)) using 4:($7 / $8 - 1) with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[i] title word(strategies, i)
}
unset multiplot
unset title
unset logscale y

# Noise in the objective.
set output "noise.svg"
set multiplot layout 1,2 title "Noise in the objective, alpha .2, n.v = .3, mixture of densities"
set xrange [12:5600]
set logscale y
set yrange [0.003:0.3]
set ylabel "relative noise of the objective, rms"
plot "noise.csv" using 1:2 every ::1 with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[1] title "measured", \
     0.48 / sqrt(x) lc rgb "#999999" dt 2 title "1 / sqrt(samples)"
unset logscale y
set yrange [0:0.7]
set ylabel "true error of the fitted fan"
plot "noise.csv" using 1:3 every ::1 with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[2] title "new samples each time", \
     "" using 1:4 every ::1 with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[1] title "the same samples", \
     "" using 1:5 every ::1 with lines lc rgb "#999999" dt 2 title "quadrature"
unset multiplot
unset logscale x
set autoscale

# Engines.
set output "optimisers.svg"
set style fill solid 0.8 noborder
set boxwidth 0.7
set xtics rotate by -28 font ",9"
set ylabel "relative L2 error over 12 points, rms"
set yrange [0:0.6]
set xlabel ""
unset key
set rmargin 12
set title "4 SGs: a fan (4 parameters) and free lobes (12), from the analytic start, from anywhere, from a box;\nabove each the error and the evaluations"
set xrange [-0.6:9.6]
plot "optimisers.csv" using 0:4:(stringcolumn(1) eq "4 free" ? 0xd1495b : 0x1b6ca8):xticlabels(stringcolumn(1)."; ".stringcolumn(2)."; ".stringcolumn(3)) every ::1 with boxes lc rgb variable, \
     "" using 0:($4 + 0.035):(sprintf("%.3f\n%.0f", $4, $6)) every ::1 with labels font ",8"
set xtics norotate font ",11"
set rmargin -1
set key

# Starts.
unset title
set output "starts.svg"
set multiplot layout 1,2 title "20 random starts of Nelder-Mead against one analytic start, fan of 4 SGs at 12 points"
set style data histograms
set style histogram rowstacked
set boxwidth 0.8
set yrange [0:1.35]
set xrange [-0.6:11.6]
set xtics rotate by -45 font ",8"
set ylabel "part of the random starts"
plot "starts.csv" using 3:xticlabels(stringcolumn(1).", ".stringcolumn(2)) every ::1 lc rgb colour[3] title "at the best", \
     "" using (1 - $3 - $4) every ::1 lc rgb "#dddddd" title "elsewhere", "" using 4 every ::1 lc rgb colour[2] title "on the plateau"
set style histogram clustered
set yrange [0:1]
set ylabel "relative L2 error"
plot "starts.csv" using 6:xticlabels(stringcolumn(1).", ".stringcolumn(2)) every ::1 lc rgb colour[2] title "best of 4 random", \
     "" using 5 every ::1 lc rgb colour[3] title "best of all", "" using 7 every ::1 lc rgb colour[1] title "analytic"
unset multiplot
set xtics norotate font ",11"
set autoscale

# Neighbours.
set output "neighbours.svg"
set style data lines
set terminal svg size 1100,420
set multiplot layout 1,4 title "Angles of 4 SGs fitted at 14 n.v, alpha .3; error at the nodes and half way between them"
methods = "'random starts' 'random starts then ordered' 'warm starts' 'two layers'"
angles(m) = sprintf("<awk -F, '$1 == .3 && $2 == \"%s\" { for (i = 0; i < 14; i++) print .1 + .9 * i / 13 \",\" $(7 + 4 * i) \",\" $(8 + 4 * i) \",\" $(9 + 4 * i) \",\" $(10 + 4 * i) }' neighbours.csv", m)
error_of(m, c) = real(system(sprintf("awk -F, '$1 == .3 && $2 == \"%s\" { print $%d }' neighbours.csv", m, c)))
set yrange [-1.7:2]
set xrange [0:1.02]
set xlabel "n.v"
unset key
do for [m=1:4] {
    if (m == 1) { set ylabel "angle" } else { unset ylabel }
    set title sprintf("%s\n%.3f at, %.3f between", word(methods, m), error_of(word(methods, m), 3), error_of(word(methods, m), 4)) font ",10"
    plot for [k=1:4] angles(word(methods, m)) using 1:(column(k + 1)) with linespoints pt 7 ps 0.4 lw 1.5 lc rgb colour[k]
}
unset multiplot
set terminal svg size 900,420
unset title
set key
set autoscale

# Wobble.
set output "wobble.svg"
set multiplot layout 1,2 title "Dents between SGs along the fan; sharpness held at the width across the plane (left) or fitted (right)"
set xlabel "length of the response over its width"
set xrange [0.8:4.8]
set yrange [0:1]
do for [c=1:2] {
    if (c == 1) { set ylabel "deepest dent / lower maximum beside it"; set key top left } else { unset ylabel }
    plot for [i=1:3] n=word("2 4 8", i) sprintf("<awk -F, '$4 == %s' wobble.csv | sort -t, -k3,3g", n) using 3:(column(c == 1 ? 5 : 7)) with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[i] title n." SGs"
}
unset multiplot
set autoscale

# Spread beyond the angle of the centre.
set output "spread.svg"
set multiplot layout 1,2 title "8 SGs, spread free or at most the centre's angle"
set xrange [0:1.02]
set xlabel "n.v"
set key top right
set ylabel "spread / theta of the free fit"
set yrange [0:3]
row(a) = sprintf("<awk -F, '$1 == %s' spread.csv", a)
plot for [i=1:4] row(word(".1 .2 .4 .7", i)) using 2:($3 > 0 ? $4 / $3 : NaN) with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[i] title "alpha ".word(".1 .2 .4 .7", i), \
     1 lc rgb "#999999" dt 2 notitle
set ylabel "error within / error free, - 1"
set yrange [-0.005:0.08]
plot for [i=1:4] row(word(".1 .2 .4 .7", i)) using 2:($8 / $6 - 1) with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[i] title "alpha ".word(".1 .2 .4 .7", i)
unset multiplot
set autoscale

# Amplitude left free.
set output "amplitude.svg"
set multiplot layout 1,2 title "Energy of fits of shape whose amplitude is left to least squares"
set xrange [0:1.02]
set yrange [-0.7:0.2]
set ylabel "energy - albedo, relative"
set key bottom right
do for [n=1:2] {
    set title word("1 8", n)." SG".(n == 1 ? "" : "s")
    plot for [i=1:4] sprintf("<awk -F, '$1 == %s && $2 == %s' amplitude.csv", word("1 8", n), word(".04 .2 .4 1", i)) using 3:4 with linespoints pt 7 ps 0.6 lw 2 lc rgb colour[i] title "alpha ".word(".04 .2 .4 1", i), \
         0 lc rgb "#999999" dt 2 notitle
}
unset multiplot
