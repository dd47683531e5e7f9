//! One run a folder: two at once, and a new one where another could still go on.
#![cfg(unix)] // signals

use crate::support::runs;

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use parsim2d::output::checkpoint::{Checkpoint, FILE, PREVIOUS};
use parsim2d::output::lock::FolderLock;
use runs::{files, outcome, parsim2d, text};

const CASE: &str = "-n 30 --radius 5e-4 --seed 1 --time 20ms";

fn wait_for(path: &Path) {
    let begun = Instant::now();
    while !path.exists() {
        assert!(begun.elapsed() < Duration::from_secs(20), "{} does not come", path.display());
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// A run so slow that it would last minutes, once it has begun.
fn slow(folder: &Path, arguments: &str) -> Child {
    let mut command = parsim2d(folder, &format!("{arguments} --slowdown 20000"));
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    wait_for(&folder.join("energy.csv")); // the last to take its place
    child
}

fn signal(child: &Child, name: &str) {
    let id = child.id().to_string();
    assert!(Command::new("kill").args([name, &id]).status().unwrap().success());
}

/// A folder with a run that was interrupted.
fn interrupted(arguments: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let mut child = slow(folder.path(), arguments);
    std::thread::sleep(Duration::from_millis(300));
    signal(&child, "-INT");
    assert_eq!(child.wait().unwrap().code(), Some(130));
    assert!(folder.path().join(FILE).exists());
    folder
}

fn assert_refused(folder: &Path, arguments: &str, parts: &[&str]) {
    let everything = || {
        let checkpoints = [FILE, PREVIOUS].map(|name| fs::read(folder.join(name)).ok());
        (files(folder), checkpoints)
    };
    let before = everything();
    let output = outcome(folder, arguments);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments}: {message}");
    for part in parts.iter().chain(&["way out: "]) {
        assert!(message.contains(part), "{arguments}: {part:?} is not in\n{message}");
    }
    assert!(everything() == before, "{arguments}: something was changed");
}

#[test]
fn a_second_run_in_a_folder_is_refused_while_the_first_writes_there() {
    let folder = tempfile::tempdir().unwrap();
    let mut child = slow(folder.path(), &format!("{CASE} --checkpoint-every 10ms"));
    wait_for(&folder.path().join(FILE));
    let busy = ["another parsim2d is writing to /", "--out-dir"];
    for second in [CASE, "--every 1 --energy-every 0", "resume", "last-run.toml --out-dir ."] {
        let output = outcome(folder.path(), second);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{second}: {message}");
        assert!(busy.iter().all(|part| message.contains(part)), "{second}: {message}");
    }
    // Who reads, or writes elsewhere, is not disturbed.
    for reader in ["plot frame out.txt -o picture.svg", "check", "--time 0 --out-dir other"] {
        let output = outcome(folder.path(), reader);
        assert!(output.status.success(), "{reader}: {}", text(&output.stderr));
    }
    // Killed, it lets go; what it left is gone on with.
    child.kill().unwrap();
    child.wait().unwrap();
    let output = outcome(folder.path(), "resume --slowdown 1e-6 -q --checkpoint-every 1min");
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(!folder.path().join(".parsim2d.lock").exists(), "nothing is left");
}

#[test]
fn of_many_runs_at_once_in_one_folder_the_files_are_of_one() {
    let folder = tempfile::tempdir().unwrap();
    let start = |seed: u32| {
        let slowdown = 50 - 5 * seed; // who begins first ends last
        let arguments = format!(
            "-n 100 --radius 5e-4 --seed {seed} --time 10ms --slowdown {slowdown} --out-dir new -q --every 50"
        );
        parsim2d(folder.path(), &arguments).stderr(Stdio::piped()).spawn().unwrap()
    };
    let children: Vec<Child> = (1..9).map(start).collect();
    let codes = children.into_iter().map(|child| {
        let output = child.wait_with_output().unwrap();
        let is_busy = text(&output.stderr).contains("another parsim2d is writing");
        assert_eq!(is_busy, output.status.code() == Some(2), "{}", text(&output.stderr));
        output.status.code().unwrap()
    });
    let done = codes.filter(|&code| code == 0).count();
    assert!(done > 0, "one at least has had the folder for itself");
    let new = folder.path().join("new");
    let record = fs::read_to_string(new.join("last-run.toml")).unwrap();
    let seed = record.lines().find_map(|line| line.strip_prefix("seed = ")).unwrap();
    let slowdown = 50 - 5 * seed.parse::<u32>().unwrap();
    let alone = format!(
        "-n 100 --radius 5e-4 --seed {seed} --time 10ms --slowdown {slowdown} --out-dir new -q --every 50"
    );
    let other = tempfile::tempdir().unwrap();
    assert!(outcome(other.path(), &alone).status.success());
    runs::assert_same(&new, &other.path().join("new"), "the last of them");
}

#[test]
fn the_lock_is_one_at_a_time_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let first = FolderLock::take(folder.path()).unwrap();
    assert!(FolderLock::take(folder.path()).is_err());
    drop(first);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    drop(FolderLock::take(folder.path()).unwrap());
    // One that was left by a killed run is no obstacle; what is no file is told of.
    fs::write(folder.path().join(".parsim2d.lock"), "").unwrap();
    drop(FolderLock::take(folder.path()).unwrap());
    fs::create_dir(folder.path().join(".parsim2d.lock")).unwrap();
    let refused = FolderLock::take(folder.path()).map(drop).unwrap_err().to_string();
    assert!(refused.contains(".parsim2d.lock is in the way"), "{refused}");
}

