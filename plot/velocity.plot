# Draws the velocity field of a frame of trajectory.txt:  gnuplot plot/velocity.plot
# As a picture:  gnuplot -e "png='velocity.png'" plot/velocity.plot
# Also: frame=K (from 0; the last if not said), file='runs/trajectory.txt'
if (!exists("file")) file = 'trajectory.txt'
if (!exists("png") && GPVAL_TERM eq "unknown") png = 'velocity.png'   # no windows here
there = strstrt(GPVAL_SYSNAME, "Windows") ? 'if exist "%s" echo 1' : 'test -s "%s" && echo 1'
if (system(sprintf(there, file)) eq "") {
    print sprintf("%s is missing or empty: run the simulator in this folder first", file)
    exit status 1
}
# The header lines "# step .. time_s .. n .. side_m .." as data.
frames = 0
times = ''
side = 0.04
set datafile commentschars "!"
stats file using (strcol(1) eq "#" ? (frames = frames + 1, times = times.' '.strcol(5), side = column(9)) : 0) nooutput
set datafile commentschars
if (!exists("frame")) frame = frames - 1
if (frame < 0 || frame >= frames) {
    print sprintf("%s holds frames 0 to %d; %d was asked for", file, frames - 1, frame)
    exit status 1
}
if (exists("png")) { set terminal pngcairo size 800,700 ; set output png }

speed(vx, vy) = sqrt(vx * vx + vy * vy)
stats file index frame using (speed(column(4), column(5))) nooutput
fastest = STATS_max
arrow = fastest > 0 ? 0.06 * side / fastest : 0     # the fastest disc's arrow: 6 % of the box

set size ratio -1                                   # discs to scale
set key off
set xrange [-0.03 * side:1.03 * side]
set yrange [-0.03 * side:1.03 * side]
set xlabel 'x, m'
set ylabel 'y, m'
set object 1 rectangle from 0,0 to side,side fillstyle empty border lt -1
set title sprintf("t = %.4f s, fastest disc %.3g m/s", real(word(times, frame + 1)), fastest)
set palette defined (0 "#56B4E9", 1 "#0072B2", 2 "#7B3294", 3 "#D55E00")
set cbrange [0:fastest > 0 ? fastest : 1]
set cblabel 'speed, m/s'
plot file index frame using 1:2:3 with circles fillstyle solid 0.35 lc rgb "#BBBBBB", \
     '' index frame using 1:2:(arrow * column(4)):(arrow * column(5)):(speed(column(4), column(5))) \
        with vectors head filled size screen 0.008,20 lw 1.5 lc palette
if (!exists("png")) { pause -1 "Return ends" }
