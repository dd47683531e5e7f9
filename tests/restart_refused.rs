//! Restarts that cannot be, and disks that fill up: what is said, and what is left.
#![cfg(unix)] // ulimit

use crate::support::runs;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use parsim2d::output::checkpoint::{Checkpoint, FILE, PREVIOUS};
use runs::{assert_same, files, outcome, reference, summary, text, with_two_checkpoints};

#[test]
fn files_that_are_not_those_of_the_run_are_refused_by_name() {
    type Harm = fn(&Path);
    let harms: [(Harm, &str, &str); 4] = [
        (
            |folder| fs::remove_file(folder.join("trajectory.txt")).unwrap(),
            "trajectory.txt",
            "not there",
        ),
        (|folder| fs::remove_file(folder.join("energy.csv")).unwrap(), "energy.csv", "not there"),
        (|folder| fs::write(folder.join("energy.csv"), "step").unwrap(), "energy.csv", "shorter"),
        (
            |folder| {
                let path = folder.join("trajectory.txt");
                let text = fs::read_to_string(&path).unwrap();
                fs::write(path, text.replacen('1', "2", 1)).unwrap();
            },
            "trajectory.txt",
            "not those of that run",
        ),
    ];
    for (harm, name, why) in harms {
        let folder = with_two_checkpoints();
        harm(folder.path());
        let before = files(folder.path());
        let output = outcome(folder.path(), "resume --time 0.2");
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        for part in [name, why, "way out"] {
            assert!(message.contains(part), "{part:?} is not in\n{message}");
        }
        assert_eq!(files(folder.path()), before, "nothing was changed");
    }
}

#[test]
fn a_damaged_checkpoint_is_refused_and_the_previous_one_offered_and_kept() {
    let folder = with_two_checkpoints();
    let whole = files(folder.path());
    let latest = folder.path().join(FILE);
    let mut bytes = fs::read(&latest).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&latest, bytes).unwrap();
    let output = outcome(folder.path(), "resume");
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("it is damaged"), "{message}");
    assert!(
        message.contains("parsim2d resume ./parsim2d.previous.ckpt")
            || message.contains("parsim2d resume parsim2d.previous.ckpt"),
        "{message}"
    );
    let previous = fs::read(folder.path().join(PREVIOUS)).unwrap();
    let output = outcome(folder.path(), "resume parsim2d.previous.ckpt --checkpoint-every 1min");
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert_eq!(files(folder.path()), whole);
    // The damaged one was replaced, and did not become the previous one.
    assert!(Checkpoint::read(&latest).is_ok());
    assert_eq!(fs::read(folder.path().join(PREVIOUS)).unwrap(), previous);
    for (content, why) in [
        ("parsim2d checkpoint 9\nmore", "format 9"),
        ("x y r\n", "no checkpoint"),
        ("", "no checkpoint"),
    ] {
        fs::write(&latest, content).unwrap();
        let output = outcome(folder.path(), "resume");
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains(why), "{}", text(&output.stderr));
    }
    let output = outcome(folder.path(), "resume nowhere.ckpt");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("nowhere.ckpt"));
}

/// Runs where no file may grow beyond `blocks` of 1 kB: the write fails as on a full disk, for the signal
/// that would kill the writer is ignored.
fn with_small_files(folder: &Path, blocks: u32, arguments: &str) -> Output {
    let program = env!("CARGO_BIN_EXE_parsim2d");
    let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec '{program}' {arguments}");
    Command::new("bash").args(["-c", &script]).current_dir(folder).output().unwrap()
}

#[test]
fn a_disk_that_fills_up_leaves_the_last_checkpoint_whole() {
    let case = "-n 100 --radius 5e-4 --seed 2 --time 0.1 --every 20 --json";
    let (whole, expected) = reference(case);
    let folder = tempfile::tempdir().unwrap();
    // A checkpoint of 100 discs has 12 kB; the trajectory passes 1 MB half-way.
    let output = with_small_files(folder.path(), 1000, &format!("{case} --checkpoint-every 1ms"));
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    for part in ["trajectory.txt failed", "once there is room", "parsim2d resume parsim2d.ckpt"] {
        assert!(message.contains(part), "{part:?} is not in\n{message}");
    }
    assert!(Checkpoint::read(&folder.path().join(FILE)).unwrap().progress.step > 0);
    assert_eq!(summary(&outcome(folder.path(), "resume")), expected);
    assert_same(folder.path(), whole.path(), "after a full disk");
}

#[test]
fn a_checkpoint_that_does_not_fit_leaves_the_last_one_as_it_was() {
    // 2000 discs: 100 kB a frame, 200 kB a checkpoint.
    let case = "-n 2000 --radius 2e-4 --seed 2 --every 100000 --time 2ms -q";
    let folder = tempfile::tempdir().unwrap();
    let run = format!("{case} --checkpoint-every 1min");
    assert!(outcome(folder.path(), &run).status.success());
    let before = fs::read(folder.path().join(FILE)).unwrap();
    assert!(
        before.len() > 180_000
            && fs::metadata(folder.path().join("out.txt")).unwrap().len() < 180_000
    );
    let output = with_small_files(folder.path(), 180, "resume --time 3ms --checkpoint-every 1ms");
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("the run goes on; the last checkpoint, of step "), "{message}");
    assert!(message.contains("parsim2d.ckpt failed"), "{message}");
    assert_eq!(fs::read(folder.path().join(FILE)).unwrap(), before);
    assert!(files(folder.path()).keys().all(|name| !name.ends_with(".tmp")));
}
