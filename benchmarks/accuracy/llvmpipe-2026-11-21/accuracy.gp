# Draws accuracy.svg and accuracy.png: gnuplot accuracy.gp
$p0_0_Base << END
1578.85 0.386825 1578.85 1578.85 0.386825 0.386825 1 ""
1578.85 0.386825 1578.85 1578.85 0.386825 0.386825 1 ""
END
$p0_0_Spacing << END
1578.85 0.386825 1578.85 1578.85 0.386825 0.386825 0 ""
175.538 0.361818 175.538 175.538 0.361818 0.361818 1 ""
186.131 0.356307 186.131 186.131 0.356307 0.356307 1 ""
END
$p0_0_Support << END
1578.85 0.386825 1578.85 1578.85 0.386825 0.386825 0 ""
941.536 0.330296 941.536 941.536 0.330296 0.330296 1 "2.5"
END
$p0_0_TimeStep << END
1556.91 0.38653 1556.91 1556.91 0.38653 0.38653 1 ""
1578.85 0.386825 1578.85 1578.85 0.386825 0.386825 0 ""
END
$p0_0_SoundSpeed << END
888.564 0.388184 888.564 888.564 0.388184 0.388184 1 ""
1578.85 0.386825 1578.85 1578.85 0.386825 0.386825 0 ""
END
$p0_1_Base << END
578.511 0.124629 578.511 578.511 0.124629 0.124629 1 ""
578.511 0.124629 578.511 578.511 0.124629 0.124629 1 ""
END
$p0_1_Spacing << END
578.511 0.124629 578.511 578.511 0.124629 0.124629 0 ""
121.349 0.141119 121.349 121.349 0.141119 0.141119 1 ""
104.418 0.162184 104.418 104.418 0.162184 0.162184 1 ""
END
$p0_1_Support << END
578.511 0.124629 578.511 578.511 0.124629 0.124629 0 ""
534.008 0.0758747 534.008 534.008 0.0758747 0.0758747 1 "2.5"
END
$p0_1_TimeStep << END
639.336 0.124711 639.336 639.336 0.124711 0.124711 1 ""
578.511 0.124629 578.511 578.511 0.124629 0.124629 0 ""
END
$p0_1_SoundSpeed << END
459.924 0.111402 459.924 459.924 0.111402 0.111402 1 ""
578.511 0.124629 578.511 578.511 0.124629 0.124629 0 ""
END
$p1_1_Base << END
2068.15 1.21022 2068.15 2068.15 1.21022 1.21022 1 ""
2068.15 1.21022 2068.15 2068.15 1.21022 1.21022 1 ""
END
$p1_1_Spacing << END
2068.15 1.21022 2068.15 2068.15 1.21022 1.21022 0 ""
722.673 1.24382 722.673 722.673 1.24382 1.24382 1 ""
809.454 1.34324 809.454 809.454 1.34324 1.34324 1 ""
END
$p1_1_Support << END
2068.15 1.21022 2068.15 2068.15 1.21022 1.21022 0 ""
2103.29 1.16876 2103.29 2103.29 1.16876 1.16876 1 "2.5"
END
$p1_1_TimeStep << END
2570.11 1.22246 2570.11 2570.11 1.22246 1.22246 1 ""
2068.15 1.21022 2068.15 2068.15 1.21022 1.21022 0 ""
END
$p1_1_SoundSpeed << END
1603.84 1.29995 1603.84 1603.84 1.29995 1.29995 1 ""
2068.15 1.21022 2068.15 2068.15 1.21022 1.21022 0 ""
END
$p1_0_Base_failed << END
3842.65
END
$p1_0_Spacing_failed << END
1042.8
1215.02
END
$p1_0_Support_failed << END
5748.06
END
$p1_0_TimeStep_failed << END
3642.55
END
$p1_0_SoundSpeed_failed << END
3533.43
END
$p2_1_Base << END
3001.14 0.0206827 3001.14 3001.14 0.0206827 0.0206827 1 ""
3001.14 0.0206827 3001.14 3001.14 0.0206827 0.0206827 1 ""
END
$p2_1_Spacing << END
3001.14 0.0206827 3001.14 3001.14 0.0206827 0.0206827 0 ""
496.534 0.00198973 496.534 496.534 0.00198973 0.00198973 1 ""
288.752 0.0379394 288.752 288.752 0.0379394 0.0379394 1 ""
END
$p2_1_Support << END
3001.14 0.0206827 3001.14 3001.14 0.0206827 0.0206827 0 ""
3168.05 0.0202205 3168.05 3168.05 0.0202205 0.0202205 1 "2.5"
END
$p2_1_TimeStep << END
3221.61 0.0157762 3221.61 3221.61 0.0157762 0.0157762 1 ""
3001.14 0.0206827 3001.14 3001.14 0.0206827 0.0206827 0 ""
END
$p2_1_SoundSpeed << END
1058.75 0.0542603 1058.75 1058.75 0.0542603 0.0542603 1 ""
3001.14 0.0206827 3001.14 3001.14 0.0206827 0.0206827 0 ""
END
$p2_0_Base_failed << END
7566.64
END
$p2_0_Spacing_failed << END
1633.55
823.546
END
$p2_0_Support_failed << END
7045.68
END
$p2_0_SoundSpeed_failed << END
2624.13
END
$p3_0_Base << END
91.9766 0.738858 91.9766 91.9766 0.738858 0.738858 1 ""
91.9766 0.738858 91.9766 91.9766 0.738858 0.738858 1 ""
END
$p3_0_Spacing << END
91.9766 0.738858 91.9766 91.9766 0.738858 0.738858 0 ""
32.6167 1.39039 32.6167 32.6167 1.39039 1.39039 1 ""
30.9579 1.03659 30.9579 30.9579 1.03659 1.03659 1 ""
END
$p3_0_Support << END
91.9766 0.738858 91.9766 91.9766 0.738858 0.738858 0 ""
219.986 0.777428 219.986 219.986 0.777428 0.777428 1 "2.5"
END
$p3_0_TimeStep << END
113.762 0.327602 113.762 113.762 0.327602 0.327602 1 ""
91.9766 0.738858 91.9766 91.9766 0.738858 0.738858 0 ""
END
$p3_0_SoundSpeed << END
56.9652 1.98206 56.9652 56.9652 1.98206 1.98206 1 ""
91.9766 0.738858 91.9766 91.9766 0.738858 0.738858 0 ""
END
$p3_1_Base << END
67.1247 0.016153 67.1247 67.1247 0.016153 0.016153 1 ""
67.1247 0.016153 67.1247 67.1247 0.016153 0.016153 1 ""
END
$p3_1_Spacing << END
67.1247 0.016153 67.1247 67.1247 0.016153 0.016153 0 ""
17.5292 0.0267995 17.5292 17.5292 0.0267995 0.0267995 1 ""
12.4777 0.0267327 12.4777 12.4777 0.0267327 0.0267327 1 ""
END
$p3_1_Support << END
67.1247 0.016153 67.1247 67.1247 0.016153 0.016153 0 ""
84.5956 0.0335031 84.5956 84.5956 0.0335031 0.0335031 1 "2.5"
END
$p3_1_TimeStep << END
57.8088 0.016575 57.8088 57.8088 0.016575 0.016575 1 ""
67.1247 0.016153 67.1247 67.1247 0.016153 0.016153 0 ""
END
$p3_1_SoundSpeed << END
29.622 0.0365987 29.622 29.622 0.0365987 0.0365987 1 ""
67.1247 0.016153 67.1247 67.1247 0.016153 0.016153 0 ""
END
$p4_0_Base << END
116.33 0.258677 116.33 116.33 0.258677 0.258677 1 ""
116.33 0.258677 116.33 116.33 0.258677 0.258677 1 ""
END
$p4_0_Spacing << END
116.33 0.258677 116.33 116.33 0.258677 0.258677 0 ""
31.7406 0.307779 31.7406 31.7406 0.307779 0.307779 1 ""
37.0448 0.431359 37.0448 37.0448 0.431359 0.431359 1 ""
END
$p4_0_Support << END
116.33 0.258677 116.33 116.33 0.258677 0.258677 0 ""
178.208 0.30622 178.208 178.208 0.30622 0.30622 1 "2.5"
END
$p4_0_TimeStep << END
115.968 0.254438 115.968 115.968 0.254438 0.254438 1 ""
116.33 0.258677 116.33 116.33 0.258677 0.258677 0 ""
END
$p4_0_SoundSpeed << END
74.026 0.430691 74.026 74.026 0.430691 0.430691 1 ""
116.33 0.258677 116.33 116.33 0.258677 0.258677 0 ""
END
$p4_1_Base << END
48.6686 0.0105138 48.6686 48.6686 0.0105138 0.0105138 1 ""
48.6686 0.0105138 48.6686 48.6686 0.0105138 0.0105138 1 ""
END
$p4_1_Spacing << END
48.6686 0.0105138 48.6686 48.6686 0.0105138 0.0105138 0 ""
17.4286 0.0107993 17.4286 17.4286 0.0107993 0.0107993 1 ""
10.9419 0.0134833 10.9419 10.9419 0.0134833 0.0134833 1 ""
END
$p4_1_Support << END
48.6686 0.0105138 48.6686 48.6686 0.0105138 0.0105138 0 ""
71.7768 0.0115979 71.7768 71.7768 0.0115979 0.0115979 1 "2.5"
END
$p4_1_TimeStep << END
44.9498 0.00982625 44.9498 44.9498 0.00982625 0.00982625 1 ""
48.6686 0.0105138 48.6686 48.6686 0.0105138 0.0105138 0 ""
END
$p4_1_SoundSpeed << END
32.8666 0.0104422 32.8666 32.8666 0.0104422 0.0104422 1 ""
48.6686 0.0105138 48.6686 48.6686 0.0105138 0.0105138 0 ""
END
$p5_0_Base << END
189912 0.534535 189912 189912 0.534535 0.534535 1 ""
189912 0.534535 189912 189912 0.534535 0.534535 1 ""
END
$p5_0_Spacing << END
189912 0.534535 189912 189912 0.534535 0.534535 0 ""
20307.6 0.543646 20307.6 20307.6 0.543646 0.543646 1 ""
7267.61 0.55174 7267.61 7267.61 0.55174 0.55174 1 ""
END
$p5_0_Support << END
189912 0.534535 189912 189912 0.534535 0.534535 0 ""
91562.8 0.538477 91562.8 91562.8 0.538477 0.538477 1 "2.5"
END
$p5_0_SoundSpeed << END
37242.1 0.543244 37242.1 37242.1 0.543244 0.543244 1 ""
189912 0.534535 189912 189912 0.534535 0.534535 0 ""
END
$p5_1_Base << END
31706.5 0.0224248 31706.5 31706.5 0.0224248 0.0224248 1 ""
31706.5 0.0224248 31706.5 31706.5 0.0224248 0.0224248 1 ""
END
$p5_1_Spacing << END
31706.5 0.0224248 31706.5 31706.5 0.0224248 0.0224248 0 ""
6329.64 0.0328505 6329.64 6329.64 0.0328505 0.0328505 1 ""
2339.88 0.0370079 2339.88 2339.88 0.0370079 0.0370079 1 ""
END
$p5_1_Support << END
31706.5 0.0224248 31706.5 31706.5 0.0224248 0.0224248 0 ""
29078.6 0.0232809 29078.6 29078.6 0.0232809 0.0232809 1 "2.5"
END
$p5_1_SoundSpeed << END
12577.9 0.0225842 12577.9 12577.9 0.0225842 0.0225842 1 ""
31706.5 0.0224248 31706.5 31706.5 0.0224248 0.0224248 0 ""
END
$p6_0_Base << END
189912 0.559313 189912 189912 0.559313 0.559313 1 ""
189912 0.559313 189912 189912 0.559313 0.559313 1 ""
END
$p6_0_Spacing << END
189912 0.559313 189912 189912 0.559313 0.559313 0 ""
20307.6 0.56614 20307.6 20307.6 0.56614 0.56614 1 ""
7267.61 0.572516 7267.61 7267.61 0.572516 0.572516 1 ""
END
$p6_0_Support << END
189912 0.559313 189912 189912 0.559313 0.559313 0 ""
91562.8 0.563103 91562.8 91562.8 0.563103 0.563103 1 "2.5"
END
$p6_0_SoundSpeed << END
37242.1 0.562362 37242.1 37242.1 0.562362 0.562362 1 ""
189912 0.559313 189912 189912 0.559313 0.559313 0 ""
END
$p6_1_Base << END
31706.5 0.0251605 31706.5 31706.5 0.0251605 0.0251605 1 ""
31706.5 0.0251605 31706.5 31706.5 0.0251605 0.0251605 1 ""
END
$p6_1_Spacing << END
31706.5 0.0251605 31706.5 31706.5 0.0251605 0.0251605 0 ""
6329.64 0.0623319 6329.64 6329.64 0.0623319 0.0623319 1 ""
2339.88 0.0923748 2339.88 2339.88 0.0923748 0.0923748 1 ""
END
$p6_1_Support << END
31706.5 0.0251605 31706.5 31706.5 0.0251605 0.0251605 0 ""
29078.6 0.0352405 29078.6 29078.6 0.0352405 0.0352405 1 "2.5"
END
$p6_1_SoundSpeed << END
12577.9 0.0228613 12577.9 12577.9 0.0228613 0.0228613 1 ""
31706.5 0.0251605 31706.5 31706.5 0.0251605 0.0251605 0 ""
END
$p7_0_Base << END
5255.63 0.51068 5255.63 5255.63 0.51068 0.51068 1 ""
5255.63 0.51068 5255.63 5255.63 0.51068 0.51068 1 ""
END
$p7_0_Spacing << END
5255.63 0.51068 5255.63 5255.63 0.51068 0.51068 0 ""
1813.58 0.478602 1813.58 1813.58 0.478602 0.478602 1 ""
225.863 0.454775 225.863 225.863 0.454775 0.454775 1 ""
END
$p7_0_Support << END
5255.63 0.51068 5255.63 5255.63 0.51068 0.51068 0 ""
5994.56 0.511297 5994.56 5994.56 0.511297 0.511297 1 "2.5"
END
$p7_0_SoundSpeed << END
3057.54 0.580918 3057.54 3057.54 0.580918 0.580918 1 ""
5255.63 0.51068 5255.63 5255.63 0.51068 0.51068 0 ""
END
$p7_1_Base << END
2474.09 0.257278 2474.09 2474.09 0.257278 0.257278 1 ""
2474.09 0.257278 2474.09 2474.09 0.257278 0.257278 1 ""
END
$p7_1_Spacing << END
2474.09 0.257278 2474.09 2474.09 0.257278 0.257278 0 ""
1861.8 0.287111 1861.8 1861.8 0.287111 0.287111 1 ""
176.278 0.317549 176.278 176.278 0.317549 0.317549 1 ""
END
$p7_1_Support << END
2474.09 0.257278 2474.09 2474.09 0.257278 0.257278 0 ""
3730.08 0.265867 3730.08 3730.08 0.265867 0.265867 1 "2.5"
END
$p7_1_SoundSpeed << END
2026.35 0.240185 2026.35 2026.35 0.240185 0.240185 1 ""
2474.09 0.257278 2474.09 2474.09 0.257278 0.257278 0 ""
END
do for [format in "svg png"] {
reset
if (format eq "svg") { set terminal svg noenhanced size 1860,1470 font 'DejaVu Sans,13' background 'white' } else { set terminal pngcairo noenhanced size 1860,1470 font 'DejaVu Sans,10' background 'white' }
set output 'accuracy.' . format
set multiplot layout 3,3 rowsfirst title 'Error against GPU time. llvmpipe (LLVM 15.0.6, 256 bits), 2026-11-21'."\n " font ',15'
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
set xrange [77.3467:2131.45]
set xtics ('100' 100, '200' 200, '500' 500, '1k' 1000, '2k' 2000, '' 80 1, '' 90 1, '' 300 1, '' 400 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1)
set yrange [0.0402089:0.524048]
set ytics ('5 %%' 0.05, '10 %%' 0.1, '20 %%' 0.2, '50 %%' 0.5, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '' 0.3 1, '' 0.4 1)
set title 'Oscillating ellipsoid' font ',13' offset 0,-0.4
set ylabel 'half axis, RMS over one period'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p0_0_Spacing using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p0_0_Support using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p0_0_TimeStep using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p0_0_SoundSpeed using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p0_1_Spacing using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p0_1_Support using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p0_1_TimeStep using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p0_1_SoundSpeed using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p0_0_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p0_0_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p0_0_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p0_0_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p0_1_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p0_1_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p0_1_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p0_1_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p0_0_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#D55E00', \
    $p0_1_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#0072B2', \
    $p0_0_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#D55E00', \
    $p0_1_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#0072B2'
unset label; unset arrow; unset object
set xrange [177.778:7759.88]
set xtics ('200' 200, '500' 500, '1k' 1000, '2k' 2000, '5k' 5000, '' 300 1, '' 400 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 3000 1, '' 4000 1, '' 6000 1, '' 7000 1)
set yrange [0.508863:2.95949]
set ytics ('100 %%' 1, '200 %%' 2, '' 0.6 1, '' 0.7 1, '' 0.8 1, '' 0.9 1)
set title 'Column at rest' font ',13' offset 0,-0.4
set ylabel 'slope of the pressure over depth'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p1_1_Spacing using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p1_1_Support using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p1_1_TimeStep using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p1_1_SoundSpeed using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p1_1_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p1_1_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p1_1_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p1_1_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p1_1_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#0072B2', \
    $p1_1_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#0072B2', \
    $p1_0_Base_failed using 1:(2.75824) with points pt 6 ps 1.9 lw 1.5 lc rgb '#D55E00', \
    $p1_0_Spacing_failed using 1:(2.75824) with points pt 8 ps 1.1 lw 1.5 lc rgb '#D55E00', \
    $p1_0_Support_failed using 1:(2.75824) with points pt 4 ps 1.1 lw 1.5 lc rgb '#D55E00', \
    $p1_0_TimeStep_failed using 1:(2.75824) with points pt 12 ps 1.1 lw 1.5 lc rgb '#D55E00', \
    $p1_0_SoundSpeed_failed using 1:(2.75824) with points pt 10 ps 1.1 lw 1.5 lc rgb '#D55E00'
unset label; unset arrow; unset object
set xrange [177.778:10215]
set xtics ('200' 200, '500' 500, '1k' 1000, '2k' 2000, '5k' 5000, '10k' 10000, '' 300 1, '' 400 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 3000 1, '' 4000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1)
set yrange [0.000820365:0.117052]
set ytics ('0.1 %%' 0.001, '0.2 %%' 0.002, '0.5 %%' 0.005, '1 %%' 0.01, '2 %%' 0.02, '5 %%' 0.05, '10 %%' 0.1, '' 0.0009 1, '' 0.003 1, '' 0.004 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '' 0.03 1, '' 0.04 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1)
set title 'Standing wave' font ',13' offset 0,-0.4
set ylabel 'period'
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.00308425 fc rgb '#E6E6E6' fs solid 1.0 noborder behind
set label 1 'reference floor 0.31 %' at graph 0.985, first 0.00308425 right offset 0,-0.7 font ',9' tc rgb '#707070'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p2_1_Spacing using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p2_1_Support using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p2_1_TimeStep using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p2_1_SoundSpeed using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p2_1_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p2_1_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p2_1_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p2_1_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p2_1_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#0072B2', \
    $p2_1_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#0072B2', \
    $p2_0_Base_failed using 1:(0.0959851) with points pt 6 ps 1.9 lw 1.5 lc rgb '#D55E00', \
    $p2_0_Spacing_failed using 1:(0.0959851) with points pt 8 ps 1.1 lw 1.5 lc rgb '#D55E00', \
    $p2_0_Support_failed using 1:(0.0959851) with points pt 4 ps 1.1 lw 1.5 lc rgb '#D55E00', \
    $p2_0_SoundSpeed_failed using 1:(0.0959851) with points pt 10 ps 1.1 lw 1.5 lc rgb '#D55E00'
set bmargin 6
unset label; unset arrow; unset object
set xrange [9.24274:648]
set xtics ('10' 10, '20' 20, '50' 50, '100' 100, '200' 200, '500' 500, '' 30 1, '' 40 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '' 300 1, '' 400 1, '' 600 1)
set yrange [0.00531483:2.67578]
set ytics ('1 %%' 0.01, '10 %%' 0.1, '100 %%' 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '' 0.02 1, '' 0.03 1, '' 0.04 1, '' 0.05 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '' 0.2 1, '' 0.3 1, '' 0.4 1, '' 0.5 1, '' 0.6 1, '' 0.7 1, '' 0.8 1, '' 0.9 1, '' 2 1)
set title 'Poiseuille start-up' font ',13' offset 0,-0.4
set ylabel 'profile, largest L2/u_max'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p3_0_Spacing using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p3_0_Support using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p3_0_TimeStep using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p3_0_SoundSpeed using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p3_1_Spacing using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p3_1_Support using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p3_1_TimeStep using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p3_1_SoundSpeed using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p3_0_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p3_0_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p3_0_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p3_0_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p3_1_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p3_1_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p3_1_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p3_1_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p3_0_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#D55E00', \
    $p3_1_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#0072B2', \
    $p3_0_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#D55E00', \
    $p3_1_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#0072B2'
unset label; unset arrow; unset object
set xrange [8.10511:648]
set xtics ('10' 10, '20' 20, '50' 50, '100' 100, '200' 200, '500' 500, '' 9 1, '' 30 1, '' 40 1, '' 60 1, '' 70 1, '' 80 1, '' 90 1, '' 300 1, '' 400 1, '' 600 1)
set yrange [0.00377213:0.582335]
set ytics ('0.5 %%' 0.005, '1 %%' 0.01, '2 %%' 0.02, '5 %%' 0.05, '10 %%' 0.1, '20 %%' 0.2, '50 %%' 0.5, '' 0.004 1, '' 0.006 1, '' 0.007 1, '' 0.008 1, '' 0.009 1, '' 0.03 1, '' 0.04 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '' 0.3 1, '' 0.4 1)
set title 'Couette start-up' font ',13' offset 0,-0.4
set ylabel 'profile, largest L2/u_max'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p4_0_Spacing using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p4_0_Support using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p4_0_TimeStep using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p4_0_SoundSpeed using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p4_1_Spacing using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p4_1_Support using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p4_1_TimeStep using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p4_1_SoundSpeed using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p4_0_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p4_0_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p4_0_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p4_0_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p4_1_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p4_1_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p4_1_TimeStep using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 13 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p4_1_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p4_0_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#D55E00', \
    $p4_1_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#0072B2', \
    $p4_0_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#D55E00', \
    $p4_1_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#0072B2'
unset label; unset arrow; unset object
set xrange [130.576:8092.66]
set xtics ('200' 200, '500' 500, '1k' 1000, '2k' 2000, '5k' 5000, '' 300 1, '' 400 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 3000 1, '' 4000 1, '' 6000 1, '' 7000 1, '' 8000 1)
set yrange [0.142422:0.78424]
set ytics ('20 %%' 0.2, '30 %%' 0.3, '50 %%' 0.5, '' 0.4 1, '' 0.6 1, '' 0.7 1)
set title 'Dam break against a box (SPHERIC 2)' font ',13' offset 0,-0.4
set ylabel 'heights, normalised RMS'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set label 10 'An error of 1 is no water at all, 0.40 is water that stands at its final level all the' at graph 0, graph 0 left offset -5,-3.6 font ',9' tc rgb '#404040'
set label 11 'time; a grid solver''s own test suite accepts 0.35.' at graph 0, graph 0 left offset -5,-4.6 font ',9' tc rgb '#404040'
plot $p7_0_Spacing using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p7_0_Support using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p7_0_SoundSpeed using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p7_1_Spacing using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p7_1_Support using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p7_1_SoundSpeed using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p7_0_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p7_0_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p7_0_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p7_1_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p7_1_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p7_1_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p7_0_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#D55E00', \
    $p7_1_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#0072B2', \
    $p7_0_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#D55E00', \
    $p7_1_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#0072B2'
set bmargin 6
unset label; unset arrow; unset object
set xrange [177.778:256381]
set xtics ('1k' 1000, '10k' 10000, '100k' 100000, '' 200 1, '' 300 1, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 2000 1, '' 3000 1, '' 4000 1, '' 5000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '' 20000 1, '' 30000 1, '' 40000 1, '' 50000 1, '' 60000 1, '' 70000 1, '' 80000 1, '' 90000 1, '' 200000 1)
set yrange [0.00933761:0.772897]
set ytics ('1 %%' 0.01, '2 %%' 0.02, '5 %%' 0.05, '10 %%' 0.1, '20 %%' 0.2, '50 %%' 0.5, '' 0.03 1, '' 0.04 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '' 0.3 1, '' 0.4 1, '' 0.6 1, '' 0.7 1)
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
plot $p5_0_Spacing using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p5_0_Support using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p5_0_SoundSpeed using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p5_1_Spacing using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p5_1_Support using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p5_1_SoundSpeed using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p5_0_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p5_0_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p5_0_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p5_1_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p5_1_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p5_1_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p5_0_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#D55E00', \
    $p5_1_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#0072B2', \
    $p5_0_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#D55E00', \
    $p5_1_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#0072B2'
unset label; unset arrow; unset object
set xrange [177.778:256381]
set xtics ('1k' 1000, '10k' 10000, '100k' 100000, '' 200 1, '' 300 1, '' 400 1, '' 500 1, '' 600 1, '' 700 1, '' 800 1, '' 900 1, '' 2000 1, '' 3000 1, '' 4000 1, '' 5000 1, '' 6000 1, '' 7000 1, '' 8000 1, '' 9000 1, '' 20000 1, '' 30000 1, '' 40000 1, '' 50000 1, '' 60000 1, '' 70000 1, '' 80000 1, '' 90000 1, '' 200000 1)
set yrange [0.00933761:0.772897]
set ytics ('1 %%' 0.01, '2 %%' 0.02, '5 %%' 0.05, '10 %%' 0.1, '20 %%' 0.2, '50 %%' 0.5, '' 0.03 1, '' 0.04 1, '' 0.06 1, '' 0.07 1, '' 0.08 1, '' 0.09 1, '' 0.3 1, '' 0.4 1, '' 0.6 1, '' 0.7 1)
set title 'Dam break, n² = 2' font ',13' offset 0,-0.4
set ylabel 'front, raw RMS'
set object 1 rectangle from graph 0, graph 0 to graph 1, first 0.04 fc rgb '#E6E6E6' fs solid 1.0 noborder behind
set label 1 'reference floor 4 %' at graph 0.985, first 0.04 right offset 0,-0.7 font ',9' tc rgb '#707070'
set arrow 1 from 240, graph 0 to 240, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 2 '4 ms/frame' at 240, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
set arrow 2 from 480, graph 0 to 480, graph 1 nohead dt 2 lw 1.5 lc rgb '#A0A0A0' back
set label 3 '8 ms/frame' at 480, graph 0.02 left rotate by 90 offset 0.8,0 font ',9' tc rgb '#707070'
plot $p6_0_Spacing using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p6_0_Support using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p6_0_SoundSpeed using 1:2 with lines lw 1 lc rgb '#D55E00', \
    $p6_1_Spacing using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p6_1_Support using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p6_1_SoundSpeed using 1:2 with lines lw 1 lc rgb '#0072B2', \
    $p6_0_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p6_0_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p6_0_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#D55E00', \
    $p6_1_Spacing using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 9 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p6_1_Support using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 5 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p6_1_SoundSpeed using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 11 ps 1.1 lw 1 lc rgb '#0072B2', \
    $p6_0_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#D55E00', \
    $p6_1_Base using ($7 == 1 ? $1 : NaN):2:3:4:5:6 with xyerrorbars pt 7 ps 1.9 lw 1 lc rgb '#0072B2', \
    $p6_0_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#D55E00', \
    $p6_1_Support using 1:2:8 with labels left offset 0.6,0.6 font ',8' tc rgb '#0072B2'
unset border; unset tics; unset xlabel; unset ylabel; unset title; unset label; unset arrow; unset object; unset grid; unset logscale
set key center center Left reverse spacing 1.5 samplen 2.5 width 1
plot [0:1][0:1] 1/0 with linespoints lw 2 pt 7 ps 1.5 lc rgb '#D55E00' title 'thesis, as printed', \
    1/0 with linespoints lw 2 pt 7 ps 1.5 lc rgb '#0072B2' title 'thesis, corrected', \
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
