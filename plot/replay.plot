# Replays trajectory.txt in a window:  gnuplot plot/replay.plot
# As an animated GIF:                  gnuplot -e "gif='replay.gif'" plot/replay.plot
# The last frame, or frame K:          gnuplot -e "png='frame.png'; frame=0" plot/replay.plot
# Also: file='runs/trajectory.txt'; first, last, step: which frames, from 0; delay: 1/100 s a frame.
if (!exists("file"))  file = 'trajectory.txt'
if (!exists("delay")) delay = 5
if (!exists("gif") && !exists("png") && GPVAL_TERM eq "unknown") gif = 'replay.gif' # no windows

frames = 0 ; times = ''
there = strstrt(GPVAL_SYSNAME, "Windows") ? 'if exist "%s" echo 1' : 'test -s "%s" && echo 1'
if (system(sprintf(there, file)) ne "") {
    # The header lines "# step .. time_s .. n .. side_m .." as data.
    set datafile commentschars "!"
    stats file using (strcol(1) eq "#" ? \
        (frames = frames + 1, side = $9, times = times.' '.strcol(5)) : 0, 0) nooutput
    set datafile commentschars
}
if (frames == 0) { print file." is missing or holds no frame: run the simulator first" ; exit status 1 }
if (!exists("first")) first = 0
if (!exists("last"))  last = frames - 1
if (!exists("step"))  step = 1
if (exists("png")) { first = exists("frame") ? frame : last ; last = first }
if (first < 0 || first > last || last >= frames) {
    print sprintf("%s holds frames 0 to %d; %d to %d were asked for", file, frames - 1, first, last)
    exit status 1
}
if (exists("png")) { set terminal pngcairo size 700,700 ; set output png }
if (exists("gif")) { set terminal gif animate delay delay loop 0 size 700,700 ; set output gif }
if (strstrt("wxt qt x11 windows aqua", GPVAL_TERM)) { eval "set terminal ".GPVAL_TERM." size 700,700" }
# In a GIF centres sit on whole pixels: elsewhere equal small discs would come out unequal.
if (exists("gif")) { set margins at screen 0.14, at screen 0.96, at screen 0.12, at screen 0.94 }
pixel = 1.06 * side / 573                    # the axes are so many pixels long
snap(v) = exists("gif") ? pixel * floor(v / pixel + 0.5) : v

set size ratio -1                           # discs to scale
set xrange [-0.03 * side:1.03 * side] ; set xtics 0.25 * side ; set xlabel 'x, m'
set yrange [-0.03 * side:1.03 * side] ; set ytics 0.25 * side ; set ylabel 'y, m'
set tics nomirror ; set key off
set style fill solid 0.6
# No walls are drawn where the record of the run beside the file says that there are none.
slash = 0
do for [i=1:strlen(file)] { if (strstrt('/\', file[i:i])) { slash = i } }
open = strstrt(GPVAL_SYSNAME, "Windows") ? 'findstr /b /c:"walls = false" "%slast-run.toml" 2>nul' \
    : 'grep -s "^walls = false" "%slast-run.toml"'
has_walls = system(sprintf(open, slash > 0 ? file[1:slash] : '')) eq ''
if (has_walls) { set object 1 rectangle from 0,0 to side,side fillstyle empty border lt -1 }
mouse = strstrt(GPVAL_COMPILE_OPTIONS, "+USE_MOUSE")
done = 0
if (mouse) { eval 'bind "Close" "done = 1"' }           # q or the window closed
do for [k = first:last:step] {
    set title sprintf("t = %.4f s", real(word(times, k + 1)))
    plot file index k using (snap($1)):(snap($2)):3 with circles
    if (!exists("png") && !exists("gif")) { pause 0.01 * delay }
    if (done) { exit }
}
if (exists("png")) { set output ; print "wrote ".png ; exit }
if (exists("gif")) { set output ; print "wrote ".gif ; exit }
eval mouse ? 'pause mouse close' : 'pause -1 "Press Enter to end"'
