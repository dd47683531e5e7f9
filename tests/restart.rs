//! Runs that are killed, interrupted or prolonged end with the bytes of a run that never was.
//!
//! `PARSIM2D_KILLS=200 cargo test --test restart killed` kills as often as that; `make kill-test` does.
#![cfg(unix)] // signals

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use parsim2d::output::checkpoint::{Checkpoint, FILE, PREVIOUS};
use serde_json::Value;
use tempfile::TempDir;

fn parsim2d(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_parsim2d"));
    command.current_dir(folder).args(arguments.split_whitespace());
    command
}

fn outcome(folder: &Path, arguments: &str) -> Output {
    parsim2d(folder, arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Every file of a folder but checkpoints.
fn files(folder: &Path) -> BTreeMap<String, String> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries
        .filter(|path| path.extension().is_none_or(|extension| extension != "ckpt"))
        .map(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            (name, fs::read_to_string(path).unwrap())
        })
        .collect()
}

/// The same bytes in every file, and the same files; says where they differ and not all they hold.
fn assert_same(folder: &Path, reference: &Path, what: &str) {
    let (these, those) = (files(folder), files(reference));
    let names = |files: &BTreeMap<String, String>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&these), names(&those), "{what}");
    for (name, text) in &those {
        let pairs = text.lines().zip(these[name].lines()).enumerate();
        if let Some((line, (this, that))) = pairs.into_iter().find(|(_, (a, b))| a != b) {
            panic!("{what}: {name}, line {}: {that:?}, not {this:?}", line + 1);
        }
        assert_eq!(text.len(), these[name].len(), "{what}: {name} is longer or shorter");
    }
}

/// A finished run in a folder of its own, with its summary.
fn reference(arguments: &str) -> (TempDir, Value) {
    let folder = tempfile::tempdir().unwrap();
    let output = outcome(folder.path(), arguments);
    (folder, summary(&output))
}

/// The summary without what depends on the machine.
fn summary(output: &Output) -> Value {
    let mut summary: Value = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|_| panic!("no summary: {}{}", text(&output.stdout), text(&output.stderr)));
    for key in ["wall_s", "particle_steps_per_s"] {
        summary.as_object_mut().unwrap().remove(key).unwrap();
    }
    summary
}

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
    let output = outcome(folder.path(), "resume");
    assert!(output.status.success() && text(&output.stderr).contains("nothing is left to do"));
    assert_same(folder.path(), whole.path(), "nothing left to do");
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
    fs::write(folder.path().join("parsim2d.mine.txt"), "mine").unwrap();
    assert!(outcome(folder.path(), "-n 2 --time 1ms -q").status.success());
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

/// A folder with a finished run of two checkpoints.
fn with_two_checkpoints() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let case = "-n 100 --radius 5e-4 --seed 2 --time 0.1 -q --checkpoint-every 1ms";
    assert!(outcome(folder.path(), case).status.success());
    folder
}

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
