//! The program as a person meets it: messages, exit codes, signals, help.
#![allow(clippy::too_many_lines)] // tables of cases

use std::fs;
use std::path::Path;
use std::process::{Output, Stdio};
use std::time::Duration;

use assert_cmd::Command;
use tempfile::TempDir;

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("parsim2d").unwrap();
    command.current_dir(folder).args(arguments);
    command
}

fn outcome(arguments: &[&str]) -> (Output, TempDir) {
    let folder = tempfile::tempdir().unwrap();
    let output = command(folder.path(), arguments).output().unwrap();
    (output, folder)
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn the_summary_says_what_was_run() {
    let (output, _folder) = outcome(&["-n", "5", "--time", "10ms", "--seed", "42"]);
    assert!(output.status.success());
    let summary = text(&output.stdout);
    for part in [
        "5 discs, preset guide, seed 42",
        "8.8858e-6 s (Eq. (2), N_t = 50 set by the preset), symplectic-euler",
        "1125 steps to t = 0.009996 s",
        "million particle-steps/s",
        "J at start",
        "J at end",
        "overlap  at most",
        "state    ",
    ] {
        assert!(summary.contains(part), "{part:?} is not in\n{summary}");
    }
}

#[test]
fn json_has_every_promised_key() {
    let (output, _folder) = outcome(&["-n", "5", "--time", "1ms", "--seed", "42", "--json"]);
    let summary: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    for key in [
        "seed",
        "n",
        "preset",
        "dt_s",
        "dt_set_by",
        "steps",
        "time_s",
        "wall_s",
        "threads",
        "particle_steps_per_s",
        "energy_start_J",
        "energy_end_J",
        "max_overlap_over_r",
        "state_hash",
    ] {
        assert!(!summary[key].is_null(), "{key} is missing in {summary}");
    }
    assert_eq!(summary["seed"], 42);
    assert_eq!(summary["dt_set_by"], "preset");
    if cfg!(target_os = "linux") {
        // The program's own text alone is more than 1 MB; five discs need next to nothing.
        let peak = summary["peak_memory_MB"].as_f64().unwrap();
        assert!((1.0..100.0).contains(&peak), "{peak} MB");
    }
    assert_eq!(summary["state_hash"].as_str().unwrap().len(), 16);
}

#[test]
fn dt_set_by_names_who_set_the_time_step() {
    for (arguments, set_by, dt) in [
        (&["--nt", "100"][..], "nt", 4.44288e-6),
        (&["--dt", "1us"], "dt", 1e-6),
        // 0.08 * 2 / sqrt(6.1 * 5e7 1/s2), a hair less for the damping
        (&["--dt", "auto"], "auto", 9.15918e-6),
        (&[], "preset", 8.88577e-6),
    ] {
        let more = ["-n", "5", "--time", "1ms", "--json", "-q"];
        let (output, _folder) = outcome(&[arguments, &more].concat());
        let summary: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(summary["dt_set_by"], set_by);
        let ratio = summary["dt_s"].as_f64().unwrap() / dt;
        assert!((ratio - 1.0).abs() < 1e-4, "{set_by}: {ratio}"); // digits quoted above
    }
}

#[test]
fn the_seed_that_is_printed_repeats_the_run() {
    let (output, _folder) = outcome(&["-n", "5", "--time", "1ms", "--json"]);
    let first: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let seed = first["seed"].to_string();
    let (output, _folder) = outcome(&["-n", "5", "--time", "1ms", "--json", "--seed", &seed]);
    let second: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(first["state_hash"], second["state_hash"]);
}

#[test]
fn a_run_without_terminal_prints_no_progress_bar_and_quiet_prints_nothing() {
    let (output, _folder) = outcome(&["-n", "5", "--time", "1ms"]);
    let notes = text(&output.stderr);
    assert!(notes.contains("drawn; --seed"), "{notes}");
    assert!(notes.lines().all(|line| line.starts_with("note: ")), "{notes}");
    let (output, _folder) = outcome(&["-n", "5", "--time", "1ms", "-q"]);
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
}

#[test]
fn the_guides_own_run_has_one_line_of_notes_and_check_has_the_rest() {
    for arguments in [&["--time", "0"][..], &["-n", "1", "--time", "0"], &["--seed", "1"]] {
        let (output, _folder) = outcome(arguments);
        let (notes, summary) = (text(&output.stderr), text(&output.stdout));
        assert_eq!(notes.lines().count(), 1, "{arguments:?}: {notes}");
        for said in
            ["eta_n = 1.5e-3 kg/s for the guide's printed 1.5e3", "soft", "`parsim2d check`"]
        {
            assert!(notes.contains(said), "{arguments:?}: {notes}");
        }
        assert!(!summary.contains("soft") && !summary.contains("try"), "{summary}");
    }
    let (output, _folder) = outcome(&["check"]);
    let said = text(&output.stdout);
    assert!(said.contains("the damping: eta_n = 1.5e-3 kg/s (the guide prints"), "{said}");
    assert!(said.contains("1.25 r deep, set by --kn = 5e4; use --radius 5e-4"), "{said}");
    // Discs that have passed through each other are told of after the run, too.
    let (output, _folder) = outcome(&["-n", "1000", "--seed", "1", "--time", "0.1"]);
    let said = text(&output.stdout);
    assert!(said.contains("overlap  at most 2.11 r: more than half a radius"), "{said}");
}

#[test]
fn bad_usage_ends_with_2_a_reason_and_nothing_written() {
    for (arguments, reason) in [
        (&["-n", "0"][..], "n = 0 is not possible"),
        (&["-n", "-5"], "n = -5 is not possible"),
        (&["--radius", "nan"], "radius = NaN is not possible"),
        (&["--side", "-1"], "side = -1 is not possible"),
        (&["--mass", "inf"], "mass = inf is not possible"),
        (&["--radius", "0.1"], "0.1 mm is 1e-4 m"),
        (&["--nt", "0.9"], "nt = 0.9 is not possible"),
        (&["--eta", "-1"], "eta = -1 is not possible"),
        (&["--eta", "1", "--gamma", "1"], "cannot be used with"),
        (&["--nt", "50", "--dt", "auto"], "cannot be used with"),
        (&["--preset", "guidd"], "guide-listing"),
        (&["--dtt", "1"], "--dt"),
        (&["--eta", "1.5e3"], "the parameter at fault: --eta = 1500"),
        (&["-n", "1000", "--radius", "5.6e-4"], "way out: --placement lattice"),
        (&["no_such.toml"], "cannot read the scenario no_such.toml"),
        (&["preset"], "nor a scenario file; did you mean `presets`?"),
        (&["--slowdown", "0"], "slowdown = 0 is not possible"),
        (&["--every", "0"], "every = 0 is not possible"),
        (&["--time", "-1"], "time = -1 is not possible"),
        (&["-n", "1.5"], "not a whole number"),
        (&["-n", "100000000"], "packing fraction 1963"),
        (&["--side", "-4cm"], "side = -0.04 is not possible"),
        (&["--radius", "1,5e-4"], "write a dot, not a comma"),
        (&["--start", "no_such.txt:abc"], "K is a whole number from 0"),
        (&["--out-dir", "out.txt"], "it is a file"),
        (&["--start", "no_such.txt"], "cannot start from no_such.txt"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("out.txt"), "precious").unwrap();
        let output = command(folder.path(), arguments).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let message = text(&output.stderr);
        assert!(message.contains(reason), "{arguments:?}: {reason:?} is not in\n{message}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "{arguments:?} wrote a file");
        assert_eq!(fs::read_to_string(folder.path().join("out.txt")).unwrap(), "precious");
    }
}

#[test]
fn a_folder_that_is_a_file_is_found_before_the_first_step() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("file"), "").unwrap();
    for out_dir in ["file", "file/below"] {
        let output = command(folder.path(), &["--out-dir", out_dir]).output().unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains(out_dir));
    }
    // A folder that is not there is made.
    let output =
        command(folder.path(), &["--out-dir", "new/deep", "--time", "0"]).output().unwrap();
    assert!(output.status.success());
    assert!(folder.path().join("new/deep/out.txt").exists());
}

