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
$method1_0 << END
0.025 0.0544679
0.075 0.23199
0.125 0.275337
0.175 0.400249
0.225 0.485634
0.275 0.597712
0.325 0.717021
0.375 0.802337
0.425 0.932211
0.475 1.01634
0.525 1.1224
0.575 1.2466
0.625 1.35928
0.675 1.4637
0.725 1.62291
0.775 1.70301
0.825 1.73131
0.875 2.33001
0.925 1.08233
END
$method1_1 << END
0.025 0.0272339
0.075 0.115995
0.125 0.137669
0.175 0.200125
0.225 0.242817
0.275 0.298856
0.325 0.35851
0.375 0.401168
0.425 0.466105
0.475 0.50817
0.525 0.561201
0.575 0.623302
0.625 0.679639
0.675 0.731849
0.725 0.811457
0.775 0.851504
0.825 0.865653
0.875 1.16501
0.925 0.541164
END
$method2_0 << END
0.025 0.0198004
0.075 0.101986
0.125 0.133387
0.175 0.187286
0.225 0.23683
0.275 0.288023
0.325 0.341302
0.375 0.397748
0.425 0.454618
0.475 0.514749
0.525 0.572076
0.575 0.627211
0.625 0.683468
0.675 0.742153
0.725 0.795186
0.775 0.840734
0.825 0.90088
0.875 1.04589
END
$method3_0 << END
0.025 0.0209131
0.075 0.100656
0.125 0.134554
0.175 0.184138
0.225 0.22923
0.275 0.280195
0.325 0.330877
0.375 0.383265
0.425 0.435002
0.475 0.487151
0.525 0.530239
0.575 0.588466
0.625 0.639572
0.675 0.693598
0.725 0.75102
0.775 0.809166
0.825 0.86931
0.875 0.894104
0.925 0.900647
0.975 1.02087
END
set terminal pngcairo size 900,626 noenhanced font 'DejaVu Sans,11' background 'white'
set output 'case-hydrostatic.png'
set autoscale xfix
set xlabel 'depth/H'
set ylabel 'p/(ρ g H)'
set grid lt 1 lc rgb '#E8E8E8' lw 0.7
set border 31 lc rgb '#404040'
set yrange [-0.101402:2.12944]
set title 'Column at rest'."\n".'thesis, corrected: dx 0.05 m, κ 2, dt 0.75, c 6'."\n".'robust: dx 0.05 m, κ 2.25, dt 0.75, c 6'."\n".'standard: dx 0.05 m, κ 2.25, dt 0.75, c 6' font ',12'
set key outside below Left reverse maxcols 2
set bmargin 8
plot $reference0 using 1:2 with points pt 6 ps 1.1 lw 1.5 lc rgb 'black' title 'equation of state', \
    $method1_0 using 1:2 with lines lw 2 dt 1 lc rgb '#0072B2' title 'thesis, corrected: pressure as read', \
    $method1_1 using 1:2 with lines lw 2 dt 2 lc rgb '#0072B2' title 'thesis, corrected: pressure as it pushes', \
    $method2_0 using 1:2 with lines lw 2 dt 1 lc rgb '#CC79A7' title 'robust: pressure as read', \
    $method3_0 using 1:2 with lines lw 2 dt 1 lc rgb '#009E73' title 'standard: pressure as read'
