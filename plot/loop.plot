# Shows out.txt live, redrawn every second:  gnuplot plot/loop.plot
# To end it: q in the window, close the window, or Ctrl-C.
# One picture of now:  gnuplot -e "png='now.png'" plot/loop.plot
# Also: file='runs/out.txt'; redraws=10
if (!exists("file"))    file = 'out.txt'
if (!exists("redraws")) redraws = exists("png") ? 1 : -1    # -1: without end
if (!exists("png") && GPVAL_TERM eq "unknown") { set terminal dumb 79,40 }  # no windows here: text
if (exists("png")) { set terminal pngcairo size 700,700 }
if (strstrt("wxt qt x11 windows aqua", GPVAL_TERM)) { eval "set terminal ".GPVAL_TERM." size 700,700" }

set size ratio -1                           # discs to scale
set key off ; set tics nomirror
set xlabel 'x, m' ; set ylabel 'y, m'
set style fill solid 0.6
there = strstrt(GPVAL_SYSNAME, "Windows") ? 'if exist "%s" echo 1' : 'test -s "%s" && echo 1'
told = 0
done = 0
if (strstrt(GPVAL_COMPILE_OPTIONS, "+USE_MOUSE")) { eval 'bind "Close" "done = 1"' }    # also for q

while (!done && redraws != 0) {
    undefine STATS_*
    if (system(sprintf(there, file)) ne "") { stats file using 1 nooutput }
    if (exists("STATS_records") && STATS_records > 0) {
        # The header line "# step .. time_s .. n .. side_m .." as data.
        side = 0.04
        now = 0.0
        set datafile commentschars "!"
        stats file every ::0::0 using (strcol(1) eq "#" ? (now = column(5), side = column(9)) : 0) nooutput
        set datafile commentschars
        # Fixed axes, with room for the border discs.
        set xrange [-0.03 * side:1.03 * side] ; set xtics 0.25 * side
        set yrange [-0.03 * side:1.03 * side] ; set ytics 0.25 * side
        set object 1 rectangle from 0,0 to side,side fillstyle empty border lt -1
        set title sprintf("t = %.4f s", now)
        if (exists("png")) { set output png }
        plot file using 1:2:3 with circles
        if (exists("png")) { set output }
        redraws = redraws - 1
    } else { if (!told) { told = 1 ; print "waiting for ".file } }
    if (redraws != 0) { pause 1 }
}
