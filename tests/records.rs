//! The record of a run, `last-run.toml`: it describes its own run or nothing, and goes with any flag.
#![allow(clippy::too_many_lines)] // tables of cases

use std::fs;
use std::path::Path;

use crate::support::runs::{outcome, parsim2d, text};
use parsim2d::output::recorder::Recorder;
use parsim2d::scenario::Scenario;
use tempfile::TempDir;

const RECORD: &str = "last-run.toml";

/// A folder with a short run.
fn run(arguments: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let output = outcome(folder.path(), arguments);
    assert!(output.status.success(), "{}", text(&output.stderr));
    folder
}

fn record(folder: &Path) -> String {
    fs::read_to_string(folder.join(RECORD)).unwrap()
}

#[test]
fn a_record_that_is_not_of_the_run_makes_no_report() {
    let arguments = "-n 5 --radius 5e-4 --seed 1 --time 5ms -q";
    let whole = run(arguments);
    let own = record(whole.path());
    let of = |arguments: &str| record(run(&format!("{arguments} -q")).path());
    let head = own.lines().next().unwrap().to_owned() + "\n";
    for (text_of_record, why) in [
        (String::new(), "it is empty"),
        ("\n".to_owned(), "it is empty"),
        ("n = 5\nradius = 5e-4\n".to_owned(), "no run of parsim2d wrote it"),
        (head, "it is cut off"),
        (own.replace("kn = 50000.0", "# kn"), "it is cut off, or was changed"),
        (of("-n 6 --radius 5e-4 --seed 1 --time 5ms"), "it tells of 6 discs, the frames have 5"),
        (of("-n 5 --side 0.05 --seed 1 --time 5ms"), "it tells of a box of 0.05 m"),
        (of("-n 5 --nt 60 --seed 1 --time 5ms"), "its time step is"),
        (of("-n 5 --seed 1 --time 4ms"), "it tells of 450 steps, the frame is of step 563"),
        (of("-n 5 --seed 1 --time 6ms"), "it tells of 675 steps, the frame is of step 563"),
    ] {
        fs::write(whole.path().join(RECORD), &text_of_record).unwrap();
        let output = outcome(whole.path(), "report");
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{why}: {message}");
        assert!(message.contains(why) && message.contains("way out"), "{why}: {message}");
        assert!(!whole.path().join("report.html").exists(), "{why}");
        // A picture of forces needs the law: it goes on with that of the flags, and says so.
        let output = outcome(whole.path(), "plot forces trajectory.txt");
        let message = text(&output.stderr);
        assert!(output.status.success() && message.contains("preset guide"), "{why}: {message}");
        let all = "plot forces trajectory.txt --kn 5e4 --eta 0";
        assert_eq!(text(&outcome(whole.path(), all).stderr), "", "{why}");
    }
    fs::write(whole.path().join(RECORD), own).unwrap();
    for command in ["report", "plot forces trajectory.txt", "plot forces trajectory.txt --frame 1"]
    {
        let output = outcome(whole.path(), command);
        assert!(output.status.success() && output.stderr.is_empty(), "{}", text(&output.stderr));
    }
}

#[test]
fn a_run_of_the_library_leaves_its_own_record_or_none() {
    for keys in ["n = 4\nradius = 5e-4\nseed = 7\nspeed = 0.1\ntime = 1e-3", ""] {
        let folder = tempfile::tempdir().unwrap();
        let scenario =
            Scenario::from_toml(&format!("{keys}\n[output]").replace("\n[output]", "")).unwrap();
        let mut simulation = scenario.build().unwrap();
        let mut plan = scenario.output_plan();
        plan.folder = folder.path().to_owned();
        if keys.is_empty() {
            plan.record.clear();
        }
        // An empty one of a former version is nobody's.
        fs::write(folder.path().join(RECORD), "").unwrap();
        let mut recorder = Recorder::create(&plan, &mut simulation).unwrap();
        simulation.step_until(50);
        recorder.finish(&simulation).unwrap();
        recorder.record_results(&["steps = 50".to_owned()]).unwrap();
        assert_eq!(folder.path().join(RECORD).exists(), !keys.is_empty());
        let report = outcome(folder.path(), "report");
        if keys.is_empty() {
            assert!(text(&report.stderr).contains("tells of no run"), "{}", text(&report.stderr));
            continue;
        }
        assert!(report.status.success(), "{}", text(&report.stderr));
        let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
        assert!(page.contains("<dt>discs</dt><dd>4</dd>") && page.contains("<dd>0.1 m/s</dd>"));
        let again = Scenario::from_toml(&record(folder.path())).unwrap().build().unwrap();
        assert_eq!(again.state_hash(), scenario.build().unwrap().state_hash());
    }
}

