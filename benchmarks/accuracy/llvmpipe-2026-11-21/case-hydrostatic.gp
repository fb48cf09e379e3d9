# Draws case-hydrostatic.png: gnuplot case-hydrostatic.gp
$reference0 << END
0 0
1 1
END
$method1_0 << END
0.025 0.0544679
0.075 0.231042
0.125 0.285132
0.175 0.401667
0.225 0.517817
0.275 0.630055
0.325 0.729017
0.375 0.846593
0.425 0.930742
0.475 1.04507
0.525 1.15035
0.575 1.27676
0.625 1.38065
0.675 1.49058
0.725 1.61848
0.775 1.75317
0.825 1.70701
0.875 2.33001
0.925 1.08233
END
$method1_1 << END
0.025 0.0272339
0.075 0.115521
0.125 0.142566
0.175 0.200834
0.225 0.258908
0.275 0.315028
0.325 0.364508
0.375 0.423296
0.425 0.465371
0.475 0.522536
0.525 0.575173
0.575 0.638381
0.625 0.690324
0.675 0.74529
0.725 0.809241
0.775 0.876585
0.825 0.853505
0.875 1.16501
0.925 0.541164
END
set terminal pngcairo size 900,564 noenhanced font 'DejaVu Sans,11' background 'white'
set output 'case-hydrostatic.png'
set autoscale xfix
set xlabel 'depth/H'
set ylabel 'p/(ρ g H)'
set grid lt 1 lc rgb '#E8E8E8' lw 0.7
set border 31 lc rgb '#404040'
set yrange [-0.1:2.1]
set title 'Column at rest'."\n".'dx 0.05 m, κ 2, dt 0.75, c 6' font ',12'
set key outside below Left reverse maxcols 2
set bmargin 7
plot $reference0 using 1:2 with lines lw 2 dt 1 lc rgb 'black' title 'ρ g d', \
    $method1_0 using 1:2 with lines lw 2 dt 1 lc rgb '#0072B2' title 'thesis, corrected: pressure as read', \
    $method1_1 using 1:2 with lines lw 2 dt 2 lc rgb '#0072B2' title 'thesis, corrected: pressure as it pushes'
