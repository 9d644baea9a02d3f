# SPDX-License-Identifier: MIT
# Error against run time of griewank-osborne: run `gnuplot griewank-osborne.gp` in this folder.
$own0 << EOD
0.002798999999999996 1 0
0.0024580000000000157 1 0
0.0029870000000000174 1 0
0.0035290000000000044 1 0
0.004495000000000027 1 0
0.005919999999999925 1 0
0.008032999999999957 1 0
0.010356000000000032 1 0
0.017071999999999976 1 0
0.02164900000000003 1 0
EOD
$lost_own0 << EOD
EOD
$solve0 << EOD
0.006637000000000004 1 0
0.00611600000000001 1 0
0.006557000000000035 1 0
0.007217999999999947 1 0
0.008191999999999977 1 0
0.0095019999999999 1 0
0.011595000000000022 1 0
0.014029999999999987 1 0
0.02079199999999992 1 0
0.02570300000000003 1 0
EOD
$lost_solve0 << EOD
EOD
$plain0 << EOD
EOD
$own1 << EOD
0.004458000000000073 1 0
0.003554999999999975 1 0
0.003838000000000008 1 0
0.004798999999999776 1 0
0.005637000000000114 1 0
0.007589999999999986 1 0
0.009413000000000338 1 0
0.011918999999999791 1 0
0.01869299999999985 1 0
0.024958999999999953 1 0
EOD
$lost_own1 << EOD
EOD
$solve1 << EOD
0.008180999999999994 1 0
0.007231999999999683 1 0
0.007357999999999976 1 0
0.00834299999999999 1 0
0.009046999999999805 1 0
0.010946000000000122 1 0
0.012839000000000045 1 0
0.015284999999999549 1 0
0.022173000000000442 1 0
0.028699999999999726 1 0
EOD
$lost_solve1 << EOD
EOD
$plain1 << EOD
EOD
$own2 << EOD
0.0005100000000002325 1 1
0.00035600000000002296 1 1
0.0005860000000001975 1 1
0.000892000000000337 1 1
0.0013300000000002754 1 1
0.012974999999999959 1 1
0.016532000000000657 1 0
0.020535999999999888 1 0
0.027766999999999875 1 0
0.029588000000000392 1 0
EOD
$lost_own2 << EOD
0.0005100000000002325 1 1
0.00035600000000002296 1 1
0.0005860000000001975 1 1
0.000892000000000337 1 1
0.0013300000000002754 1 1
0.012974999999999959 1 1
EOD
$solve2 << EOD
0.029154000000000124 1 1
0.029653000000000596 1 1
0.026392000000000415 1 1
0.03110299999999988 1 0
0.020646999999999416 1 0
0.02431200000000011 1 0
0.0286369999999998 1 0
0.03561800000000037 1 0
0.057621000000000144 1 0
0.058582000000000356 1 0
EOD
$lost_solve2 << EOD
0.029154000000000124 1 1
0.029653000000000596 1 1
0.026392000000000415 1 1
EOD
$plain2 << EOD
EOD
$own3 << EOD
0.0005990000000002382 1 1
0.0007909999999995421 1 1
0.0008060000000007506 1 1
0.0012830000000008113 1 1
0.0017669999999991859 1 1
0.013474999999999682 1 1
0.02177799999999941 1 0
0.028411000000000186 1 0
0.03822399999999959 1 0
0.036108999999999725 1 0
EOD
$lost_own3 << EOD
0.0005990000000002382 1 1
0.0007909999999995421 1 1
0.0008060000000007506 1 1
0.0012830000000008113 1 1
0.0017669999999991859 1 1
0.013474999999999682 1 1
EOD
$solve3 << EOD
0.03031299999999959 1 1
0.03076599999999985 1 1
0.03823000000000043 1 1
0.0477950000000007 1 0
0.043049999999999145 1 0
0.037354999999999805 1 0
0.03381199999999929 1 0
0.04395599999999966 1 0
0.07265800000000056 1 0
0.07305700000000037 1 0
EOD
$lost_solve3 << EOD
0.03031299999999959 1 1
0.03076599999999985 1 1
0.03823000000000043 1 1
EOD
$plain3 << EOD
EOD
$own4 << EOD
0.0002089999999999037 1 1
0.00029299999999921056 1 1
0.0005009999999998627 1 1
0.0007809999999999206 1 1
0.0011450000000010618 1 1
0.012247999999999593 1 0
0.014855000000000729 1 0
0.019709000000000643 1 0
0.038354 1 0
0.028083999999999776 1 0
EOD
$lost_own4 << EOD
0.0002089999999999037 1 1
0.00029299999999921056 1 1
0.0005009999999998627 1 1
0.0007809999999999206 1 1
0.0011450000000010618 1 1
EOD
$solve4 << EOD
0.02876299999999965 1 1
0.029493000000000436 1 1
0.030212999999999823 1 0
0.03031200000000034 1 0
0.019843999999999085 1 0
0.023569999999999425 1 0
0.02769800000000089 1 0
0.04317100000000096 1 0
0.044786000000000215 1 0
0.06355699999999942 1 0
EOD
$lost_solve4 << EOD
0.02876299999999965 1 1
0.029493000000000436 1 1
EOD
$plain4 << EOD
EOD
$own5 << EOD
0.0003480000000006811 1 1
0.0004969999999993036 1 1
0.0007249999999991985 1 1
0.001020000000000465 1 1
0.0014979999999997773 1 1
0.024350000000000094 1 0
0.025729000000000113 1 0
0.03159899999999993 1 0
0.059467999999998966 1 0
0.03900600000000054 1 0
EOD
$lost_own5 << EOD
0.0003480000000006811 1 1
0.0004969999999993036 1 1
0.0007249999999991985 1 1
0.001020000000000465 1 1
0.0014979999999997773 1 1
EOD
$solve5 << EOD
0.029495000000000715 1 1
0.029427000000000092 1 1
0.04178500000000085 1 0
0.04145100000000035 1 0
0.0312739999999998 1 0
0.03621599999999958 1 0
0.03945600000000127 1 0
0.0725529999999992 1 0
0.10021400000000114 1 0
0.06906499999999838 1 0
EOD
$lost_solve5 << EOD
0.029495000000000715 1 1
0.029427000000000092 1 1
EOD
$plain5 << EOD
EOD
$own6 << EOD
0.0009380000000014377 1 0
0.0009000000000014552 1 0
0.0008999999999979025 1 0
0.0009340000000008786 1 0
0.0010319999999985896 1 0
0.0011259999999992942 1 0
0.0013129999999996755 1 0
0.0015339999999994802 1 0
0.001882999999999413 1 0
0.002292999999998102 1 0
EOD
$lost_own6 << EOD
EOD
$solve6 << EOD
0.004439999999998889 1 0
0.004376999999998077 1 0
0.004476999999997844 1 0
0.004363000000001449 1 0
0.004564999999999486 1 0
0.00482900000000086 1 0
0.004995999999998446 1 0
0.005178000000000793 1 0
0.005355999999999028 1 0
0.0061080000000011125 1 0
EOD
$lost_solve6 << EOD
EOD
$plain6 << EOD
EOD
$own7 << EOD
0.0010109999999983188 1 0
0.0010130000000003747 1 0
0.0010170000000009338 1 0
0.0010849999999997806 1 0
0.0012660000000010996 1 0
0.001560000000001338 1 0
0.0021100000000018326 1 0
0.002885000000002691 1 0
EOD
$lost_own7 << EOD
EOD
$solve7 << EOD
0.004665000000002806 1 0
0.004647000000002066 1 0
0.004692999999999614 1 0
0.004747000000001833 1 0
0.004972000000002197 1 0
0.005196000000001533 1 0
0.005728000000001288 1 0
0.006622000000000128 1 0
EOD
$lost_solve7 << EOD
EOD
$plain7 << EOD
EOD
$own8 << EOD
0.0015460000000011576 1 0
0.0015350000000005082 1 0
0.0015760000000000218 1 0
0.002932999999998742 1 0
EOD
$lost_own8 << EOD
EOD
$solve8 << EOD
0.005203999999999098 1 0
0.005211000000002741 1 0
0.0052410000000016055 1 0
0.006492999999998972 1 0
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
set xrange [1e-4:1e0]
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
