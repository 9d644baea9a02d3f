# SPDX-License-Identifier: MIT
# Error against run time of griewank-osborne: run `gnuplot griewank-osborne.gp` in this folder.
$own0 << EOD
0.002447999999999999 1 0
0.002251000000000003 1 0
0.0025380000000000125 1 0
0.002915000000000001 1 0
0.0034079999999999666 1 0
0.004063000000000039 1 0
0.005072999999999994 1 0
0.005395999999999956 1 0
0.017992999999999926 1 0
0.026375000000000037 1 0
EOD
$lost_own0 << EOD
EOD
$solve0 << EOD
0.0024330000000000046 1 0
0.002236999999999989 1 0
0.0025499999999999967 1 0
0.002925999999999984 1 0
0.003379999999999994 1 0
0.0041280000000000205 1 0
0.005040999999999962 1 0
0.005443000000000087 1 0
0.01811699999999994 1 0
0.026170000000000027 1 0
EOD
$lost_solve0 << EOD
EOD
$plain0 << EOD
EOD
$own1 << EOD
0.0029879999999999907 1 0
0.002663000000000082 1 0
0.002843000000000151 1 0
0.0031730000000000924 1 0
0.0037799999999998946 1 0
0.0045280000000000875 1 0
0.00532699999999986 1 0
0.005863999999999869 1 0
0.006278000000000006 1 0
0.06904000000000021 1 0
EOD
$lost_own1 << EOD
EOD
$solve1 << EOD
0.002990999999999966 1 0
0.0026600000000001067 1 0
0.002866999999999953 1 0
0.003238000000000074 1 0
0.0037410000000002164 1 0
0.004547000000000079 1 0
0.005336999999999925 1 0
0.005949000000000204 1 0
0.006336000000000119 1 0
0.0692569999999999 1 0
EOD
$lost_solve1 << EOD
EOD
$plain1 << EOD
EOD
$own2 << EOD
0.0001389999999998892 1 0
0.0005930000000002877 1 0
0.0008210000000001827 1 0
0.0009969999999999146 1 0
0.002104000000000106 1 0
0.0035449999999999093 1 0
0.004191000000000056 1 0
0.004753000000000007 1 0
0.00726899999999997 1 0
0.00989099999999965 1 0
EOD
$lost_own2 << EOD
EOD
$solve2 << EOD
0.00013600000000035806 1 0
0.0005729999999997126 1 0
0.0007959999999997969 1 0
0.0010110000000000952 1 0
0.002107000000000081 1 0
0.0035840000000000316 1 0
0.0041240000000000165 1 0
0.004710000000000214 1 0
0.007276999999999756 1 0
0.010029000000000288 1 0
EOD
$lost_solve2 << EOD
EOD
$plain2 << EOD
EOD
$own3 << EOD
0.0001829999999998222 1 0
0.0006459999999997024 1 0
0.0009759999999996438 1 0
0.0011630000000000251 1 0
0.00233500000000042 1 0
0.0041569999999993 1 0
0.004715000000000025 1 0
0.0052189999999994185 1 0
0.007467999999999364 1 0
0.010671000000000319 1 0
EOD
$lost_own3 << EOD
EOD
$solve3 << EOD
0.00017700000000075988 1 0
0.0006469999999998421 1 0
0.0009620000000003515 1 0
0.0011570000000000746 1 0
0.0023530000000002715 1 0
0.0041599999999997195 1 0
0.004669999999999952 1 0
0.0052520000000004785 1 0
0.007465000000000721 1 0
0.010650000000000048 1 0
EOD
$lost_solve3 << EOD
EOD
$plain3 << EOD
EOD
$own4 << EOD
0.0001499999999996504 1 0
0.0006199999999996209 1 0
0.0008220000000003225 1 0
0.0015899999999993142 1 0
0.002771000000000079 1 0
0.0033840000000004977 1 0
0.0038520000000001886 1 0
0.004582000000000086 1 0
0.00479900000000022 1 0
0.009617999999999682 1 0
EOD
$lost_own4 << EOD
EOD
$solve4 << EOD
0.00014800000000025904 1 0
0.0006149999999998101 1 0
0.0008330000000000837 1 0
0.001595000000000013 1 0
0.0028519999999998547 1 0
0.0034000000000000696 1 0
0.0038169999999997373 1 0
0.004562999999999207 1 0
0.004758999999999958 1 0
0.009653000000000134 1 0
EOD
$lost_solve4 << EOD
EOD
$plain4 << EOD
EOD
$own5 << EOD
0.00018600000000024153 1 0
0.0007229999999998071 1 0
0.0008459999999992363 1 0
0.0010500000000002174 1 0
0.004420999999999786 1 0
0.004449000000000147 1 0
0.0048040000000000305 1 0
0.005512999999999657 1 0
0.006506000000000789 1 0
0.009344999999999715 1 0
EOD
$lost_own5 << EOD
EOD
$solve5 << EOD
0.00018099999999954264 1 0
0.0007269999999994781 1 0
0.0008590000000001652 1 0
0.0010329999999996176 1 0
0.0043319999999997805 1 0
0.004463000000000328 1 0
0.004730000000000345 1 0
0.005478000000000094 1 0
0.0064950000000001396 1 0
0.009294999999999831 1 0
EOD
$lost_solve5 << EOD
EOD
$plain5 << EOD
EOD
$own6 << EOD
0.0016099999999994452 1 0
0.0015809999999998325 1 0
0.001595000000000013 1 0
0.001615000000000144 1 0
0.001726999999999812 1 0
0.001799000000000106 1 0
0.001968000000000636 1 0
0.002162999999999471 1 0
0.0023010000000001085 1 0
0.00465400000000038 1 0
EOD
$lost_own6 << EOD
EOD
$solve6 << EOD
0.0015999999999998238 1 0
0.001600000000000712 1 0
0.0016020000000001033 1 0
0.0016099999999994452 1 0
0.001746999999999943 1 0
0.0018060000000001963 1 0
0.001974999999999838 1 0
0.002178999999999931 1 0
0.002316000000000429 1 0
0.004498999999999143 1 0
EOD
$lost_solve6 << EOD
EOD
$plain6 << EOD
EOD
$own7 << EOD
0.0016540000000002664 1 0
0.0016499999999997073 1 0
0.0016410000000011138 1 0
0.001718999999999582 1 0
0.0018929999999990343 1 0
0.0022060000000010405 1 0
0.003942000000000334 1 0
0.0057000000000009265 1 0
EOD
$lost_own7 << EOD
EOD
$solve7 << EOD
0.0016530000000010148 1 0
0.0016369999999987783 1 0
0.0016439999999988686 1 0
0.0017379999999995732 1 0
0.0019079999999984665 1 0
0.0022030000000015093 1 0
0.004056999999999533 1 0
0.005580999999999392 1 0
EOD
$lost_solve7 << EOD
EOD
$plain7 << EOD
EOD
$own8 << EOD
0.00203100000000056 1 0
0.002065999999999235 1 0
0.0020439999999997127 1 0
0.0055440000000004375 1 0
EOD
$lost_own8 << EOD
EOD
$solve8 << EOD
0.002041999999999433 1 0
0.0020340000000000913 1 0
0.002060000000000173 1 0
0.005468999999999724 1 0
EOD
$lost_solve8 << EOD
EOD
$plain8 << EOD
EOD
set terminal svg size 1180,700 dynamic font "sans-serif,13" background "white"
set output "griewank-osborne.svg"
set logscale xy 10
set format xy "10^{%T}"
set grid lc rgb "#dddddd"
set multiplot title "griewank-osborne: 1 root, 3 paths; errors not known, since no root is simple: drawn as 1" noenhanced
set tmargin at screen 0.88
set bmargin at screen 0.25
set xrange [1e-4:1e-1]
set lmargin at screen 0.075
set rmargin at screen 0.475
set title "nothing repaired"
set xlabel "CPU time of all paths [s]"
set ylabel "largest relative error of a root"
set yrange [1e-1:1e1]
unset key
unset mytics
set label "bdf_projection" at screen 0.075,0.125 left offset 1.5,0 noenhanced point ps 0.8 pt 7 lc rgb "#0072b2"
set label "bdf_projection+newton" at screen 0.075,0.083 left offset 1.5,0 noenhanced point ps 0.8 pt 5 lc rgb "#56b4e9"
set label "bdf" at screen 0.075,0.041 left offset 1.5,0 noenhanced point ps 0.8 pt 9 lc rgb "#d55e00"
set label "bdf+newton" at screen 0.305,0.125 left offset 1.5,0 noenhanced point ps 0.8 pt 11 lc rgb "#e69f00"
set label "adams" at screen 0.305,0.083 left offset 1.5,0 noenhanced point ps 0.8 pt 4 lc rgb "#009e73"
set label "adams+newton" at screen 0.305,0.041 left offset 1.5,0 noenhanced point ps 0.8 pt 6 lc rgb "#7fcf9f"
set label "lanes" at screen 0.535,0.125 left offset 1.5,0 noenhanced point ps 0.8 pt 13 lc rgb "#000000"
set label "lanes+cubic" at screen 0.535,0.083 left offset 1.5,0 noenhanced point ps 0.8 pt 8 lc rgb "#cc79a7"
set label "lanes+tangent" at screen 0.535,0.041 left offset 1.5,0 noenhanced point ps 0.8 pt 10 lc rgb "#999999"
set label "roots are lost, so many" at screen 0.765,0.125 left offset 1.5,0 noenhanced point pt 2 ps 1.4 lw 2 lc rgb "#555555"
set label "residuals in plain double" at screen 0.765,0.083 left offset 1.5,0 noenhanced point pt 6 ps 0.9 lc rgb "#555555"
plot \
  $own0 using 1:2 with lines lw 1.5 lc rgb "#0072b2" notitle, \
  $own0 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 7 lc rgb "#0072b2" notitle, \
  $own1 using 1:2 with lines lw 1.5 lc rgb "#56b4e9" dt 2 notitle, \
  $own1 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 5 lc rgb "#56b4e9" notitle, \
  $own2 using 1:2 with lines lw 1.5 lc rgb "#d55e00" notitle, \
  $own2 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 9 lc rgb "#d55e00" notitle, \
  $own3 using 1:2 with lines lw 1.5 lc rgb "#e69f00" dt 2 notitle, \
  $own3 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 11 lc rgb "#e69f00" notitle, \
  $own4 using 1:2 with lines lw 1.5 lc rgb "#009e73" notitle, \
  $own4 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 4 lc rgb "#009e73" notitle, \
  $own5 using 1:2 with lines lw 1.5 lc rgb "#7fcf9f" dt 2 notitle, \
  $own5 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 6 lc rgb "#7fcf9f" notitle, \
  $own6 using 1:2 with lines lw 1.5 lc rgb "#000000" notitle, \
  $own6 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 13 lc rgb "#000000" notitle, \
  $own7 using 1:2 with lines lw 1.5 lc rgb "#cc79a7" dt 2 notitle, \
  $own7 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 8 lc rgb "#cc79a7" notitle, \
  $own8 using 1:2 with lines lw 1.5 lc rgb "#999999" dt 2 notitle, \
  $own8 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 10 lc rgb "#999999" notitle
