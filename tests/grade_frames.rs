//! Grading frames: right programs lose nothing, a bug costs the right check and is named.
#![allow(clippy::too_many_lines)] // tables of cases

use std::fmt::Write as _;
use std::fs;

use parsim2d::grading::judge::check::Check;
use parsim2d::grading::judge::frames::Footage;
use parsim2d::grading::judge::mistake::Mistake;
use parsim2d::grading::judge::rubric::Rubric;
use parsim2d::grading::judge::rubric::program::Program as Course;
use parsim2d::grading::judge::words::Finding;
use parsim2d::grading::judge::{grade, grade_film};
use proptest::prelude::*;

use crate::support::runs;
use crate::support::student;

use runs::{outcome, text};
use student::{Bug, Program, damped, elastic, lost};

#[test]
fn right_programs_lose_nothing_and_every_check_is_seen() {
    for seed in 1..6 {
        for (eta, rubric) in [(0.0, elastic()), (0.7, damped())] {
            let report = grade(
                Program { eta, ..Program::new(Bug::None, seed) }.output().as_bytes(),
                &rubric,
            );
            assert_eq!(lost(&report), [], "seed {seed}, eta {eta}: {:#?}", report.checks);
            // A pair's restitution needs two straight hits with nobody else near: one seed has one. And
            // the film is too short for its end to be judged.
            assert!(report.open() <= 2.0, "seed {seed}, eta {eta}: {:#?}", report.checks);
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
        (Bug::DampingSign, C::RestitutionWall, M::DampingSign),
        (Bug::TooMuchDamping, C::RestitutionWall, M::EnergyLostElastic),
        (Bug::ForceOverWrongMass, C::Box, M::ForceOverWrongMass),
        (Bug::NormalNotNormalised, C::PairCollision, M::NormalNotNormalised),
        (Bug::ForceAppliedTwice, C::RestitutionPair, M::ForceAppliedTwice),
        (Bug::DashpotAtFloorOnly, C::RestitutionWall, M::EnergyLostElastic),
        (Bug::LastMeetsNobody, C::PairCollision, M::PairsLeftOut),
        (Bug::FloorSticks, C::RestitutionWall, M::SticksToWall),
        (Bug::ForcesNotReset, C::FreeFlight, M::ForcesNotReset),
        (Bug::SoftSprings, C::Box, M::StiffnessWrong),
        (Bug::SoftPairs, C::PairCollision, M::StiffnessWrong),
        (Bug::SameSign, C::PairCollision, M::ReactionSign),
        (Bug::Sleeps, C::FreeFlight, M::StoppedInTheAir),
        (Bug::SpeedLimit, C::FreeFlight, M::SpeedsSet),
        (Bug::WallFurther, C::Box, M::WallElsewhere),
        (Bug::Periodic, C::Box, M::WallMissing),
        (Bug::NoDashpot, C::RestitutionWall, M::DashpotMissing),
        (Bug::MovesCopies, C::Frames, M::NothingMoves),
    ];
    let mut wrong = 0;
    println!("{:>20}  {:<34}  lost, three seeds (check:cause xN)", "bug", "expected");
    for (bug, check, cause) in cases {
        use Bug as B;
        let is_damped = matches!(bug, B::DampingSign | B::ForceAppliedTwice | B::NoDashpot);
        let (eta, rubric) = if is_damped { (0.7, damped()) } else { (0.0, elastic()) };
        let mut seen: Vec<(String, usize)> = Vec::new();
        for seed in 1..4 {
            let report =
                grade(Program { eta, ..Program::new(bug, seed) }.output().as_bytes(), &rubric);
            // The same mistake shows at walls and in pairs: both restitutions may be lost.
            let expected = |(c, m): &(Check, Option<Mistake>)| {
                // How long pairs touch tells a force that is applied twice before its restitution does.
                let twin = match check {
                    C::RestitutionWall => *c == C::RestitutionPair,
                    C::RestitutionPair => *c == C::PairCollision,
                    _ => false,
                };
                // A pair that runs off among others at once is known by the energy only.
                let is_energy = bug == B::SameSign && (*c, *m) == (C::Energy, Some(M::EnergyPump));
                (*c == check || twin) && *m == Some(cause) || is_energy
            };
            let lost = lost(&report);
            wrong += usize::from(!lost.iter().all(expected) || lost.is_empty());
            let said = lost.iter().map(|(c, m)| format!("{}:{}", c.id(), m.map_or("-", M::id)));
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
    assert_eq!(wrong, 0, "of 108; the table above says which");
}

#[test]
fn explicit_euler_without_a_dashpot_is_not_taken_for_a_wrong_sign_of_it() {
    // e = 1.18 at walls and 1.26 of pairs, where 1/0.855 and 1/0.800 are what the wrong sign gives.
    for seed in 1..6 {
        for (bug, eta, check, cause) in [
            (Bug::ExplicitEuler, 0.0, Check::Energy, Mistake::ExplicitEuler),
            (Bug::DampingSign, 0.7, Check::RestitutionWall, Mistake::DampingSign),
        ] {
            let program = Program { eta, ..Program::new(bug, seed) };
            let report = grade(program.output().as_bytes(), &damped());
            let lost = lost(&report);
            assert_eq!(lost[0], (check, Some(cause)), "{bug:?}, seed {seed}: {:#?}", report.checks);
            assert!(lost.iter().all(|(_, said)| *said == Some(cause)), "{bug:?}, seed {seed}");
        }
    }
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
        let manners = [(1, "symplectic-euler"), (2, "velocity-verlet"), (3, "symplectic-euler")];
        for ((damping, rubric), (seed, integrator)) in base.iter().zip(&rubrics).zip(manners) {
            let folder = tempfile::tempdir().unwrap();
            let time = if case.contains("--time") { "" } else { "--time 0.5" };
            let arguments =
                format!("{case} {damping} --seed {seed} --integrator {integrator} {time} -q");
            let run = outcome(folder.path(), &arguments);
            assert!(run.status.success(), "{arguments}: {}", text(&run.stderr));
            let report = grade(&fs::read(folder.path().join("trajectory.txt")).unwrap(), rubric);
            assert_eq!(lost(&report), [], "{arguments}: {:#?}", report.checks);
            assert!(report.passed(Check::FreeFlight), "{arguments}: {:#?}", report.checks);
            assert_eq!(report.percent(), 100.0, "{arguments}");
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
    // Somewhere in a line; half of 20 lines would be the end of one.
    let cut = |frame: &str| frame[..frame.len() * 4 / 9].to_owned();
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
fn a_file_that_is_no_film_says_what_is_wrong_with_it() {
    let plain = Program::new(Bug::None, 1).output();
    let together = plain.replace("\n\n", "");
    let dips = |text: &str| {
        let frames = text.split("\n\n").enumerate().map(|(k, frame)| match k % 3 {
            1 => frame.split_once('\n').map_or("", |(_, rest)| rest),
            _ => frame,
        });
        frames.map(|frame| format!("{frame}\n\n")).collect::<String>()
    };
    use Check::{Discs, Frames};
    for (what, text, check, cause) in [
        ("commas alone", plain.replace(' ', ","), Frames, Mistake::WrongColumns),
        ("words", "these are\nno numbers\n".repeat(9), Frames, Mistake::WrongColumns),
        ("remarks", "# t = 0\n\n\n# t = 1\n".into(), Frames, Mistake::NoFrames),
        ("rows that run together", together, Frames, Mistake::FrameTorn),
        ("a disc that comes and goes", dips(&plain), Discs, Mistake::DiscLost),
    ] {
        let report = grade(text.as_bytes(), &elastic());
        assert_eq!(lost(&report), [(check, Some(cause))], "{what}");
    }
    let short = Rubric { n: vec![21], ..elastic() };
    let report = grade(plain.as_bytes(), &short);
    assert_eq!(lost(&report), [(Discs, Some(Mistake::DiscLost))], "20 where 21 are asked for");
}

/// Discs in rows, so near to each other that none is free: 0.1 mm between them, and none on the floor.
fn crowd() -> String {
    let row = |i: usize| {
        let (x, y) = (0.001 + 0.0011 * (i % 35) as f64, 0.001 + 0.0011 * (i / 35) as f64);
        format!("{x:.6} {y:.6} 5e-4\n")
    };
    (0..35 * 35).map(row).collect::<String>() + "\n"
}

#[test]
fn frames_that_show_no_motion_earn_no_full_marks_however_they_were_written() {
    let moving = Program::new(Bug::None, 1).output();
    let first = |count: usize| -> Vec<Vec<u8>> {
        let frames = moving.split_inclusive("\n\n").take(count);
        frames.map(|frame| frame.as_bytes().to_vec()).collect()
    };
    for (count, percent) in [(1, 0.0), (2, 0.0), (19, 0.0), (20, 100.0)] {
        let frames = first(count);
        let file = frames.concat();
        for footage in [Footage::File(&file), Footage::Snapshots(&frames)] {
            let report = grade_film(footage, &elastic());
            assert_eq!(report.percent(), percent, "{count} frames: {:#?}", report.checks);
            let failed = report.failures().map(|(check, why)| (check, why.finding)).next();
            let expected = (count < 20).then_some((Check::Frames, Finding::TooFewFrames));
            assert_eq!(failed, expected, "{count} frames");
        }
    }
    let few = Course { frames_at_least: 1, ..elastic().program };
    let least = grade(&first(2).concat(), &Rubric { program: few, ..elastic() });
    assert_eq!(lost(&least), [(Check::Frames, None)], "a second difference takes three frames");
    let hanging = String::from_utf8(first(1).concat()).unwrap();
    let floor: String = (1..20).map(|i| format!("{} 5e-4 5e-4\n", 0.002 * f64::from(i))).collect();
    for (what, frame) in
        [("in the air", hanging), ("in a crowd", crowd()), ("on the floor", floor + "\n")]
    {
        let report = grade(frame.repeat(30).as_bytes(), &elastic());
        assert_eq!(lost(&report), [(Check::Frames, Some(Mistake::NothingMoves))], "{what}");
        assert_eq!(report.percent(), 0.0, "{what}");
    }
    // A film that is cut because it blew up was long enough before.
    let blown = first(30).into_iter().enumerate().map(|(k, frame)| {
        let frame = String::from_utf8(frame).unwrap();
        let (_, rest) = frame.split_once(' ').unwrap();
        match k {
            0..8 => frame,
            8 => format!("1e90 {rest}"),
            _ => format!("inf {rest}"),
        }
    });
    let report = grade(blown.collect::<String>().as_bytes(), &elastic());
    assert!(report.passed(Check::Frames) && report.frames == 9, "{:#?}", report.checks);
}

/// Manners of saying which frame it is: before each, after each, and whether blank lines part frames as well.
const MANNERS: [(&str, &str, &str); 14] = [
    ("t = {t}\n", "", "\n"),
    ("t={t}\n", "", ""),
    ("20\n", "", "\n"),
    ("20\nframe {k}\n", "", ""),
    ("20\n\n", "", ""),
    ("frame {k}/400\n", "", "\n"),
    ("{t}\n", "", "\n"),
    ("{t}\n", "", ""),
    ("{t}\n\n", "", "\n"),
    ("t = {t} s\n\n", "", "\n"),
    ("", "---\n", ""),
    ("", "end of frame {k}\n", "\n"),
    ("{k} {t}\n", "", "\n"),
    ("ITEM: TIMESTEP\n{k}\nITEM: BOX BOUNDS\n0 0.04\n0 0.04\nITEM: ATOMS x y r\n", "", ""),
];

/// Frames of a right program written in one of these manners; times are printed as C++ does, 0 among them.
fn in_manner((before, after, blank): (&str, &str, &str), frames: &[&str]) -> Vec<String> {
    let write = |(k, frame): (usize, &&str)| {
        let said = |text: &str| {
            let t = (k as f64 * 1e-3).to_string();
            text.replace("{k}", &k.to_string()).replace("{t}", &t)
        };
        format!("{}{frame}\n{}{blank}", said(before), said(after))
    };
    frames.iter().enumerate().map(write).collect()
}

#[test]
fn lines_that_say_which_frame_it_is_cost_nothing_with_blank_lines_or_without() {
    let plain = Program::new(Bug::None, 3).output();
    let frames: Vec<&str> = plain.split("\n\n").filter(|frame| !frame.is_empty()).collect();
    for manner in MANNERS {
        let written = in_manner(manner, &frames);
        let file = written.concat();
        let snapshots: Vec<Vec<u8>> = written.into_iter().map(String::into_bytes).collect();
        for footage in [Footage::File(file.as_bytes()), Footage::Snapshots(&snapshots)] {
            for n in [vec![], vec![20]] {
                let report = grade_film(footage, &Rubric { n, ..elastic() });
                assert_eq!(lost(&report), [], "{manner:?}: {:#?}", report.checks);
                let seen = (report.frames, report.discs, report.torn);
                assert_eq!(seen, (400, 20, 0), "{manner:?}");
                assert!(report.passed(Check::FreeFlight), "{manner:?}: {:#?}", report.checks);
            }
        }
    }
    // Words between the same discs of each frame part nothing; a title and a last word are no frames.
    let walls = frames.iter().map(|frame| {
        let (at, _) = frame.match_indices('\n').nth(4).unwrap();
        format!("{}\nthe others{}\n\n", &frame[..at], &frame[at..])
    });
    let walls = format!("My simulation\n\n{}done\n", walls.collect::<String>());
    let report = grade(walls.as_bytes(), &elastic());
    assert_eq!((lost(&report), report.frames, report.torn), (vec![], 400, 0));
}

#[test]
fn a_wrong_program_loses_the_same_whatever_lines_stand_between_its_frames() {
    for (bug, check, cause) in [
        (Bug::DiscLost, Check::Discs, Mistake::DiscLost),
        (Bug::GravitySign, Check::FreeFlight, Mistake::GravitySign),
        (Bug::Diameter, Check::Radii, Mistake::DiameterAsRadius),
    ] {
        let plain = Program::new(bug, 2).output();
        let frames: Vec<&str> = plain.split("\n\n").filter(|frame| !frame.is_empty()).collect();
        for manner in MANNERS {
            let report = grade(in_manner(manner, &frames).concat().as_bytes(), &elastic());
            assert_eq!(lost(&report), [(check, Some(cause))], "{bug:?}, {manner:?}");
        }
    }
}

#[test]
fn lines_that_are_no_disc_are_shown_as_they_stand_there() {
    let plain = Program::new(Bug::None, 1).output();
    let row = plain.lines().next().unwrap();
    let long = format!("{} {}", "wide;".repeat(40), "\u{202e}");
    for (text, shown) in [
        (plain.replace(' ', ";"), row.replace(' ', ";")),
        (format!("x;y;r\n{}", plain.replace(' ', ",")), row.replace(' ', ",")),
        (long, format!("{} ...", "wide;".repeat(12))),
        ("a\u{1b}[31m b\n".to_owned(), "a\\u{1b}[31m b".to_owned()),
    ] {
        let report = grade(text.as_bytes(), &elastic());
        assert_eq!(lost(&report), [(Check::Frames, Some(Mistake::WrongColumns))]);
        let (_, why) = report.failures().next().unwrap();
        assert_eq!(why.said, Some(format!("the first of these lines: {shown}")));
    }
}

/// Each row of a film changed by the numbers in it.
fn with_rows(plain: &str, change: impl Fn(usize, [f64; 3]) -> String) -> String {
    let mut k = 0;
    let row = |line: &str| {
        let numbers: Vec<f64> = line.split(' ').filter_map(|word| word.parse().ok()).collect();
        let Ok(numbers) = <[f64; 3]>::try_from(numbers) else { return "\n".to_owned() };
        k += 1;
        change(k - 1, numbers) + "\n"
    };
    plain.lines().map(row).collect()
}

type Change = fn(usize, [f64; 3]) -> String;

#[test]
fn columns_units_and_a_box_elsewhere_are_told_by_name_and_cost_one_check() {
    use Mistake::{BoxShifted, ColumnsExchanged, OtherUnit};
    let cases: [(&str, Check, Mistake, Change); 12] = [
        ("id x y r", Check::Radii, ColumnsExchanged, |k, [x, y, r]| {
            format!("{} {x} {y} {r}", k % 20)
        }),
        ("r x y", Check::Radii, ColumnsExchanged, |_, [x, y, r]| format!("{r} {x} {y}")),
        ("x r y", Check::Radii, ColumnsExchanged, |_, [x, y, r]| format!("{x} {r} {y}")),
        ("x y z r", Check::Radii, ColumnsExchanged, |_, [x, y, r]| format!("{x} {y} 0 {r}")),
        ("t x y r", Check::Radii, ColumnsExchanged, |k, [x, y, r]| {
            format!("{} {x} {y} {r}", k / 20)
        }),
        ("x y m id r", Check::Radii, ColumnsExchanged, |k, [x, y, r]| {
            format!("{x} {y} 1e-3 {} {r}", k % 20)
        }),
        ("mm", Check::Radii, OtherUnit, |_, all| all.map(|v| format!("{:.6}", 1e3 * v)).join(" ")),
        ("mm, fixed", Check::Radii, OtherUnit, |_, all| {
            all.map(|v| format!("{}", (1e8 * v).round() / 1e5)).join(" ")
        }),
        ("cm", Check::Radii, OtherUnit, |_, all| {
            all.map(|v| format!("{}", (1e9 * v).round() / 1e7)).join(" ")
        }),
        ("centred", Check::Box, BoxShifted, |_, [x, y, r]| {
            format!("{:.9} {:.9} {r}", x - 0.02, y - 0.02)
        }),
        ("centred, as C++", Check::Box, BoxShifted, |_, [x, y, r]| {
            format!("{:e} {:e} {r}", x as f32 - 0.02, y as f32 - 0.02)
        }),
        ("centred in x", Check::Box, BoxShifted, |_, [x, y, r]| {
            format!("{:.9} {y:.9} {r}", x - 0.02)
        }),
    ];
    for seed in 1..4 {
        let plain = Program::new(Bug::None, seed).output();
        let wrong = Program::new(Bug::GravitySign, seed).output();
        for (what, check, cause, change) in cases {
            let report = grade(with_rows(&plain, change).as_bytes(), &elastic());
            assert_eq!(lost(&report), [(check, Some(cause))], "{what}: {:#?}", report.checks);
            assert!(report.passed(Check::FreeFlight) && report.passed(Check::Energy), "{what}");
            // A second mistake is judged as well.
            let report = grade(with_rows(&wrong, change).as_bytes(), &elastic());
            assert!(report.failed(Check::FreeFlight), "{what}: {:#?}", report.checks);
        }
    }
}

#[test]
fn what_no_column_unit_or_corner_makes_right_keeps_its_own_cause() {
    let plain = Program::new(Bug::None, 1).output();
    let cases: [(&str, Change); 4] = [
        ("radii in mm alone", |_, [x, y, r]| format!("{x} {y} {}", 1e3 * r)),
        ("radius of another course", |_, [x, y, r]| format!("{x} {y} {}", 3.0 * r)),
        ("no radius", |k, [x, y, _]| format!("{x} {y} {}", k % 20)),
        ("all lengths 10 times", |_, all| all.map(|v| (10.0 * v).to_string()).join(" ")),
    ];
    for (what, change) in cases {
        let report = grade(with_rows(&plain, change).as_bytes(), &elastic());
        let radii = lost(&report).into_iter().find(|(check, _)| *check == Check::Radii);
        assert_eq!(radii, Some((Check::Radii, None)), "{what}: {:#?}", report.checks);
    }
    // Whoever falls out of the box is not at home elsewhere.
    for bug in [Bug::WallMissing, Bug::InwardWallNormal, Bug::PlacedInWall] {
        for seed in 1..9 {
            let report = grade(Program::new(bug, seed).output().as_bytes(), &elastic());
            assert!(lost(&report).iter().all(|(_, cause)| *cause != Some(Mistake::BoxShifted)));
        }
    }
}

#[test]
fn one_frame_alone_is_told_by_name() {
    let plain = Program::new(Bug::None, 1).output();
    let frames: Vec<&str> = plain.split_inclusive("\n\n").collect();
    for (count, cause) in [(1, Some(Mistake::OnlyTheLastFrame)), (2, None)] {
        let report = grade(frames[..count].concat().as_bytes(), &elastic());
        assert_eq!(lost(&report), [(Check::Frames, cause)]);
    }
}

proptest! {
    #![proptest_config(crate::support::steady())]

    /// Bytes of any kind, and numbers in any disorder, give a report of every check.
    #[test]
    fn no_bytes_make_the_grader_fall_over(
        bytes in proptest::collection::vec(any::<u8>(), 0..400),
        rows in proptest::collection::vec((any::<f64>(), -0.01..0.05f64, -1e-3..1e-3f64, 0..9u8), 0..120),
    ) {
        prop_assert_eq!(grade(&bytes, &elastic()).checks.len(), 12);
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
            prop_assert_eq!(grade(text.as_bytes(), &rubric).checks.len(), 12);
        }
    }
    /// A film with lines between its frames loses nothing if its end is cut off anywhere, nor if frames of it are.
    #[test]
    fn frames_in_any_manner_may_be_cut_anywhere(
        manner in 0..MANNERS.len(),
        end in 0.4..1.0f64,
        cuts in proptest::collection::vec((0..60usize, 0.0..1.0f64), 0..4),
        n in 0..2usize,
    ) {
        let plain = Program { frames: 60, ..Program::new(Bug::None, 3) }.output();
        let frames: Vec<&str> = plain.split("\n\n").filter(|frame| !frame.is_empty()).collect();
        let written = in_manner(MANNERS[manner], &frames);
        let part = |text: &str, part: f64| text[..(text.len() as f64 * part) as usize].to_owned();
        let rubric = Rubric { n: vec![20; n], ..elastic() };
        let cut_end = part(&written.concat(), end);
        let report = grade(cut_end.as_bytes(), &rubric);
        prop_assert_eq!(lost(&report), [], "{:?}, cut at {}: {:#?}", MANNERS[manner], end, report.checks);
        prop_assert!(report.discs == 20 && report.frames >= 22, "{:?}: {}", MANNERS[manner], report.frames);
        let mut snapshots = written.clone();
        for (k, at) in cuts {
            snapshots[k] = part(&snapshots[k], at);
        }
        let snapshots: Vec<Vec<u8>> = snapshots.into_iter().map(String::into_bytes).collect();
        let report = grade_film(Footage::Snapshots(&snapshots), &rubric);
        prop_assert_eq!(lost(&report), [], "{:?}: {:#?}", MANNERS[manner], report.checks);
        prop_assert!(report.discs == 20 && report.frames >= 52);
    }
}