#[test]
fn every_flag_goes_beside_a_printed_record() {
    let source = run("-n 4 --radius 5e-4 --seed 1 --speed 0.1 --time 2ms -q");
    let frame = |name: &str| format!("{}/{name}", source.path().display());
    let (with, without) = (frame("trajectory.txt"), frame("out.txt"));
    // Listed discs say their own speed, and where they are; without them a placement may be chosen.
    let listed = ["--speed 0.2", "--placement lattice"];
    for (discs, refused) in [
        ("-n 4 --radius 5e-4".to_owned(), &[][..]),
        ("-n 4 --speed 0.3 --placement lattice".to_owned(), &[]),
        (format!("--start {with}"), &listed),
        (format!("--start {without}"), &listed),
        (format!("--start {without} --speed 0.2"), &listed),
    ] {
        let folder = run(&format!("{discs} --seed 3 --time 1ms -q"));
        for flag in [
            "-n 3",
            "--seed 5",
            "--preset guide-listing",
            "--side 0.05",
            "--radius 4e-4",
            "--mass 2e-3",
            "--gravity=1,-9",
            "--gravity 3",
            "--kn 6e4",
            "--eta 0.1",
            "--gamma 100",
            "--restitution 0.8",
            "--no-tension",
            "--no-walls",
            "--walls",
            "--nt 60",
            "--dt auto",
            "--dt 1e-6",
            "--time 2ms",
            "--integrator velocity-verlet",
            "--allow-unstable",
            "--placement lattice",
            "--speed 0.2",
            &format!("--start {with}"),
            &format!("--start {without}"),
            &format!("--start {without} --speed 0.2"),
            "--every 10",
            "--energy-every 0",
            "--slowdown 1",
            "--threads 1",
            "--checkpoint-every 10min",
            "--border",
            "--json",
        ] {
            let output = outcome(folder.path(), &format!("{RECORD} --out-dir again -q {flag}"));
            let message = text(&output.stderr);
            let is_refused = refused.contains(&flag);
            assert_eq!(output.status.success(), !is_refused, "{discs}: {flag}: {message}");
            assert!(!is_refused || message.contains("exclude each other"), "{flag}: {message}");
        }
    }
}

#[test]
fn the_command_that_repeats_a_run_has_the_seed_that_was_drawn() {
    let folder = run("-n 4 --speed 0.2 --time 2ms -q");
    let command = |folder: &Path| {
        let text = record(folder);
        text.lines().find_map(|line| line.strip_prefix("# result: command = ")).unwrap().to_owned()
    };
    let typed = command(folder.path());
    let seed = record(folder.path());
    let seed = seed.lines().find_map(|line| line.strip_prefix("seed = ")).unwrap();
    assert_eq!(typed, format!("parsim2d -n 4 --speed 0.2 --time 2ms -q --seed {seed}"));
    assert!(outcome(folder.path(), "report").status.success());
    let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert!(page.contains(&format!("<code>{typed}</code>")));
    // Typed again it leaves the same files, this record included.
    let again = run(typed.strip_prefix("parsim2d ").unwrap());
    assert_eq!(record(again.path()), record(folder.path()));
    assert!(!command(run("-n 2 --seed 3 --time 1ms -q").path()).contains("--seed 3 --seed"));
    // Where nothing is drawn, nothing is added.
    fs::write(again.path().join("one.toml"), "[[disc]]\nposition = [0.01, 0.02]\n").unwrap();
    assert!(parsim2d(again.path(), "one.toml --time 1ms -q").status().unwrap().success());
    assert_eq!(command(again.path()), "parsim2d one.toml --time 1ms -q");
}
