#!/bin/sh
# What threads bring: speed, speedup S_p = T_1 / T_p and efficiency E_p = S_p / p (Foster 1995, Designing
# and Building Parallel Programs, 3.3) over threads and numbers of discs, ledger on. Medians of five,
# thread counts in turn; a ratio is one of neighbouring runs. Writes bench/<machine>/<date>-scaling.csv.
#
# Usage: sh bench/scaling.sh ./parSim2D [scene ...]
set -eu
program=$(realpath "$1")
shift
here=$(cd "$(dirname "$0")" && pwd)
. "$here/scenes.sh"
scenes=${*:-guide-20 dense-1000 bed-20k bed-100k gas-100k bed-1m}
if [ -z "$(threads_flag 1)" ]; then
    echo "scaling: $program has no --threads" >&2
    exit 2
fi
counts=1
t=2
while [ "$t" -le "$cores" ]; do counts="$counts $t" t=$((2 * t)); done
results=$work/scaling
rm -f "$results"
for scene in $scenes; do make_state "$scene"; done

run=0
while [ "$run" -lt "$runs" ]; do
    for scene in $scenes; do
        for t in $counts; do
            # shellcheck disable=SC2086 # a flag is two words
            timed "$scene" --threads "$t" $rows >"$work/summary"
            echo "$scene $t $run $(field particle_steps_per_s <"$work/summary") $(field state_hash <"$work/summary")" >>"$results"
        done
    done
    run=$((run + 1))
done

mkdir -p "$here/$(machine)"
result=$here/$(machine)/$(date +%Y-%m-%d)-scaling.csv
[ "$scale" = 1 ] || result=$work/scaling.csv
echo "scene,n,threads,particle_steps_per_s,speedup,lowest_speedup,highest_speedup,efficiency,same_bits" >"$result"
for scene in $scenes; do
    for t in $counts; do
        speed=$(awk -v s="$scene" -v t="$t" '$1 == s && $2 == t { print $4 }' "$results" | median)
        awk -v s="$scene" -v t="$t" '
            $1 == s && $2 == 1 { alone[$3] = $4 }
            $1 == s && $2 == t { print $4 / alone[$3] }' "$results" | sort -g >"$work/ratios"
        states=$(awk -v s="$scene" '$1 == s && !seen[$5]++' "$results" | wc -l)
        speedup=$(median <"$work/ratios")
        printf '%s,%s,%s,%.3g,%.2f,%.2f,%.2f,%.2f,%s\n' "$scene" "$(discs_of "$scene")" "$t" "$speed" "$speedup" \
            "$(head -n 1 "$work/ratios")" "$(tail -n 1 "$work/ratios")" "$(calculate "$speedup / $t")" \
            "$([ "$states" -eq 1 ] && echo yes || echo no)" >>"$result"
    done
done
echo "$result"
cat "$result"
