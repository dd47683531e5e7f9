//! Restarts that cannot be: one way out is named, and it works.
#![cfg(unix)] // devices, sparse files

use crate::support::runs;

use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};

use parsim2d::output::checkpoint::{Checkpoint, PREVIOUS};
use runs::{files, outcome, parsim2d, text, with_two_checkpoints};

/// The message of a refusal, which changes nothing in `folder`.
fn refused(folder: &Path, arguments: &str) -> String {
    let before = files(folder);
    let output = outcome(folder, arguments);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments}: {message}");
    assert_eq!(message.matches("way out").count(), 1, "one way out:\n{message}");
    assert_eq!(files(folder), before, "nothing was changed");
    message
}

#[test]
fn another_checkpoint_is_offered_only_if_it_fits_the_files() {
    let folder = with_two_checkpoints();
    // Two frames more in the latest than in the previous one.
    assert!(outcome(folder.path(), "resume --time 0.12 -q --checkpoint-every 1h").status.success());
    let previous = folder.path().join(PREVIOUS);
    let damaged = "parsim2d checkpoint 2\n";
    // The previous one is damaged: the latest is offered, also for a copy of another name.
    let whole = fs::read(&previous).unwrap();
    fs::write(&previous, damaged).unwrap();
    let message = refused(folder.path(), "resume parsim2d.previous.ckpt");
    assert!(message.contains("step ") && message.contains("resume parsim2d.ckpt\n"), "{message}");
    fs::write(folder.path().join("copy.ckpt"), damaged).unwrap();
    let message = refused(folder.path(), "resume copy.ckpt");
    assert!(message.contains("resume parsim2d.ckpt\n"), "{message}");
    fs::write(&previous, whole).unwrap();
    // A trajectory cut back to before the latest, but not before the previous: that one is offered, and works.
    let extent = Checkpoint::read(&previous).unwrap().progress.written.trajectory.bytes;
    let trajectory = folder.path().join("trajectory.txt");
    let text = fs::read(&trajectory).unwrap();
    assert!((extent as usize) < text.len(), "the previous one was of before the end");
    fs::write(&trajectory, &text[..extent as usize]).unwrap();
    let message = refused(folder.path(), "resume --time 0.14");
    assert!(message.contains("resume parsim2d.previous.ckpt\n"), "{message}");
    // Without it neither fits.
    fs::remove_file(&trajectory).unwrap();
    let message = refused(folder.path(), "resume --time 0.14");
    for part in ["put the file of that run back", "parsim2d last-run.toml --out-dir again"] {
        assert!(message.contains(part), "{part:?} is not in\n{message}");
    }
    assert!(!message.contains("previous"), "{message}");
    assert!(outcome(folder.path(), "last-run.toml --out-dir again").status.success());
}

#[test]
fn what_cannot_be_a_checkpoint_is_refused_without_reading_it_whole() {
    let folder = tempfile::tempdir().unwrap();
    assert!(refused(folder.path(), "resume /dev/zero").contains("a pipe or a device"));
    let sparse = folder.path().join("sparse.ckpt");
    let file = fs::File::create(&sparse).unwrap();
    file.set_len(1 << 40).unwrap(); // a terabyte of nothing
    let output = outcome(folder.path(), "resume sparse.ckpt");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("no checkpoint"), "{}", text(&output.stderr));
    fs::write(&sparse, "parsim2d checkpoint 2\nsection a f64 8 crc32 00000000\n").unwrap();
    fs::File::options().write(true).open(&sparse).unwrap().set_len(1 << 40).unwrap();
    let output = outcome(folder.path(), "resume sparse.ckpt");
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("it is damaged"), "{}", text(&output.stderr));
}

