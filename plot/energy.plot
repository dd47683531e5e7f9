# Draws the energy ledger of a run:  gnuplot plot/energy.plot
# As a file:  gnuplot -e "png='energy.png'" plot/energy.plot        Also: file='runs/energy.csv'
if (!exists("file")) file = 'energy.csv'
if (!exists("png") && GPVAL_TERM eq "unknown") png = 'energy.png'   # this gnuplot has no windows

rows = 0
supplied = 0.0                              # from outside: a ninth column, drawn if there is any
top = 0.0                                   # the largest energy, which sets the unit
larger(a, b) = abs(b) > a ? abs(b) : a
set datafile separator comma columnheaders
there = strstrt(GPVAL_SYSNAME, "Windows") ? 'if exist "%s" echo 1' : 'test -s "%s" && echo 1'
if (system(sprintf(there, file)) ne "") {
    stats file using (rows = rows + 1, top = larger(larger(larger(top, $3), $4), $7), \
        supplied = larger(supplied, valid(9) ? $9 : 0), top = larger(top, supplied), \
        rows == 1 ? (start = $7, E = abs($3) + abs($4) + abs($5)) : 0) nooutput
}
if (rows < 2) { print file." is missing or has less than two rows: run the simulator first" ; exit status 1 }
if (exists("png")) { set terminal pngcairo size 900,800 ; set output png }
if (strstrt("wxt qt x11 windows aqua", GPVAL_TERM)) { eval "set terminal ".GPVAL_TERM." size 900,800" }
set key outside top center horizontal samplen 2 Left reverse
set grid linecolor rgb "gray85"
set autoscale xfix
set lmargin 11 ; set rmargin 3          # the two panels in line
set xlabel 'time, s'
set multiplot layout 2,1
# Colours of Okabe and Ito: told apart by every kind of eye.
power = top > 0 ? real(gprintf("%S", top)) : 0
scale = 10**-power
prefix = power == -6 ? "{/Symbol m}" : abs(power) > 12 ? sprintf("10^{%g} ", power) : gprintf("%c", 10**power)
set ylabel sprintf("energy, %sJ", prefix)
set offsets 0, 0, graph 0.05, 0
if (top == 0) { E = 1.0 ; set yrange [-1:1] }   # at rest, without gravity
plot file using 2:(scale * $7) with lines lw 2.5 lc rgb "black" title 'total', \
    '' using 2:(scale * $4) with lines lw 2 lc rgb "#0072B2" title 'gravitational', \
    '' using 2:(scale * $3) with lines lw 2 lc rgb "#D55E00" title 'kinetic', \
    '' using 2:(scale * $5) with lines lw 2 lc rgb "#009E73" title 'elastic', \
    '' using 2:(scale * $6) with lines lw 2 lc rgb "#CC79A7" title 'dissipated', \
    for [k=9:supplied > 0 ? 9 : 8] '' using 2:(scale * column(k)) with lines lw 2 lc rgb "#E69F00" title 'supplied'

set ylabel "error / energy at start"
set offsets
set logscale y                              # which has no zero: only the sizes of errors
set format y '10^{%T}'
set yrange [1e-18:*]
part(x) = x > 0 ? x / E : NaN
plot file using 2:(part($7 - start)) with points pt 7 ps 0.4 lc rgb "#E69F00" notitle, \
    '' using 2:(part(start - $7)) with points pt 7 ps 0.4 lc rgb "#56B4E9" notitle, \
    keyentry with points pt 7 lc rgb "#E69F00" title 'integration error: gain', \
    keyentry with points pt 7 lc rgb "#56B4E9" title 'integration error: loss', \
    '' using 2:(part(abs($8))) with lines lw 2 lc rgb "#882255" title 'work residue (round-off)', \
    2.2e-16 with lines lw 2 dt 3 lc rgb "gray50" title 'double precision'
unset multiplot
if (exists("png")) { set output ; print "wrote ".png ; exit }
eval strstrt(GPVAL_COMPILE_OPTIONS, "+USE_MOUSE") ? 'pause mouse close' : 'pause -1 "Press Enter to end"'
