# What was aimed at beside what was measured: reads the csv files of one day and machine.
#
# Usage: awk -F, -f bench/targets.awk bench/<machine>/<date>*.csv
function say(what, wanted, measured, met) {
    printf "%-58s %-12s %-10s %s\n", what, wanted, measured, met ? "met" : "missed"
}
function at_least(what, wanted, measured) { say(what, ">= " wanted, sprintf("%.3g", measured), measured >= wanted) }
function at_most(what, wanted, measured) { say(what, "<= " wanted, sprintf("%.3g", measured), measured <= wanted) }

FNR == 1 {
    delete column
    for (k = 1; k <= NF; k++) column[$k] = k
    kind = ("ratio" in column) ? "peers" : ("efficiency" in column) ? "scaling" : ("cost_percent" in column) ? "costs" : "bench"
    next
}
kind == "bench" && $4 == 1 {
    if ($1 == "guide-20") at_least("n = 20: million steps a second", 1, $5 / 20 / 1e6)
    if ($1 == "bed-20k") small = $6
    if ($1 == "bed-1m") {
        if (small) at_most("ns a particle-step, bed of 1,000,000 over 20,000", 1.5, $6 / small)
        if ($7) at_most("bytes a disc at 1,000,000, with ledger", 230, $7 * 1e6 / $2)
    }
    if ($1 == "bed-1m-no-ledger") at_most("ns a particle-step, bed of 1,000,000, no ledger", 14, $6)
}
kind == "peers" {
    is_off = $4 == "off"
    if ($1 ~ /^gas/) wanted = is_off ? 4.5 : 3.5
    else if ($1 ~ /^polydisperse/) wanted = is_off ? 7 : 5.5
    else if ($3 == 1) wanted = is_off ? 10 : 7.5
    else if ($1 ~ /-1000$/) wanted = is_off ? 7 : 6
    else wanted = is_off ? 9 : 7
    at_least($1 " over LAMMPS, cores " $3 ", ledger " $4, wanted, $7)
}
kind == "scaling" && $3 == 2 && $2 >= 20000 { at_least("speedup of two threads, " $1, 1.8, $5) }
kind == "costs" && $1 == "live-frames" { at_most("per cent for live frames, " $2, 5, $5) }
kind == "costs" && $1 == "progress-bar" { at_most("per cent for the progress bar, " $2, 1, $5) }
