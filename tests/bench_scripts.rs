//! The scripts of `bench/` still run: with few discs and few steps, so that their numbers mean nothing.
#![cfg(unix)] // they are shell scripts

use std::path::Path;
use std::process::{Command, Output};

/// What comes of `script`, scaled down. Its files go into a temporary folder.
fn outcome(script: &str, arguments: &[&str]) -> Output {
    let work = tempfile::tempdir().unwrap();
    Command::new("sh")
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("bench").join(script))
        .arg(env!("CARGO_BIN_EXE_parsim2d"))
        .args(arguments)
        .env("PARSIM2D_BENCH_SCALE", "0.01")
        .env("PARSIM2D_BENCH_RUNS", "2")
        .env("PARSIM2D_BENCH_WORK", work.path())
        .output()
        .unwrap()
}

/// What `script` prints.
fn printed(script: &str, arguments: &[&str]) -> String {
    let output = outcome(script, arguments);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{script}: {errors}");
    String::from_utf8(output.stdout).unwrap()
}

/// The rows of the table that `text` holds below its head, each a list of cells.
fn rows(text: &str, head: &str) -> Vec<Vec<String>> {
    let below = text.lines().skip_while(|line| !line.starts_with(head));
    below.skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

#[test]
fn the_bench_runs_every_scene_and_says_speed_memory_and_state() {
    let scenes = [
        "guide-20",
        "dense-1000",
        "bed-20k-no-ledger",
        "polydisperse-20k",
        "gas-100k",
        "cluster-16k",
        "far-20k",
        "giant-100k",
        "bed-1m",
    ];
    let text = printed("run.sh", &scenes);
    let rows = rows(&text, "scene,n,steps,threads,");
    for scene in scenes {
        let row = rows.iter().find(|row| row[0] == scene).unwrap_or_else(|| panic!("{text}"));
        let speed: f64 = row[4].parse().unwrap();
        let nanoseconds: f64 = row[5].parse().unwrap();
        // Written with three digits and one decimal: 0.05 ns of some 10, and half a per cent.
        assert!((speed * nanoseconds * 1e-9 - 1.0).abs() < 0.02, "{row:?}");
        assert_eq!(row[8].len(), 16, "no state hash: {row:?}");
        if cfg!(target_os = "linux") {
            assert!(row[6].parse::<f64>().unwrap() > 1.0, "no memory: {row:?}");
        }
    }
}

#[test]
fn an_unknown_scene_is_refused_with_the_names_of_the_known() {
    for unknown in ["guide", "bed-20k-no", "-no-ledger"] {
        let output = outcome("run.sh", &["guide-20", unknown]);
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{message}");
        for part in [&format!("there is no scene {unknown}\n"), "way out", "gas-100k"] {
            assert!(message.contains(part), "{part:?} is not in\n{message}");
        }
    }
}

#[test]
fn make_takes_the_program_from_where_cargo_builds() {
    let make = |target: Option<&str>| {
        let mut make = Command::new("make");
        make.args(["--dry-run", "--always-make", "parSim2D"]);
        make.current_dir(env!("CARGO_MANIFEST_DIR")).env_remove("CARGO_TARGET_DIR");
        if let Some(target) = target {
            make.env("CARGO_TARGET_DIR", target);
        }
        make.output().ok().map(|output| String::from_utf8(output.stdout).unwrap())
    };
    for (target, from) in [(None, "cp target/release/"), (Some("/else"), "cp /else/release/")] {
        let Some(said) = make(target) else { return }; // there is no make
        assert!(said.contains(from), "{said}");
    }
}

#[test]
fn the_costs_of_ledger_frames_and_bar_are_measured() {
    if Command::new("timeout").arg("--version").output().is_err() {
        return; // not everywhere; `make costs` says so there
    }
    let text = printed("costs.sh", &[]);
    let rows = rows(&text, "what,scene,n,");
    for what in ["ledger", "live-frames", "trajectory"] {
        let row = rows.iter().find(|row| row[0] == what).unwrap_or_else(|| panic!("{text}"));
        assert!(row[3].parse::<f64>().unwrap() > 0.0 && row[4].parse::<f64>().is_ok(), "{row:?}");
    }
}

#[test]
fn speedup_over_threads_is_measured_where_there_are_threads() {
    let output = outcome("scaling.sh", &["dense-1000"]);
    if output.status.code() == Some(2) {
        let errors = String::from_utf8_lossy(&output.stderr);
        return assert!(errors.contains("has no --threads"), "{errors}");
    }
    let text = String::from_utf8(output.stdout).unwrap();
    let rows = rows(&text, "scene,n,threads,");
    let [_, _, threads, _, speedup, .., efficiency, same_bits] = &rows[0][..] else {
        panic!("{text}")
    };
    // One thread beside itself.
    let beside_itself = [threads, speedup, efficiency].map(|cell| cell.parse::<f64>().unwrap());
    assert_eq!(beside_itself, [1.0; 3], "{text}");
    assert_eq!(same_bits, "yes", "{text}");
}

#[test]
fn lammps_where_it_is_installed_does_the_same_as_we_do() {
    if Command::new("lmp").arg("-h").output().is_err() {
        eprintln!("no LAMMPS here: nothing to compare with");
        return;
    }
    let output = outcome("peers/run.sh", &["bed-20k"]);
    let (text, said) =
        (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert!(output.status.success(), "{said}");
    assert!(text.contains("\nbed-20k,"), "{text}");
    let line = said.lines().find(|line| line.contains("kinetic energy")).unwrap();
    let numbers: Vec<f64> = line.split(' ').filter_map(|word| word.parse().ok()).collect();
    let [_, kinetic, theirs, height, their_height] = numbers[..] else { panic!("{line}") };
    // Velocity Verlet begins with half a kick where Eq. (3) has a whole one: velocities differ by half a step
    // in 20 at the most. Heights are those of discs that have moved by far less than a millionth of the bed's.
    assert!((kinetic / theirs - 1.0).abs() < 0.05, "{line}");
    assert!((height / their_height - 1.0).abs() < 1e-6, "{line}");
}
