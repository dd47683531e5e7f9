//! Grading frames: right programs lose nothing, a bug costs the right check and is named.
#![allow(clippy::too_many_lines)] // tables of cases

mod support;

use std::fmt::Write as _;
use std::fs;

use parsim2d::grade::check::Check;
use parsim2d::grade::grade;
use parsim2d::grade::mistake::Mistake;
use parsim2d::grade::rubric::Rubric;
use parsim2d::grade::verdict::{Report, Status};
use proptest::prelude::*;

#[path = "support/runs.rs"]
mod runs;

use runs::{outcome, text};

/// A bug of the little program below.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Bug {
    None,
    ExplicitEuler,
    GravitySign,
    GravityMissing,
    GravitySideways,
    WallMissing,
    InwardWallNormal,
    WallAtCentre,
    OneDiscOnly,
    ContactAtOneRadius,
    NoPairContact,
    PlacedOverlapping,
    PlacedInWall,
    Diameter,
    NotANumber,
    DiscLost,
    OrderChanges,
    Friction,
    UnevenFrames,
    DampingSign,
    TooMuchDamping,
}

/// The guide's program as a student writes it: two loops, Eq. (1) to (3).
struct Program {
    bug: Bug,
    n: usize,
    radius: f64,
    eta: f64,
    every: usize,
    frames: usize,
    seed: u64,
}

const STIFFNESS: f64 = 5e4;
const MASS: f64 = 1e-3;
const SIDE: f64 = 0.04;
/// Eq. (2) with N_t = 30.
const DT: f64 = 1.480_960_979_386_122e-5;

type Disc = [f64; 4]; // x y vx vy

impl Program {
    fn new(bug: Bug, seed: u64) -> Self {
        Self { bug, n: 20, radius: 5e-4, eta: 0.0, every: 60, frames: 400, seed }
    }

