//! What can go wrong, and whether the program names the parameter at fault: faults, and
//! sensible inputs. `cargo test --test all faults:: -- --nocapture` prints both
//! tables.
#![allow(clippy::too_many_lines)] // tables of cases

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;
use tempfile::TempDir;

fn parsim2d(folder: &Path) -> Command {
    let mut command = Command::cargo_bin("parsim2d").unwrap();
    command.current_dir(folder);
    command
}

/// A fault as a command line, or as a scenario file; and its name.
struct Fault {
    what: &'static str,
    said: &'static str,
    file: &'static str,
    fault: &'static str,
    /// A part of the message that a person reads.
    says: &'static str,
}

const fn flags(
    what: &'static str,
    said: &'static str,
    fault: &'static str,
    says: &'static str,
) -> Fault {
    Fault { what, said, file: "", fault, says }
}

const fn file(
    what: &'static str,
    file: &'static str,
    fault: &'static str,
    says: &'static str,
) -> Fault {
    Fault { what, said: "fault.toml", file, fault, says }
}

const FAULTS: [Fault; 19] = [
    flags("dt a hundred times too large", "--dt 8.9e-4", "--dt", "--dt = 8.9e-4"),
    flags("eta 1500 with Eq. (2)", "--eta 1.5e3", "--eta", "--eta = 1500"),
    flags("eta negative", "--eta -1.5e-3", "--eta", "eta = -1.5e-3 is not possible"),
    flags("k_n 5e10 with dt fixed", "--kn 5e10 --dt 8.9e-6", "--kn", "--kn = 5e10"),
    flags("mass 1e-9 with dt fixed", "--mass 1e-9 --dt 8.9e-6", "--mass", "--mass = 1e-9"),
    flags("radius in millimetres", "--radius 0.1", "--radius", "write 0.1mm"),
    flags("gravity in millimetres", "--gravity 9810", "--gravity", "--gravity = 9810"),
    flags("box too full", "-n 1000 --radius 1e-3", "-n", "way out"),
    flags("N_t = 1", "--nt 1", "--nt", "--nt = 1"),
    flags("speed in mm/s", "--speed 500", "--speed", "--speed = 500"),
    flags("side in millimetres", "--side 40", "--side", "--side = 40"),
    file(
        "overlapping start",
        "[[disc]]\nposition = [0.02, 0.02]\n[[disc]]\nposition = [0.02005, 0.02]",
        "discs 0 and 1: position",
        "discs 0 and 1 overlap by 1.5 radii",
    ),
    file(
        "disc outside the box",
        "[[disc]]\nposition = [0.05, 0.02]",
        "disc 0: position",
        "disc 0 has its centre outside the box",
    ),
    file(
        "centre on a wall plane",
        "[[disc]]\nposition = [0.02, 0]",
        "disc 0: position",
        "disc 0 has its centre on a wall",
    ),
    file(
        "two coincident discs",
        "[[disc]]\nposition = [0.02, 0.02]\n[[disc]]\nposition = [0.02, 0.02]",
        "discs 0 and 1: position",
        "discs 0 and 1 have the same centre",
    ),
    file(
        "velocity that is no number",
        "[[disc]]\nposition = [0.02, 0.02]\nvelocity = [0, nan]",
        "disc 0: velocity y",
        "must be a finite number",
    ),
    file(
        "a disc that crosses another in a step",
        "[[disc]]\nposition = [0.01, 0.02]\nvelocity = [50, 0]\n[[disc]]\nposition = [0.02, 0.02]",
        "disc 0: velocity",
        "moves 4.44 r in a step",
    ),
    file(
        "one disc lighter than said, dt fixed",
        "dt = 8.9e-6\n[[disc]]\nposition = [0.01, 0.02]\n[[disc]]\nposition = [0.02, 0.02]\n\
         mass = 1e-9",
        "disc 1: mass",
        "disc 1, 1e-9 kg",
    ),
    file(
        "a large disc as light as its many small neighbours",
        "preset = 'guide-printed'\n[[disc]]\nposition = [0.02, 0.02]\nradius = 3e-3\n\
         [[population]]\nn = 100\nradius = 1.4e-4",
        "--eta",
        "for a large disc among many small ones",
    ),
];

