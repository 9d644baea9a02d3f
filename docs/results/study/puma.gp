# SPDX-License-Identifier: MIT
# Error against run time of puma: run `gnuplot puma.gp` in this folder.
$own0 << EOD
0.018418999999994412 9.332286464945288e-12
0.024535000000000196 1.547607592158991e-12
0.033445999999997866 1.3102125661133747e-13
0.06439600000000212 1.63311818788881e-14
EOD
$lost_own0 << EOD
EOD
$solve0 << EOD
0.018418999999994412 4.8804989228236466e-17
0.024535000000000196 4.8804989228236466e-17
0.033445999999997866 4.8804989228236466e-17
0.06439600000000212 4.8804989228236466e-17
EOD
$lost_solve0 << EOD
EOD
$plain0 << EOD
0.018418999999994412 6.8183978743087805e-15
0.024535000000000196 6.8183978743087805e-15
0.033445999999997866 6.8183978743087805e-15
0.06439600000000212 6.8183978743087805e-15
EOD
$own1 << EOD
0.044354999999995925 6.4481344920792384e-12
0.042287999999999215 3.445642623550072e-13
0.052399000000001195 3.975296584285304e-13
0.09273600000000215 3.823590788103831e-14
EOD
$lost_own1 << EOD
EOD
$solve1 << EOD
0.044354999999995925 4.8804989228236466e-17
0.042287999999999215 4.8804989228236466e-17
0.052399000000001195 4.8804989228236466e-17
0.09273600000000215 4.8804989228236466e-17
EOD
$lost_solve1 << EOD
EOD
$plain1 << EOD
0.044354999999995925 6.8183978743087805e-15
0.042287999999999215 6.8183978743087805e-15
0.052399000000001195 6.8183978743087805e-15
0.09273600000000215 6.8183978743087805e-15
EOD
$own2 << EOD
0.008007999999996684 0.6395971949492026
0.015788999999998055 1
0.024036999999999864 0.11770409634356375
0.07991699999999469 0.0033762309015548885
EOD
$lost_own2 << EOD
0.008007999999996684 0.6395971949492026 16
0.015788999999998055 1 8
0.024036999999999864 0.11770409634356375 8
EOD
$solve2 << EOD
1.1584849999999989 4.8804989228236466e-17
1.1868499999999997 4.8804989228236466e-17
1.0923499999999962 4.8804989228236466e-17
0.7913819999999987 4.8804989228236466e-17
EOD
$lost_solve2 << EOD
EOD
$plain2 << EOD
1.1584849999999989 6.8183978743087805e-15
1.1868499999999997 6.8183978743087805e-15
1.0923499999999962 6.8183978743087805e-15
0.7913819999999987 6.8183978743087805e-15
EOD
$own3 << EOD
0.01665599999999756 1
0.02560700000000793 0.8759972708336441
0.03929899999999975 0.22541847472154913
0.1403799999999933 0.003640167625700258
EOD
$lost_own3 << EOD
0.01665599999999756 1 16
0.02560700000000793 0.8759972708336441 11
0.03929899999999975 0.22541847472154913 8
EOD
$solve3 << EOD
1.223979 4.8804989228236466e-17
1.2418499999999995 4.8804989228236466e-17
1.2958950000000016 4.8804989228236466e-17
1.006889000000001 4.8804989228236466e-17
EOD
$lost_solve3 << EOD
EOD
$plain3 << EOD
1.223979 6.8183978743087805e-15
1.2418499999999995 6.8183978743087805e-15
1.2958950000000016 6.8183978743087805e-15
1.006889000000001 6.8183978743087805e-15
EOD
$own4 << EOD
0.009041000000010513 0.30423837619879024
0.01229000000000724 1
0.021399999999999864 0.018883041158885967
0.13120599999999172 0.0015488560793084382
EOD
$lost_own4 << EOD
0.009041000000010513 0.30423837619879024 12
0.01229000000000724 1 8
0.021399999999999864 0.018883041158885967 4
EOD
$solve4 << EOD
1.1214389999999952 4.8804989228236466e-17
1.1122239999999977 4.8804989228236466e-17
1.0728610000000032 4.8804989228236466e-17
0.753144000000006 4.8804989228236466e-17
EOD
$lost_solve4 << EOD
EOD
$plain4 << EOD
1.1214389999999952 6.8183978743087805e-15
1.1122239999999977 6.8183978743087805e-15
1.0728610000000032 6.8183978743087805e-15
0.753144000000006 6.8183978743087805e-15
EOD
$own5 << EOD
0.019268999999994207 1
0.024319999999988795 1
0.04031300000001181 0.16258150372720745
0.18605700000000525 0.0014201737219444186
EOD
$lost_own5 << EOD
0.019268999999994207 1 12
0.024319999999988795 1 8
0.04031300000001181 0.16258150372720745 4
EOD
$solve5 << EOD
1.268921000000006 4.8804989228236466e-17
1.2010599999999982 4.8804989228236466e-17
1.2741889999999927 4.8804989228236466e-17
0.953331999999989 4.8804989228236466e-17
EOD
$lost_solve5 << EOD
EOD
$plain5 << EOD
1.268921000000006 6.8183978743087805e-15
1.2010599999999982 6.8183978743087805e-15
1.2741889999999927 6.8183978743087805e-15
0.953331999999989 6.8183978743087805e-15
EOD
$own6 << EOD
0.003743000000000052 8.033528873999316e-10
0.003948999999991543 3.2685696972025385e-14
0.004177999999996018 7.511539109821952e-13
0.006544000000005212 2.1387624451848012e-14
EOD
$lost_own6 << EOD
EOD
$solve6 << EOD
0.003743000000000052 4.8804989228236466e-17
0.003948999999991543 4.8804989228236466e-17
0.004177999999996018 4.8804989228236466e-17
0.006544000000005212 4.8804989228236466e-17
EOD
$lost_solve6 << EOD
EOD
$plain6 << EOD
0.003743000000000052 6.8183978743087805e-15
0.003948999999991543 6.8183978743087805e-15
0.004177999999996018 6.8183978743087805e-15
0.006544000000005212 6.8183978743087805e-15
EOD
set terminal svg size 1180,620 dynamic font "sans-serif,13" background "white"
set output "puma.svg"
set datafile missing "?"
set logscale xy 10
set format xy "10^{%T}"
set grid lc rgb "#dddddd"
set multiplot title "puma: 16 roots, 64 paths" noenhanced
set tmargin at screen 0.86
set bmargin at screen 0.30
set xrange [1e-3:1e1]
set lmargin at screen 0.075
set rmargin at screen 0.475
set title "as the tracker leaves its paths, nothing repaired"
set xlabel "CPU time of all paths [s]"
set ylabel "largest relative error of a root"
set yrange [1e-15:1e1]
unset key
unset mytics
set label "bdf_projection" at screen 0.16,0.15 left offset 1.5,0 noenhanced point pt 7 ps 0.8 lc rgb "#0072b2"
set label "bdf_projection+newton" at screen 0.16,0.1 left offset 1.5,0 noenhanced point pt 5 ps 0.8 lc rgb "#56b4e9"
set label "bdf" at screen 0.16,0.05 left offset 1.5,0 noenhanced point pt 9 ps 0.8 lc rgb "#d55e00"
set label "bdf+newton" at screen 0.41,0.15 left offset 1.5,0 noenhanced point pt 11 ps 0.8 lc rgb "#e69f00"
set label "adams" at screen 0.41,0.1 left offset 1.5,0 noenhanced point pt 13 ps 0.8 lc rgb "#009e73"
set label "adams+newton" at screen 0.41,0.05 left offset 1.5,0 noenhanced point pt 15 ps 0.8 lc rgb "#cc79a7"
set label "lanes" at screen 0.66,0.15 left offset 1.5,0 noenhanced point pt 4 ps 0.8 lc rgb "#000000"
set label "roots are lost, so many" at screen 0.66,0.1 left offset 1.5,0 noenhanced point pt 2 ps 1.4 lw 2 lc rgb "#555555"
set label "residuals in plain double" at screen 0.66,0.05 left offset 1.5,0 noenhanced point pt 6 ps 0.9 lc rgb "#555555"
plot \
  $own0 using 1:2 with linespoints lw 1.5 ps 0.7 pt 7 lc rgb "#0072b2" notitle, \
  $own1 using 1:2 with linespoints lw 1.5 ps 0.7 pt 5 lc rgb "#56b4e9" notitle, \
  $own2 using 1:2 with linespoints lw 1.5 ps 0.7 pt 9 lc rgb "#d55e00" notitle, \
  $lost_own2 using 1:2 with points pt 2 ps 1.6 lw 2 lc rgb "#d55e00" notitle, \
  $lost_own2 using 1:2:3 with labels offset 1.2,0.6 font ",10" tc rgb "#d55e00" notitle, \
  $own3 using 1:2 with linespoints lw 1.5 ps 0.7 pt 11 lc rgb "#e69f00" notitle, \
  $lost_own3 using 1:2 with points pt 2 ps 1.6 lw 2 lc rgb "#e69f00" notitle, \
  $lost_own3 using 1:2:3 with labels offset 1.2,0.6 font ",10" tc rgb "#e69f00" notitle, \
  $own4 using 1:2 with linespoints lw 1.5 ps 0.7 pt 13 lc rgb "#009e73" notitle, \
  $lost_own4 using 1:2 with points pt 2 ps 1.6 lw 2 lc rgb "#009e73" notitle, \
  $lost_own4 using 1:2:3 with labels offset 1.2,0.6 font ",10" tc rgb "#009e73" notitle, \
  $own5 using 1:2 with linespoints lw 1.5 ps 0.7 pt 15 lc rgb "#cc79a7" notitle, \
  $lost_own5 using 1:2 with points pt 2 ps 1.6 lw 2 lc rgb "#cc79a7" notitle, \
  $lost_own5 using 1:2:3 with labels offset 1.2,0.6 font ",10" tc rgb "#cc79a7" notitle, \
  $own6 using 1:2 with linespoints lw 1.5 ps 0.7 pt 4 lc rgb "#000000" notitle
