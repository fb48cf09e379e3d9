# Draws accuracy.svg and accuracy.png: gnuplot accuracy.gp
$p0_2_Base << END
739.682 0.0474906 637.016 1408.74 0.0473252 0.0475623 1 ""
739.682 0.0474906 637.016 1408.74 0.0473252 0.0475623 1 ""
END
$p0_2_Spacing << END
739.682 0.0474906 637.016 1408.74 0.0473252 0.0475623 0 ""
120.524 0.0452506 120.524 120.524 0.0452506 0.0452506 1 ""
47.7615 0.0562901 47.7615 47.7615 0.0562901 0.0562901 1 ""
END
$p0_2_Support << END
361.218 0.0987251 361.218 361.218 0.0987251 0.0987251 1 "2"
739.682 0.0474906 637.016 1408.74 0.0473252 0.0475623 0 ""
949.525 0.0211256 949.525 949.525 0.0211256 0.0211256 1 "2.5"
END
$p0_2_TimeStep << END
486.604 0.0474015 486.604 486.604 0.0474015 0.0474015 1 ""
739.682 0.0474906 637.016 1408.74 0.0473252 0.0475623 0 ""
END
$p0_2_SoundSpeed << END
302.678 0.0473192 302.678 302.678 0.0473192 0.0473192 1 ""
739.682 0.0474906 637.016 1408.74 0.0473252 0.0475623 0 ""
END
$p1_2_Base << END
3955.59 0.0129973 3618.71 7241.07 0.0127784 0.0130857 1 ""
3955.59 0.0129973 3618.71 7241.07 0.0127784 0.0130857 1 ""
END
$p1_2_Spacing << END
3955.59 0.0129973 3618.71 7241.07 0.0127784 0.0130857 0 ""
812.306 0.0141428 812.306 812.306 0.0141428 0.0141428 1 ""
439.354 0.0116492 439.354 439.354 0.0116492 0.0116492 1 ""
END
$p1_2_Support << END
1551.72 0.013099 1551.72 1551.72 0.013099 0.013099 1 "2"
3955.59 0.0129973 3618.71 7241.07 0.0127784 0.0130857 0 ""
4998.69 0.0201246 4998.69 4998.69 0.0201246 0.0201246 1 "2.5"
END
$p1_2_TimeStep << END
3100.62 0.0132416 3100.62 3100.62 0.0132416 0.0132416 1 ""
3955.59 0.0129973 3618.71 7241.07 0.0127784 0.0130857 0 ""
END
$p1_2_SoundSpeed << END
1358.05 0.0127088 1358.05 1358.05 0.0127088 0.0127088 1 ""
3955.59 0.0129973 3618.71 7241.07 0.0127784 0.0130857 0 ""
END
$p2_2_Base << END
5176.94 0.00512281 3795.14 6649.59 0.00329095 0.00827054 1 ""
5176.94 0.00512281 3795.14 6649.59 0.00329095 0.00827054 1 ""
END
$p2_2_Spacing << END
5176.94 0.00512281 3795.14 6649.59 0.00329095 0.00827054 0 ""
554.643 0.0707266 554.643 554.643 0.0707266 0.0707266 1 ""
265.688 0.114878 265.688 265.688 0.114878 0.114878 1 ""
END
$p2_2_Support << END
1529.79 0.0851564 1529.79 1529.79 0.0851564 0.0851564 1 "2"
5176.94 0.00512281 3795.14 6649.59 0.00329095 0.00827054 0 ""
4929.73 0.0102502 4929.73 4929.73 0.0102502 0.0102502 1 "2.5"
END
$p2_2_TimeStep << END
30090.3 0.00829118 30090.3 30090.3 0.00829118 0.00829118 1 ""
5176.94 0.00512281 3795.14 6649.59 0.00329095 0.00827054 0 ""
END
$p2_2_SoundSpeed << END
2316.85 0.0039364 2316.85 2316.85 0.0039364 0.0039364 1 ""
5176.94 0.00512281 3795.14 6649.59 0.00329095 0.00827054 0 ""
END
$p3_2_Base << END
56.6024 0.00852364 48.0824 122.181 0.00807181 0.00945689 1 ""
56.6024 0.00852364 48.0824 122.181 0.00807181 0.00945689 1 ""
END
$p3_2_Spacing << END
56.6024 0.00852364 48.0824 122.181 0.00807181 0.00945689 0 ""
12.3638 0.0116314 12.3638 12.3638 0.0116314 0.0116314 1 ""
8.04508 0.0190043 8.04508 8.04508 0.0190043 0.0190043 1 ""
END
$p3_2_Support << END
24.2207 0.00743989 24.2207 24.2207 0.00743989 0.00743989 1 "2"
56.6024 0.00852364 48.0824 122.181 0.00807181 0.00945689 0 ""
106.962 0.00870021 106.962 106.962 0.00870021 0.00870021 1 "2.5"
END
$p3_2_TimeStep << END
87.6817 0.0085333 87.6817 87.6817 0.0085333 0.0085333 1 ""
56.6024 0.00852364 48.0824 122.181 0.00807181 0.00945689 0 ""
END
$p3_2_SoundSpeed << END
45.5842 0.0186775 45.5842 45.5842 0.0186775 0.0186775 1 ""
56.6024 0.00852364 48.0824 122.181 0.00807181 0.00945689 0 ""
END
$p4_2_Base << END
110.181 0.00252674 45.2815 130.438 0.00248633 0.00253496 1 ""
110.181 0.00252674 45.2815 130.438 0.00248633 0.00253496 1 ""
END
$p4_2_Spacing << END
110.181 0.00252674 45.2815 130.438 0.00248633 0.00253496 0 ""
15.4617 0.00599924 15.4617 15.4617 0.00599924 0.00599924 1 ""
13.9621 0.0136497 13.9621 13.9621 0.0136497 0.0136497 1 ""
END
$p4_2_Support << END
29.4239 0.0030239 29.4239 29.4239 0.0030239 0.0030239 1 "2"
110.181 0.00252674 45.2815 130.438 0.00248633 0.00253496 0 ""
99.2398 0.00218903 99.2398 99.2398 0.00218903 0.00218903 1 "2.5"
END
$p4_2_TimeStep << END
60.1909 0.00237855 60.1909 60.1909 0.00237855 0.00237855 1 ""
110.181 0.00252674 45.2815 130.438 0.00248633 0.00253496 0 ""
END
$p4_2_SoundSpeed << END
39.8928 0.00248393 39.8928 39.8928 0.00248393 0.00248393 1 ""
110.181 0.00252674 45.2815 130.438 0.00248633 0.00253496 0 ""
END
$p5_2_Base << END
65860.7 0.0201457 25759 72795.7 0.0179657 0.0203551 1 ""
65860.7 0.0201457 25759 72795.7 0.0179657 0.0203551 1 ""
END
$p5_2_Spacing << END
65860.7 0.0201457 25759 72795.7 0.0179657 0.0203551 0 ""
6867.79 0.0175242 6867.79 6867.79 0.0175242 0.0175242 1 ""
4046.15 0.0165113 4046.15 4046.15 0.0165113 0.0165113 1 ""
END
$p5_2_Support << END
27449.2 0.0206434 27449.2 27449.2 0.0206434 0.0206434 1 "2"
65860.7 0.0201457 25759 72795.7 0.0179657 0.0203551 0 ""
51105.2 0.0169873 51105.2 51105.2 0.0169873 0.0169873 1 "2.5"
END
$p5_2_TimeStep << END
113126 0.0199777 113126 113126 0.0199777 0.0199777 1 ""
65860.7 0.0201457 25759 72795.7 0.0179657 0.0203551 0 ""
END
$p5_2_SoundSpeed << END
21573 0.0202001 21573 21573 0.0202001 0.0202001 1 ""
65860.7 0.0201457 25759 72795.7 0.0179657 0.0203551 0 ""
END
$p6_2_Base << END
65860.7 0.127703 25759 72795.7 0.125141 0.12777 1 ""
65860.7 0.127703 25759 72795.7 0.125141 0.12777 1 ""
END
$p6_2_Spacing << END
65860.7 0.127703 25759 72795.7 0.125141 0.12777 0 ""
6867.79 0.111313 6867.79 6867.79 0.111313 0.111313 1 ""
4046.15 0.0935272 4046.15 4046.15 0.0935272 0.0935272 1 ""
END
$p6_2_Support << END
27449.2 0.128416 27449.2 27449.2 0.128416 0.128416 1 "2"
65860.7 0.127703 25759 72795.7 0.125141 0.12777 0 ""
51105.2 0.117111 51105.2 51105.2 0.117111 0.117111 1 "2.5"
END
$p6_2_TimeStep << END
113126 0.126652 113126 113126 0.126652 0.126652 1 ""
65860.7 0.127703 25759 72795.7 0.125141 0.12777 0 ""
END
$p6_2_SoundSpeed << END
21573 0.152906 21573 21573 0.152906 0.152906 1 ""
65860.7 0.127703 25759 72795.7 0.125141 0.12777 0 ""
END
$p7_2_Base << END
9387.28 0.170941 3972.55 9533.51 0.169515 0.175365 1 ""
9387.28 0.170941 3972.55 9533.51 0.169515 0.175365 1 ""
END
$p7_2_Spacing << END
9387.28 0.170941 3972.55 9533.51 0.169515 0.175365 0 ""
914.112 0.187012 914.112 914.112 0.187012 0.187012 1 ""
326.36 0.236507 326.36 326.36 0.236507 0.236507 1 ""
END
$p7_2_Support << END
6730.81 0.173924 6730.81 6730.81 0.173924 0.173924 1 "2"
9387.28 0.170941 3972.55 9533.51 0.169515 0.175365 0 ""
46130.2 0.181126 46130.2 46130.2 0.181126 0.181126 1 "2.5"
END
$p7_2_TimeStep << END
25150.2 0.172896 25150.2 25150.2 0.172896 0.172896 1 ""
9387.28 0.170941 3972.55 9533.51 0.169515 0.175365 0 ""
END
$p7_2_SoundSpeed << END
2898.89 0.199216 2898.89 2898.89 0.199216 0.199216 1 ""
9387.28 0.170941 3972.55 9533.51 0.169515 0.175365 0 ""
END
$p8_2_Base << END
1469.57 0.0390353 1171.96 2471.46 0.0379976 0.0401185 1 ""
1469.57 0.0390353 1171.96 2471.46 0.0379976 0.0401185 1 ""
END
$p8_2_Spacing << END
1469.57 0.0390353 1171.96 2471.46 0.0379976 0.0401185 0 ""
213.324 0.0367141 213.324 213.324 0.0367141 0.0367141 1 ""
97.2089 0.0272133 97.2089 97.2089 0.0272133 0.0272133 1 ""
END
$p8_2_Support << END
2099.08 0.039992 2099.08 2099.08 0.039992 0.039992 1 "2"
1469.57 0.0390353 1171.96 2471.46 0.0379976 0.0401185 0 ""
1526.41 0.0400006 1526.41 1526.41 0.0400006 0.0400006 1 "2.5"
END
$p8_2_TimeStep << END
11114.7 0.0398648 11114.7 11114.7 0.0398648 0.0398648 1 ""
1469.57 0.0390353 1171.96 2471.46 0.0379976 0.0401185 0 ""
END
$p8_2_SoundSpeed << END
846.486 0.0438097 846.486 846.486 0.0438097 0.0438097 1 ""
1469.57 0.0390353 1171.96 2471.46 0.0379976 0.0401185 0 ""
END
do for [format in "svg png"] {
reset
if (format eq "svg") { set terminal svg noenhanced size 1860,1940 font 'DejaVu Sans,13' background 'white' } else { set terminal pngcairo noenhanced size 1860,1940 font 'DejaVu Sans,10' background 'white' }
set output 'accuracy.' . format
set multiplot layout 4,3 rowsfirst title 'Error against GPU time. llvmpipe (LLVM 15.0.6, 256 bits), 2026-11-23'."\n " font ',15'
set logscale xy
set tmargin 2.5
set rmargin 2.5
set lmargin 10
set border 31 lc rgb '#404040'
unset key
set tics nomirror
set grid xtics ytics lt 1 lc rgb '#E8E8E8' lw 0.7
set errorbars 0.4
set xlabel 'GPU ms per simulated second' offset 0,0.4
set bmargin 4
unset label; unset arrow; unset object
set xrange [35.3789:1901.79]
set xtics ('50' 50, '100' 100, '200' 200, '500' 500, '1k' 1000, '' 40 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '' 300 1, '' 400 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1)
set yrange [0.0113483:0.133279]
set ytics ('2 %%' 0.02, '3 %%' 0.03, '5 %%' 0.05, '10 %%' 0.1, '' 0.04 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1)
set title 'Oscillating ellipsoid' font ',13' offset 0,-0.4
set ylabel 'half axis, RMS over one period'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p0_2_Spacing using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p0_2_Support using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p0_2_TimeStep using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p0_2_SoundSpeed using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p0_2_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#009E73', \
    $p0_2_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#009E73', \
    $p0_2_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#009E73', \
    $p0_2_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#009E73', \
    $p0_2_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#009E73', \
    $p0_2_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#009E73'
unset label; unset arrow; unset object
set xrange [177.778:9775.44]
set xtics ('200' 200, '500' 500, '1k' 1000, '2k' 2000, '5k' 5000, '' 300 1, '' 400 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 3000 1, '' 4000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1)
set yrange [0.0062183:0.0306225]
set ytics ('1 %%' 0.01, '2 %%' 0.02, '3 %%' 0.03, '' 0.007 1, '' 0.008 1, '' 0.009 1)
set title 'Column at rest' font ',13' offset 0,-0.4
set ylabel 'slope of the pressure over depth'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p1_2_Spacing using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p1_2_Support using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p1_2_TimeStep using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p1_2_SoundSpeed using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p1_2_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#009E73', \
    $p1_2_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#009E73', \
    $p1_2_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#009E73', \
    $p1_2_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#009E73', \
    $p1_2_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#009E73', \
    $p1_2_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#009E73'
unset label; unset arrow; unset object
set xrange [177.778:40621.9]
set xtics ('200' 200, '500' 500, '1k' 1000, '2k' 2000, '5k' 5000, '10k' 10000, '20k' 20000, '' 300 1, '' 400 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 3000 1, '' 4000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '' 30000 1, '' 40000 1)
set yrange [0.000805222:0.155085]
set ytics ('0.1 %%' 0.001, '0.2 %%' 0.002, '0.5 %%' 0.005, '1 %%' 0.01, '2 %%' 0.02, '5 %%' 0.05, '10 %%' 0.1, '' 0.0009 1, '' 0.003 1, '' 0.004 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '' 0.03 1, '' 0.04 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1)
set title 'Standing wave' font ',13' offset 0,-0.4
set ylabel 'period'
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00308425 fc rgb '#E6E6E6' fs solid 1.0 noborder behind
set label 1 'reference floor 0.31 %' at graph 0.985, first 0.00308425 right offset 0,-0.7 font ',9' tc rgb '#707070'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p2_2_Spacing using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p2_2_Support using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p2_2_TimeStep using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p2_2_SoundSpeed using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p2_2_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#009E73', \
    $p2_2_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#009E73', \
    $p2_2_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#009E73', \
    $p2_2_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#009E73', \
    $p2_2_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#009E73', \
    $p2_2_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#009E73'
set bmargin 6
unset label; unset arrow; unset object
set xrange [5.95932:648]
set xtics ('10' 10, '20' 20, '50' 50, '100' 100, '200' 200, '500' 500, '' 6 1, '' 7 1, '' 8 1, '' 9 1, '' 30 1, '' 40 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '' 300 1, '' 400 1, '' 600 1)
set yrange [0.00437562:0.0256558]
set ytics ('0.5 %%' 0.005, '1 %%' 0.01, '2 %%' 0.02, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1)
set title 'Poiseuille start-up' font ',13' offset 0,-0.4
set ylabel 'profile, largest L2/u_max'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p3_2_Spacing using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p3_2_Support using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p3_2_TimeStep using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p3_2_SoundSpeed using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p3_2_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#009E73', \
    $p3_2_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#009E73', \
    $p3_2_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#009E73', \
    $p3_2_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#009E73', \
    $p3_2_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#009E73', \
    $p3_2_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#009E73'
unset label; unset arrow; unset object
set xrange [10.3423:648]
set xtics ('20' 20, '50' 50, '100' 100, '200' 200, '500' 500, '' 30 1, '' 40 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '' 300 1, '' 400 1, '' 600 1)
set yrange [0.00112613:0.018427]
set ytics ('0.2 %%' 0.002, '0.5 %%' 0.005, '1 %%' 0.01, '' 0.003 1, '' 0.004 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1)
set title 'Couette start-up' font ',13' offset 0,-0.4
set ylabel 'profile, largest L2/u_max'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p4_2_Spacing using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p4_2_Support using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p4_2_TimeStep using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p4_2_SoundSpeed using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p4_2_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#009E73', \
    $p4_2_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#009E73', \
    $p4_2_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#009E73', \
    $p4_2_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#009E73', \
    $p4_2_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#009E73', \
    $p4_2_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#009E73'
unset label; unset arrow; unset object
set xrange [177.778:62275.8]
set xtics ('1k' 1000, '10k' 10000, '' 200 1, '' 300 1, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 2000 1, '' 3000 1, '' 4000 1, '' 5000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '' 20000 1, '' 30000 1, '' 40000 1, '' 50000 1, '' 60000 1)
set yrange [0.0813181:0.400458]
set ytics ('10 %%' 0.1, '20 %%' 0.2, '30 %%' 0.3, '' 0.09 1, '' 0.4 1)
set title 'Dam break against a box (SPHERIC 2)' font ',13' offset 0,-0.4
set ylabel 'heights, normalised RMS'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set label 10 'An error of 1 is no water at all, 0.40 is water that stands at its final level all the' at graph 0, graph 0 left offset -5,-3.6 font ',9' tc rgb '#404040'
set label 11 'time; a grid solver''s own test suite accepts 0.35.' at graph 0, graph 0 left offset -5,-4.6 font ',9' tc rgb '#404040'
plot $p7_2_Spacing using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p7_2_Support using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p7_2_TimeStep using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p7_2_SoundSpeed using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p7_2_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#009E73', \
    $p7_2_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#009E73', \
    $p7_2_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#009E73', \
    $p7_2_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#009E73', \
    $p7_2_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#009E73', \
    $p7_2_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#009E73'
set bmargin 6
unset label; unset arrow; unset object
set xrange [177.778:152720]
set xtics ('1k' 1000, '10k' 10000, '100k' 100000, '' 200 1, '' 300 1, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 2000 1, '' 3000 1, '' 4000 1, '' 5000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '' 20000 1, '' 30000 1, '' 40000 1, '' 50000 1, '' 60000 1, '' 70000 1, '' 80000 1, '' 90000 1)
set yrange [0.00800483:0.206423]
set ytics ('1 %%' 0.01, '2 %%' 0.02, '5 %%' 0.05, '10 %%' 0.1, '20 %%' 0.2, '' 0.009 1, '' 0.03 1, '' 0.04 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1)
set title 'Dam break, n² = 2' font ',13' offset 0,-0.4
set ylabel 'front, shifted RMS'
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.04 fc rgb '#E6E6E6' fs solid 1.0 noborder behind
set label 1 'reference floor 4 %' at graph 0.985, first 0.04 right offset 0,-0.7 font ',9' tc rgb '#707070'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set label 10 'The raw error ranks methods backwards: the experiment''s gate holds the front back by about 0.2 in T, and a method that loses energy imitates the delay. Compare shifted errors,' at graph 0, graph 0 left offset -5,-3.6 font ',9' tc rgb '#404040'
set label 11 'and none below the experiment''s own 4 %.' at graph 0, graph 0 left offset -5,-4.6 font ',9' tc rgb '#404040'
plot $p5_2_Spacing using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p5_2_Support using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p5_2_TimeStep using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p5_2_SoundSpeed using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p5_2_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#009E73', \
    $p5_2_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#009E73', \
    $p5_2_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#009E73', \
    $p5_2_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#009E73', \
    $p5_2_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#009E73', \
    $p5_2_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#009E73'
unset label; unset arrow; unset object
set xrange [177.778:152720]
set xtics ('1k' 1000, '10k' 10000, '100k' 100000, '' 200 1, '' 300 1, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 2000 1, '' 3000 1, '' 4000 1, '' 5000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '' 20000 1, '' 30000 1, '' 40000 1, '' 50000 1, '' 60000 1, '' 70000 1, '' 80000 1, '' 90000 1)
set yrange [0.00800483:0.206423]
set ytics ('1 %%' 0.01, '2 %%' 0.02, '5 %%' 0.05, '10 %%' 0.1, '20 %%' 0.2, '' 0.009 1, '' 0.03 1, '' 0.04 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1)
set title 'Dam break, n² = 2' font ',13' offset 0,-0.4
set ylabel 'front, raw RMS'
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.04 fc rgb '#E6E6E6' fs solid 1.0 noborder behind
set label 1 'reference floor 4 %' at graph 0.985, first 0.04 right offset 0,-0.7 font ',9' tc rgb '#707070'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p6_2_Spacing using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p6_2_Support using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p6_2_TimeStep using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p6_2_SoundSpeed using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p6_2_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#009E73', \
    $p6_2_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#009E73', \
    $p6_2_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#009E73', \
    $p6_2_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#009E73', \
    $p6_2_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#009E73', \
    $p6_2_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#009E73'
unset label; unset arrow; unset object
set xrange [72.0066:15004.8]
set xtics ('100' 100, '200' 200, '500' 500, '1k' 1000, '2k' 2000, '5k' 5000, '10k' 10000, '' 80 1, '' 90 1, '' 300 1, '' 400 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 3000 1, '' 4000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1)
set yrange [0.00359909:0.0591431]
set ytics ('0.5 %%' 0.005, '1 %%' 0.01, '2 %%' 0.02, '5 %%' 0.05, '' 0.004 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '' 0.03 1, '' 0.04 1)
set title 'Two drops collide' font ',13' offset 0,-0.4
set ylabel 'momentum of a drop, RMS over D/U'
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.01 fc rgb '#E6E6E6' fs solid 1.0 noborder behind
set label 1 'reference floor 1 %' at graph 0.985, first 0.01 right offset 0,-0.7 font ',9' tc rgb '#707070'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p8_2_Spacing using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p8_2_Support using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p8_2_TimeStep using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p8_2_SoundSpeed using 1:2 with lines lw 1 lc rgb '#009E73', \
    $p8_2_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#009E73', \
    $p8_2_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#009E73', \
    $p8_2_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#009E73', \
    $p8_2_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#009E73', \
    $p8_2_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#009E73', \
    $p8_2_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#009E73'
set bmargin 4
unset border; unset tics; unset xlabel; unset ylabel; unset title; unset label; unset arrow; unset object; unset grid; unset logscale
set key center center Left reverse spacing 1.5 samplen 2.5 width 1
plot [0:1][0:1] 1/0 with linespoints lw 2 pt 7 ps 1.5 lc rgb '#009E73' title 'standard', \
    1/0 with points pt 7 ps 1.9 lc rgb '#606060' title 'base', \
    1/0 with points pt 9 ps 1.1 lc rgb '#606060' title 'spacing dx', \
    1/0 with points pt 5 ps 1.1 lc rgb '#606060' title 'support κ = R/dx', \
    1/0 with points pt 13 ps 1.1 lc rgb '#606060' title 'time step', \
    1/0 with points pt 11 ps 1.1 lc rgb '#606060' title 'speed of sound', \
    1/0 with points pt 6 ps 1.5 lw 1.5 lc rgb '#606060' title 'open, at the top: a run failed', \
    1/0 with xyerrorbars pt 7 ps 0.6 lc rgb '#606060' title 'median, least and greatest of the seeds', \
    1/0 with lines lw 1.5 dt 2 lc rgb '#A0A0A0' title 'real time at 4 and 8 ms a frame of 60 Hz', \
    1/0 with boxes fs solid 1.0 noborder lc rgb '#E6E6E6' title 'below what the reference is good for'
unset multiplot
unset output
}
