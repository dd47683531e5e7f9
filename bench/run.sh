#!/bin/sh
# How fast does this machine step? Runs each scene five times, scenes in turn so that a noisy
# machine is noisy for all, and writes the medians to bench/<machine>/<date>.csv.
#
# Usage: sh bench/run.sh ./parSim2D [runs]
set -eu
program=$(realpath "$1")
runs=${2:-5}
cd "$(dirname "$0")"

cpu=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)
machine=$(printf '%s' "${cpu:-$(uname -m)}" | tr -cs 'A-Za-z0-9' '-' | tr 'A-Z' 'a-z' | sed 's/-$//')
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# name, then the flags of the scene
cat >"$folder/scenes" <<SCENES
guide-20 -n 20 --time 2
guide-20-no-ledger -n 20 --time 2 --energy-every 0
guide-1000 -n 1000 --time 0.2
dense-1000 -n 1000 --radius 5e-4 --time 0.2
dense-1000-no-ledger -n 1000 --radius 5e-4 --time 0.2 --energy-every 0
dense-20k -n 20000 --radius 1.1e-4 --time 0.01
gas-100k -n 100000 --radius 2e-5 --speed 0.3 --gravity 0 --time 0.002
SCENES

run=0
while [ "$run" -lt "$runs" ]; do
    while read -r scene flags; do
        # shellcheck disable=SC2086 # flags are words
        "$program" $flags --seed 1 --json -q --every 1000000000 --out-dir "$folder" |
            sed -E 's/.*"n":([0-9]+).*"steps":([0-9]+).*"particle_steps_per_s":([0-9.eE+-]+).*"state_hash":"([0-9a-f]+)".*/'"$scene"' \1 \2 \3 \4/' >>"$folder/results"
    done <"$folder/scenes"
    run=$((run + 1))
done

mkdir -p "$machine"
result="$machine/$(date +%Y-%m-%d).csv"
echo "scene,n,steps,threads,particle_steps_per_s,ns_per_particle_step,state_hash" >"$result"
while read -r scene flags; do
    grep "^$scene " "$folder/results" | sort -g -k 4 | awk -v middle=$(((runs + 1) / 2)) \
        'NR == middle { printf "%s,%d,%d,1,%.3g,%.1f,%s\n", $1, $2, $3, $4, 1e9 / $4, $5 }' >>"$result"
done <"$folder/scenes"
echo "bench/$result"
cat "$result"
