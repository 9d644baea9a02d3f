# SPDX-License-Identifier: MIT
# Error against run time of griewank-osborne: run `gnuplot griewank-osborne.gp` in this folder.
$own0 << EOD
0.002381000000000008 1 0
0.0020429999999999893 1 0
0.0025360000000000382 1 0
0.003218999999999972 1 0
0.003988000000000103 1 0
0.005297999999999914 1 0
0.007333999999999952 1 0
0.009552000000000005 1 0
0.01555200000000001 1 0
0.02002499999999996 1 0
EOD
$lost_own0 << EOD
EOD
$solve0 << EOD
0.005732999999999988 1 0
0.005309999999999981 1 0
0.005827000000000027 1 0
0.006434000000000051 1 0
0.007326000000000055 1 0
0.009124999999999939 1 0
0.010480999999999963 1 0
0.01267700000000005 1 0
0.018608999999999876 1 0
0.023309999999999942 1 0
EOD
$lost_solve0 << EOD
EOD
$plain0 << EOD
EOD
$own1 << EOD
0.003821999999999992 1 0
0.0030559999999999476 1 0
0.0033330000000000304 1 0
0.004392999999999869 1 0
0.00502899999999995 1 0
0.006745000000000001 1 0
0.008305000000000007 1 0
0.010653000000000024 1 0
0.017904999999999838 1 0
0.0252460000000001 1 0
EOD
$lost_own1 << EOD
EOD
$solve1 << EOD
0.007149000000000072 1 0
0.006285999999999792 1 0
0.0067909999999997694 1 0
0.007492000000000054 1 0
0.008483000000000018 1 0
0.009816999999999965 1 0
0.011685999999999641 1 0
0.013967000000000063 1 0
0.021570999999999785 1 0
0.02769300000000019 1 0
EOD
$lost_solve1 << EOD
EOD
$plain1 << EOD
EOD
$own2 << EOD
0.0005649999999999267 1 1
0.0004359999999996589 1 1
0.0006250000000003197 1 1
0.0009250000000005087 1 1
0.001396000000000619 1 1
0.012628999999999557 1 1
0.016194999999999737 1 0
0.020051999999999737 1 0
0.02798799999999968 1 0
0.029936000000000185 1 0
EOD
$lost_own2 << EOD
0.0005649999999999267 1 1
0.0004359999999996589 1 1
0.0006250000000003197 1 1
0.0009250000000005087 1 1
0.001396000000000619 1 1
0.012628999999999557 1 1
EOD
$solve2 << EOD
0.02879300000000029 1 1
0.030429000000000705 1 1
0.026572000000000706 1 1
0.03274199999999983 1 0
0.02166000000000068 1 0
0.025548999999999822 1 0
0.02969099999999969 1 0
0.03654899999999994 1 0
0.05769399999999969 1 0
0.04983499999999985 1 0
EOD
$lost_solve2 << EOD
0.02879300000000029 1 1
0.030429000000000705 1 1
0.026572000000000706 1 1
EOD
$plain2 << EOD
EOD
$own3 << EOD
0.0006199999999996209 1 1
0.000834999999999475 1 1
0.0008270000000001332 1 1
0.0012729999999994135 1 1
0.0017519999999997538 1 1
0.01296499999999945 1 1
0.02015500000000081 1 0
0.025453999999999866 1 0
0.034304000000000556 1 0
0.033525000000000915 1 0
EOD
$lost_own3 << EOD
0.0006199999999996209 1 1
0.000834999999999475 1 1
0.0008270000000001332 1 1
0.0012729999999994135 1 1
0.0017519999999997538 1 1
0.01296499999999945 1 1
EOD
$solve3 << EOD
0.030387000000000164 1 1
0.031216999999999828 1 1
0.03728199999999937 1 1
0.04781100000000116 1 0
0.0438010000000002 1 0
0.03487899999999833 1 0
0.031957000000000235 1 0
0.041193999999999065 1 0
0.06832799999999928 1 0
0.06810300000000069 1 0
EOD
$lost_solve3 << EOD
0.030387000000000164 1 1
0.031216999999999828 1 1
0.03728199999999937 1 1
EOD
$plain3 << EOD
EOD
$own4 << EOD
0.00019499999999972317 1 1
0.0002770000000005268 1 1
0.00047599999999903275 1 1
0.0007369999999990995 1 1
0.0010950000000011784 1 1
0.010894999999999655 1 0
0.013279999999999959 1 0
0.01778099999999938 1 0
0.035309999999999064 1 0
0.026891000000000886 1 0
EOD
$lost_own4 << EOD
0.00019499999999972317 1 1
0.0002770000000005268 1 1
0.00047599999999903275 1 1
0.0007369999999990995 1 1
0.0010950000000011784 1 1
EOD
$solve4 << EOD
0.026881000000001265 1 1
0.027315999999999008 1 1
0.0280149999999999 1 0
0.028389000000000664 1 0
0.01868599999999887 1 0
0.02259600000000006 1 0
0.026267000000000706 1 0
0.039393000000000455 1 0
0.04264399999999924 1 0
0.06210099999999841 1 0
EOD
$lost_solve4 << EOD
0.026881000000001265 1 1
0.027315999999999008 1 1
EOD
$plain4 << EOD
EOD
$own5 << EOD
0.0003459999999986252 1 1
0.0004980000000003315 1 1
0.0007219999999996674 1 1
0.0009940000000003835 1 1
0.0014249999999993435 1 1
0.02336099999999952 1 0
0.025336000000001135 1 0
0.029770000000000962 1 0
0.05724200000000046 1 0
0.03767299999999807 1 0
EOD
$lost_own5 << EOD
0.0003459999999986252 1 1
0.0004980000000003315 1 1
0.0007219999999996674 1 1
0.0009940000000003835 1 1
0.0014249999999993435 1 1
EOD
$solve5 << EOD
0.02859400000000001 1 1
0.029979000000000866 1 1
0.04087700000000005 1 0
0.039552000000000476 1 0
0.030206999999998985 1 0
0.03542599999999929 1 0
0.03916000000000075 1 0
0.06669899999999984 1 0
0.09901399999999683 1 0
0.06807500000000033 1 0
EOD
$lost_solve5 << EOD
0.02859400000000001 1 1
0.029979000000000866 1 1
EOD
$plain5 << EOD
EOD
$own6 << EOD
0.0007349999999988199 1 0
0.0006740000000000634 1 0
0.0007349999999988199 1 0
0.0007479999999979725 1 0
0.0008300000000005525 1 0
0.0009030000000009863 1 0
0.0010380000000012046 1 0
0.0012660000000010996 1 0
0.001560000000001338 1 0
0.0019570000000008747 1 0
EOD
$lost_own6 << EOD
EOD
$solve6 << EOD
0.004068000000000183 1 0
0.004083999999998866 1 0
0.004241999999997859 1 0
0.004345999999998185 1 0
0.004152999999998741 1 0
0.004408999999998997 1 0
0.004564000000002011 1 0
0.004932999999997634 1 0
0.004981999999998266 1 0
0.005501000000002421 1 0
EOD
$lost_solve6 << EOD
EOD
$plain6 << EOD
EOD
$own7 << EOD
0.0007730000000023551 1 0
0.0007960000000011291 1 0
0.0007829999999984238 1 0
0.0008589999999983888 1 0
0.0010019999999997253 1 0
0.0013959999999997308 1 0
0.001737000000002098 1 0
0.002481000000003064 1 0
EOD
$lost_own7 << EOD
EOD
$solve7 << EOD
0.004120000000000346 1 0
0.004110000000000724 1 0
0.004156000000001825 1 0
0.00421400000000105 1 0
0.004429999999999268 1 0
0.004965000000002107 1 0
0.005199999999998539 1 0
0.0060269999999995605 1 0
EOD
$lost_solve7 << EOD
EOD
$plain7 << EOD
EOD
$own8 << EOD
0.001224000000000558 1 0
0.0012319999999981235 1 0
0.0013080000000016412 1 0
0.0025009999999987542 1 0
EOD
$lost_own8 << EOD
EOD
$solve8 << EOD
0.004767000000001076 1 0
0.004842000000000013 1 0
0.004817999999996658 1 0
0.0061019999999984975 1 0
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
set multiplot title "griewank-osborne: 1 root, 6 paths; errors not known, since no root is simple: drawn as 1" noenhanced
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
  $lost_solve2 using 1:2 with points pt 2 ps 0.9 lw 1.5 lc rgb "#d55e00" notitle, \
  $lost_solve2 using 1:2:3 with labels offset 0.9,0.5 font ",9" tc rgb "#d55e00" notitle, \
  $solve3 using 1:2 with lines lw 1.5 lc rgb "#e69f00" dt 2 notitle, \
  $solve3 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 11 lc rgb "#e69f00" notitle, \
  $lost_solve3 using 1:2 with points pt 2 ps 0.9 lw 1.5 lc rgb "#e69f00" notitle, \
  $lost_solve3 using 1:2:3 with labels offset 0.9,0.5 font ",9" tc rgb "#e69f00" notitle, \
  $solve4 using 1:2 with lines lw 1.5 lc rgb "#009e73" notitle, \
  $solve4 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 4 lc rgb "#009e73" notitle, \
  $lost_solve4 using 1:2 with points pt 2 ps 0.9 lw 1.5 lc rgb "#009e73" notitle, \
  $lost_solve4 using 1:2:3 with labels offset 0.9,0.5 font ",9" tc rgb "#009e73" notitle, \
  $solve5 using 1:2 with lines lw 1.5 lc rgb "#7fcf9f" dt 2 notitle, \
  $solve5 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 6 lc rgb "#7fcf9f" notitle, \
  $lost_solve5 using 1:2 with points pt 2 ps 0.9 lw 1.5 lc rgb "#7fcf9f" notitle, \
  $lost_solve5 using 1:2:3 with labels offset 0.9,0.5 font ",9" tc rgb "#7fcf9f" notitle, \
  $solve6 using 1:2 with lines lw 1.5 lc rgb "#000000" notitle, \
  $solve6 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 13 lc rgb "#000000" notitle, \
  $solve7 using 1:2 with lines lw 1.5 lc rgb "#cc79a7" dt 2 notitle, \
  $solve7 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 8 lc rgb "#cc79a7" notitle, \
  $solve8 using 1:2 with lines lw 1.5 lc rgb "#999999" dt 2 notitle, \
  $solve8 using 1:($3 > 0 ? NaN : $2) with points ps 0.7 pt 10 lc rgb "#999999" notitle
unset multiplot