#[test]
fn a_checkpoint_of_another_version_is_not_made_useless() {
    for (content, format) in
        [("parsim2d checkpoint 7\n...", "another version (format 7)"), ("", "it is empty")]
    {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("parsim2d.ckpt"), content).unwrap();
        fs::write(folder.path().join("model.ckpt"), "of another program").unwrap();
        let output = command(folder.path(), &["--time", "1ms"]).output().unwrap();
        assert_eq!(output.status.code(), Some(2));
        let message = text(&output.stderr);
        assert!(message.contains(format) && message.contains("way out"), "{message}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2, "something was written");
        fs::remove_file(folder.path().join("parsim2d.ckpt")).unwrap();
        assert!(command(folder.path(), &["--time", "1ms"]).output().unwrap().status.success());
    }
}

#[test]
fn print_config_is_a_scenario_that_reproduces_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| {
        let output = command(folder.path(), arguments).output().unwrap();
        assert!(output.status.success(), "{}", text(&output.stderr));
        let files = ["out.txt", "trajectory.txt", "energy.csv"]
            .map(|name| fs::read(folder.path().join(name)).unwrap_or_default());
        (text(&output.stdout), files)
    };
    for arguments in [
        &["-n", "10", "--radius", "4e-4", "--time", "20ms"][..],
        &["-n", "10", "--restitution", "0.7", "--no-tension", "--dt", "auto", "--time", "20ms"],
        &["--preset", "guide-mass-scaled", "--gravity", "-3", "--time", "20ms", "--speed", "0.2"],
        &["--preset", "guide-printed", "--time", "0.1ms", "--integrator", "velocity-verlet"],
        &[
            "--gamma",
            "21/s",
            "--kn",
            "60 kN/m",
            "--gravity",
            "-9.81m/s2",
            "--time",
            "1e1 ms",
            "-n",
            "1e1",
        ],
    ] {
        let (config, _) = run(&[arguments, &["--print-config", "--seed", "8"]].concat());
        fs::write(folder.path().join("again.toml"), config).unwrap();
        let (_, first) = run(&[arguments, &["--seed", "8"]].concat());
        let (_, second) = run(&["run", "again.toml"]);
        assert_eq!(first, second, "{arguments:?}");
        let (config, _) = run(&["again.toml", "--print-config"]);
        assert_eq!(config, fs::read_to_string(folder.path().join("again.toml")).unwrap());
    }
}

