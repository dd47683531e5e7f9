#!/bin/sh
# What comes on top of the stepping: the ledger, live frames, the trajectory, the progress bar. Each is
# switched on alone, and steps a second of wall time are compared with those of the run beside it that has
# none. Each run is stopped (as by Ctrl-C) after some seconds. Medians of five. Writes
# bench/<machine>/<date>-costs.csv.
#
# Usage: sh bench/costs.sh ./parSim2D
set -eu
program=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
. "$here/scenes.sh"
folder=$work/costs
rm -rf "$folder"
mkdir -p "$folder"
[ "$scale" = 1 ] && seconds=4 || seconds=0.3

# rate HOW SCENE FLAGS: steps a second of wall time; HOW is `plain`, or `terminal` where there is a progress bar.
rate() {
    how=$1 scene=$2
    shift 2
    command="timeout -s INT $seconds $program $(flags_of "$scene") --time 1000 --json --out-dir $folder/run $*"
    if [ "$how" = terminal ]; then
        script -qec "$command" "$folder/typescript" </dev/null >"$folder/summary" 2>/dev/null || true
    else
        $command >"$folder/summary" 2>/dev/null || true # an interrupted run ends with 130
    fi
    echo "$(field steps <"$folder/summary") $(field wall_s <"$folder/summary")" | awk '{ print $1 / $2 }'
}

# cost NAME SCENE WITHOUT WITH: by how many per cent the time of a step grows. WITHOUT and WITH are what `rate`
# takes, but the scene; they take turns in going first.
cost() {
    make_state "$2"
    run=0
    while [ "$run" -lt "$runs" ]; do
        # shellcheck disable=SC2086 # flags are words
        if [ $((run % 2)) = 0 ]; then
            a=$(rate ${3%% *} "$2" ${3#* }) b=$(rate ${4%% *} "$2" ${4#* })
        else
            b=$(rate ${4%% *} "$2" ${4#* }) a=$(rate ${3%% *} "$2" ${3#* })
        fi
        echo "$a $b" >>"$folder/$1-$2"
        run=$((run + 1))
    done
    awk '{ print 100 * ($1 / $2 - 1) }' "$folder/$1-$2" | sort -g >"$folder/percents"
    printf '%s,%s,%s,%.4g,%.1f,%.1f,%.1f\n' "$1" "$2" "$(discs_of "$2")" "$(awk '{ print $1 }' "$folder/$1-$2" | median)" \
        "$(median <"$folder/percents")" "$(head -n 1 "$folder/percents")" "$(tail -n 1 "$folder/percents")" | tee -a "$result"
}

mkdir -p "$here/$(machine)"
result=$here/$(machine)/$(date +%Y-%m-%d)-costs.csv
[ "$scale" = 1 ] || result=$work/costs.csv
echo "what,scene,n,steps_per_s_without,cost_percent,lowest,highest" | tee "$result"
none="plain -q --every 1000000000 --energy-every 0"
for scene in dense-1000 bed-20k bed-100k; do
    cost ledger $scene "$none" "plain -q --every 1000000000 $rows"
done
cost live-frames bed-20k "$none" "plain -q --energy-every 0" # out.txt, at most 60 times a second
cost trajectory bed-100k "$none" "plain -q --energy-every 0 --every 563" # as in a run of a second
if command -v script >/dev/null; then
    cost progress-bar dense-1000 "terminal -q --every 1000000000 --energy-every 0" "terminal --every 1000000000 --energy-every 0"
fi