#[test]
fn with_nothing_left_to_do_the_checkpoint_stays() {
    let folder = interrupted(CASE);
    let latest = folder.path().join(FILE);
    let time = Checkpoint::read(&latest).unwrap().progress.time_s;
    let before = fs::read(&latest).unwrap();
    let output = outcome(folder.path(), &format!("resume --time {time:?} --slowdown 1e-6"));
    let message = text(&output.stderr);
    assert!(output.status.success() && message.contains("nothing is left to do"), "{message}");
    assert_eq!(fs::read(&latest).unwrap(), before);
    let way_out = message.split("parsim2d ").nth(1).unwrap().lines().next().unwrap();
    let output = outcome(folder.path(), &format!("{way_out} --slowdown 1e-6"));
    assert!(output.status.success(), "{way_out}: {}", text(&output.stderr));
}

#[test]
fn a_run_that_keeps_checkpoints_and_is_not_done_is_not_replaced() {
    let folder = interrupted(&format!("{CASE} --checkpoint-every 1min"));
    let step = Checkpoint::read(&folder.path().join(FILE)).unwrap().progress.step;
    let at = format!("step {step} of ");
    let parts = ["parsim2d resume parsim2d.ckpt", "--out-dir", "remove parsim2d.ckpt", &at];
    assert_refused(folder.path(), CASE, &parts);
    // Another run that would go on here.
    let other = interrupted(CASE);
    let vic = folder.path().display();
    assert_refused(other.path(), &format!("resume --out-dir {vic}"), &["resume", "remove", &at]);
    let before = files(folder.path());
    assert_eq!(outcome(other.path(), &format!("resume --out-dir {vic}")).status.code(), Some(2));
    assert_eq!(files(folder.path()), before);
    // The ways out.
    assert!(outcome(folder.path(), &format!("{CASE} --out-dir other")).status.success());
    assert!(outcome(folder.path(), "resume --slowdown 1e-6").status.success());
    assert!(outcome(folder.path(), CASE).status.success(), "it is done: nothing is lost");
    fs::copy(other.path().join(FILE), folder.path().join(FILE)).unwrap();
    fs::remove_file(folder.path().join(FILE)).unwrap();
    assert!(outcome(folder.path(), CASE).status.success());
}

#[test]
fn an_interrupted_run_that_asked_for_no_checkpoints_is_replaced_with_a_word() {
    let folder = interrupted(CASE);
    let step = Checkpoint::read(&folder.path().join(FILE)).unwrap().progress.step;
    let output = outcome(folder.path(), CASE);
    let message = text(&output.stderr);
    let said = format!("note: the interrupted run here (step {step} of ");
    assert!(output.status.success() && message.contains(&said), "{message}");
    assert!(message.contains(") is replaced\n"), "{message}");
    assert!(!folder.path().join(FILE).exists());
    assert!(!text(&outcome(folder.path(), CASE).stderr).contains("replaced"));
}

#[test]
fn what_is_no_checkpoint_is_called_what_it_is_and_a_damaged_one_is_replaced_with_a_word() {
    let folder = tempfile::tempdir().unwrap();
    let latest = folder.path().join(FILE);
    for (content, what) in [("", "it is empty"), ("a poem\n", "is no checkpoint of parsim2d,")] {
        fs::write(&latest, content).unwrap();
        assert_refused(folder.path(), CASE, &[what]);
    }
    fs::remove_file(&latest).unwrap();
    fs::create_dir(&latest).unwrap();
    let message = text(&outcome(folder.path(), CASE).stderr);
    assert!(message.contains("it is a folder") && !message.contains("version"), "{message}");
    let folder = interrupted(CASE);
    let bytes = fs::read(folder.path().join(FILE)).unwrap();
    fs::write(folder.path().join(FILE), &bytes[..bytes.len() / 2]).unwrap();
    let output = outcome(folder.path(), CASE);
    let message = text(&output.stderr);
    assert!(
        output.status.success() && message.contains("note: parsim2d.ckpt is damaged"),
        "{message}"
    );
}

#[test]
fn a_run_does_not_replace_the_file_that_it_starts_from() {
    let folder = tempfile::tempdir().unwrap();
    assert!(outcome(folder.path(), CASE).status.success());
    for start in ["trajectory.txt", "trajectory.txt:2", "./trajectory.txt", "out.txt", "out.txt:0"]
    {
        let arguments = format!("--start {start} --time 1ms");
        assert_refused(folder.path(), &arguments, &["this run would replace", "--out-dir next"]);
    }
    assert!(
        outcome(folder.path(), "--start trajectory.txt --time 1ms --out-dir next").status.success()
    );
    // Under another name it is not replaced; and its discs are listed in the record.
    fs::rename(folder.path().join("out.txt"), folder.path().join("start.txt")).unwrap();
    assert!(outcome(folder.path(), "--start start.txt --time 1ms").status.success());
    let record = fs::read_to_string(folder.path().join("last-run.toml")).unwrap();
    assert_eq!(record.matches("[[disc]]").count(), 30);
}
