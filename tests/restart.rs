//! Runs that are killed, interrupted or prolonged end with the bytes of a run that never was.
//!
//! `PARSIM2D_KILLS=200 cargo test --test all restart::runs_killed` kills as often as that; `make kill-test` does.
#![cfg(unix)] // signals

use crate::support::runs;

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use parsim2d::output::checkpoint::{Checkpoint, FILE, PREVIOUS};
use runs::{assert_same, files, outcome, parsim2d, reference, summary, text, with_two_checkpoints};
use tempfile::TempDir;

fn wait_for(path: &Path) {
    let begun = Instant::now();
    while !path.exists() {
        assert!(begun.elapsed() < Duration::from_secs(20), "{} does not come", path.display());
        std::thread::sleep(Duration::from_millis(5));
    }
}

fn signal(child: &Child, name: &str) {
    let id = child.id().to_string();
    assert!(Command::new("kill").args([name, &id]).status().unwrap().success());
}

/// Starts a run so slow that it would last minutes and interrupts it after a moment.
fn interrupted(folder: &Path, arguments: &str, with: &str) -> Output {
    let slow = format!("{arguments} --slowdown 200");
    let mut command = parsim2d(folder, &slow);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    wait_for(&folder.join("out.txt"));
    std::thread::sleep(Duration::from_millis(400)); // 2 ms of simulated time
    signal(&child, with);
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130), "{arguments}: {}", text(&output.stderr));
    output
}

const GO_ON: &str = "resume parsim2d.ckpt --slowdown 1e-6";

#[test]
fn an_interrupted_run_goes_on_to_the_same_bytes() {
    let cases = [
        "-n 30 --radius 5e-4 --seed 1 --time 20ms",
        "-n 150 --radius 5e-4 --seed 1 --time 20ms --integrator velocity-verlet --every 7 --border",
        "-n 30 --radius 5e-4 --seed 1 --time 20ms --integrator explicit-euler --energy-every 0",
        "-n 200 --radius 5e-4 --seed 1 --time 20ms --placement lattice --speed 0.3 --no-tension --threads 2",
        "-n 2 --radius 5e-4 --seed 1 --time 20ms --restitution 0.6 --dt auto --no-walls",
    ];
    for (case, with) in cases.into_iter().zip(["-INT", "-TERM"].into_iter().cycle()) {
        let folder = tempfile::tempdir().unwrap();
        // `--slowdown` is a word of the command; the last run.toml of both must say the same.
        let (whole, whole_summary) = reference(&format!("{case} --json --slowdown 1e-6"));
        let output = interrupted(folder.path(), &format!("{case} --json"), with);
        let message = text(&output.stderr);
        assert!(message.contains(": parsim2d resume parsim2d.ckpt\n"), "{message}");
        let step = summary(&output)["steps"].as_u64().unwrap();
        let resumed = outcome(folder.path(), GO_ON);
        assert!(resumed.status.success(), "{case}: {}", text(&resumed.stderr));
        assert!(text(&resumed.stderr).contains(&format!("going on from step {step} of ")));
        assert_eq!(summary(&resumed), whole_summary, "{case}");
        let record = folder.path().join("last-run.toml");
        let said = fs::read_to_string(&record).unwrap();
        fs::write(record, said.replace("--slowdown 200", "--slowdown 1e-6")).unwrap();
        assert_same(folder.path(), whole.path(), case);
        assert!(!folder.path().join(FILE).exists(), "a run that is done leaves no checkpoint");
    }
}

#[test]
fn a_start_file_and_tables_are_not_needed_to_go_on() {
    let start =
        "# step 0 time_s 0 n 2 side_m 0.03 columns x y r\n0.01 0.02 5e-4\n0.012 0.02 3e-4\n";
    let tables = "[[disc]]\nposition = [0.01, 0.01]\nvelocity = [0.3, 0.1]\n\
                  [[population]]\nn = 20\nradius = 4e-4\nspeed = 0.2\n";
    for said in ["--start start.txt --speed 0.3", "start.toml"] {
        let arguments = format!("{said} --seed 4 --time 20ms --json");
        let (folder, whole) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        for folder in [folder.path(), whole.path()] {
            fs::write(folder.join("start.txt"), start).unwrap();
            fs::write(folder.join("start.toml"), tables).unwrap();
        }
        let expected = summary(&outcome(whole.path(), &format!("{arguments} --slowdown 200e-9")));
        interrupted(folder.path(), &arguments, "-INT");
        for name in ["start.txt", "start.toml"] {
            fs::remove_file(folder.path().join(name)).unwrap();
            fs::remove_file(whole.path().join(name)).unwrap();
        }
        assert_eq!(summary(&outcome(folder.path(), GO_ON)), expected, "{said}");
        let record = whole.path().join("last-run.toml");
        let said = fs::read_to_string(&record).unwrap();
        fs::write(record, said.replace("--slowdown 200e-9", "--slowdown 200")).unwrap();
        assert_same(folder.path(), whole.path(), &arguments);
    }
}

