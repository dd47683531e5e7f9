# A dense body of discs of 1e-3 m on a square lattice in an open plane. In the scene cluster-* one disc in ten flies at 25 m/s
# somewhere in a hundred widths of it; in far-* one lies 500 m away. Prints a frame (x y r vx vy).
#
# Usage: awk -v n=16000 -v scene=cluster-16k -f cluster.awk
#
# Random numbers by Park and Miller's generator (1988), exact in double precision: the same in every awk.
function uniform() {
    state = (16807 * state) % 2147483647
    return state / 2147483647
}

BEGIN {
    state = 7
    for (k = 0; k < 20; k++) uniform() # the first ones of small seeds are small
    out = scene ~ /^far/ ? 1 : int(n / 10)
    body = n - out
    columns = int(sqrt(body - 1)) + 1
    step = 2.02e-3
    width = columns * step
    print "# columns x y r vx vy"
    for (k = 0; k < body; k++)
        printf "%.9g %.9g 1e-3 %.9g %.9g\n", (k % columns) * step, int(k / columns) * step, 0.2 * (uniform() - 0.5), 0.2 * (uniform() - 0.5)
    for (k = 0; k < out; k++) {
        if (scene ~ /^far/) {
            print "500 500 1e-3 0 0"
            continue
        }
        do {
            x = (uniform() - 0.5) * 100 * width
            y = (uniform() - 0.5) * 100 * width
        } while (x > -step && x < width + step && y > -step && y < width + step)
        angle = 6.283185307 * uniform()
        printf "%.9g %.9g 1e-3 %.9g %.9g\n", x, y, 25 * cos(angle), 25 * sin(angle)
    }
}
