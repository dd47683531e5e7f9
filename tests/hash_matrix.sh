#!/bin/sh
# The same bits whatever computes them: every scenario of tests/scenarios/same_bits by every PROGRAM given (builds
# of parsim2d), on 1, 2, 3, 4 and 8 threads, with several kinds of output. Prints a table; fails if the final states
# of a scenario have two hashes, its energy.csv two contents, or its trajectory.txt two for the same kind of output.
#
# Usage: sh tests/hash_matrix.sh PROGRAM ...
#
# PARSIM2D_MATRIX_SCENES, _THREADS and _OUTPUTS: fewer of each (outputs: usual often seldom quiet).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
scenes=${PARSIM2D_MATRIX_SCENES:-dense gas falling corner polydisperse}
threads=${PARSIM2D_MATRIX_THREADS:-1 2 3 4 8}
outputs=${PARSIM2D_MATRIX_OUTPUTS:-usual often seldom quiet}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

flags_of() {
    case $1 in
    usual) ;;
    often) echo "--every 7" ;;
    seldom) echo "--every 1000000 --energy-every 0" ;;
    quiet) echo "-q" ;;
    *) echo "hash_matrix: no kind of output is called $1" >&2; exit 2 ;;
    esac
}

# same NAME VALUE: notes VALUE for NAME, and says whether it is the one noted first.
same() {
    [ -e "$work/$1" ] || echo "$2" >"$work/$1"
    [ "$(cat "$work/$1")" = "$2" ]
}

# is_a_test <SUMMARY: discs touched by more than a thousandth of a radius, and their list was made anew.
is_a_test() {
    sed -nE 's/.*"list_rebuilds":([0-9]+).*"max_overlap_over_r":([0-9.e-]+).*/\1 \2/p' |
        awk '$1 > 1 && $2 > 1e-3 { good = 1 } END { exit !good }'
}

failures=0
runs=0
printf '%-13s %-7s %-16s %-16s %s\n' scene output threads "state hash" program
for scene in $scenes; do
    for program in "$@"; do
        for output in $outputs; do
            odd=
            for t in $threads; do
                rm -rf "$work/out"
                # shellcheck disable=SC2046 # flags are words
                "$program" "$here/scenarios/same_bits/$scene.toml" --threads "$t" $(flags_of "$output") --json \
                    --out-dir "$work/out" >"$work/summary" 2>"$work/said" || { cat "$work/said" >&2; exit 1; }
                runs=$((runs + 1))
                hash=$(sed -nE 's/.*"state_hash":"([0-9a-f]+)".*/\1/p' "$work/summary")
                [ -n "$hash" ] || { echo "hash_matrix: no hash in the summary" >&2; exit 1; }
                is_a_test <"$work/summary" || { echo "hash_matrix: $scene is no test: too little happens" >&2; exit 1; }
                same "$scene.hash" "$hash" || odd="$odd $t:$hash"
                same "$scene.$output.frames" "$(cksum <"$work/out/trajectory.txt")" || odd="$odd $t:trajectory.txt"
                [ "$output" = seldom ] || same "$scene.energy" "$(cksum <"$work/out/energy.csv")" ||
                    odd="$odd $t:energy.csv"
            done
            printf '%-13s %-7s %-16s %-16s %s\n' "$scene" "$output" "$threads" "$(cat "$work/$scene.hash")" "$program"
            if [ -n "$odd" ]; then
                echo "    DIFFERS (threads:what):$odd"
                failures=$((failures + 1))
            fi
        done
    done
done
[ "$runs" -gt 0 ] || { echo "hash_matrix: no program was given" >&2; exit 2; }
if [ "$failures" -gt 0 ]; then
    echo "$failures rows differ" >&2
    exit 1
fi
echo "$runs runs, one state for each scene"
