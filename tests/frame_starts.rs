//! A run that starts from a frame has what the discs of the frame have, and says what it takes for the rest.

use std::fs;
use std::path::Path;

use parsim2d::output::frames::read_frame;
use serde_json::Value;
use tempfile::TempDir;

use crate::support::runs::{outcome, text};

/// Two kinds of discs, of masses 8 g and 1 g.
const KINDS: &str = "radius = 5e-4\nrestitution = 0.8\nseed = 3\ntime = 0.05\n\
                     [[population]]\nn = 10\nradius = 1e-3\nmass = 8e-3\n\
                     [[population]]\nn = 20\nradius = 5e-4\nmass = 1e-3\n";

fn two_kinds() -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("kinds.toml"), KINDS).unwrap();
    let output = outcome(folder.path(), "kinds.toml -q");
    assert!(output.status.success(), "{}", text(&output.stderr));
    folder
}

/// The summary of a run, and what it said.
fn run(folder: &Path, arguments: &str) -> (Value, String) {
    let output = outcome(folder, &format!("{arguments} --json"));
    let said = text(&output.stderr);
    assert!(output.status.success(), "{arguments}: {said}");
    (serde_json::from_slice(&output.stdout).unwrap(), said)
}

/// The energy (J) in the first or last line of a ledger, but for what was dissipated.
fn mechanical_energy(folder: &Path, line: fn(&str) -> Option<&str>) -> f64 {
    let ledger = fs::read_to_string(folder.join("energy.csv")).unwrap();
    let numbers = line(&ledger).unwrap().split(',').map(|word| word.parse::<f64>().unwrap());
    numbers.skip(2).take(3).sum()
}

#[test]
fn a_second_run_begins_with_the_energy_with_which_the_first_ended() {
    let folder = two_kinds();
    let end = mechanical_energy(folder.path(), |ledger| ledger.lines().last());
    run(folder.path(), "--start trajectory.txt --restitution 0.8 --time 1ms --out-dir next");
    let start = mechanical_energy(&folder.path().join("next"), |ledger| ledger.lines().nth(1));
    // A frame has nine digits; the elastic energy of overlaps loses two or three of them.
    assert!((start / end - 1.0).abs() < 1e-7, "{start} J, not {end} J");
    assert!((end - 1.486_613e-2).abs() < 1e-8, "{end} J"); // as its ledger said before frames had masses
}

#[test]
fn a_repeated_frame_is_the_frame() {
    let folder = two_kinds();
    let (_, said) = run(folder.path(), "--start trajectory.txt --time 0 --out-dir next");
    assert!(!said.contains("holds no"), "{said}");
    let last = |path: &str| {
        let text = fs::read(folder.path().join(path)).unwrap();
        read_frame(&text[..], None).unwrap().rows
    };
    assert_eq!(last("trajectory.txt"), last("next/trajectory.txt"));
    assert_eq!(last("trajectory.txt")[0].mass, Some(8e-3));
}

#[test]
fn one_note_says_what_a_frame_does_not_hold_and_what_is_taken() {
    let folder = two_kinds();
    let rows = "0.01 0.02 1e-3 0.1 0\n0.03 0.02 1e-3 0 0\n";
    fs::write(folder.path().join("moving.txt"), rows).unwrap();
    fs::write(folder.path().join("heavy.txt"), "# x y r m\n0.01 0.02 1e-3 0.5\n").unwrap();
    for (arguments, note) in [
        (
            "--start out.txt",
            "note: out.txt holds no velocities and no masses: all discs start at rest, with 0.001 kg (--mass); \
             trajectory.txt of the same run has both\n",
        ),
        (
            "--start out.txt --mass 2g --speed 0.1",
            "note: out.txt holds no velocities and no masses: all discs are thrown with an rms speed of 0.1 m/s \
             (--speed), with 0.002 kg (--mass); trajectory.txt of the same run has both\n",
        ),
        (
            "--start moving.txt",
            "note: moving.txt holds no masses: each disc has 0.001 kg (--mass)\n",
        ),
        ("--start heavy.txt", "note: heavy.txt holds no velocities: all discs start at rest\n"),
        (
            "--start trajectory.txt --mass 2g",
            "note: trajectory.txt has the mass of each disc: mass = 0.002 kg is not used\n",
        ),
    ] {
        let arguments = format!("{arguments} --time 0 --seed 1 --out-dir next");
        let (_, said) = run(folder.path(), &arguments);
        assert!(said.contains(note), "{arguments}: {said}");
        assert_eq!(
            said.matches("holds no").count() + said.matches("is not used").count(),
            1,
            "{said}"
        );
        assert!(!text(&outcome(folder.path(), &format!("{arguments} -q")).stderr).contains("note"));
    }
    let heavy = fs::read(folder.path().join("next/trajectory.txt")).unwrap();
    assert_eq!(read_frame(&heavy[..], None).unwrap().rows[0].mass, Some(8e-3));
}

#[test]
fn a_printed_scenario_of_a_start_gives_the_same_run() {
    let folder = two_kinds();
    let columns = "# nothing is named here\n0.01 0.02 0 1e-3\n0.03 0.02 0 1e-3\n";
    fs::write(folder.path().join("xyzr.txt"), columns).unwrap();
    for (k, start) in [
        "--start trajectory.txt:7",
        "--start out.txt --mass 2g",
        "--start xyzr.txt --columns x,y,-,r",
    ]
    .into_iter()
    .enumerate()
    {
        let arguments = format!("{start} --time 2ms --seed 4");
        let (first, _) = run(folder.path(), &format!("{arguments} --out-dir first{k}"));
        let printed = outcome(folder.path(), &format!("{arguments} --print-config"));
        fs::write(folder.path().join("printed.toml"), printed.stdout).unwrap();
        let (second, _) = run(folder.path(), &format!("printed.toml --out-dir second{k}"));
        // The record lists the discs, each with its mass.
        let (third, _) = run(folder.path(), &format!("first{k}/last-run.toml --out-dir third{k}"));
        for other in [second, third] {
            assert_eq!(other["state_hash"], first["state_hash"], "{start}");
        }
    }
}

#[test]
fn a_run_from_a_frame_is_resumed_with_its_masses() {
    let folder = two_kinds();
    let whole = "--start trajectory.txt --time 4ms --seed 4";
    let (reference, _) = run(folder.path(), &format!("{whole} --out-dir whole"));
    run(
        folder.path(),
        "--start trajectory.txt --time 2ms --seed 4 --checkpoint-every 10s --out-dir parts",
    );
    fs::remove_file(folder.path().join("trajectory.txt")).unwrap();
    let (resumed, _) = run(folder.path(), "resume parts --time 4ms");
    assert_eq!(resumed["state_hash"], reference["state_hash"]);
}