/// What else may be said of how a run is computed; none of it may change a bit. One entry a thread count.
const COMPUTED: [&str; 2] = ["--threads 1", "--threads 2"];

/// Each case, computed in each way, with the folder of a run that was never killed.
fn finished(cases: &[&str]) -> Vec<(String, TempDir)> {
    let cases = cases.iter().flat_map(|case| COMPUTED.map(|how| format!("{case} {how}")));
    let run = |case: String| {
        let folder = tempfile::tempdir().unwrap();
        assert!(outcome(folder.path(), &case).status.success());
        (case, folder)
    };
    cases.map(run).collect()
}

#[test]
fn runs_killed_at_any_moment_end_in_the_bytes_of_a_run_never_killed() {
    let kills = std::env::var("PARSIM2D_KILLS").map_or(6, |count| count.parse().unwrap());
    let cases = [
        "-n 150 --radius 5e-4 --seed 3 --time 0.3 -q",
        "-n 60 --radius 5e-4 --seed 3 --time 0.5 -q --every 50 --energy-every 3",
        "-n 300 --radius 5e-4 --seed 3 --time 0.1 -q --integrator velocity-verlet",
    ];
    let cases = finished(&cases);
    let (mut killed, mut resumed, mut runs, mut dice) = (0, 0, 0, 2019_u64);
    while killed < kills {
        let (case, whole) = &cases[runs % cases.len()];
        runs += 1;
        let folder = tempfile::tempdir().unwrap();
        loop {
            let goes_on = [FILE, PREVIOUS].iter().any(|name| folder.path().join(name).exists());
            let arguments = match goes_on {
                true => "resume -q".to_owned(),
                false => format!("{case} --checkpoint-every 10ms"),
            };
            let mut child = parsim2d(folder.path(), &arguments).spawn().unwrap();
            resumed += u64::from(goes_on);
            // Knuth's generator; the moment is random in any case.
            dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            std::thread::sleep(Duration::from_micros((dice >> 33) % 300_000));
            if killed < kills {
                let _ = child.kill(); // it may have ended
            }
            let status = child.wait().unwrap();
            if status.success() {
                break;
            }
            assert_eq!(status.code(), None, "{arguments} failed after {killed} kills");
            killed += 1;
        }
        assert_same(folder.path(), whole.path(), &format!("{case} after {killed} kills"));
    }
    println!("{killed} kills, {resumed} resumes, {runs} runs");
    assert!(resumed * 4 > killed, "{resumed} of {killed} were resumed: too few to test anything");
}

#[test]
fn a_prolonged_run_that_is_killed_at_once_goes_on_to_its_new_end() {
    let case = "-n 30 --radius 5e-4 --seed 1 --time 20ms -q --every 50 --energy-every 50";
    let (whole, _) = {
        let case = case.replace("20ms -q", "0.04 --json");
        reference(&format!("{case} --checkpoint-every 1h"))
    };
    for with in ["--checkpoint-every 1h", ""] {
        let folder = tempfile::tempdir().unwrap();
        match with {
            "" => drop(interrupted(folder.path(), case, "-INT")),
            _ => assert!(outcome(folder.path(), &format!("{case} {with}")).status.success()),
        }
        let before = fs::read(folder.path().join(FILE)).unwrap();
        let mut child =
            parsim2d(folder.path(), "resume --time 40ms --slowdown 200").spawn().unwrap();
        let begun = Instant::now();
        while fs::read(folder.path().join(FILE)).unwrap() == before {
            assert!(begun.elapsed() < Duration::from_secs(20), "the new end is not kept");
            std::thread::sleep(Duration::from_millis(5));
        }
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(outcome(folder.path(), "resume --slowdown 1e-6").status.success());
        for name in ["out.txt", "trajectory.txt", "energy.csv"] {
            let read = |folder: &TempDir| fs::read_to_string(folder.path().join(name)).unwrap();
            assert!(read(&folder) == read(&whole), "{name} {with}");
        }
    }
}

#[test]
fn a_run_is_prolonged_to_the_bytes_of_the_longer_run() {
    let short = "-n 30 --radius 5e-4 --seed 1 --json";
    let folder = tempfile::tempdir().unwrap();
    let output = outcome(folder.path(), &format!("{short} --time 15.1ms --checkpoint-every 1min"));
    assert!(output.status.success());
    let written = Checkpoint::read(&folder.path().join(FILE)).unwrap().progress.written;
    assert!(written.frame_every > 1 && written.frame_at < 1699, "the last frame is an extra one");
    let (every, energy_every) = (written.frame_every, written.energy_every);
    let (whole, expected) =
        reference(&format!("{short} --every {every} --energy-every {energy_every} --time 0.04"));
    let output = outcome(folder.path(), "resume --time 40ms");
    assert_eq!(summary(&output), expected);
    assert_same(folder.path(), whole.path(), "prolonged");
    // It was asked for checkpoints and can be prolonged again; a shorter time is refused.
    let output = outcome(folder.path(), "resume --time 30ms");
    assert_eq!(output.status.code(), Some(2));
    let message = text(&output.stderr);
    assert!(message.contains("--time = 0.03 s is before") && message.contains("way out"));
    assert_same(folder.path(), whole.path(), "after a refusal");
    for again in ["resume", "resume --time 40ms"] {
        let output = outcome(folder.path(), again);
        assert!(output.status.success() && text(&output.stderr).contains("nothing is left to do"));
        assert_same(folder.path(), whole.path(), again);
    }
}

