# Draws stability-m4.svg and stability-m4.png: gnuplot stability-m4.gp
$standard << END
-0.1 1.7 -0.125 -0.075 1.4125 1.9875 2 "V"
-0.05 1.7 -0.075 -0.025 1.4125 1.9875 0 ""
0 1.7 -0.025 0.025 1.4125 1.9875 0 ""
0.05 1.7 0.025 0.075 1.4125 1.9875 1 "r"
0.1 1.7 0.075 0.125 1.4125 1.9875 1 "r"
0.15 1.7 0.125 0.175 1.4125 1.9875 1 "r"
0.2 1.7 0.175 0.225 1.4125 1.9875 1 "r"
0.25 1.7 0.225 0.275 1.4125 1.9875 1 "r"
0.3 1.7 0.275 0.325 1.4125 1.9875 1 "r"
-0.1 2.275 -0.125 -0.075 1.9875 2.5625 0 ""
-0.05 2.275 -0.075 -0.025 1.9875 2.5625 0 ""
0 2.275 -0.025 0.025 1.9875 2.5625 0 ""
0.05 2.275 0.025 0.075 1.9875 2.5625 0 ""
0.1 2.275 0.075 0.125 1.9875 2.5625 0 ""
0.15 2.275 0.125 0.175 1.9875 2.5625 0 ""
0.2 2.275 0.175 0.225 1.9875 2.5625 0 ""
0.25 2.275 0.225 0.275 1.9875 2.5625 0 ""
0.3 2.275 0.275 0.325 1.9875 2.5625 0 ""
-0.1 2.85 -0.125 -0.075 2.5625 3.1375 0 ""
-0.05 2.85 -0.075 -0.025 2.5625 3.1375 0 ""
0 2.85 -0.025 0.025 2.5625 3.1375 0 ""
0.05 2.85 0.025 0.075 2.5625 3.1375 0 ""
0.1 2.85 0.075 0.125 2.5625 3.1375 0 ""
0.15 2.85 0.125 0.175 2.5625 3.1375 0 ""
0.2 2.85 0.175 0.225 2.5625 3.1375 0 ""
0.25 2.85 0.225 0.275 2.5625 3.1375 0 ""
0.3 2.85 0.275 0.325 2.5625 3.1375 0 ""
-0.1 3.425 -0.125 -0.075 3.1375 3.7125 0 ""
-0.05 3.425 -0.075 -0.025 3.1375 3.7125 0 ""
0 3.425 -0.025 0.025 3.1375 3.7125 0 ""
0.05 3.425 0.025 0.075 3.1375 3.7125 0 ""
0.1 3.425 0.075 0.125 3.1375 3.7125 0 ""
0.15 3.425 0.125 0.175 3.1375 3.7125 0 ""
0.2 3.425 0.175 0.225 3.1375 3.7125 0 ""
0.25 3.425 0.225 0.275 3.1375 3.7125 0 ""
0.3 3.425 0.275 0.325 3.1375 3.7125 0 ""
-0.1 4 -0.125 -0.075 3.7125 4.2875 0 ""
-0.05 4 -0.075 -0.025 3.7125 4.2875 0 ""
0 4 -0.025 0.025 3.7125 4.2875 0 ""
0.05 4 0.025 0.075 3.7125 4.2875 0 ""
0.1 4 0.075 0.125 3.7125 4.2875 0 ""
0.15 4 0.125 0.175 3.7125 4.2875 0 ""
0.2 4 0.175 0.225 3.7125 4.2875 0 ""
0.25 4 0.225 0.275 3.7125 4.2875 0 ""
0.3 4 0.275 0.325 3.7125 4.2875 0 ""
END
do for [format in "svg png"] {
reset
if (format eq "svg") { set terminal svg noenhanced size 760,710 font 'DejaVu Sans,14' background 'white' } else { set terminal pngcairo noenhanced size 760,710 font 'DejaVu Sans,11' background 'white' }
set output 'stability-m4.' . format
set multiplot layout 1,1 title 'M4: Periodic box under pressure. llvmpipe (LLVM 15.0.6, 256 bits), 2026-11-27' font ',13'
set xrange [-0.125:0.325]
set xlabel 'P/(ρc²)'
set xtics format '%g'
set yrange [1.4125:4.2875]
set ylabel 'κ = R/dx'
set ytics format '%g'
set border 31 lc rgb '#404040'; set tics nomirror out; set bmargin 11; set tmargin 4; set lmargin 9; set rmargin 3
set key at graph 0.5, graph -0.19 center top horizontal Left reverse samplen 2 spacing 1.15 maxcols 2 width 2 font ',10'
set label 1 'V too fast   r does not rest' at graph 0.5, graph -0.16 center font ',10'
set title 'standard'
plot $standard using ($7 == 0 ? $1 : NaN):2:3:4:5:6 with boxxyerror fs solid 1.0 border lc rgb 'white' fc rgb '#9BC8E8' title 'stable', \
    $standard using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with boxxyerror fs solid 1.0 border lc rgb 'white' fc rgb '#F5E37A' title 'degraded', \
    $standard using ($7 == 2 ? $1 : NaN):2:3:4:5:6 with boxxyerror fs solid 1.0 border lc rgb 'white' fc rgb '#E79A6B' title 'failed', \
    $standard using 1:2:8 with labels font ',12' tc rgb '#303030' notitle
unset multiplot
unset output
}
