# Figures 1, 2, 3 and 25 of Blatny, Gray & Gaume (2024) from the series in `runs`: see make_figures.
set terminal svg size 860,560 font 'sans,15' enhanced background rgb 'white'
set datafile separator comma
set tics out nomirror
set border 3 lc rgb '#555555'
set grid lc rgb '#dddddd' lt 1 lw 0.7
blue = '#0072b2'; red = '#d55e00'; green = '#009e73'; pink = '#cc79a7'; amber = '#e69f00'
array colour[5] = [blue, red, green, pink, amber]
series(study, k) = sprintf('%s/%s/cases/case_%03d/series.csv', runs, study, k)
# columns by name; a header reads `name [unit]`
last(file, name) = system(sprintf("awk -F, 'NR==1{for(i=1;i<=NF;i++)if($i~/^%s \\[/)c=i} END{printf(\"%%.15f\",$c)}' %s", name, file)) + 0
M = 0.381863; mu_2 = 0.643468; I_0 = 0.279
ellipse(p, p_c, beta) = M*sqrt((p_c - p)*(p + beta*p_c))
set samples 601

# 1: yield ellipses, critical-state lines, and where straining ends
set output 'docs/theory/figure_1.svg'
set xlabel 'pressure p (Pa)'; set ylabel 'shear stress q (Pa)'
set xrange [-35:115]; set yrange [0:38]; set key inside top right width -2
array beta[2] = [0.0, 0.3]
$ends << EOD
EOD
set print $ends append
do for [b=0:1] { do for [k=0:10] {
  f = series('yield_ellipse', 11*b + k)
  print sprintf('%d,%.12g,%.12g', b, last(f, 'pressure'), last(f, 'shear_stress'))
} }
unset print
plot for [b=1:2] (x >= -beta[b]*100 && x <= 100 ? ellipse(x, 100, beta[b]) : 1/0) lw 2 lc rgb colour[b] title sprintf('yield ellipse, {/Symbol b} = %.1f', beta[b]), \
     for [b=1:2] (x > 0 ? M*(1 + beta[b])/(1 - beta[b])*x : 1/0) lw 1.5 dt 2 lc rgb colour[b] title (b == 1 ? 'critical states' : ''), \
     for [b=0:1] $ends using ($1 == b ? $2 : 1/0):3 with points pt 7 ps 0.9 lc rgb colour[b+1] title (b == 0 ? 'ends of strain paths' : '')

# 2: friction in steady shear
set output 'docs/theory/figure_2.svg'
set xlabel 'inertial number I'; set ylabel 'q/p'; set xrange [0:2.6]; set yrange [0.3:1.25]; set key inside bottom right
array cohesion[4] = [0.0, 0.1, 0.2, 0.3]
omega(b) = (1 + b)/(1 - b)
mu(I, b) = omega(b)*(M + (mu_2 - M)/(sqrt(omega(b))*I_0/I + 1))
$ends << EOD
EOD
set print $ends append
do for [b=0:3] { do for [k=0:10] {
  f = series('mu_i_of_cohesion', 11*b + k)
  p = last(f, 'pressure')
  print sprintf('%d,%.12g,%.12g', b, 0.0025*last(f, 'shear_rate')*sqrt(2500/p), last(f, 'stress_ratio'))
} }
unset print
plot for [b=1:4] (x > 0 ? mu(x, cohesion[b]) : 1/0) lw 2 lc rgb colour[b] title sprintf('{/Symbol b} = %.1f, {/Symbol w} = %.2f', cohesion[b], omega(cohesion[b])), \
     for [b=0:3] $ends using ($1 == b ? $2 : 1/0):3 with points pt 7 ps 0.7 lc rgb colour[b+1] title (b == 0 ? 'material point' : '')

# 3: one step of the two-stage map
set output 'docs/theory/figure_3.svg'
set xlabel 'pressure p (Pa)'; set ylabel 'shear stress q (Pa)'; set xrange [0:1500]; set yrange [0:760]; set key inside top left
first = series('return_map', 0); slow = series('return_map', 5); middle = series('return_map', 2)
p1 = last(slow, 'pressure'); q_y = last(slow, 'shear_stress'); p_c1 = last(slow, 'compressive_strength')
q1 = last(middle, 'shear_stress')
set arrow 1 from 1400,700 to p1,q_y lc rgb '#777777' lw 1.5 dt 2 filled
set arrow 2 from p1,q_y to p1,q1 lc rgb red lw 2 filled
plot (x <= 1000 ? ellipse(x, 1000, 0) : 1/0) lw 2 lc rgb '#999999' title 'surface before the step', \
     (x <= p_c1 ? ellipse(x, p_c1, 0) : 1/0) lw 2 lc rgb blue title 'surface after the step', \
     '+' using (1400):(700) every ::0::0 with points pt 6 ps 1.4 lc rgb 'black' title 'trial stress', \
     '+' using (p1):(q_y) every ::0::0 with points pt 7 ps 1.1 lc rgb blue title 'stage 1: without viscosity', \
     '+' using (p1):(q1) every ::0::0 with points pt 7 ps 1.1 lc rgb red title sprintf('stage 2: dt = %.0e s', last(middle, 'time'))
unset arrow

# 25: direct shear
set output 'docs/theory/figure_25.svg'
set xlabel 'shear strain'; set ylabel 'volume strain'; set xrange [0:0.42]; set yrange [-0.016:0.016]; set key inside center right
array strength[5] = [0.5, 1, 2, 4, 8]
plot for [k=0:4] series('direct_shear', k) skip 1 every 25 using 5:14 with lines lw 2 lc rgb colour[k+1] title sprintf('p_c^0 = %g {/Symbol s}_n', strength[k+1]), \
     for [k=0:4] log(strength[k+1]/2)/100 lw 1 dt 3 lc rgb colour[k+1] title (k==0 ? 'ln(p_c^0/2{/Symbol s}_n)/{/Symbol x}' : '')
