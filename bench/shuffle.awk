# A frame with its discs in a random order: after a real fall numbers say nothing about places.
# Random numbers by Park and Miller's generator (1988), as in bed.awk.
function uniform() {
    state = (16807 * state) % 2147483647
    return state / 2147483647
}

/^#/ { print; next }
NF { row[n++] = $0 }

END {
    state = 20190611
    for (last = n - 1; last > 0; last--) { # Fisher and Yates
        other = int(uniform() * (last + 1))
        swap = row[last]
        row[last] = row[other]
        row[other] = swap
    }
    for (k = 0; k < n; k++) print row[k]
}