#[test]
fn every_fault_is_named() {
    println!("{:<52} {:<26} named", "fault", "by check and run");
    let mut missed = Vec::new();
    for Fault { what, said, file, fault, says } in FAULTS {
        let folder = TempDir::new().unwrap();
        fs::write(folder.path().join("fault.toml"), file).unwrap();
        let said: Vec<&str> = said.split_whitespace().chain(["--seed", "1"]).collect();
        let checked = parsim2d(folder.path()).arg("check").args(&said).arg("--json").output();
        let checked = checked.unwrap();
        let answer: Value = serde_json::from_slice(&checked.stdout).unwrap();
        let ran = parsim2d(folder.path()).args(&said).output().unwrap();
        let message = String::from_utf8(ran.stderr).unwrap();
        let is_named = answer["fault"] == *fault
            && answer["verdict"] != "good"
            && checked.status.code() == Some(2)
            && ran.status.code() == Some(2)
            && message.contains(says);
        let named = answer["fault"].as_str().unwrap_or("-");
        println!("{what:<52} {named:<26} {}", if is_named { "yes" } else { "NO" });
        if !is_named {
            missed.push(format!("{what}: {answer}\n{message}"));
        }
        assert!(!folder.path().join("out.txt").exists(), "{what}: files of a refused run");
    }
    assert!(missed.is_empty(), "{}", missed.join("\n"));
}

/// Faults that show only while the run is under way, with what the guard calls them.
const ON_THE_WAY: [(&str, &str, &str, &str); 6] = [
    ("explicit Euler", "--integrator explicit-euler", "energy-grown", "--integrator"),
    // Damping takes what the integrator gives: only the sum of both grows.
    (
        "explicit Euler, damped",
        "--integrator explicit-euler --restitution 0.8 --nt 20",
        "energy-grown",
        "--integrator",
    ),
    ("eta 1500, allowed", "--eta 1.5e3 --allow-unstable", "energy-grown", "--eta"),
    ("N_t = 2, allowed", "-n 200 --radius 5e-4 --nt 2 --allow-unstable", "energy-grown", "--nt"),
    ("discs too small for their spring", "--radius 1e-5", "beyond-wall", "--radius"),
    ("spring too soft", "--kn 500", "beyond-wall", "--kn"),
];

#[test]
fn a_run_that_goes_wrong_is_stopped_and_explained() {
    println!("{:<34} {:<14} {:<14} step", "fault", "kind", "named");
    for (what, said, kind, fault) in ON_THE_WAY {
        let folder = TempDir::new().unwrap();
        let allowed = said.contains("allow");
        let args: Vec<&str> = said.split_whitespace().collect();
        let output =
            parsim2d(folder.path()).args(args).args(["--seed", "1", "--json"]).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(if allowed { 0 } else { 1 }), "{what}: {message}");
        let text = fs::read_to_string(folder.path().join("failure.json")).unwrap();
        let failure: Value = serde_json::from_str(&text).unwrap();
        println!("{what:<34} {kind:<14} {:<14} {}", failure["fault"], failure["step"]);
        assert_eq!(failure["kind"], kind, "{what}: {failure}");
        assert_eq!(failure["fault"], fault, "{what}: {failure}");
        assert_eq!(failure["stopped"], !allowed, "{what}");
        let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(summary["went_wrong_at_step"], failure["step"], "{what}");
        if !allowed {
            // Every file ends with the last good step, one before.
            let last_good = failure["step"].as_u64().unwrap() - 1;
            assert_eq!(summary["steps"], last_good, "{what}");
            let frame = fs::read_to_string(folder.path().join("out.txt")).unwrap();
            assert!(frame.starts_with(&format!("# step {last_good} ")), "{what}: {frame:.60}");
            let energies = fs::read_to_string(folder.path().join("energy.csv")).unwrap();
            let last = energies.lines().last().unwrap();
            assert!(last.starts_with(&format!("{last_good},")), "{what}: {last}");
            assert!(!energies.contains("NaN") && !energies.contains("inf"), "{what}");
        }
    }
}

#[test]
fn a_later_run_removes_the_failure_of_a_former_one() {
    let folder = TempDir::new().unwrap();
    parsim2d(folder.path()).args(["--kn", "500", "--seed", "1"]).assert().code(1);
    assert!(folder.path().join("failure.json").exists());
    parsim2d(folder.path()).args(["--time", "1ms", "--seed", "1"]).assert().success();
    assert!(!folder.path().join("failure.json").exists());
}

