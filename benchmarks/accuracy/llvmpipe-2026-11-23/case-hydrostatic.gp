# Draws case-hydrostatic.png: gnuplot case-hydrostatic.gp
$reference0 << END
0 0
0.05 0.0500347
0.1 0.100139
0.15 0.150313
0.2 0.200557
0.25 0.25087
0.3 0.301253
0.35 0.351707
0.4 0.40223
0.45 0.452824
0.5 0.503488
0.55 0.554223
0.6 0.605028
0.65 0.655904
0.7 0.70685
0.75 0.757867
0.8 0.808955
0.85 0.860114
0.9 0.911344
0.95 0.962646
1 1.01402
END
$method2_0 << END
0.025 0.0267993
0.075 0.0984492
0.125 0.13458
0.175 0.181721
0.225 0.229841
0.275 0.280326
0.325 0.330668
0.375 0.382156
0.425 0.435447
0.475 0.488216
0.525 0.536818
0.575 0.58617
0.625 0.639227
0.675 0.693513
0.725 0.749968
0.775 0.807091
0.825 0.869824
0.875 0.899516
0.925 0.906986
0.975 1.01868
END
set terminal pngcairo size 900,542 noenhanced font 'DejaVu Sans,11' background 'white'
set output 'case-hydrostatic.png'
set autoscale xfix
set xlabel 'depth/H'
set ylabel 'p/(ρ g H)'
set grid lt 1 lc rgb '#E8E8E8' lw 0.7
set border 31 lc rgb '#404040'
set yrange [-0.050934:1.06961]
set title 'Column at rest'."\n".'dx 0.05 m, κ 2.25, dt 0.75, c 6' font ',12'
set key outside below Left reverse maxcols 2
set bmargin 6
plot $reference0 using 1:2 with points pt 6 ps 1.1 lw 1.5 lc rgb 'black' title 'equation of state', \
    $method2_0 using 1:2 with lines lw 2 dt 1 lc rgb '#009E73' title 'standard: pressure as read'
