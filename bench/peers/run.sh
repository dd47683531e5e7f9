#!/bin/sh
# parsim2d beside LAMMPS (Debian's package: apt-get install lammps) on the same starting states, with the
# same law, the same time step and the same number of steps, in turn on the same machine. Prints a
# table and writes bench/<machine>/<date>-peers.csv; with --markdown the table is the README's.
#
# Usage: sh bench/peers/run.sh ./parSim2D [--markdown] [scene ...]
set -eu
program=$(realpath "$1")
shift
markdown=
if [ "${1:-}" = --markdown ]; then markdown=1 && shift; fi
here=$(cd "$(dirname "$0")/.." && pwd)
. "$here/scenes.sh"
lammps=${LAMMPS:-lmp}
if ! command -v "$lammps" >/dev/null; then
    echo "peers: no LAMMPS: $lammps is not there; apt-get install lammps, or LAMMPS=/path/to/lmp" >&2
    exit 3
fi
scenes=${*:-dense-1000 bed-20k bed-100k polydisperse-20k gas-100k}
eta=1.5e-3 # the guide's, kg/s
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
processes="1 2"
[ "$cores" -ge 2 ] && command -v mpirun >/dev/null || processes=1
folder=$work/peers
rm -rf "$folder"
mkdir -p "$folder"

# lammps_run PROCESSES SCENE STEPS SKIN NEWTON: runs; leaves the log in $folder/log.
lammps_run() {
    frame=$work/$2-$(discs_of "$2").frame
    [ "$1" = 1 ] && start= || start="mpirun -np $1"
    $start "$lammps" -in "$here/peers/discs.in" -log none -nocite \
        -var data "$folder/$2.data" -var side "$(side "$frame")" -var skin "$4" -var newton "$5" \
        -var dt "$(dt_of "$2")" -var steps "$3" -var gravity "$(gravity_of "$2")" -var kn $kn \
        -var pairrate "$(calculate "2 * $eta / $(mass_of "$2")")" -var wallrate "$(calculate "$eta / $(mass_of "$2")")" \
        >"$folder/log" 2>&1 </dev/null || { cat "$folder/log" >&2 && exit 1; }
}

# lammps_speed: particle-steps a second of the run in $folder/log.
lammps_speed() { awk '/^Loop time of/ { printf "%.6g\n", $9 * $12 / $4 }' "$folder/log"; }

# try SCENE PROCESSES SKIN NEWTON: speed, skin and newton of a short run.
try() {
    lammps_run "$2" "$1" "$(($(steps_of "$1") / 3))" "$3" "$4"
    echo "$(lammps_speed) $3 $4"
}

# tune SCENE PROCESSES: the fastest skin (in smallest radii: 0.05 to 3), and then newton, for LAMMPS.
tune() {
    frame=$work/$1-$(discs_of "$1").frame
    smallest=$(awk '!/^#/ && NF && (!r || $3 < r) { r = $3 } END { print r }' "$frame")
    for skin in 0.05 0.2 0.6 1.5 3; do
        try "$1" "$2" "$(calculate "$skin * $smallest")" off
    done >"$folder/tried"
    best=$(sort -g "$folder/tried" | tail -n 1 | cut -d ' ' -f 2)
    try "$1" "$2" "$best" on >>"$folder/tried"
    sort -g "$folder/tried" | awk 'END { print $2, $3 }'
}

# ours SCENE THREADS FLAGS: particle-steps a second; leaves the summary in $folder/summary.
ours() {
    ours_scene=$1 threads=$2
    shift 2
    # shellcheck disable=SC2046 # a flag is two words
    timed "$ours_scene" --eta $eta $(threads_flag "$threads") "$@" >"$folder/summary"
    field particle_steps_per_s <"$folder/summary"
}

