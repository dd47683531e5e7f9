#!/bin/sh
# A disk that fills up during output, and during a checkpoint: the run ends with 1 and says so, and the last
# checkpoint is whole. Mounts a small tmpfs, for which it must be root: sh tests/disk_full.sh PROGRAM
set -eu
program=$1
room=$(mktemp -d)
reference=$(mktemp -d)
clean() {
    mountpoint -q "$room" && umount "$room"
    rm -rf "$room" "$reference"
}
trap clean EXIT
fail() { echo "disk_full: $*" >&2; exit 1; }

if ! mount -t tmpfs -o size=1m tmpfs "$room" 2>/dev/null; then
    echo "SKIPPED: no tmpfs can be mounted here; cargo test has the short form" >&2
    exit 0
fi
case="-n 100 --radius 5e-4 --seed 2 --time 0.1 --every 20 --energy-every 20 -q"
(cd "$reference" && "$program" $case)

echo "1. the disk fills up during output"
code=0
(cd "$room" && "$program" $case --checkpoint-every 1ms 2>"$reference/said") || code=$?
cat "$reference/said"
[ "$code" = 1 ] || fail "exit code $code, not 1"
grep -q "failed: No space left on device" "$reference/said" || fail "no word of the full disk"
mount -o remount,size=20m "$room"
(cd "$room" && "$program" resume -q)
for name in trajectory.txt energy.csv out.txt last-run.toml; do
    cmp "$room/$name" "$reference/$name" || fail "$name differs"
done

echo "2. the disk fills up during a checkpoint"
rm -f "$room"/*
case="-n 3000 --radius 2e-4 --seed 2 --time 1ms --every 100000 -q"
(cd "$room" && "$program" $case --checkpoint-every 1min)
cp "$room/parsim2d.ckpt" "$reference/before.ckpt"
# Room for frames of 150 kB and 90 kB, not for a checkpoint of 290 kB.
used=$(du -sk "$room" | cut -f1)
mount -o remount,size=$((used + 110))k "$room"
code=0
(cd "$room" && "$program" resume --time 3ms --checkpoint-every 1ms -q 2>"$reference/said") || code=$?
cat "$reference/said"
[ "$code" = 1 ] || fail "exit code $code, not 1"
grep -q "parsim2d.ckpt failed: No space left on device" "$reference/said" || fail "no word of the checkpoint"
cmp "$room/parsim2d.ckpt" "$reference/before.ckpt" || fail "the last checkpoint was touched"
mount -o remount,size=20m "$room"
(cd "$room" && "$program" resume --time 3ms -q) || fail "it does not go on"
echo "disk_full: all good"
