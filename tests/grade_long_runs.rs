//! Long films: discs come to rest at the bottom, or are a gas; who gets that wrong fails there and nowhere else.

use std::fs;

use parsim2d::grading::judge::check::Check;
use parsim2d::grading::judge::grade;
use parsim2d::grading::judge::mistake::Mistake;
use parsim2d::grading::judge::rubric::Rubric;
use parsim2d::grading::judge::verdict::{Report, Status};
use parsim2d::grading::judge::words::Finding;

use crate::support::runs;
use crate::support::student;

use runs::{outcome, text};
use student::{Bug, Program, elastic, lost};

/// kg/s: e = 0.55 at a wall, 0.43 of a pair, and up to 0.63 if contacts end where the force is zero.
const MUCH: f64 = 2.6;

fn said(report: &Report) -> Vec<(Check, Finding, Option<Mistake>)> {
    report.failures().map(|(check, why)| (check, why.finding, why.cause)).collect()
}

/// A film of the guide's program, long enough for its end to be judged.
fn long(bug: Bug, eta: f64, n: usize, seed: u64) -> Report {
    long_by(bug, eta, n, seed, |rubric| rubric)
}

/// The same, by another rubric.
fn long_by(bug: Bug, eta: f64, n: usize, seed: u64, other: fn(Rubric) -> Rubric) -> Report {
    let frames = if eta > 0.0 { 760 } else { 4200 };
    let program = Program { n, eta, every: 120, frames, ..Program::new(bug, seed) };
    let rubric = if eta > 0.0 { Rubric { eta, ..Rubric::default() } } else { elastic() };
    grade(program.output().as_bytes(), &other(rubric))
}

#[test]
fn right_programs_come_to_rest_or_are_a_gas() {
    for (eta, n, seed) in [(MUCH, 20, 1), (MUCH, 60, 2), (0.0, 20, 3)] {
        let report = long(Bug::None, eta, n, seed);
        assert_eq!(said(&report), [], "eta {eta}, n {n}, seed {seed}: {:#?}", report.checks);
        assert!(report.passed(Check::LongRun), "eta {eta}, n {n}, seed {seed}");
    }
}

#[test]
fn what_is_wrong_only_in_the_end_costs_the_long_run_and_nothing_else() {
    use Bug::{NeverLiesStill, StaysAtWall, WaitsOnFloor};
    for (bug, eta, n, finding, cause) in [
        (StaysAtWall, MUCH, 20, Finding::HangsInTheEnd, Some(Mistake::StoppedInTheAir)),
        (NeverLiesStill, MUCH, 20, Finding::NeverRests, Some(Mistake::EnergyPump)),
        (WaitsOnFloor, 0.0, 30, Finding::NotExponential, None),
    ] {
        for seed in 1..3 {
            // How long contacts last, and who stays on the floor, would tell those who wait there before.
            let report = long_by(bug, eta, n, seed, |rubric| Rubric {
                stiffness_factor: f64::INFINITY,
                restitution_tolerance: 2.0,
                ..rubric
            });
            let expected = [(Check::LongRun, finding, cause)];
            assert_eq!(said(&report), expected, "{bug:?}, seed {seed}: {:#?}", report.checks);
        }
    }
}

#[test]
fn parsim2d_itself_passes_with_any_restitution_and_short_films_are_not_judged() {
    for (case, e, is_seen) in [
        ("-n 20 --radius 5e-4 --time 1", 0.5, true),
        ("-n 20 --radius 1e-4 --time 5", 0.9, true),
        ("-n 300 --radius 5e-4 --time 1", 0.4, true),
        ("-n 20 --radius 5e-4 --time 2", 0.9, false),
        ("-n 20 --radius 5e-4 --time 5", 1.0, true),
        ("-n 60 --radius 5e-4 --time 4", 1.0, true),
        ("-n 20 --radius 5e-4 --time 1", 1.0, false),
        ("-n 5 --radius 5e-4 --time 5", 1.0, false),
    ] {
        let rubric = Rubric { restitution: Some(e), ..Rubric::default() };
        for seed in 1..3 {
            let folder = tempfile::tempdir().unwrap();
            let rest = format!("--speed 0.5 --restitution {e} --seed {seed} --every 200 -q");
            let run = outcome(folder.path(), &format!("{case} {rest}"));
            assert!(run.status.success(), "{case}: {}", text(&run.stderr));
            let report = grade(&fs::read(folder.path().join("trajectory.txt")).unwrap(), &rubric);
            assert_eq!(lost(&report), [], "{case}, e {e}, seed {seed}: {:#?}", report.checks);
            let expected = if is_seen { Status::Passed } else { Status::NotSeen };
            let status = report.status(Check::LongRun);
            assert_eq!(status, Some(&expected), "{case}, e {e}, seed {seed}");
        }
    }
}
