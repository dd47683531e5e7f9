# Draws the velocity field of the last frame of trajectory.txt:  gnuplot plot/velocity.plot
# Another frame, as a file:  gnuplot -e "frame=0; png='velocity.png'" plot/velocity.plot
# Also: file='runs/trajectory.txt'. Frames count from 0.
if (!exists("file")) file = 'trajectory.txt'
if (!exists("png") && GPVAL_TERM eq "unknown") png = 'velocity.png' # this gnuplot has no windows

frames = 0 ; times = ''
there = strstrt(GPVAL_SYSNAME, "Windows") ? 'if exist "%s" echo 1' : 'test -s "%s" && echo 1'
if (system(sprintf(there, file)) ne "") {
    # The header lines "# step .. time_s .. n .. side_m .. columns x y r vx vy" as data.
    set datafile commentschars "!"
    stats file using (strcol(1) eq "#" && strcol(15) eq "vy" ? \
        (frames = frames + 1, side = $9, times = times.' '.strcol(5)) : 0, 0) nooutput
    set datafile commentschars
}
if (frames == 0) {
    print file." is missing or holds no frame with velocities: run the simulator first"
    exit status 1
}
if (!exists("frame")) frame = frames - 1
if (frame < 0 || frame >= frames) {
    print sprintf("%s holds frames 0 to %d; frame %d was asked for", file, frames - 1, frame)
    exit status 1
}
stats file index frame using (sqrt($4**2 + $5**2)) nooutput
fastest = exists("STATS_max") ? STATS_max : 0      # m/s
arrow = fastest > 0 ? 0.05 * side / fastest : 0     # the fastest disc's is 5 % of the box

if (exists("png")) { set terminal pngcairo size 800,700 ; set output png }
if (strstrt("wxt qt x11 windows aqua", GPVAL_TERM)) { eval "set terminal ".GPVAL_TERM." size 800,700" }
set size ratio -1                                   # discs to scale
set xrange [-0.03 * side:1.03 * side] ; set xtics 0.25 * side ; set xlabel 'x, m'
set yrange [-0.03 * side:1.03 * side] ; set ytics 0.25 * side ; set ylabel 'y, m'
set tics nomirror ; set key off
set cbrange [0:fastest > 0 ? fastest : 1] ; set cblabel 'speed, m/s'
# Darker is slower, and no colour is too light for white paper.
set palette defined (0 "#0d0887", 1 "#7e03a8", 2 "#cc4778", 3 "#f89540")
# No walls are drawn where the record of the run beside the file says that there are none.
slash = 0
do for [i=1:strlen(file)] { if (strstrt('/\', file[i:i])) { slash = i } }
open = strstrt(GPVAL_SYSNAME, "Windows") ? 'findstr /b /c:"walls = false" "%slast-run.toml" 2>nul' \
    : 'grep -s "^walls = false" "%slast-run.toml"'
has_walls = system(sprintf(open, slash > 0 ? file[1:slash] : '')) eq ''
if (has_walls) { set object 1 rectangle from 0,0 to side,side fillstyle empty border lt -1 }
set title sprintf("t = %.4f s, fastest disc %.3g m/s", real(word(times, frame + 1)), fastest)
plot file index frame using 1:2:3 with circles fc rgb "gray90" fs solid border lc rgb "gray60", \
    '' index frame using 1:2:(arrow * $4):(arrow * $5):(sqrt($4**2 + $5**2)) \
    with vectors head filled size screen 0.012,18 lw 1.5 lc palette
if (exists("png")) { set output ; print "wrote ".png ; exit }
eval strstrt(GPVAL_COMPILE_OPTIONS, "+USE_MOUSE") ? 'pause mouse close' : 'pause -1 "Press Enter to end"'
