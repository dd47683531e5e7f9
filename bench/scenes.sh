# The scenes and their starting states, for the scripts beside this file (sourced, not run).
#
# PARSIM2D_BENCH_SCALE multiplies numbers of discs and of steps (default 1; tests use a tiny one).
# PARSIM2D_BENCH_WORK is the folder of starting states, made once (default target/bench).
# PARSIM2D_BENCH_RUNS is how many times each case is run (default 5); the median counts.

scale=${PARSIM2D_BENCH_SCALE:-1}
runs=${PARSIM2D_BENCH_RUNS:-5}
work=${PARSIM2D_BENCH_WORK:-$(dirname "$here")/target/bench}
mkdir -p "$work"
work=$(cd "$work" && pwd)
kn=5e4 # N/m, the guide's
cores=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)

# calculate EXPRESSION: arithmetic in awk, nine digits.
calculate() { awk "BEGIN { printf \"%.9g\", $1 }"; }

# count N LEAST: N discs or steps, scaled.
count() { awk -v n="$1" -v s="$scale" -v least="$2" 'BEGIN { n = int(n * s); print n < least ? least : n }'; }

# field NAME <JSON: a value of the summary, nothing if it is null or not there.
field() { sed -nE 's/.*"'"$1"'":"?([^",}]*).*/\1/p' | sed 's/^null$//'; }

# side FRAME: what the head of a frame says.
side() { sed -n '1s/.*side_m \([^ ]*\).*/\1/p' "$1"; }

# median <NUMBERS, one a line.
median() { sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }

# Lasting name of this machine.
machine() {
    cpu=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1)
    printf '%s' "${cpu:-$(uname -m)}" | tr -cs 'A-Za-z0-9' '-' | tr 'A-Z' 'a-z' | sed 's/-$//'
}

# Number of discs of a scene.
discs_of() {
    case $1 in
    guide-20*) count 20 20 ;;
    *-1000) count 1000 50 ;;
    *-16k) count 16000 50 ;;
    *-20k) count 20000 50 ;;
    *-100k) count 100000 50 ;;
    *-1m) count 1000000 50 ;;
    esac
}

# Mass of a disc, kg: the guide's; in the gas lighter, for with the guide's its small discs would fly through each
# other and the walls.
mass_of() { case $1 in gas-* | cluster-*) echo 1e-5 ;; giant-*) echo 1e-6 ;; *) echo 1e-3 ;; esac; }

# Time step, s: Eq. (2) with N_t = 50.
dt_of() { calculate "3.141592653589793 * sqrt($(mass_of "$1") / $kn) / 50"; }

# Gravity, m/s2. A bed of a million is a thousand rows high: under the earth's its foot would be 0.23 r deep
# in each other on the average; a third of it leaves 0.08 r, as in bed-100k.
gravity_of() {
    case $1 in
    gas-* | cluster-* | far-* | giant-*) echo 0 ;;
    *-1m) echo 3.27 ;;
    *) echo 9.81 ;;
    esac
}

# Steps of a timed run: some seconds.
steps_of() {
    case $1 in
    guide-20*) count 200000 20 ;;
    *-1000) count 30000 20 ;;
    *-20k) count 1500 20 ;;
    *-1m) count 30 10 ;;
    *) count 300 20 ;;
    esac
}

# settle FRAME STEPS ROUNDS GRAVITY: lets the discs of FRAME, of the guide's mass, come to rest; after each round
# they stand still once more.
settle() {
    round=0
    while [ "$round" -lt "$3" ]; do
        "$program" --start "$1" --restitution 0.3 --gravity "$4" --nt 50 --time "$(calculate "$2 * $(dt_of bed)")" \
            --energy-every 0 --every 1000000000 --json -q --out-dir "$work/settling" >/dev/null
        mv "$work/settling/out.txt" "$1"
        round=$((round + 1))
    done
}

