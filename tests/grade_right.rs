//! Films that look odd and are right: frames a step early or late, the guide's own trap, columns that a heading names.

use std::fmt::Write as _;

use parsim2d::grading::judge::check::Check;
use parsim2d::grading::judge::grade;
use parsim2d::grading::judge::mistake::Mistake;
use parsim2d::grading::judge::rubric::{PrintedEta, Rubric};
use parsim2d::grading::judge::verdict::Status;
use parsim2d::grading::judge::words::Note;

use crate::support::student;

use student::{Bug, Program, damped, lost};

/// N_t of Eq. (2), as the guide has it.
const STEPS: [f64; 4] = [10.0, 17.0, 30.0, 50.0];

#[test]
fn frames_that_come_when_the_time_has_passed_a_millisecond_cost_nothing() {
    let mut seen = 0;
    for (k, steps) in STEPS.into_iter().enumerate() {
        for (seed, n, period, at_rest) in
            [(1, 20, 1e-3, true), (2, 40, 1e-3, false), (3, 20, 5e-4, false), (4, 60, 2e-3, true)]
        {
            let seed = seed + 10 * k as u64;
            let program = Program {
                eta: 0.7,
                n,
                steps,
                period: Some(period),
                at_rest,
                ..Program::new(Bug::None, seed)
            };
            let report = grade(program.output().as_bytes(), &damped());
            let what = format!("N_t {steps}, seed {seed}, n {n}, every {period} s");
            assert_eq!(lost(&report), [], "{what}: {:#?}", report.checks);
            assert!(report.passed(Check::FreeFlight), "{what}: {:#?}", report.checks);
            seen += usize::from(report.passed(Check::RestitutionPair));
        }
    }
    // At even times contacts are measured as well as in any other film.
    assert!(seen >= 12, "of 16 films {seen} show what pairs give back");
}

#[test]
fn a_bug_beside_frames_that_come_a_step_early_or_late_costs_what_it_should() {
    for (bug, check, cause) in [
        (Bug::GravitySideways, Check::FreeFlight, Mistake::GravitySideways),
        // Speeds that fall by themselves tell no times.
        (Bug::Friction, Check::FreeFlight, Mistake::TimeStepNotConstant),
        (Bug::WallMissing, Check::Box, Mistake::WallMissing),
        (Bug::OneDiscOnly, Check::PairCollision, Mistake::ForceOnOneDiscOnly),
        (Bug::NoDashpot, Check::RestitutionWall, Mistake::DashpotMissing),
    ] {
        let program = Program { eta: 0.7, steps: 30.0, period: Some(1e-3), ..Program::new(bug, 5) };
        let report = grade(program.output().as_bytes(), &damped());
        let lost = lost(&report);
        assert!(lost.contains(&(check, Some(cause))), "{bug:?}: {:#?}", report.checks);
    }
}

/// What the printed eta hides.
const HIDDEN: [Check; 7] = [
    Check::Box,
    Check::WallBounce,
    Check::PairCollision,
    Check::RestitutionWall,
    Check::RestitutionPair,
    Check::Energy,
    Check::LongRun,
];

/// The guide to the letter, at rest, with the printed eta and the step of Eq. (2).
fn printed(bug: Bug, seed: u64, steps: f64, every: usize) -> Program {
    Program { eta: 1.5e3, steps, every, radius: 1e-4, at_rest: true, ..Program::new(bug, seed) }
}

#[test]
fn the_guide_to_the_letter_explodes_and_loses_nothing() {
    for steps in STEPS {
        for (seed, every, n) in [(1, 100, 20), (2, 100, 60), (3, 20, 20), (4, 200, 20), (5, 60, 5)]
        {
            let program = Program { n, ..printed(Bug::None, seed, steps, every) };
            let report = grade(program.output().as_bytes(), &Rubric::default());
            let what = format!("N_t {steps}, seed {seed}, n {n}, every {every} steps");
            assert_eq!((lost(&report), report.percent()), (vec![], 100.0), "{what}: {report:#?}");
            assert_eq!(report.notes, [Note::PrintedEtaExplodes], "{what}");
            for check in HIDDEN {
                assert_eq!(report.status(check), Some(&Status::Masked), "{what}: {}", check.id());
            }
        }
    }
}

