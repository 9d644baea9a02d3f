# SPDX-License-Identifier: MIT
# Error against run time of griewank-osborne: run `gnuplot griewank-osborne.gp` in this folder.
$own0 << EOD
0.001920999999999999 1 0
0.0017469999999999986 1 0
0.0021979999999999777 1 0
0.002546999999999966 1 0
0.0031979999999999786 1 0
0.004280999999999979 1 0
0.005459999999999909 1 0
0.0068669999999999565 1 0
0.007553000000000143 1 0
0.009967999999999977 1 0
EOD
$lost_own0 << EOD
EOD
$solve0 << EOD
0.0037869999999999987 1 0
0.0037699999999999956 1 0
0.004245999999999972 1 0
0.004305000000000003 1 0
0.005412000000000028 1 0
0.006299999999999972 1 0
0.007330999999999976 1 0
0.008485999999999994 1 0
0.009765999999999941 1 0
0.01187399999999994 1 0
EOD
$lost_solve0 << EOD
EOD
$plain0 << EOD
EOD
$own1 << EOD
0.0027240000000001707 1 0
0.0022610000000000685 1 0
0.002818999999999905 1 0
0.003185999999999911 1 0
0.0035569999999998103 1 0
0.005024999999999835 1 0
0.005813999999999986 1 0
0.007271999999999945 1 0
0.009847999999999857 1 0
0.01160799999999984 1 0
EOD
$lost_own1 << EOD
EOD
$solve1 << EOD
0.004690000000000083 1 0
0.0044319999999999915 1 0
0.004897999999999847 1 0
0.005014000000000074 1 0
0.005576999999999721 1 0
0.0069510000000003735 1 0
0.008424999999999905 1 0
0.009176000000000073 1 0
0.011528000000000205 1 0
0.013973000000000013 1 0
EOD
$lost_solve1 << EOD
EOD
$plain1 << EOD
EOD
$own2 << EOD
0.00015799999999988046 1 1
0.000284000000000173 1 1
0.00047900000000034026 1 1
0.0006510000000004013 1 1
0.0026959999999993656 1 1
0.0033680000000000376 1 0
0.004399999999999515 1 0
0.0049600000000005195 1 0
0.006305999999999479 1 0
0.008891000000000204 1 0
EOD
$lost_own2 << EOD
0.00015799999999988046 1 1
0.000284000000000173 1 1
0.00047900000000034026 1 1
0.0006510000000004013 1 1
0.0026959999999993656 1 1
EOD
$solve2 << EOD
0.015998999999999874 1 0
0.011478000000000321 1 0
0.011200999999999794 1 0
0.010018999999999778 1 0
0.0077990000000003334 1 0
0.005569999999999631 1 0
0.006372999999999962 1 0
0.0071870000000000545 1 0
0.008826 1 0
0.01128899999999966 1 0
EOD
$lost_solve2 << EOD
EOD
$plain2 << EOD
EOD
$own3 << EOD
0.00021100000000018326 1 1
0.0004070000000000462 1 1
0.0005609999999993676 1 1
0.0009190000000005583 1 1
0.004846999999999824 1 1
0.004223000000000532 1 0
0.004875999999999436 1 0
0.006127999999999467 1 0
0.007802000000000753 1 0
0.009834999999999816 1 0
EOD
$lost_own3 << EOD
0.00021100000000018326 1 1
0.0004070000000000462 1 1
0.0005609999999993676 1 1
0.0009190000000005583 1 1
0.004846999999999824 1 1
EOD
$solve3 << EOD
0.016636000000000095 1 0
0.011417999999999928 1 0
0.01158599999999943 1 0
0.012629999999999697 1 0
0.00851200000000052 1 0
0.006535999999999653 1 0
0.0069710000000000605 1 0
0.008016999999999719 1 0
0.009920999999999403 1 0
0.012063000000000379 1 0
EOD
$lost_solve3 << EOD
EOD
$plain3 << EOD
EOD
$own4 << EOD
0.00014700000000011926 1 1
0.0002699999999995484 1 1
0.00038499999999963563 1 1
0.001787000000000205 1 1
0.004192999999999003 1 1
0.003427000000000291 1 0
0.0036679999999993385 1 0
0.004941000000000528 1 0
0.005660999999999916 1 0
0.006866999999999734 1 0
EOD
$lost_own4 << EOD
0.00014700000000011926 1 1
0.0002699999999995484 1 1
0.00038499999999963563 1 1
0.001787000000000205 1 1
0.004192999999999003 1 1
EOD
$solve4 << EOD
0.020224999999999937 1 0
0.011034000000000432 1 0
0.0106850000000005 1 0
0.008630000000000138 1 0
0.00926899999999975 1 0
0.0053520000000002454 1 0
0.005639000000000394 1 0
0.00694999999999979 1 0
0.007619000000000042 1 0
0.008989000000001468 1 0
EOD
$lost_solve4 << EOD
EOD
$plain4 << EOD
EOD
$own5 << EOD
0.00019599999999897477 1 1
0.0005840000000016943 1 1
0.0005359999999985376 1 1
0.0008229999999986859 1 1
0.0069189999999998975 1 1
0.0044480000000000075 1 0
0.004692999999999614 1 0
0.006091000000001401 1 0
0.006576000000000803 1 0
0.008286000000000016 1 0
EOD
$lost_own5 << EOD
0.00019599999999897477 1 1
0.0005840000000016943 1 1
0.0005359999999985376 1 1
0.0008229999999986859 1 1
0.0069189999999998975 1 1
EOD
$solve5 << EOD
0.016771000000000313 1 0
0.01235699999999973 1 0
0.011418000000000816 1 0
0.009712999999999639 1 0
0.009940000000000282 1 0
0.0065040000000013976 1 0
0.006838000000000122 1 0
0.007900000000001128 1 0
0.008841999999999572 1 0
0.009652999999998357 1 0
EOD
$lost_solve5 << EOD
EOD
$plain5 << EOD
EOD
$own6 << EOD
0.0011850000000013239 1 0
0.000992000000000104 1 0
0.0009930000000011319 1 0
0.0009969999999999146 1 0
0.0013070000000006132 1 0
0.001314999999999955 1 0
0.0016759999999997888 1 0
0.0020340000000000913 1 0
0.0029679999999991935 1 0
0.002898000000000067 1 0
EOD
$lost_own6 << EOD
EOD
$solve6 << EOD
0.003916000000000253 1 0
0.004229000000000482 1 0
0.004054000000000002 1 0
0.003766999999999854 1 0
0.00419800000000059 1 0
0.0046109999999988105 1 0
0.005709000000001296 1 0
0.006946000000001007 1 0
0.009223999999999677 1 0
0.011426000000000158 1 0
EOD
$lost_solve6 << EOD
EOD
$plain6 << EOD
EOD
$own7 << EOD
0.001068000000000069 1 0
0.0010550000000009163 1 0
0.0011149999999986449 1 0
0.0012010000000000076 1 0
0.0016020000000001033 1 0
0.0018440000000001788 1 0
0.0025560000000002248 1 0
0.003987000000000407 1 0
EOD
$lost_own7 << EOD
EOD
$solve7 << EOD
0.004433999999999827 1 0
0.00462199999999946 1 0
0.004592000000000596 1 0
0.004825000000000301 1 0
0.004964999999998554 1 0
0.006800000000000139 1 0
0.009542999999998969 1 0
0.01397600000000132 1 0
EOD
$lost_solve7 << EOD
EOD
$plain7 << EOD
EOD
$own8 << EOD
0.0016259999999999053 1 0
0.001626999999999157 1 0
0.0017629999999986268 1 0
0.0030199999999993565 1 0
EOD
$lost_own8 << EOD
EOD
$solve8 << EOD
0.01594200000000079 1 0
0.01625100000000046 1 0
0.016140999999999295 1 0
0.016788000000000025 1 0
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
  $lost_own2 using 1:2 with points pt 2 ps 0.9 lw 1.5 lc rgb "#d55e00" notitle, \
  $lost_own2 using 1:2:3 with labels offset 0.9,0.5 font ",9" tc rgb "#d55e00" notitle, \
  $own3 using 1:2 with lines lw 1.5 lc rgb "#e69f00" dt 2 notitle, \
  $own3 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 11 lc rgb "#e69f00" notitle, \
  $lost_own3 using 1:2 with points pt 2 ps 0.9 lw 1.5 lc rgb "#e69f00" notitle, \
  $lost_own3 using 1:2:3 with labels offset 0.9,0.5 font ",9" tc rgb "#e69f00" notitle, \
  $own4 using 1:2 with lines lw 1.5 lc rgb "#009e73" notitle, \
  $own4 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 4 lc rgb "#009e73" notitle, \
  $lost_own4 using 1:2 with points pt 2 ps 0.9 lw 1.5 lc rgb "#009e73" notitle, \
  $lost_own4 using 1:2:3 with labels offset 0.9,0.5 font ",9" tc rgb "#009e73" notitle, \
  $own5 using 1:2 with lines lw 1.5 lc rgb "#7fcf9f" dt 2 notitle, \
  $own5 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 6 lc rgb "#7fcf9f" notitle, \
  $lost_own5 using 1:2 with points pt 2 ps 0.9 lw 1.5 lc rgb "#7fcf9f" notitle, \
  $lost_own5 using 1:2:3 with labels offset 0.9,0.5 font ",9" tc rgb "#7fcf9f" notitle, \
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