    fn random(&mut self) -> f64 {
        self.seed = self.seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.seed >> 11) as f64 / (1u64 << 53) as f64
    }

    fn place(&mut self) -> Vec<Disc> {
        let mut discs: Vec<Disc> = Vec::new();
        let r = self.radius;
        let margin = if self.bug == Bug::PlacedInWall { 0.0 } else { 1.01 * r };
        while discs.len() < self.n {
            let x = margin + (SIDE - 2.0 * margin) * self.random();
            let y = margin + (SIDE - 2.0 * margin) * self.random();
            let v = [self.random() - 0.5, self.random() - 0.5];
            let is_free = |d: &Disc| (d[0] - x).hypot(d[1] - y) > 2.02 * r;
            if discs.iter().all(is_free) {
                discs.push([x, y, v[0], v[1]]);
            }
        }
        match self.bug {
            Bug::PlacedOverlapping => {
                let beside = [discs[0][0] + r, discs[0][1]];
                discs[1][..2].copy_from_slice(&beside);
            }
            Bug::PlacedInWall => discs[3][0] = 0.3 * r,
            _ => {}
        }
        discs
    }

    fn forces(&self, discs: &[Disc]) -> Vec<[f64; 2]> {
        let g = match self.bug {
            Bug::GravitySign => [0.0, 9.81],
            Bug::GravityMissing => [0.0, 0.0],
            Bug::GravitySideways => [9.81, 0.0],
            _ => [0.0, -9.81],
        };
        let mut forces: Vec<[f64; 2]> = vec![[MASS * g[0], MASS * g[1]]; discs.len()];
        let eta = match self.bug {
            Bug::DampingSign => -self.eta,
            Bug::TooMuchDamping => 2.0,
            _ => self.eta,
        };
        self.pairs(discs, eta, &mut forces);
        let reach = if self.bug == Bug::WallAtCentre { 0.0 } else { self.radius };
        for (disc, force) in discs.iter().zip(&mut forces) {
            for (axis, high) in [(0, false), (0, true), (1, false), (1, true)] {
                let sign = if high { 1.0 } else { -1.0 }; // of the normal, to the wall
                let depth = reach - if high { SIDE - disc[axis] } else { disc[axis] };
                let push = -STIFFNESS * depth * sign - eta * disc[axis + 2];
                if depth > 0.0 {
                    force[axis] += match self.bug {
                        Bug::WallMissing => 0.0,
                        Bug::InwardWallNormal => -push,
                        _ => push,
                    };
                }
            }
            if self.bug == Bug::Friction {
                force[0] -= 5e-3 * disc[2];
                force[1] -= 5e-3 * disc[3];
            }
        }
        forces
    }

    fn pairs(&self, discs: &[Disc], eta: f64, forces: &mut [[f64; 2]]) {
        let reach = match self.bug {
            Bug::ContactAtOneRadius => self.radius,
            Bug::NoPairContact => 0.0,
            _ => 2.0 * self.radius,
        };
        for i in 0..discs.len() {
            for j in i + 1..discs.len() {
                let way = [discs[j][0] - discs[i][0], discs[j][1] - discs[i][1]];
                let distance = way[0].hypot(way[1]);
                if distance >= reach || distance == 0.0 {
                    continue;
                }
                let n = [way[0] / distance, way[1] / distance];
                let v = (discs[i][2] - discs[j][2]) * n[0] + (discs[i][3] - discs[j][3]) * n[1];
                let push = STIFFNESS * (reach - distance) + eta * v;
                for axis in 0..2 {
                    forces[i][axis] -= push * n[axis];
                    if self.bug != Bug::OneDiscOnly {
                        forces[j][axis] += push * n[axis];
                    }
                }
            }
        }
    }

    fn step(&self, discs: &mut [Disc]) {
        let forces = self.forces(discs);
        for (disc, force) in discs.iter_mut().zip(forces) {
            for axis in 0..2 {
                let old = disc[axis + 2];
                disc[axis + 2] += force[axis] / MASS * DT;
                let mover = if self.bug == Bug::ExplicitEuler { old } else { disc[axis + 2] };
                disc[axis] += mover * DT;
            }
        }
    }

    /// What it writes: six significant digits, as C++ streams do.
    fn output(mut self) -> String {
        let mut discs = self.place();
        let mut out = String::new();
        let printed = if self.bug == Bug::Diameter { 2.0 * self.radius } else { self.radius };
        for frame in 0..self.frames {
            if self.bug == Bug::OrderChanges && frame % 40 == 20 {
                discs.swap(0, 1);
            }
            if self.bug == Bug::DiscLost && frame == 100 {
                discs.pop();
            }
            for (i, disc) in discs.iter().enumerate() {
                let x = if self.bug == Bug::NotANumber && frame == 50 && i == 7 {
                    f64::NAN
                } else {
                    disc[0]
                };
                writeln!(out, "{} {} {}", general(x), general(disc[1]), general(printed)).unwrap();
            }
            out.push('\n');
            let more = self.bug == Bug::UnevenFrames && self.random() < 0.5;
            for _ in 0..if more { 2 * self.every } else { self.every } {
                self.step(&mut discs);
            }
        }
        out
    }
}

/// Six significant digits without trailing zeros.
fn general(value: f64) -> String {
    format!("{value:.5e}").parse::<f64>().unwrap().to_string()
}

fn elastic() -> Rubric {
    Rubric { restitution: Some(1.0), ..Rubric::default() }
}

/// eta = 0.7 kg/s: e = 0.855 at a wall, 0.800 for a pair.
fn damped() -> Rubric {
    Rubric { eta: 0.7, ..Rubric::default() }
}

fn lost(report: &Report) -> Vec<(Check, Option<Mistake>)> {
    report.failures().map(|(check, failure)| (check, failure.cause)).collect()
}

#[test]
fn right_programs_lose_nothing_and_every_check_is_seen() {
    for seed in 1..6 {
        for (eta, rubric) in [(0.0, elastic()), (0.7, damped())] {
            let report = grade(
                Program { eta, ..Program::new(Bug::None, seed) }.output().as_bytes(),
                &rubric,
            );
            assert_eq!(lost(&report), [], "seed {seed}, eta {eta}: {:#?}", report.checks);
            // A pair's restitution needs two straight hits with nobody else near: one seed has one.
            assert!(report.open() <= 1.0, "seed {seed}, eta {eta}: {:#?}", report.checks);
        }
    }
}