unset label
set lmargin at screen 0.575
set rmargin at screen 0.975
set title "as solve delivers them"
set xlabel "CPU time of solve with repairs [s]"
set yrange [1e-18:1e-13]
plot \
  $solve0 using 1:2 with linespoints lw 1.5 ps 0.7 pt 7 lc rgb "#0072b2" notitle, \
  $plain0 using 1:2 with points pt 6 ps 0.9 lc rgb "#0072b2" notitle, \
  $solve1 using 1:2 with linespoints lw 1.5 ps 0.7 pt 5 lc rgb "#56b4e9" notitle, \
  $plain1 using 1:2 with points pt 6 ps 0.9 lc rgb "#56b4e9" notitle, \
  $solve2 using 1:2 with linespoints lw 1.5 ps 0.7 pt 9 lc rgb "#d55e00" notitle, \
  $plain2 using 1:2 with points pt 6 ps 0.9 lc rgb "#d55e00" notitle, \
  $solve3 using 1:2 with linespoints lw 1.5 ps 0.7 pt 11 lc rgb "#e69f00" notitle, \
  $plain3 using 1:2 with points pt 6 ps 0.9 lc rgb "#e69f00" notitle, \
  $solve4 using 1:2 with linespoints lw 1.5 ps 0.7 pt 13 lc rgb "#009e73" notitle, \
  $plain4 using 1:2 with points pt 6 ps 0.9 lc rgb "#009e73" notitle, \
  $solve5 using 1:2 with linespoints lw 1.5 ps 0.7 pt 15 lc rgb "#cc79a7" notitle, \
  $plain5 using 1:2 with points pt 6 ps 0.9 lc rgb "#cc79a7" notitle, \
  $solve6 using 1:2 with linespoints lw 1.5 ps 0.7 pt 4 lc rgb "#000000" notitle, \
  $plain6 using 1:2 with points pt 6 ps 0.9 lc rgb "#000000" notitle
unset multiplot