#[test]
fn the_step_found_does_not_depend_on_what_is_written() {
    // A steady growth, and one that comes and goes with contacts of two steps.
    let steady = ["--integrator", "explicit-euler", "--seed", "1"];
    let fitful = "-n 1 --nt 2 --gravity 0 --speed 0.3 --time 2 --seed 2";
    let fitful: Vec<&str> = fitful.split_whitespace().collect();
    for run in [&steady[..], &fitful] {
        let failure = |more: &[&str]| {
            let folder = TempDir::new().unwrap();
            parsim2d(folder.path()).args(run).args(more).assert().code(1);
            let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
            let failure: Value = serde_json::from_str(&read("failure.json")).unwrap();
            // Every file ends with the last good step, whatever was written on the way.
            let last_good = failure["step"].as_u64().unwrap() - 1;
            let ends = |text: &str| text.contains(&format!("# step {last_good} "));
            assert!(ends(&read("out.txt")), "{run:?} {more:?}");
            let trajectory = read("trajectory.txt");
            let last = trajectory.rsplit("\n\n\n").next().unwrap();
            assert!(ends(last.lines().next().unwrap()), "{run:?} {more:?}");
            let n = last.lines().count() - 1;
            assert!(trajectory.split("\n\n\n").all(|frame| frame.lines().count() == n + 1));
            let rows = read("energy.csv");
            let steps: Vec<u64> = rows
                .lines()
                .skip(1)
                .map(|row| row.split(',').next().unwrap().parse().unwrap())
                .collect();
            assert_eq!(steps.last(), Some(&last_good), "{run:?} {more:?}");
            assert!(steps.windows(2).all(|pair| pair[0] < pair[1]), "{run:?} {more:?}");
            (failure["step"].clone(), failure["energy_after_J"].clone(), failure["discs"].clone())
        };
        let usual = failure(&[]);
        let writing = [
            &["--every", "1"][..],
            &["--every", "7"],
            &["--every", "64"],
            &["--energy-every", "3"],
            &["--slowdown", "0.001"],
        ];
        for more in writing {
            assert_eq!(failure(more), usual, "{run:?} {more:?}");
        }
    }
}

#[test]
fn a_run_is_looked_at_to_its_last_step() {
    // The energy grows at step 2619, less than two looks of 64 steps before these ends.
    let lesson = ["--eta", "1.5e3", "--allow-unstable", "--seed", "1", "--json", "-q"];
    for (time, found) in [("23.2ms", false), ("23.6ms", true), ("23.7ms", true), ("24ms", true)] {
        let folder = TempDir::new().unwrap();
        let output = parsim2d(folder.path()).args(lesson).args(["--time", time]).output().unwrap();
        let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
        let expected = if found { Value::from(2619) } else { Value::Null };
        assert_eq!(summary["went_wrong_at_step"], expected, "{time}");
    }
}

#[test]
fn an_overlap_at_the_start_is_told_once() {
    let folder = TempDir::new().unwrap();
    let start = "radius = 5e-4\ntime = '1ms'\n[[disc]]\nposition = [0.01, 0.02]\n\
                 [[disc]]\nposition = [0.01052, 0.02]";
    fs::write(folder.path().join("start.toml"), start).unwrap();
    let output = parsim2d(folder.path()).arg("start.toml").output().unwrap();
    let notes = String::from_utf8(output.stderr).unwrap();
    assert_eq!(notes.matches("at the start").count(), 1, "{notes}");
}

#[test]
fn a_refusal_has_the_same_keys_whatever_it_is_for() {
    for said in ["--eta 1.5e3", "--eta -1", "-n 100000", "--restitution 2", "--radius 0.1", ""] {
        let folder = TempDir::new().unwrap();
        let args = said.split_whitespace();
        let output =
            parsim2d(folder.path()).arg("check").args(args).arg("--json").output().unwrap();
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        for key in ["verdict", "fault", "value", "ways_out", "sentence"] {
            assert!(answer.get(key).is_some(), "{said}: {key} of {answer}");
        }
        assert!(!answer["ways_out"].as_array().unwrap().is_empty(), "{said}: {answer}");
    }
}

#[test]
fn one_number_is_offered_against_softness() {
    // The note before the run and the summary after it name the same stiffness; a run that went
    // wrong for another reason is not called soft.
    let run = |said: &str| {
        let folder = TempDir::new().unwrap();
        let output = parsim2d(folder.path()).args(said.split_whitespace()).output().unwrap();
        let texts = [output.stderr, output.stdout].map(|text| String::from_utf8(text).unwrap());
        texts.map(|text| {
            let after = text.split("--kn ").nth(1).map(|rest| rest.to_owned());
            after.map(|rest| rest.split_whitespace().next().unwrap_or_default().to_owned())
        })
    };
    let [note, summary] = run("--gravity 30 --seed 1");
    assert!(note.is_some() && note == summary, "{note:?} {summary:?}");
    let [_, summary] = run("--radius 5e-4 -n 500 --nt 4 --eta 0 --seed 1 --time 0.5");
    assert_eq!(summary, None);
}

