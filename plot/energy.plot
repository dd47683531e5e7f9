# Draws the energy ledger of a run:  gnuplot plot/energy.plot
# As a picture:  gnuplot -e "png='energy.png'" plot/energy.plot     Also: file='runs/energy.csv'
if (!exists("file")) file = 'energy.csv'
if (!exists("png") && GPVAL_TERM eq "unknown") png = 'energy.png'   # no windows here
there = strstrt(GPVAL_SYSNAME, "Windows") ? 'if exist "%s" echo 1' : 'test -s "%s" && echo 1'
if (system(sprintf(there, file)) eq "") {
    print sprintf("%s is missing or empty: run the simulator in this folder first", file)
    exit status 1
}
if (exists("png")) { set terminal pngcairo size 900,800 ; set output png }

set datafile separator comma
stats file skip 1 using 1 nooutput                   # counts the rows
if (STATS_records < 2) { print sprintf("%s has fewer than two lines yet", file) ; exit status 1 }
stats file skip 1 every ::0::0 using (start = column(7)) nooutput
# Errors in parts of the largest energy the run had to turn over.
stats file skip 1 using (column(3) + column(4) + column(5)) nooutput
scale = STATS_max > 0 ? STATS_max : 1.0

stats file skip 1 using (abs(column(8)) / scale) nooutput
residue = STATS_max

# Okabe and Ito's colours: told apart by colour-blind eyes too.
set linetype 1 lc rgb "#D55E00" lw 2
set linetype 2 lc rgb "#0072B2" lw 2
set linetype 3 lc rgb "#009E73" lw 2
set linetype 4 lc rgb "#E69F00" lw 2
set linetype 5 lc rgb "#000000" lw 2

set multiplot layout 2,1
set lmargin 14
set key outside right top vertical Left reverse
set rmargin 26
set autoscale xfix
set grid
set ylabel 'energy, J'
set format y "%.1e"
set title 'Where the energy is'
plot file skip 1 using 2:3 with lines lt 1 title 'kinetic', \
     '' skip 1 using 2:4 with lines lt 2 title 'gravitational', \
     '' skip 1 using 2:5 with lines lt 3 title 'elastic', \
     '' skip 1 using 2:6 with lines lt 4 title 'dissipated', \
     '' skip 1 using 2:7 with lines lt 5 title 'total'
set xlabel 'time, s'
set ylabel 'part of the mechanical energy'
set title 'Two residues: is the time step right, is the bookkeeping right?'
plot file skip 1 using 2:((column(7) - start) / scale) with lines lt 5 title 'integration error', \
     '' skip 1 using 2:(column(8) / scale) with lines lt 1 \
     title sprintf("work residue, %.0e", residue)
unset multiplot
if (!exists("png")) { pause -1 "Return ends" }
