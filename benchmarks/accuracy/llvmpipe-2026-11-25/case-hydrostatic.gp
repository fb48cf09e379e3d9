# Draws case-hydrostatic.png: gnuplot case-hydrostatic.gp
$reference0 << END
0 0
0.1 0.101082
0.2 0.204361
0.3 0.309883
0.4 0.417698
0.5 0.527855
0.6 0.640405
0.7 0.755401
0.8 0.872895
0.9 0.992941
1 1.1156
END
$method2_0 << END
0.05 0.0359307
0.15 0.170805
0.25 0.240814
0.35 0.344282
0.45 0.431306
0.55 0.538186
0.65 0.680495
0.75 0.83772
0.85 0.944991
END
$method3_0 << END
0.0384615 0.0241512
0.115385 0.129616
0.192308 0.187466
0.269231 0.275858
0.346154 0.33919
0.423077 0.424774
0.5 0.495139
0.576923 0.573669
0.653846 0.650882
0.730769 0.721324
0.807692 0.808649
0.884615 0.864507
0.961538 0.974936
END
set terminal pngcairo size 900,584 noenhanced font 'DejaVu Sans,11' background 'white'
set output 'case-hydrostatic.png'
set autoscale xfix
set xlabel 'depth/H'
set ylabel 'p/(ρ g H)'
set grid lt 1 lc rgb '#E8E8E8' lw 0.7
set border 31 lc rgb '#404040'
set yrange [-0.05578:1.17138]
set title 'Column at rest'."\n".'robust: dx 0.1 m, κ 2, dt 0.75, c 6'."\n".'standard: dx 0.0769 m, κ 2, dt 0.75, c 6' font ',12'
set key outside below Left reverse maxcols 2
set bmargin 7
plot $reference0 using 1:2 with points pt 6 ps 1.1 lw 1.5 lc rgb 'black' title 'equation of state', \
    $method2_0 using 1:2 with lines lw 2 dt 1 lc rgb '#CC79A7' title 'robust: pressure as read', \
    $method3_0 using 1:2 with lines lw 2 dt 1 lc rgb '#009E73' title 'standard: pressure as read'
