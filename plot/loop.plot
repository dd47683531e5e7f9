# Shows out.txt live, redrawn some twenty times a second:  gnuplot plot/loop.plot
# To end it: q in the window, close the window, or Ctrl-C.
# One picture of now:   gnuplot -e "png='now.png'" plot/loop.plot
# A hundred numbered:   gnuplot -e "png='live%03d.png'; redraws=100" plot/loop.plot
# Also: file='runs/out.txt'; pause_s=0.2 between two pictures; patience_s=60 until it asks.
if (!exists("file"))       file = 'out.txt'
if (!exists("pause_s"))    pause_s = 0.03
if (!exists("patience_s")) patience_s = 5
if (!exists("redraws"))    redraws = exists("png") ? 1 : -1    # -1: without end
if (!exists("png") && GPVAL_TERM eq "unknown") { set terminal dumb 79,23 }  # no windows here: text
if (exists("png")) { set terminal pngcairo size 700,700 }
quiet = strstrt("wxt qt x11", GPVAL_TERM) ? " noraise" : ""  # the window takes the keyboard but once
if (strstrt("wxt qt x11 windows aqua", GPVAL_TERM)) { eval "set terminal ".GPVAL_TERM." size 700,700".quiet }

# A name in two pairs of quotes, as file='"out.txt"', is a name in one.
ends = file[1:1].file[strlen(file):strlen(file)]
if (strlen(file) > 2 && (ends eq '""' || ends eq "''")) {
    file = file[2:strlen(file) - 1]
    print "file has quotes within its quotes; taken as ".file
}
# No walls are drawn where the record of the run beside the file says that there are none.
slash = 0
do for [i=1:strlen(file)] { if (strstrt('/\', file[i:i])) { slash = i } }
open = strstrt(GPVAL_SYSNAME, "Windows") ? 'findstr /b /c:"walls = false" "%slast-run.toml" 2>nul' \
    : 'grep -s "^walls = false" "%slast-run.toml"'
set size ratio -1                           # discs to scale
set key off ; set tics nomirror
set xlabel 'x, m' ; set ylabel 'y, m'
set style fill solid 0.6
there = strstrt(GPVAL_SYSNAME, "Windows") ? 'if exist "%s" echo 1' : 'test -s "%s" && echo 1'
is_there = 0
waited = 0.0                                # s
pictures = 0
done = 0
if (strstrt(GPVAL_COMPILE_OPTIONS, "+USE_MOUSE")) { eval 'bind "Close" "done = 1"' }    # also for q

while (!done && redraws != 0) {
    if (!is_there) { is_there = system(sprintf(there, file)) ne "" }
    discs = 0
    if (is_there) {
        # The header line "# step .. time_s .. n .. side_m .." and the first discs, all as data.
        side = 0.04
        now = 0.0
        set datafile commentschars "!"
        stats file every ::0::20 using (substr(strcol(1), 1, 1) ne "#" ? (discs = discs + 1) : \
            strcol(2) eq "step" ? (now = column(5), side = column(9)) : 0, 0) nooutput
        set datafile commentschars
    }
    if (discs > 0) {
        if (pictures == 0) { has_walls = system(sprintf(open, slash > 0 ? file[1:slash] : '')) eq '' }
        # Fixed axes, with room for the border discs.
        set xrange [-0.03 * side:1.03 * side] ; set xtics 0.25 * side
        set yrange [-0.03 * side:1.03 * side] ; set ytics 0.25 * side
        if (has_walls) { set object 1 rectangle from 0,0 to side,side fillstyle empty border lt -1 }
        set title sprintf("t = %.4f s", now)
        if (exists("png")) { set output sprintf(png, pictures) }
        # Text is drawn over the text before: to the upper left corner first, as terminals have it.
        if (GPVAL_TERM eq "dumb" && redraws < 0) { set print "-" ; print "\033[H" ; set print }
        plot file using 1:2:3 with circles
        if (exists("png")) { set output }
        pictures = pictures + 1
        redraws = redraws - 1
        if (redraws != 0) { pause pause_s }
    } else {
        is_there = 0
        if (waited == 0) { print "waiting for ".file }
        if (waited < patience_s && waited + 0.2 >= patience_s) {
            print "still no ".file." in ".GPVAL_PWD
            print "it appears once a run writes there; another name: gnuplot -e \"file='runs/out.txt'\" plot/loop.plot"
        }
        waited = waited + 0.2
        pause 0.2
    }
}
