//! What the tests of pictures share: runs to draw, every kind of picture, the command itself.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use parsim2d::output::drift::{CurveRow, DriftRow};
use tempfile::TempDir;

/// Every kind of picture on the files of a run, with its picture's name.
pub const KINDS: [(&str, &str); 13] = [
    ("frame out.txt", "frame.svg"),
    ("frame trajectory.txt --vectors -o arrows.svg", "arrows.svg"),
    ("frame trajectory.txt --colour radius --frame 1 -o radius.svg", "radius.svg"),
    ("trajectory trajectory.txt", "trajectory.svg"),
    ("trajectory trajectory.txt --gif --every 40 --size 100 -o film.gif", "film.gif"),
    ("energy energy.csv", "energy.svg"),
    ("energy energy.csv energy.csv -o two.svg", "two.svg"),
    ("velocity trajectory.txt", "velocity.svg"),
    ("forces trajectory.txt", "forces.svg"),
    ("speeds trajectory.txt --pool", "speeds.svg"),
    ("history trajectory.txt", "history.svg"),
    ("history trajectory.txt --disc 0 x y vx vy speed -o disc.svg", "disc.svg"),
    ("drift drift.csv", "drift.svg"),
];

/// Runs whose pictures are drawn: few discs, many with contacts, one, at rest.
pub const RUNS: [&str; 4] = [
    "-n 5 --time 0.01 --seed 1 -q --speed 0.5",
    "-n 60 --time 0.01 --seed 1 -q --speed 0.5 --radius 1e-3 --restitution 0.5",
    "-n 1 --time 0.01 --seed 1 -q --gravity 0 --speed 0.5 --radius 2e-3",
    "-n 2 --time 0.001 --seed 1 -q --gravity 0",
];

pub fn parsim2d(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_parsim2d"));
    command.current_dir(folder);
    command
}

pub fn run(folder: &Path, arguments: &str) -> Output {
    parsim2d(folder).arg("plot").args(arguments.split_whitespace()).output().unwrap()
}

/// Draws; it must work.
pub fn plot(folder: &Path, arguments: &str) -> Output {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{arguments}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

/// A folder with the files of a run.
pub fn simulate(arguments: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    let output = parsim2d(folder.path()).args(arguments.split_whitespace()).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    folder
}

pub fn write(folder: &TempDir, name: &str, text: &str) {
    fs::write(folder.path().join(name), text).unwrap();
}

pub fn read(folder: &TempDir, name: &str) -> String {
    fs::read_to_string(folder.path().join(name)).unwrap()
}

/// A drift study whose errors fall exactly as the orders say: dt for explicit Euler, dt² for Eq. (3).
pub fn write_study(folder: &Path) {
    let (mut rows, mut curves) = (Vec::new(), Vec::new());
    for (case, size) in [("wall", 1.0), ("pair", 2.0), ("box", 1.0), ("dense", 1.0)] {
        for (integrator, order) in [("symplectic-euler", 2), ("explicit-euler", 1)] {
            for nt in [10.0, 20.0, 50.0] {
                let error = size / f64::powi(nt, order);
                let (case, integrator) = (case.to_owned(), integrator.to_owned());
                let key = (case.clone(), integrator.clone());
                rows.push(DriftRow {
                    case,
                    integrator,
                    restitution: 1.0,
                    nt,
                    dt_s: 4.4e-4 / nt,
                    largest_error: 2.0 * error,
                    final_error: error,
                    dissipated_J: 0.0,
                    work_error_J: 1e-18,
                });
                if ["box", "dense"].contains(&key.0.as_str()) {
                    let point = |k: u32| CurveRow {
                        case: key.0.clone(),
                        integrator: key.1.clone(),
                        restitution: 1.0,
                        nt,
                        time_s: 0.1 * f64::from(k),
                        error: error * f64::from(k),
                    };
                    curves.extend((0..10).map(point));
                }
            }
        }
    }
    parsim2d::output::drift::write(&folder.join("drift.csv"), &rows).unwrap();
    parsim2d::output::drift::write(&folder.join("drift_energy.csv"), &curves).unwrap();
}