# Whether the two did the same: kinetic energy and mean height at the end. Ends the script if the energies are further apart than
# half a kick at the start explains.
same_physics() {
    timed "$1" --eta $eta --energy-every "$(steps_of "$1")" >"$folder/summary"
    kinetic=$(tail -n 1 "$work/run/energy.csv" | cut -d, -f 3)
    height=$(awk '!/^#/ && NF { y += $2; n++ } END { printf "%.9g", y / n }' "$work/run/out.txt")
    awk -v steps="$(steps_of "$1")" -v scene="$1" -v k="$kinetic" -v h="$height" '
        $1 == steps && NF == 3 { differs = k > 1.2 * $2 || k < 0.8 * $2; printf "%s: after %d steps kinetic energy %.4e J, LAMMPS %.4e J; mean height %.7e m, LAMMPS %.7e m\n", scene, steps, k, $2, h, $3 }
        /Neighbor list builds/ { print "  lists made by LAMMPS: " $NF }
        /Dangerous builds = [1-9]/ { print "  " $0 }
        END { if (differs) { print "error: " scene ": not the same physics, so no row" | "cat >&2"; exit 1 } }' "$folder/log"
}

threaded=$(threads_flag 1)
for scene in $scenes; do
    make_state "$scene"
    awk -v mass="$(mass_of "$scene")" -f "$here/peers/frame_to_data.awk" "$work/$scene-$(discs_of "$scene").frame" >"$folder/$scene.data"
    for p in $processes; do
        best=$(tune "$scene" "$p")
        echo "$scene on $p: LAMMPS is fastest with skin ${best% *} m, newton ${best#* }" | tee -a "$folder/notes" >&2
        echo "$best" >"$folder/$scene.$p.best"
    done
    run=0
    while [ "$run" -lt "$runs" ]; do # in turn, so that a noisy machine is noisy for all
        for p in $processes; do
            # shellcheck disable=SC2046
            lammps_run "$p" "$scene" "$(steps_of "$scene")" $(cat "$folder/$scene.$p.best")
            lammps_speed >>"$folder/$scene.$p.lammps"
            [ "$p" = 1 ] && cp "$folder/log" "$folder/$scene.log"
            if [ "$p" = 1 ] || [ -n "$threaded" ]; then
                # shellcheck disable=SC2086 # a flag is two words
                ours "$scene" "$p" $no_rows >>"$folder/$scene.$p.off"
                # shellcheck disable=SC2086
                ours "$scene" "$p" $rows >>"$folder/$scene.$p.on"
            fi
        done
        run=$((run + 1))
    done
    cp "$folder/$scene.log" "$folder/log"
    same_physics "$scene" | tee -a "$folder/notes" >&2
done

mkdir -p "$here/$(machine)"
result=$here/$(machine)/$(date +%Y-%m-%d)-peers.csv
[ "$scale" = 1 ] || result=$folder/peers.csv
echo "scene,n,cores,ledger,parsim2d_particle_steps_per_s,lammps_particle_steps_per_s,ratio,lowest_ratio,highest_ratio,lammps_skin_m,lammps_newton" >"$result"
for scene in $scenes; do
    for p in $processes; do
        for ledger in off on; do
            [ -s "$folder/$scene.$p.$ledger" ] || continue
            paste -d ' ' "$folder/$scene.$p.$ledger" "$folder/$scene.$p.lammps" | awk '{ print $1 / $2 }' | sort -g >"$folder/ratios"
            a=$(median <"$folder/$scene.$p.$ledger") b=$(median <"$folder/$scene.$p.lammps")
            printf '%s,%s,%s,%s,%.3g,%.3g,%.2f,%.2f,%.2f,%s\n' "$scene" "$(discs_of "$scene")" "$p" $ledger "$a" "$b" \
                "$(median <"$folder/ratios")" "$(head -n 1 "$folder/ratios")" "$(tail -n 1 "$folder/ratios")" \
                "$(tr ' ' , <"$folder/$scene.$p.best")" >>"$result"
        done
    done
done
if [ -n "$markdown" ]; then
    echo "| scene | discs | cores | ledger | parsim2d, million particle-steps/s | LAMMPS | times as fast (lowest to highest) |"
    echo "|---|---|---|---|---|---|---|"
    awk -F, 'NR > 1 { printf "| %s | %s | %s | %s | %.1f | %.1f | %.1f (%.1f to %.1f) |\n", $1, $2, $3, $4, $5 / 1e6, $6 / 1e6, $7, $8, $9 }' "$result"
else
    echo "$result"
    cat "$result"
fi