#[test]
fn each_bug_costs_the_right_check_and_is_named() {
    use Check as C;
    use Mistake as M;
    let cases = [
        (Bug::ExplicitEuler, C::Energy, M::ExplicitEuler),
        (Bug::GravitySign, C::FreeFlight, M::GravitySign),
        (Bug::GravityMissing, C::FreeFlight, M::GravityMissing),
        (Bug::GravitySideways, C::FreeFlight, M::GravitySideways),
        (Bug::WallMissing, C::Box, M::WallMissing),
        (Bug::InwardWallNormal, C::Box, M::InwardWallNormal),
        (Bug::WallAtCentre, C::Box, M::WallAtCentre),
        (Bug::OneDiscOnly, C::PairCollision, M::ForceOnOneDiscOnly),
        (Bug::ContactAtOneRadius, C::PairCollision, M::ContactAtOneRadius),
        (Bug::NoPairContact, C::PairCollision, M::Tunnelling),
        (Bug::PlacedOverlapping, C::Start, M::PlacedOverlapping),
        (Bug::PlacedInWall, C::Start, M::PlacedOutside),
        (Bug::Diameter, C::Radii, M::DiameterAsRadius),
        (Bug::NotANumber, C::Discs, M::NotANumber),
        (Bug::DiscLost, C::Discs, M::DiscLost),
        (Bug::OrderChanges, C::Discs, M::DiscOrderChanges),
        (Bug::Friction, C::FreeFlight, M::FrictionInFlight),
        (Bug::UnevenFrames, C::FreeFlight, M::TimeStepNotConstant),
        (Bug::DampingSign, C::Energy, M::DampingSign),
        (Bug::TooMuchDamping, C::RestitutionWall, M::RestitutionWrong),
    ];
    let mut wrong = 0;
    println!("{:>20}  {:<34}  lost, five seeds (check:cause xN)", "bug", "expected");
    for (bug, check, cause) in cases {
        let (eta, rubric) =
            if bug == Bug::DampingSign { (0.7, damped()) } else { (0.0, elastic()) };
        let mut seen: Vec<(String, usize)> = Vec::new();
        for seed in 1..6 {
            let report =
                grade(Program { eta, ..Program::new(bug, seed) }.output().as_bytes(), &rubric);
            // The same mistake shows at walls and in pairs: both restitutions may be lost.
            let expected = |(c, m): &(Check, Option<Mistake>)| {
                let twin = cause == M::RestitutionWrong && *c == C::RestitutionPair;
                (*c == check || twin) && *m == Some(cause)
            };
            let lost = lost(&report);
            wrong += usize::from(!(lost.iter().all(expected) && !lost.is_empty()));
            let said =
                lost.iter().map(|(c, m)| format!("{}:{}", c.id(), m.map_or("-".into(), M::id)));
            let said = said.collect::<Vec<_>>().join(" ");
            match seen.iter_mut().find(|(known, _)| *known == said) {
                Some((_, count)) => *count += 1,
                None => seen.push((said, 1)),
            }
        }
        let seen = seen.iter().map(|(said, count)| format!("{said} x{count}"));
        let expected = format!("{}:{}", check.id(), cause.id());
        println!(
            "{:>20}  {expected:<34}  {}",
            format!("{bug:?}"),
            seen.collect::<Vec<_>>().join(", ")
        );
    }
    assert_eq!(wrong, 0, "of 100; the table above says which");
}

