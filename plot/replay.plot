# Replays trajectory.txt in a window:  gnuplot plot/replay.plot
# As an animated GIF:                  gnuplot -e "gif='replay.gif'" plot/replay.plot
# One frame, the last or number K:     gnuplot -e "png='frame.png'; frame=0" plot/replay.plot
# Also: file='runs/trajectory.txt'; first, last, step: which frames (from 0); delay: 1/100 s a frame.
if (!exists("file"))  file = 'trajectory.txt'
if (!exists("delay")) delay = 5
if (!exists("gif") && !exists("png") && GPVAL_TERM eq "unknown") gif = 'replay.gif' # no windows here

there = strstrt(GPVAL_SYSNAME, "Windows") ? 'if exist "%s" echo 1' : 'test -s "%s" && echo 1'
if (system(sprintf(there, file)) eq "") {
    print sprintf("%s is missing or empty: run the simulator in this folder first", file)
    exit status 1
}
# The header lines "# step .. time_s .. n .. side_m .." as data: how many, when, how large a box.
frames = 0
times = ''
side = 0.04
set datafile commentschars "!"
stats file using (strcol(1) eq "#" ? (frames = frames + 1, times = times.' '.strcol(5), side = column(9)) : 0) nooutput
set datafile commentschars
if (!exists("first")) first = 0
if (!exists("last"))  last = frames - 1
if (!exists("step"))  step = 1
if (exists("png")) { if (!exists("frame")) { frame = last } ; first = frame ; last = frame }
if (first < 0 || first > last || last >= frames) {
    print sprintf("%s holds frames 0 to %d; %d to %d were asked for", file, frames - 1, first, last)
    exit status 1
}

if (exists("gif")) { set terminal gif animate delay delay loop 0 size 600,600 ; set output gif }
if (exists("png")) { set terminal pngcairo size 700,700 ; set output png }
set size ratio -1                           # discs to scale
set key off
set xlabel 'x, m'
set ylabel 'y, m'
set style fill solid 0.6
set object 1 rectangle from 0,0 to side,side fillstyle empty border lt -1
set xrange [-0.03 * side:1.03 * side]       # fixed: gnuplot would follow the discs
set yrange [-0.03 * side:1.03 * side]
do for [k = first:last:step] {
    set title sprintf("t = %.4f s", real(word(times, k + 1)))
    plot file index k using 1:2:3 with circles
    if (!exists("gif") && !exists("png")) { pause 0.01 * delay }
}
