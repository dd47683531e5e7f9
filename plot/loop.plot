# Shows out.txt live, redrawn every second:  gnuplot plot/loop.plot
# Stop with Ctrl-C, or q in the plot window.
# Other choices: gnuplot -e "file='runs/out.txt'; redraws=1; png='now.png'" plot/loop.plot
if (!exists("file"))    file = 'out.txt'
if (!exists("redraws")) redraws = -1        # without end
if (exists("png"))      { set terminal pngcairo size 700,700 ; set output png }
if (!exists("png") && GPVAL_TERM eq "unknown") { set terminal dumb 79,40 } # no windows here: text

set size ratio -1                           # discs to scale
set key off
set xlabel 'x, m'
set ylabel 'y, m'
set style fill solid 0.6
done = 0
if (strstrt(GPVAL_COMPILE_OPTIONS, "+USE_MOUSE")) { eval 'bind all "q" "done = 1"' }

while (!done && redraws != 0) {
    # A missing or empty file: wait for it.
    undefine STATS_*
    stats file using 1 nooutput
    if (exists("STATS_records") && STATS_records > 0) {
        # The header line "# step .. time_s .. n .. side_m .." as data.
        side = 0.04
        now = 0.0
        set datafile commentschars "!"
        stats file every ::0::0 using (strcol(1) eq "#" ? (now = column(5), side = column(9)) : 0) nooutput
        set datafile commentschars
        edge = 0.03 * side                  # room for the border discs
        set xrange [-edge:side + edge]
        set yrange [-edge:side + edge]
        set object 1 rectangle from 0,0 to side,side fillstyle empty border lt -1
        set title sprintf("t = %.4f s", now)
        plot file using 1:2:3 with circles
        redraws = redraws - 1
    }
    if (redraws != 0) { pause 1 }
}
