# The picture at the head of the README: three moments of examples/settling.toml.
#   cargo run -- examples/settling.toml --seed 1 --out-dir /tmp/settling
#   gnuplot -e "file='/tmp/settling/trajectory.txt'" docs/settling.plot
if (!exists("file")) file = 'trajectory.txt'
set terminal pngcairo size 1200,430
set output 'docs/settling.png'
side = 0.04
set size ratio -1
set key off
unset tics
unset border
set style fill solid 0.9 noborder
set palette defined (0 "#56B4E9", 1 "#0072B2", 2 "#7B3294", 3 "#D55E00")
set cbrange [0:0.5]
set cblabel 'speed, m/s'
set object 1 rectangle from 0,0 to side,side fillstyle empty border lc rgb "#444444" lw 2
set xrange [-0.0005:side + 0.0005]
set yrange [-0.0005:side + 0.0005]
set multiplot layout 1,3 margins 0.01,0.91,0.02,0.90 spacing 0.02
do for [shot = 1:3] {
    frame = int(word("0 16 200", shot))
    set title "t = ".word("0 0.048 0.6", shot)." s"
    if (shot < 3) { unset colorbox } else { set colorbox user origin 0.925,0.1 size 0.015,0.75 ; set cbtics }
    plot file index frame using 1:2:3:(sqrt($4**2 + $5**2)) with circles lc palette
}
unset multiplot
