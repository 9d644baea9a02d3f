# SPDX-License-Identifier: MIT
# Error against run time of griewank-osborne: run `gnuplot griewank-osborne.gp` in this folder.
$own0 << EOD
0.0016559999999999978 1 0
0.0014929999999999943 1 0
0.0017670000000000186 1 0
0.002139000000000002 1 0
0.0026680000000000037 1 0
0.003369000000000011 1 0
0.0045520000000000005 1 0
0.005639000000000061 1 0
0.006619999999999959 1 0
0.008666000000000063 1 0
EOD
$lost_own0 << EOD
EOD
$solve0 << EOD
0.0031090000000000007 1 0
0.0029629999999999934 1 0
0.0032189999999999996 1 0
0.0036339999999999706 1 0
0.004164000000000001 1 0
0.005025000000000002 1 0
0.006071999999999966 1 0
0.007116000000000011 1 0
0.008043000000000022 1 0
0.01012499999999994 1 0
EOD
$lost_solve0 << EOD
EOD
$plain0 << EOD
EOD
$own1 << EOD
0.0022179999999998312 1 0
0.001855000000000162 1 0
0.0021369999999998335 1 0
0.0024370000000000225 1 0
0.0030050000000001464 1 0
0.003770999999999969 1 0
0.004612999999999978 1 0
0.0059989999999996435 1 0
0.007371999999999712 1 0
0.009577000000000169 1 0
EOD
$lost_own1 << EOD
EOD
$solve1 << EOD
0.003725999999999896 1 0
0.0033250000000000224 1 0
0.0035690000000001554 1 0
0.00391000000000008 1 0
0.004483000000000015 1 0
0.005211000000000077 1 0
0.006121999999999961 1 0
0.007436999999999916 1 0
0.008839000000000041 1 0
0.011047000000000029 1 0
EOD
$lost_solve1 << EOD
EOD
$plain1 << EOD
EOD
$own2 << EOD
0.00010900000000013677 1 1
0.000188000000000077 1 1
0.00030999999999981043 1 1
0.0005170000000003228 1 1
0.002091000000000065 1 1
0.0027489999999996684 1 0
0.0034810000000002894 1 0
0.004227000000000203 1 0
0.005403000000000269 1 0
0.007456000000000351 1 0
EOD
$lost_own2 << EOD
0.00010900000000013677 1 1
0.000188000000000077 1 1
0.00030999999999981043 1 1
0.0005170000000003228 1 1
0.002091000000000065 1 1
EOD
$solve2 << EOD
0.012741999999999809 1 0
0.008960000000000079 1 0
0.008751999999999871 1 0
0.00804899999999975 1 0
0.00642100000000001 1 0
0.004381000000000412 1 0
0.004901000000000266 1 0
0.005813999999999986 1 0
0.006832999999999423 1 0
0.008987999999999552 1 0
EOD
$lost_solve2 << EOD
EOD
$plain2 << EOD
EOD
$own3 << EOD
0.00015699999999974068 1 1
0.00026499999999973767 1 1
0.0004239999999997579 1 1
0.0006319999999995218 1 1
0.0036020000000007713 1 1
0.0033609999999999474 1 0
0.003959999999999297 1 0
0.0049400000000003885 1 0
0.006440999999999697 1 0
0.008160000000000167 1 0
EOD
$lost_own3 << EOD
0.00015699999999974068 1 1
0.00026499999999973767 1 1
0.0004239999999997579 1 1
0.0006319999999995218 1 1
0.0036020000000007713 1 1
EOD
$solve3 << EOD
0.013206000000000273 1 0
0.009089000000000347 1 0
0.009159000000000361 1 0
0.00991600000000048 1 0
0.006855999999999973 1 0
0.004890999999999757 1 0
0.005380999999999858 1 0
0.006409999999999805 1 0
0.007951000000000263 1 0
0.009623000000000381 1 0
EOD
$lost_solve3 << EOD
EOD
$plain3 << EOD
EOD
$own4 << EOD
0.0001129999999998077 1 1
0.00018499999999921357 1 1
0.00028600000000000847 1 1
0.0012359999999995708 1 1
0.00326300000000046 1 1
0.0025690000000002655 1 0
0.003006000000000064 1 0
0.0039319999999998245 1 0
0.004622000000000348 1 0
0.00571799999999989 1 0
EOD
$lost_own4 << EOD
0.0001129999999998077 1 1
0.00018499999999921357 1 1
0.00028600000000000847 1 1
0.0012359999999995708 1 1
0.00326300000000046 1 1
EOD
$solve4 << EOD
0.0162760000000004 1 0
0.008951999999999849 1 0
0.008650000000000269 1 0
0.0066379999999997 1 0
0.007279999999999731 1 0
0.0040119999999994604 1 0
0.0045440000000001035 1 0
0.005374999999999908 1 0
0.006135999999999697 1 0
0.0072309999999999874 1 0
EOD
$lost_solve4 << EOD
EOD
$plain4 << EOD
EOD
$own5 << EOD
0.0001509999999997902 1 1
0.0003260000000002705 1 1
0.0003809999999999647 1 1
0.0005510000000015225 1 1
0.0045869999999990085 1 1
0.003750000000000142 1 0
0.004089000000000453 1 0
0.004888000000001114 1 0
0.005406000000000688 1 0
0.006337999999999511 1 0
EOD
$lost_own5 << EOD
0.0001509999999997902 1 1
0.0003260000000002705 1 1
0.0003809999999999647 1 1
0.0005510000000015225 1 1
0.0045869999999990085 1 1
EOD
$solve5 << EOD
0.013262000000000107 1 0
0.01017999999999919 1 0
0.009000000000000341 1 0
0.00725399999999965 1 0
0.00822300000000098 1 0
0.005258999999998792 1 0
0.0055320000000005365 1 0
0.006394999999999484 1 0
0.006954000000000349 1 0
0.007780999999999594 1 0
EOD
$lost_solve5 << EOD
EOD
$plain5 << EOD
EOD
$own6 << EOD
0.0007870000000007593 1 0
0.0007819999999991722 1 0
0.0007750000000008583 1 0
0.000793000000001598 1 0
0.0008979999999993993 1 0
0.000984000000000762 1 0
0.0011460000000003134 1 0
0.0014059999999993522 1 0
0.0017400000000016291 1 0
0.002217999999999165 1 0
EOD
$lost_own6 << EOD
EOD
$solve6 << EOD
0.002803000000000111 1 0
0.0027849999999993713 1 0
0.0027860000000003993 1 0
0.0028170000000002915 1 0
0.0029199999999995896 1 0
0.0032370000000003785 1 0
0.0037970000000004944 1 0
0.004699000000000453 1 0
0.0059389999999996945 1 0
0.007799999999999585 1 0
EOD
$lost_solve6 << EOD
EOD
$plain6 << EOD
EOD
$own7 << EOD
0.0008239999999997139 1 0
0.0008189999999999031 1 0
0.0008270000000010214 1 0
0.0008969999999983713 1 0
0.001078999999998942 1 0
0.00141600000000075 1 0
0.0019969999999993604 1 0
0.003057999999999339 1 0
EOD
$lost_own7 << EOD
EOD
$solve7 << EOD
0.003213999999999828 1 0
0.003179000000001153 1 0
0.0032220000000009463 1 0
0.00325400000000009 1 0
0.0034589999999994347 1 0
0.004480000000000928 1 0
0.00646899999999917 1 0
0.009783999999999793 1 0
EOD
$lost_solve7 << EOD
EOD
$plain7 << EOD
EOD
$own8 << EOD
0.001250999999999891 1 0
0.0012389999999999901 1 0
0.0012410000000002697 1 0
0.0026330000000012177 1 0
EOD
$lost_own8 << EOD
EOD
$solve8 << EOD
0.010744000000000753 1 0
0.010816000000000159 1 0
0.011191999999999425 1 0
0.012639999999999318 1 0
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