#[test]
fn parsim2d_itself_loses_nothing() {
    let base = ["--restitution 1", "--eta 1.5e-3", "--restitution 0.7"];
    let rubrics =
        [elastic(), Rubric::default(), Rubric { restitution: Some(0.7), ..Rubric::default() }];
    let cases = [
        "-n 20 --radius 1e-4",
        "-n 20 --radius 5e-4 --speed 0.5",
        "-n 300 --radius 1e-4",
        "-n 300 --radius 1e-4 --speed 0.5 --every 40 --time 50ms",
        "-n 20 --radius 5e-4 --every 1 --time 20ms",
        "-n 20 --radius 5e-4 --every 7 --time 50ms --speed 0.3",
        "-n 60 --radius 5e-4 --every 100 --speed 0.5",
    ];
    for case in cases {
        for (damping, rubric) in base.iter().zip(&rubrics) {
            for (seed, integrator) in
                [(1, "symplectic-euler"), (2, "velocity-verlet"), (3, "symplectic-euler")]
            {
                let folder = tempfile::tempdir().unwrap();
                let time = if case.contains("--time") { "" } else { "--time 0.5" };
                let arguments =
                    format!("{case} {damping} --seed {seed} --integrator {integrator} {time} -q");
                let run = outcome(folder.path(), &arguments);
                assert!(run.status.success(), "{arguments}: {}", text(&run.stderr));
                let report =
                    grade(&fs::read(folder.path().join("trajectory.txt")).unwrap(), rubric);
                assert_eq!(lost(&report), [], "{arguments}: {:#?}", report.checks);
                assert!(report.passed(Check::FreeFlight), "{arguments}: {:#?}", report.checks);
                assert_eq!(report.percent(), 100.0, "{arguments}");
            }
        }
    }
}

#[test]
fn what_is_no_mistake_costs_nothing() {
    let plain = Program::new(Bug::None, 3).output();
    let lines = |change: &dyn Fn(&str) -> String| plain.lines().map(change).collect::<String>();
    let each = |more: &'static str| {
        move |line: &str| match line {
            "" => "\n".to_owned(),
            line => format!("{line}{more}\n"),
        }
    };
    let frames: Vec<&str> = plain.split("\n\n").collect();
    let border = "0 0.01 0.01\n0.04 0.02 0.01\n0.02 -0.01 0.01";
    let cut = |frame: &str| frame[..frame.len() / 2].to_owned();
    let cases = [
        ("CRLF", plain.replace('\n', "\r\n")),
        ("more columns", lines(&each(" 0.5 0.25 red"))),
        ("commas", plain.replace(' ', ", ")),
        ("no blank lines", plain.replace("\n\n", "\n")),
        ("names", format!("x y r\n{plain}")),
        ("remarks for blank lines", plain.replace("\n\n", "\n# frame\n")),
        (
            "a border",
            frames.iter().filter(|f| !f.is_empty()).map(|f| format!("{f}\n{border}\n\n")).collect(),
        ),
        (
            "every tenth frame cut",
            frames
                .iter()
                .enumerate()
                .map(|(k, f)| if k % 10 == 5 { cut(f) + "\n\n" } else { format!("{f}\n\n") })
                .collect(),
        ),
        (
            "every tenth frame gone",
            frames
                .iter()
                .enumerate()
                .filter(|(k, _)| k % 10 != 5)
                .map(|(_, f)| format!("{f}\n\n"))
                .collect(),
        ),
        ("the last frame sooner", format!("{plain}{}", frames[frames.len() - 2])),
    ];
    let rubric = Rubric { n: vec![20], ..elastic() };
    for (what, text) in cases {
        let report = grade(text.as_bytes(), &rubric);
        assert_eq!(lost(&report), [], "{what}: {:#?}", report.checks);
        assert_eq!(report.discs, 20, "{what}");
        assert!(report.passed(Check::FreeFlight), "{what}: {:#?}", report.checks);
    }
}