# make_state SCENE: its starting frame, unless it is there.
make_state() {
    n=$(discs_of "$1")
    frame=$work/$1-$n.frame
    case $1 in guide-*) return ;; esac # placed by the program
    if [ -s "$frame" ]; then return; fi
    echo "making $frame" >&2
    new=$work/new.frame
    case $1 in
    dense-1000) # the guide's box of a thousand larger discs, fallen and at rest
        "$program" -n "$n" --radius 5e-4 --side "$(calculate "0.04 * sqrt($n / 1000)")" --seed 1 --time 0.6 \
            --restitution 0.3 --energy-every 0 --every 1000000000 --json -q --out-dir "$work/settling" >/dev/null
        mv "$work/settling/out.txt" "$new"
        settle "$new" "$(count 4000 10)" 3 9.81
        ;;
    bed-*)
        awk -v n="$n" -v radius=5e-4 -v mass="$(mass_of "$1")" -v kn=$kn -v gravity="$(gravity_of "$1")" -v seed=1 \
            -f "$here/bed.awk" >"$new"
        rounds=8
        [ "$1" != bed-1m ] || rounds=1
        settle "$new" "$(count 1000 10)" $rounds "$(gravity_of "$1")"
        awk -f "$here/shuffle.awk" "$new" >"$new.shuffled"
        mv "$new.shuffled" "$new"
        ;;
    gas-*) # its very first frame, velocities too
        "$program" -n "$n" --radius 2e-5 --mass "$(mass_of "$1")" --side "$(calculate "0.04 * sqrt($n / 1e5)")" --speed 0.3 --gravity 0 \
            --seed 1 --time 1e-5 --energy-every 0 --json -q --out-dir "$work/settling" >/dev/null
        awk '/^$/ { exit } { print }' "$work/settling/trajectory.txt" >"$new"
        ;;
    cluster-* | far-*) # a dense body in an open plane: one in ten far and fast around it, or one disc 500 m away
        awk -v n="$n" -v scene="$1" -f "$here/cluster.awk" >"$new"
        ;;
    giant-*) # one large disc among small ones, 1:500, all at rest
        awk -v n="$n" -f "$here/giant.awk" >"$new"
        ;;
    polydisperse-*) # three sizes, 1:2:3, fallen and at rest; equal masses, for --start knows one
        polydisperse "$n" >"$work/polydisperse.toml"
        "$program" "$work/polydisperse.toml" --seed 1 --time "$(calculate "0.25 * ($scale < 1 ? $scale : 1)")" --restitution 0.3 \
            --energy-every 0 --every 1000000000 --json -q --out-dir "$work/settling" >/dev/null
        mv "$work/settling/out.txt" "$new"
        settle "$new" "$(count 2000 10)" 3 9.81
        ;;
    esac
    rm -rf "$work/settling"
    mv "$new" "$frame"
}

# polydisperse N: a scenario of half small, a third middle and the rest large discs, packed at 0.5.
polydisperse() {
    small=$(($1 / 2))
    middle=$(($1 / 3))
    large=$(($1 - small - middle))
    area="($small * 2.5e-4^2 + $middle * 5e-4^2 + $large * 7.5e-4^2)"
    echo "side = $(calculate "sqrt(3.14159265 * $area / 0.5)")"
    for group in "$small 2.5e-4" "$middle 5e-4" "$large 7.5e-4"; do
        printf '[[population]]\nn = %s\nradius = %s\n' "${group% *}" "${group#* }"
    done
}

# flags_of SCENE: flags of its timed run, without its length in time.
flags_of() {
    n=$(discs_of "$1")
    case $1 in
    guide-*) echo "-n $n --seed 1 --dt $(dt_of "$1")" ;;
    cluster-* | far-*) echo "--start $work/$1-$n.frame --no-walls --mass $(mass_of "$1") --gravity 0 --dt $(dt_of "$1")" ;;
    *) echo "--start $work/$1-$n.frame --mass $(mass_of "$1") --gravity $(gravity_of "$1") --dt $(dt_of "$1")" ;;
    esac
}

# timed SCENE FLAGS: one timed run; its summary as JSON. The writing of frames is left out.
timed() {
    timed_scene=$1 # sh has no local names
    shift
    # shellcheck disable=SC2046 # flags are words
    "$program" $(flags_of "$timed_scene") --time "$(calculate "$(steps_of "$timed_scene") * $(dt_of "$timed_scene")")" \
        --every 1000000000 --json -q --out-dir "$work/run" "$@"
}

# How often a row of the ledger falls due, in steps: as in a run of a second of the guide's. The timed runs are pieces of
# such runs; by themselves they would write a row every step.
rows="--energy-every 56"
no_rows="--energy-every 0"

# threads_flag T: the flag, or nothing if the program has none.
threads_flag() {
    if "$program" --help | grep -q -- --threads; then echo "--threads $1"; fi
}