#[test]
fn a_reader_that_leaves_early_is_no_failure() {
    let folder = tempfile::tempdir().unwrap();
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_parsim2d"))
        .args(["-n", "2", "--time", "1ms"])
        .current_dir(&folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take()); // the reader is gone before the summary
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{:?}", output.status);
    assert!(!text(&output.stderr).contains("panicked"));
}

#[test]
fn help_names_units_and_defaults() {
    let (output, _folder) = outcome(&["-h"]);
    let help = text(&output.stdout);
    for part in ["k_n [default: 5e4]", "<N/M>", "eta_n [default: 1.5e-3]", "<KG/S>", "Eq. (2)"] {
        assert!(help.contains(part), "{part:?} is not in\n{help}");
    }
}

#[test]
fn doctor_finds_what_is_on_the_path_and_says_what_is_missing() {
    let empty = tempfile::tempdir().unwrap();
    let doctor = |path: &std::path::Path| {
        let mut command = Command::cargo_bin("parsim2d").unwrap();
        let output = command.current_dir(&empty).env("PATH", path).arg("doctor").output().unwrap();
        assert!(output.status.success());
        text(&output.stdout)
    };
    let without = doctor(empty.path());
    for name in ["gnuplot", "ffmpeg", "bwrap"] {
        assert!(without.lines().any(|line| line.starts_with(name) && line.ends_with("not found")));
    }
    assert_eq!(fs::read_dir(&empty).unwrap().count(), 0, "the trial file is gone");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let tools = tempfile::tempdir().unwrap();
        let gnuplot = tools.path().join("gnuplot");
        fs::write(&gnuplot, "#!/bin/sh\necho gnuplot 9.9 patchlevel 0\n").unwrap();
        fs::set_permissions(&gnuplot, fs::Permissions::from_mode(0o755)).unwrap();
        let with = doctor(tools.path());
        assert!(with.contains("gnuplot  gnuplot 9.9 patchlevel 0, "), "{with}");
    }
}

