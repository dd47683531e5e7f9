# A bed of n equal discs that is nearly at rest, as wide as high: staggered rows, pressed together by the
# weight above them and by the walls, some sites empty. Prints a frame (x y r), row by row;
# `parsim2d --start` then lets it settle.
#
# Usage: awk -v n=20000 -v radius=5e-4 -v mass=1e-3 -v kn=5e4 -v gravity=9.81 -v seed=1 -f bed.awk
#
# Random numbers by Park and Miller's generator (1988), exact in double precision: the same in every awk.
function uniform() {
    state = (16807 * state) % 2147483647
    return state / 2147483647
}

BEGIN {
    state = 1 + seed % 2147483646
    for (k = 0; k < 20; k++) uniform() # the first ones of small seeds are small
    empty = 0.005
    sites = int(n / (1 - empty)) + 1
    columns = int(sqrt(0.9 * sites)) + 1
    rows = int((sites + columns - 1) / columns)

    # Equilibrium of a column of rows: two contacts, 30 degrees off the vertical, carry what is above.
    # Along a row discs overlap as they do on the average: a row without load would buckle.
    weight = mass * gravity * (1 - empty)
    d = 2 * radius - 0.5 * rows * weight / (sqrt(3) * kn)
    side = (columns - 0.5) * d + 2 * radius
    y[0] = radius - rows * weight / kn
    for (row = 1; row < rows; row++) {
        gap = 2 * radius - (rows - row) * weight / (sqrt(3) * kn)
        y[row] = y[row - 1] + sqrt(gap * gap - 0.25 * d * d)
    }

    printf "# step 0 time_s 0 n %d side_m %.9g columns x y r\n", n, side
    free = rows * columns
    left = n
    for (row = 0; row < rows; row++)
        for (column = 0; column < columns; column++)
            if (uniform() * free-- < left) {
                left--
                x = radius + (0.5 * (row % 2) + column) * d
                printf "%.9g %.9g %.9g\n", x, y[row], radius
            }
}
