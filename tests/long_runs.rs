//! What is said of runs that take long: before, and in the summary.

use crate::support::runs;

use std::io::{BufRead, BufReader};
use std::process::Stdio;

use parsim2d::scenario::quantity::{Quantity, Time};
use runs::{outcome, parsim2d, text};

#[test]
fn hours_are_a_unit_of_time() {
    let time = |text: &str| text.parse::<Quantity<Time>>().map(|time| time.si);
    assert_eq!(time("1h"), Ok(3600.0));
    assert_eq!(time("0.5 h"), Ok(1800.0));
    assert!(time("h").is_err());
}

#[test]
fn a_long_run_is_told_of_checkpoints_unless_it_keeps_them() {
    for (more, is_told) in [("", true), ("--checkpoint-every 1h", false)] {
        let folder = tempfile::tempdir().unwrap();
        let mut command = parsim2d(folder.path(), &format!("-n 20 --seed 1 --time 10000 {more}"));
        let mut child = command.stderr(Stdio::piped()).spawn().unwrap();
        let said = BufReader::new(child.stderr.take().unwrap()).lines();
        let note = said.map(Result::unwrap).find(|line| line.contains("a long run"));
        child.kill().unwrap();
        child.wait().unwrap();
        let note = note.expect("it is told that it is long");
        assert_eq!(note.contains("--checkpoint-every 10min"), is_told, "{note}");
    }
}

#[test]
fn threads_that_find_nothing_to_do_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let note = |arguments: &str| {
        let arguments = format!("{arguments} --seed 1 --time 0.1ms");
        text(&outcome(folder.path(), &arguments).stderr)
    };
    assert!(note("-n 50 --threads 3").contains("note: --threads 3: 50 discs run on one"));
    for quiet in ["-n 50 --threads 1", "-n 50", "-n 100 --threads 3"] {
        assert!(!note(quiet).contains("run on one"), "{quiet}");
    }
}

#[test]
#[cfg(target_os = "linux")] // others do not tell it in a file
fn the_summary_of_many_discs_says_how_much_memory_they_took() {
    let folder = tempfile::tempdir().unwrap();
    for (n, is_told) in [(9_999, false), (10_000, true)] {
        let arguments =
            format!("-n {n} --placement lattice --seed 1 --time 0.1ms --energy-every 0");
        let said = text(&outcome(folder.path(), &arguments).stdout);
        let line = said.lines().find(|line| line.starts_with("memory   at most "));
        assert_eq!(line.is_some(), is_told, "{said}");
        if let Some(line) = line {
            let megabytes: f64 = line.split_whitespace().nth(3).unwrap().parse().unwrap();
            // 10,000 discs of some 100 bytes, and a program of some MB.
            assert!((2.0..500.0).contains(&megabytes), "{line}");
        }
    }
}