unset label
set lmargin at screen 0.575
set rmargin at screen 0.975
set title "as solve delivers them"
set xlabel "CPU time of solve with repairs [s]"
set yrange [1e-1:1e1]
plot \
  $solve0 using 1:2 with lines lw 1.5 lc rgb "#0072b2" notitle, \
  $solve0 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 7 lc rgb "#0072b2" notitle, \
  $solve1 using 1:2 with lines lw 1.5 lc rgb "#56b4e9" dt 2 notitle, \
  $solve1 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 5 lc rgb "#56b4e9" notitle, \
  $solve2 using 1:2 with lines lw 1.5 lc rgb "#d55e00" notitle, \
  $solve2 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 9 lc rgb "#d55e00" notitle, \
  $solve3 using 1:2 with lines lw 1.5 lc rgb "#e69f00" dt 2 notitle, \
  $solve3 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 11 lc rgb "#e69f00" notitle, \
  $solve4 using 1:2 with lines lw 1.5 lc rgb "#009e73" notitle, \
  $solve4 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 4 lc rgb "#009e73" notitle, \
  $solve5 using 1:2 with lines lw 1.5 lc rgb "#7fcf9f" dt 2 notitle, \
  $solve5 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 6 lc rgb "#7fcf9f" notitle, \
  $solve6 using 1:2 with lines lw 1.5 lc rgb "#000000" notitle, \
  $solve6 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 13 lc rgb "#000000" notitle, \
  $solve7 using 1:2 with lines lw 1.5 lc rgb "#cc79a7" dt 2 notitle, \
  $solve7 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 8 lc rgb "#cc79a7" notitle, \
  $solve8 using 1:2 with lines lw 1.5 lc rgb "#999999" dt 2 notitle, \
  $solve8 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 10 lc rgb "#999999" notitle
unset multiplot