/// Inputs that a course, an instructor or a researcher may well try. The first word may be a
/// file in `examples/`.
const SENSIBLE: [&str; 53] = [
    "",
    "-n 1",
    "-n 2",
    "-n 3 --nt 10",
    "-n 100",
    "-n 1000 --time 0.2",
    "-n 1000 --radius 5e-4 --time 0.2",
    "-n 1000 --radius 5e-4 --restitution 1 --time 0.2",
    "-n 1000 --radius 5e-4 --restitution 0.5 --time 0.2",
    "-n 300 --radius 5e-4 --nt 10 --restitution 1",
    "-n 300 --radius 5e-4 --nt 20",
    "-n 2000 --radius 4e-4 --placement lattice --time 0.1",
    "--nt 10",
    "--nt 20 --restitution 1",
    "--nt 100",
    "--nt 1000 --time 0.1",
    "--dt auto",
    "--dt auto --eta 1.5e3 --time 0.2",
    "--dt 1e-6 --time 0.2",
    "--preset guide-listing",
    "--preset guide-mass-scaled",
    "--preset guide-printed --time 0.2",
    "--preset guide-printed -n 300 --radius 5e-4 --time 0.02",
    "--restitution 1 --time 5",
    "--restitution 0.9 --time 5",
    "--restitution 0.1",
    "--restitution 0.5 --no-tension",
    "--eta 0",
    "--eta 1",
    "--gamma 100",
    "--integrator velocity-verlet",
    "--integrator velocity-verlet --nt 10 -n 300 --radius 5e-4",
    "--integrator explicit-euler --nt 1000 --time 0.1",
    "--gravity 0 --speed 0.5 --radius 5e-4",
    "--gravity 0 --speed 2 --radius 5e-4 -n 300",
    "--gravity 0",
    "--gravity 1.62",
    "--gravity -9.81",
    "--gravity 100 --radius 1e-3",
    "--no-walls",
    "--no-walls --integrator velocity-verlet",
    "--no-walls --integrator explicit-euler --time 0.1",
    "--no-walls --gravity -9.81 -n 1 --integrator velocity-verlet",
    "--no-walls --gravity 0 --speed 0.1 -n 100",
    "--side 10cm --radius 1mm",
    "--side 0.4 --radius 5mm --mass 100g --kn 1e5",
    "--radius 1mm --mass 1g",
    "--kn 1e6 --radius 5e-4",
    "--kn 5e3 --radius 1e-3 -n 50",
    "--mass 1e-5 --radius 5e-4",
    "examples/settling.toml --time 0.1",
    "examples/newtons_cradle.toml",
    "examples/oblique.toml",
];

#[test]
fn sensible_inputs_raise_no_false_alarm() {
    let mut alarms = Vec::new();
    println!("{:<64} {:<7} {:<14} run", "input", "verdict", "fault");
    for said in SENSIBLE {
        let folder = TempDir::new().unwrap();
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let args: Vec<String> = said
            .split_whitespace()
            .map(|word| match word.starts_with("examples/") {
                true => root.join(word).display().to_string(),
                false => word.to_owned(),
            })
            .chain(["--seed".to_owned(), "1".to_owned()])
            .collect();
        let checked = parsim2d(folder.path()).arg("check").args(&args).arg("--json").output();
        let checked = checked.unwrap();
        let ran = parsim2d(folder.path()).args(&args).output().unwrap();
        let answer: Value = serde_json::from_slice(&checked.stdout).unwrap_or_default();
        let verdict = answer["verdict"].as_str().unwrap_or("?");
        let is_calm = checked.status.success()
            && ran.status.success()
            && ["good", "coarse"].contains(&verdict)
            && !folder.path().join("failure.json").exists();
        let fault = answer["fault"].as_str().unwrap_or("-");
        println!("{said:<64} {verdict:<7} {fault:<14} {}", if is_calm { "ok" } else { "ALARM" });
        if !is_calm {
            alarms.push(format!("{said}: {answer}\n{}", String::from_utf8_lossy(&ran.stderr)));
        }
    }
    assert!(alarms.is_empty(), "{}", alarms.join("\n"));
}

#[test]
fn presets_of_the_guide_are_coarse_and_never_refused() {
    // A fall sinks discs of 1e-4 m too deep; those of 5e-4 m are hard enough.
    for (preset, verdict, fault) in [
        ("guide", "coarse", "--kn"),
        ("guide-mass-scaled", "coarse", "--kn"),
        ("guide-printed", "coarse", "--eta"),
        ("guide-listing", "good", "-"),
    ] {
        for n in ["20", "1000"] {
            let folder = TempDir::new().unwrap();
            let args = ["check", "--preset", preset, "-n", n, "--json"];
            let output = parsim2d(folder.path()).args(args).output().unwrap();
            let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
            assert_eq!(output.status.code(), Some(0), "{preset}");
            assert_eq!(answer["verdict"], verdict, "{preset} {n}");
            assert_eq!(answer["fault"].as_str().unwrap_or("-"), fault, "{preset} {n}");
        }
    }
}