#[test]
fn what_hangs_on_a_failure_is_skipped_and_costs_nothing_unless_the_rubric_says_so() {
    let text = Program::new(Bug::GravitySign, 1).output();
    let report = grade(text.as_bytes(), &elastic());
    let skipped = report.checks.iter().filter(|(_, s)| *s == Status::Skipped(Check::FreeFlight));
    assert_eq!(skipped.count(), 5);
    assert_eq!((report.earned(), report.lost(), report.open()), (5.0, 3.0, 8.0));
    let strict = Rubric::parse("skipped = \"lost\"\nrestitution = 1.0").unwrap();
    let report = grade(text.as_bytes(), &strict);
    assert_eq!((report.earned(), report.lost(), report.open()), (5.0, 11.0, 0.0));
    let empty = grade(b" \n", &elastic());
    assert_eq!(lost(&empty), [(Check::Frames, Some(Mistake::EmptyFile))]);
    assert_eq!((empty.percent(), empty.checks.len()), (0.0, 11));
    let two = grade(b"1 2\n3 4\n", &elastic());
    assert_eq!(lost(&two), [(Check::Frames, Some(Mistake::WrongColumns))]);
}

#[test]
fn the_command_grades_explains_and_refuses() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("good.txt"), Program::new(Bug::None, 1).output()).unwrap();
    fs::write(path("bad.txt"), Program::new(Bug::GravitySign, 1).output()).unwrap();
    fs::write(path("bad.toml"), "radios = 3").unwrap();
    fs::write(path("range.toml"), "kn = -1").unwrap();
    let init = outcome(folder.path(), "grade --init-rubric");
    fs::write(path("new.toml"), &init.stdout).unwrap();
    assert_eq!(Rubric::parse(&text(&init.stdout)).unwrap(), {
        let points = Check::ALL.map(|check| (check, check.usual_points())).into();
        Rubric { points, ..Rubric::default() }
    });
    let cases = [
        ("grade --frames good.txt --rubric new.toml --fail-under 100", 0, ":) free_flight"),
        ("grade --frames bad.txt", 0, "[gravity_sign]"),
        ("grade --frames good.txt bad.txt --fail-under 70", 1, ":( free_flight"),
        ("grade --frames bad.txt --json", 0, "\"id\": \"gravity_sign\""),
        ("grade --explain energy", 0, "energy: energy is never made (2 points)"),
        ("grade --explain enrgy", 2, "free_flight"),
        ("grade --frames good.txt --rubric bad.toml", 2, "radios"),
        ("grade --frames good.txt --rubric range.toml", 2, "kn = -1"),
        ("grade --frames good.txt --fail-under 101", 2, "0 to 100"),
        ("grade", 2, "--frames"),
        ("grade --frames nowhere.txt", 3, "nowhere.txt cannot be read"),
    ];
    for (arguments, code, said) in cases {
        let output = outcome(folder.path(), arguments);
        let all = text(&output.stdout) + &text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments}: {all}");
        assert!(all.contains(said), "{arguments}: {all}");
    }
    let json = outcome(folder.path(), "grade --frames good.txt bad.txt --json");
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json[1]["checks"][5]["failure"]["cause"]["id"], "gravity_sign");
    assert_eq!(json[1]["checks"][6]["status"], "skipped");
}

proptest! {
    #![proptest_config(support::steady())]

    /// Bytes of any kind, and numbers in any disorder, give a report of every check.
    #[test]
    fn no_bytes_make_the_grader_fall_over(
        bytes in proptest::collection::vec(any::<u8>(), 0..400),
        rows in proptest::collection::vec((any::<f64>(), -0.01..0.05f64, -1e-3..1e-3f64, 0..9u8), 0..120),
    ) {
        prop_assert_eq!(grade(&bytes, &elastic()).checks.len(), 11);
        let mut text = String::new();
        for (wild, x, r, kind) in rows {
            match kind {
                0 => text.push_str("\n\n"),
                1 => writeln!(text, "{wild} {x} {r}").unwrap(),
                2 => writeln!(text, "{x} {r}").unwrap(),
                _ => writeln!(text, "{x} {x} {r}").unwrap(),
            }
        }
        for rubric in [elastic(), Rubric { n: vec![1, 2, 3], ..damped() }] {
            prop_assert_eq!(grade(text.as_bytes(), &rubric).checks.len(), 11);
        }
    }
}