#[test]
fn a_checkpoint_is_no_scenario_and_says_what_to_do_with_it() {
    let folder = with_two_checkpoints();
    for arguments in ["parsim2d.ckpt", "check parsim2d.ckpt", "run parsim2d.ckpt"] {
        let message = refused(folder.path(), arguments);
        assert!(message.contains("is a checkpoint, not a scenario"), "{message}");
        assert!(message.contains("parsim2d resume parsim2d.ckpt"), "{message}");
    }
}

#[test]
fn physics_flags_are_refused_with_a_reason() {
    let folder = with_two_checkpoints();
    for flag in ["--kn", "--seed", "--integrator", "--every", "-n", "--nt=20"] {
        let message = refused(folder.path(), &format!("resume {flag} 3"));
        let name = flag.split('=').next().unwrap();
        for part in [name, "cannot change on the way", "last-run.toml --out-dir again"] {
            assert!(message.contains(part), "{part:?} is not in\n{message}");
        }
    }
    let message = text(&outcome(folder.path(), "resume --knn 3").stderr);
    assert!(message.contains("unexpected argument"), "{message}");
    for arguments in ["resume --threads abc", "--threads abc"] {
        let message = text(&outcome(folder.path(), arguments).stderr);
        assert!(message.contains("from 1 to 256"), "{message}");
    }
}

#[test]
fn a_flag_of_physics_names_the_run_of_the_folder_that_was_named() {
    let folder = tempfile::tempdir().unwrap();
    let begin = "-n 5 --seed 1 --time 2ms -q --checkpoint-every 1h --out-dir";
    assert!(outcome(folder.path(), &format!("{begin} mm")).status.success());
    assert!(outcome(folder.path(), &format!("{begin} . --radius 2e-4")).status.success());
    for (arguments, way_out) in [
        ("resume mm --nt 100", "parsim2d mm/last-run.toml --out-dir again --nt 100;"),
        ("resume --nt 100 mm", "parsim2d mm/last-run.toml --out-dir again --nt 100;"),
        ("resume mm/parsim2d.ckpt --nt=100", "mm/last-run.toml --out-dir again --nt=100;"),
        ("resume -q mm --time 4ms -n 7", "parsim2d mm/last-run.toml --out-dir again -n 7;"),
        ("resume --border mm", "parsim2d mm/last-run.toml --out-dir again --border;"),
        ("resume --nt 100", "parsim2d last-run.toml --out-dir again --nt 100;"),
    ] {
        let output = outcome(folder.path(), arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments}: {message}");
        assert!(message.contains(way_out), "{arguments}: {way_out:?} is not in\n{message}");
    }
    let output = outcome(folder.path(), "mm/last-run.toml --out-dir again --nt 100");
    assert!(output.status.success(), "{}", text(&output.stderr));
    fs::remove_file(folder.path().join("mm/last-run.toml")).unwrap();
    let message = text(&outcome(folder.path(), "resume mm --nt 100").stderr);
    assert!(!message.contains("last-run.toml"), "there is none: {message}");
}

#[test]
fn a_run_begun_quietly_goes_on_as_loud_as_it_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let begin = "-n 5 --seed 1 --time 2ms -q --checkpoint-every 1h";
    assert!(outcome(folder.path(), begin).status.success());
    for (arguments, is_loud) in [
        ("resume --time 4ms", true),
        ("resume --time 6ms -q", false),
        ("resume --time 8ms --quiet=false", true),
        ("resume --time 10ms --quiet", false),
    ] {
        let output = outcome(folder.path(), arguments);
        let said = format!("{}{}", text(&output.stdout), text(&output.stderr));
        assert!(output.status.success(), "{arguments}: {said}");
        assert_eq!(said.contains("going on from step"), is_loud, "{arguments}: {said}");
        assert_eq!(!output.stdout.is_empty(), is_loud, "{arguments}: {said}");
    }
}