#[test]
fn checkpoints_change_nothing_and_go_with_the_next_run() {
    let case = "-n 100 --radius 5e-4 --seed 2 --time 0.1 --json";
    let (whole, expected) = reference(case);
    let folder = tempfile::tempdir().unwrap();
    let output = outcome(folder.path(), &format!("{case} --checkpoint-every 1ms"));
    assert_eq!(summary(&output), expected);
    assert_same(folder.path(), whole.path(), "with checkpoints");
    for name in [FILE, PREVIOUS] {
        assert!(Checkpoint::read(&folder.path().join(name)).is_ok(), "{name}");
    }
    // Refused before it began: they stay. Begun: they go.
    assert_eq!(outcome(folder.path(), "--nt 0").status.code(), Some(2));
    assert!(folder.path().join(FILE).exists());
    // This one goes wrong: it does not tidy up at its end.
    let wrong = "-n 20 --seed 1 --integrator explicit-euler --time 1 --speed 0.5 -q";
    assert_eq!(outcome(folder.path(), wrong).status.code(), Some(1));
    assert!(!folder.path().join(FILE).exists() && !folder.path().join(PREVIOUS).exists());
}

#[test]
fn a_run_goes_on_in_another_folder_and_leaves_the_first_as_it_is() {
    let case = "-n 30 --radius 5e-4 --seed 1 --time 20ms --json";
    let (whole, expected) = reference(&format!("{case} --slowdown 1e-6"));
    let folder = tempfile::tempdir().unwrap();
    interrupted(folder.path(), case, "-INT");
    let (before, checkpoint) = (files(folder.path()), fs::read(folder.path().join(FILE)).unwrap());
    let output = outcome(folder.path(), &format!("{GO_ON} --out-dir other/deep"));
    assert_eq!(summary(&output), expected);
    let other = folder.path().join("other/deep");
    let record = fs::read_to_string(other.join("last-run.toml")).unwrap();
    fs::write(other.join("last-run.toml"), record.replace("--slowdown 200", "--slowdown 1e-6"))
        .unwrap();
    assert_same(&other, whole.path(), "in another folder");
    fs::remove_dir_all(folder.path().join("other")).unwrap();
    assert_eq!(files(folder.path()), before);
    assert_eq!(fs::read(folder.path().join(FILE)).unwrap(), checkpoint);
}

#[test]
fn a_run_that_goes_wrong_after_a_restart_stops_at_the_same_step_with_the_same_files() {
    // Explicit Euler gains energy at every bounce; with --allow-unstable it goes on.
    let case = "-n 20 --seed 1 --integrator explicit-euler --time 1 --speed 0.5";
    for more in ["", "--allow-unstable"] {
        let arguments = format!("{case} {more} --json");
        let whole = tempfile::tempdir().unwrap();
        let output = outcome(whole.path(), &format!("{arguments} --slowdown 1e-6"));
        let wrong_at = summary(&output)["went_wrong_at_step"].as_u64().expect("it goes wrong");
        let folder = tempfile::tempdir().unwrap();
        interrupted(folder.path(), &arguments, "-INT");
        let resumed = outcome(folder.path(), &format!("{GO_ON} --checkpoint-every 1ms"));
        assert_eq!(resumed.status.code(), output.status.code());
        assert_eq!(summary(&resumed), summary(&output));
        let record = folder.path().join("last-run.toml");
        let said = fs::read_to_string(&record).unwrap();
        fs::write(record, said.replace("--slowdown 200", "--slowdown 1e-6")).unwrap();
        assert_same(folder.path(), whole.path(), &arguments);
        let kept = Checkpoint::read(&folder.path().join(FILE)).unwrap().progress.step;
        assert!(kept < wrong_at, "a checkpoint of step {kept}, wrong at {wrong_at}");
    }
}

#[test]
fn a_run_may_go_on_to_an_earlier_end_than_it_once_had() {
    let folder = with_two_checkpoints();
    let Checkpoint { progress, .. } = Checkpoint::read(&folder.path().join(PREVIOUS)).unwrap();
    let time = 0.5 * (progress.time_s + 0.1);
    let (every, energy_every) = (progress.written.frame_every, progress.written.energy_every);
    let whole = tempfile::tempdir().unwrap();
    let case = format!(
        "-n 100 --radius 5e-4 --seed 2 -q --every {every} --energy-every {energy_every} --time {time:?}"
    );
    assert!(outcome(whole.path(), &case).status.success());
    let output = outcome(folder.path(), &format!("resume parsim2d.previous.ckpt --time {time:?}"));
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert_same(folder.path(), whole.path(), "what was written past the new end is gone");
}
