# One disc of 5e-3 m amid discs of 1e-5 m on a square lattice around it, in a box. Prints a frame (x y r vx vy).
#
# Usage: awk -v n=100000 -f giant.awk
BEGIN {
    radius = 5e-3
    step = 4e-5
    columns = int(sqrt(n + 3.1416 * (radius / step) ^ 2)) + 3
    side = columns * step
    if (side < 2.2 * radius) { # few small discs: they lie around it all the same
        side = 2.2 * radius
        columns = int(side / step)
    }
    printf "# side_m %.9g columns x y r vx vy\n", side
    printf "%.9g %.9g %.9g 0 0\n", side / 2, side / 2, radius
    left = n - 1
    for (k = 0; left > 0 && k < columns * columns; k++) {
        x = (k % columns + 0.5) * step
        y = (int(k / columns) + 0.5) * step
        if ((x - side / 2) ^ 2 + (y - side / 2) ^ 2 < (radius + 2e-5) ^ 2) continue
        left--
        printf "%.9g %.9g 1e-5 %.9g %.9g\n", x, y, 0.1 * cos(k), 0.1 * sin(k)
    }
}