#[test]
fn a_run_that_is_done_or_went_wrong_says_so_when_it_is_resumed() {
    let folder = tempfile::tempdir().unwrap();
    assert!(outcome(folder.path(), "-n 5 --seed 1 --time 1ms -q").status.success());
    // A script that resumes until the run is done comes to an end.
    let output = outcome(folder.path(), "resume");
    assert!(output.status.success());
    assert!(text(&output.stderr).starts_with("note: nothing is left to do: the run there is done"));
    let message = refused(folder.path(), "resume --time 2ms");
    assert!(message.contains("the run there is done, t = 0.001"), "{message}");
    assert!(message.contains("parsim2d last-run.toml --out-dir again --time 0.002"), "{message}");
    let wrong = "-n 20 --seed 1 --integrator explicit-euler --time 1 --speed 0.5 -q";
    assert_eq!(outcome(folder.path(), wrong).status.code(), Some(1));
    let message = refused(folder.path(), "resume");
    assert!(message.contains("went wrong (energy-grown at step"), "{message}");
    // With checkpoints it can be resumed, and goes wrong again; flags are for a new run.
    assert_eq!(
        outcome(folder.path(), &format!("{wrong} --checkpoint-every 1ms")).status.code(),
        Some(1)
    );
    let output = outcome(folder.path(), "resume");
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    let way_out = message.lines().last().unwrap().split(": parsim2d ").nth(1).unwrap();
    assert!(
        message.contains("a new run can: parsim2d last-run.toml --out-dir again --"),
        "{message}"
    );
    let output = outcome(folder.path(), way_out);
    assert!(output.status.success(), "{way_out}: {}", text(&output.stderr));
    // What is left of it is no reason to refuse another run.
    assert!(outcome(folder.path(), "-n 5 --seed 1 --time 1ms -q").status.success());
}

#[test]
fn a_folder_that_cannot_be_written_is_told_before_anything_is_touched() {
    let folder = with_two_checkpoints();
    // Root may write anywhere; a folder where the record goes stops it too.
    fs::remove_file(folder.path().join("last-run.toml")).unwrap();
    fs::create_dir(folder.path().join("last-run.toml")).unwrap();
    let before = fs::read(folder.path().join("trajectory.txt")).unwrap();
    let output = outcome(folder.path(), "resume --time 0.2");
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("--out-dir") && !message.contains("more room"), "{message}");
    assert_eq!(fs::read(folder.path().join("trajectory.txt")).unwrap(), before);
    assert!(outcome(folder.path(), "resume --time 0.11 --out-dir other -q").status.success());
}

#[test]
fn a_folder_in_place_of_a_scenario_says_what_can_be_done_with_the_run_there() {
    let folder = with_two_checkpoints();
    let message = refused(folder.path(), ".");
    assert!(message.contains("way out: to go on with the run there: parsim2d resume"), "{message}");
    for name in ["parsim2d.ckpt", PREVIOUS] {
        fs::remove_file(folder.path().join(name)).unwrap();
    }
    let message = refused(folder.path(), ".");
    assert!(message.contains("last-run.toml --out-dir again"), "{message}");
    let empty = tempfile::tempdir().unwrap();
    assert!(refused(empty.path(), ".").contains("way out: the name of a file"));
}

#[test]
fn a_run_whose_folder_is_taken_away_promises_nothing_that_is_gone() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = "-n 20 --seed 1 --time 100 --slowdown 1 --checkpoint-every 10ms --out-dir run";
    let mut command = parsim2d(folder.path(), arguments);
    let child = command.stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
    let run = folder.path().join("run");
    let begun = Instant::now();
    while !run.join(PREVIOUS).exists() {
        assert!(begun.elapsed() < Duration::from_secs(20), "no checkpoint comes");
        std::thread::sleep(Duration::from_millis(5));
    }
    fs::rename(&run, folder.path().join("elsewhere")).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    let message = text(&output.stderr);
    assert!(message.contains("its folder is gone"), "{message}");
    assert!(!message.contains("is kept") && !message.contains("parsim2d resume"), "{message}");
}
