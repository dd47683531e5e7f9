#!/bin/sh
# How fast does this machine step, and in how much memory? Runs each scene five times, scenes in turn so
# that a noisy machine is noisy for all, and writes the medians to bench/<machine>/<date>.csv.
#
# Usage: sh bench/run.sh ./parSim2D [scene ...]
#
# PARSIM2D_BENCH_RUNS, _SCALE and _WORK: see scenes.sh.
set -eu
program=$(realpath "$1")
shift
here=$(cd "$(dirname "$0")" && pwd)
. "$here/scenes.sh"
known="guide-20 guide-20-no-ledger guide-1000 dense-1000 bed-20k bed-20k-no-ledger polydisperse-20k bed-100k gas-100k cluster-16k far-20k giant-100k bed-1m bed-1m-no-ledger"
scenes=${*:-$known}
for scene in $scenes; do
    case " $known " in
    *" ${scene%-no-ledger} "*) ;;
    *)
        echo "error: there is no scene $scene" >&2
        echo "  way out: one or more of $known" >&2
        exit 2
        ;;
    esac
done
results=$work/results
rm -f "$results"

threads=1
if [ "$cores" -ge 2 ] && [ -n "$(threads_flag 2)" ]; then threads="1 2"; fi
for scene in $scenes; do make_state "${scene%-no-ledger}"; done

run=0
while [ "$run" -lt "$runs" ]; do
    for scene in $scenes; do
        [ "$scene" = "${scene%-no-ledger}" ] && ledger=$rows || ledger=$no_rows
        for t in $threads; do
            # shellcheck disable=SC2046,SC2086 # flags are words
            timed "${scene%-no-ledger}" $(threads_flag "$t") $ledger >"$work/summary"
            for name in particle_steps_per_s peak_memory_MB list_rebuilds state_hash; do
                printf '%s,' "$(field $name <"$work/summary")"
            done | sed "s/^/$scene,$t,/; s/,\$//" >>"$results"
            echo >>"$results"
        done
    done
    run=$((run + 1))
done

mkdir -p "$here/$(machine)"
result=$here/$(machine)/$(date +%Y-%m-%d).csv
[ "$scale" = 1 ] || result=$work/results.csv
echo "scene,n,steps,threads,particle_steps_per_s,ns_per_particle_step,peak_memory_MB,list_rebuilds,state_hash" >"$result"
for scene in $scenes; do
    for t in $threads; do
        # The run of median speed. What the run was may not hang on luck: all its hashes are one.
        grep "^$scene,$t," "$results" | sort -t , -g -k 3 | awk -F , -v head="$scene,$(discs_of "${scene%-no-ledger}"),$(steps_of "${scene%-no-ledger}")" \
            -v middle=$(((runs + 1) / 2)) '
            NR == 1 { hash = $6 }
            $6 != hash { print head ": two runs ended in two states, " hash " and " $6 >"/dev/stderr"; exit 1 }
            NR == middle {
                memory = $4 == "" ? "" : sprintf("%.4g", $4)
                printf "%s,%d,%.3g,%.1f,%s,%s,%s\n", head, $2, $3, 1e9 / $3, memory, $5, $6
            }
            END { if (!NR) { print head ": no runs" >"/dev/stderr"; exit 1 } }' >>"$result"
    done
done
echo "$result"
cat "$result"