#[test]
fn presets_are_listed_with_their_numbers() {
    let (output, _folder) = outcome(&["presets"]);
    let list = text(&output.stdout);
    for name in ["guide ", "guide-listing", "guide-printed", "guide-mass-scaled"] {
        assert!(list.lines().any(|line| line.starts_with(name)), "{name} is not in\n{list}");
    }
}

#[test]
fn an_unstable_run_asked_for_ends_and_says_so() {
    let arguments = ["--eta", "1.5e3", "--allow-unstable", "-n", "50", "--time", "50ms", "--json"];
    let (output, _folder) = outcome(&arguments);
    assert!(output.status.success());
    assert!(text(&output.stderr).contains("unstable on purpose"));
    let summary: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(summary["state_hash"].is_string(), "{summary}");
    let arguments = ["--eta", "1.5e3", "--allow-unstable", "-n", "50", "--time", "50ms"];
    let (output, _folder) = outcome(&arguments);
    let summary = text(&output.stdout);
    assert!(summary.contains("the numbers have overflowed"), "{summary}");
    assert!(!summary.contains("try --"), "{summary}");
}

#[test]
fn slowdown_takes_its_seconds_and_every_rules_out_txt() {
    let arguments = ["-n", "3", "--time", "20ms", "--slowdown", "25", "--json", "--seed", "1"];
    let (output, _folder) = outcome(&arguments);
    let summary: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let wall = summary["wall_s"].as_f64().unwrap();
    assert!((0.49..1.5).contains(&wall), "{wall}"); // 20 ms times 25, and a busy machine

    let folder = tempfile::tempdir().unwrap();
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_parsim2d"))
        .args(["-n", "3", "--slowdown", "20", "--every", "700", "-q", "--seed", "1"])
        .current_dir(&folder)
        .spawn()
        .unwrap();
    let mut steps = std::collections::BTreeSet::new();
    for _ in 0..100 {
        std::thread::sleep(Duration::from_millis(10));
        let text = fs::read_to_string(folder.path().join("out.txt")).unwrap_or_default();
        steps.extend(text.split_whitespace().nth(2).and_then(|step| step.parse::<u64>().ok()));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(steps.len() > 2 && steps.iter().all(|step| step % 700 == 0), "{steps:?}");
}

#[cfg(unix)]
mod signals {
    use super::*;
    use crate::support::heeding;

    /// Starts a run that would last minutes, and sends it `signal` after `delay`.
    fn interrupted(signal: &str, delay: Duration) -> (Output, TempDir) {
        let folder = tempfile::tempdir().unwrap();
        let child = heeding(env!("CARGO_BIN_EXE_parsim2d"))
            .args(["-n", "20", "--time", "100", "--slowdown", "3", "--seed", "1", "--json"])
            .args(["--every", "100", "--energy-every", "100"])
            .current_dir(&folder)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let begun = std::time::Instant::now();
        while !folder.path().join("out.txt").exists() {
            assert!(begun.elapsed() < Duration::from_secs(20), "the run does not start");
            std::thread::sleep(Duration::from_millis(10));
        }
        std::thread::sleep(delay);
        let id = child.id().to_string();
        assert!(std::process::Command::new("kill").args([signal, &id]).status().unwrap().success());
        (child.wait_with_output().unwrap(), folder)
    }

    #[test]
    fn an_interrupted_run_ends_with_130_and_complete_files() {
        for (signal, delay) in [("-INT", 300), ("-TERM", 150), ("-HUP", 700)] {
            let (output, folder) = interrupted(signal, Duration::from_millis(delay));
            assert_eq!(output.status.code(), Some(130), "{}", text(&output.stderr));
            let summary: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
            assert_eq!(summary["interrupted"], true);
            let step = summary["steps"].as_u64().unwrap();
            assert!(step > 0);
            let read = |name| fs::read_to_string(folder.path().join(name)).unwrap();
            // Every file ends with the last step, every frame has its 20 rows.
            let out = read("out.txt");
            assert!(out.starts_with(&format!("# step {step} ")), "{out}");
            assert_eq!(out.lines().count(), 21);
            let trajectory = read("trajectory.txt");
            let frames: Vec<&str> = trajectory.split("\n\n\n").collect();
            assert!(frames.iter().all(|frame| frame.trim_end().lines().count() == 21));
            assert!(frames.last().unwrap().starts_with(&format!("# step {step} ")));
            let energy = read("energy.csv");
            assert!(energy.lines().last().unwrap().starts_with(&format!("{step},")), "{energy}");
            assert!(energy.ends_with('\n'));
            assert!(read("last-run.toml").contains("# result: interrupted = true"));
            assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 5); // and a checkpoint
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_run_under_nohup_goes_on_when_the_terminal_closes() {
        let folder = tempfile::tempdir().unwrap();
        let mut child = heeding("nohup")
            .args([env!("CARGO_BIN_EXE_parsim2d"), "-n", "20", "--time", "100", "--slowdown", "3"])
            .current_dir(&folder)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        while !folder.path().join("out.txt").exists() {
            assert!(child.try_wait().unwrap().is_none(), "the run does not start");
            std::thread::sleep(Duration::from_millis(10));
        }
        let id = child.id().to_string();
        let send = |signal: &str| {
            assert!(
                std::process::Command::new("kill").args([signal, &id]).status().unwrap().success()
            );
            std::thread::sleep(Duration::from_millis(500)); // it ends in some 20 ms if it heeds it
        };
        send("-HUP");
        assert!(child.try_wait().unwrap().is_none(), "SIGHUP was to be ignored");
        send("-TERM");
        assert_eq!(child.wait_with_output().unwrap().status.code(), Some(130));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_signal_sent_twice_at_once_still_leaves_complete_files() {
        // timeout(1) sends its signal to the process and to its group.
        let folder = tempfile::tempdir().unwrap();
        let output = heeding("timeout")
            .args(["0.4", env!("CARGO_BIN_EXE_parsim2d"), "--slowdown", "50", "--json"])
            .args(["--every", "10"])
            .current_dir(&folder)
            .output()
            .unwrap();
        let summary: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(summary["interrupted"], true);
        let out = fs::read_to_string(folder.path().join("out.txt")).unwrap();
        assert!(out.starts_with(&format!("# step {} ", summary["steps"])), "{out}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 5); // and a checkpoint
    }

    #[test]
    fn a_signal_during_the_first_frame_keeps_old_files_or_leaves_whole_ones() {
        for delay in [50, 150, 300, 500, 700] {
            let folder = tempfile::tempdir().unwrap();
            let names = ["out.txt", "trajectory.txt", "energy.csv"];
            for name in names {
                fs::write(folder.path().join(name), "precious").unwrap();
            }
            let child = heeding(env!("CARGO_BIN_EXE_parsim2d"))
                .args(["-n", "200000", "--radius", "1e-5", "-q"])
                .current_dir(&folder)
                .spawn()
                .unwrap();
            std::thread::sleep(Duration::from_millis(delay));
            let id = child.id().to_string();
            assert!(
                std::process::Command::new("kill").args(["-INT", &id]).status().unwrap().success()
            );
            let output = child.wait_with_output().unwrap();
            let out = fs::read_to_string(folder.path().join("out.txt")).unwrap();
            let kept = out == "precious";
            // On a busy machine the signal may come before the program listens, and ends it just so.
            let code = output.status.code();
            assert!(code == Some(130) || code.is_none() && kept, "{delay} ms: {code:?}");
            assert!(kept || out.lines().count() == 200_001, "{delay} ms: {}", out.lines().count());
            let files = if kept { 3 } else { 5 }; // and last-run.toml, and a checkpoint
            assert_eq!(fs::read_dir(folder.path()).unwrap().count(), files, "{delay} ms");
        }
    }

    #[test]
    fn a_full_disk_ends_the_run_with_1_and_the_path() {
        // Files above 64 kB (ulimit counts blocks of 1 kB in bash) fail to grow; the signal that
        // would kill the writer is ignored, so the write itself fails as on a full disk.
        let folder = tempfile::tempdir().unwrap();
        let script = format!(
            "trap '' XFSZ; ulimit -f 64; exec '{}' -n 100 --time 1 --seed 1 --every 10",
            env!("CARGO_BIN_EXE_parsim2d")
        );
        let output = std::process::Command::new("bash")
            .args(["-c", &script])
            .current_dir(&folder)
            .output()
            .unwrap();
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{message}");
        assert!(message.contains("writing ./trajectory.txt failed"), "{message}");
    }
}