#[test]
fn what_is_wrong_beside_the_printed_eta_costs_its_points() {
    for (bug, check, cause) in [
        (Bug::GravitySideways, Check::FreeFlight, Mistake::GravitySideways),
        (Bug::GravitySign, Check::FreeFlight, Mistake::GravitySign),
        (Bug::Diameter, Check::Radii, Mistake::DiameterAsRadius),
        (Bug::PlacedInWall, Check::Start, Mistake::PlacedOutside),
    ] {
        let report = grade(printed(bug, 1, 50.0, 100).output().as_bytes(), &Rubric::default());
        assert_eq!(lost(&report), [(check, Some(cause))], "{bug:?}: {:#?}", report.checks);
    }
}

#[test]
fn a_rubric_that_calls_the_printed_eta_wrong_takes_points_for_what_it_does() {
    let strict = Rubric { printed_eta: PrintedEta::Wrong, ..Rubric::default() };
    let report = grade(printed(Bug::None, 1, 50.0, 100).output().as_bytes(), &strict);
    assert!(!lost(&report).is_empty(), "{:#?}", report.checks);
    assert!(report.checks.iter().all(|(_, status)| *status != Status::Masked));
}

/// A film with rows made of number, x, y and r, each frame after these lines.
fn written(heading: &str, row: impl Fn(usize, [&str; 3]) -> String) -> String {
    let plain = Program { eta: 0.7, frames: 200, ..Program::new(Bug::None, 3) }.output();
    let mut text = String::new();
    for frame in plain.split("\n\n").filter(|frame| !frame.is_empty()) {
        text += heading;
        for (i, line) in frame.lines().enumerate() {
            let columns: Vec<&str> = line.split(' ').collect();
            writeln!(text, "{}", row(i, [columns[0], columns[1], columns[2]])).unwrap();
        }
        text.push('\n');
    }
    text
}

#[test]
fn columns_are_read_as_a_heading_names_them() {
    let usual = |_: usize, [x, y, r]: [&str; 3]| format!("{x} {y} {r}");
    let right = grade(written("", usual).as_bytes(), &damped());
    assert_eq!(lost(&right), [], "{:#?}", right.checks);
    let files = [
        written("# id x y r\n", |i, [x, y, r]| format!("{i} {x} {y} {r}")),
        written("x\ty\tz\tr\n", |_, [x, y, r]| format!("{x}\t{y}\t0.01\t{r}")),
        written("# x, y, phi, vx, vy, omega, r, m\n", |_, [x, y, r]| {
            format!("{x}, {y}, 0.031, 0, 0, 0, {r}, 1e-3")
        }),
        written("# step 0 time_s 0 n 20 side_m 0.04 columns x y r vx vy m\n", |_, [x, y, r]| {
            format!("{x} {y} {r} 0.1 0.1 1e-3")
        }),
        // One angle is a radius by chance.
        written("# x y phi r\n", |i, [x, y, r]| {
            format!("{x} {y} {} {r}", if i == 3 { "0.0005" } else { "0.031" })
        }),
        written("# radius; x; y\n", |_, [x, y, r]| format!("{r}; {x}; {y}")),
        written("", usual).replace('\n', "\r"),
        written("", usual).replace('\n', "\r\n"),
    ];
    for file in files {
        let report = grade(file.as_bytes(), &damped());
        let beginning = &file[..file.len().min(90)];
        assert_eq!(report.checks, right.checks, "{beginning:?}");
        assert_eq!(report.notes, right.notes, "{beginning:?}");
    }
}

#[test]
fn a_column_is_taken_for_the_radius_only_if_that_is_said() {
    let columns = |_: usize, [x, y, r]: [&str; 3]| format!("{x} {y} 0.031 0 0 0 {r} 1e-3");
    // The rubric's radius tells which it is; the student is told.
    let report = grade(written("", columns).as_bytes(), &damped());
    let cause = (Check::Radii, Some(Mistake::ColumnsExchanged));
    assert_eq!(lost(&report), [cause], "{:#?}", report.checks);
    // Nothing tells: the reader is told what was taken.
    let any = Rubric { radius: vec![], ..damped() };
    let report = grade(written("", columns).as_bytes(), &any);
    assert!(report.notes.contains(&Note::ColumnsTaken), "{:?}", report.notes);
    let heading = "# x y phi vx vy omega r m\n";
    let report = grade(written(heading, columns).as_bytes(), &any);
    assert!(!report.notes.contains(&Note::ColumnsTaken), "{:?}", report.notes);
    assert_eq!(lost(&report), [], "{:#?}", report.checks);
    // A heading that is not of the rows below it.
    let swapped = written("# y r x\n", |_, [x, y, r]| format!("{x} {y} {r}"));
    assert_eq!(lost(&grade(swapped.as_bytes(), &damped())), []);
}
