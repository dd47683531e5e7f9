//! Reports of grading: points, words, rubrics, the command, and what the documents show.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use parsim2d::grading::judge::check::Check;
use parsim2d::grading::judge::frames::Footage;
use parsim2d::grading::judge::mistake::Mistake;
use parsim2d::grading::judge::rubric::{PrintedEta, Rubric};
use parsim2d::grading::judge::verdict::{Failure, Report, Status};
use parsim2d::grading::judge::words::{ENGLISH, Note};
use parsim2d::grading::judge::{add_film, add_many, grade, grade_film};

use crate::support::runs;
use crate::support::student;

use runs::{outcome, text};
use student::{Bug, Program, elastic, lost};

#[test]
fn what_hangs_on_a_failure_is_skipped_and_costs_nothing_unless_the_rubric_says_so() {
    let text = Program::new(Bug::GravitySign, 1).output();
    let report = grade(text.as_bytes(), &elastic());
    let skipped = report.checks.iter().filter(|(_, s)| *s == Status::Skipped(Check::FreeFlight));
    assert_eq!(skipped.count(), 6);
    assert_eq!((report.earned(), report.lost(), report.open()), (5.0, 3.0, 9.0));
    let strict = Rubric::parse("skipped = \"lost\"\nrestitution = 1.0").unwrap();
    let report = grade(text.as_bytes(), &strict);
    assert_eq!((report.earned(), report.lost(), report.open()), (5.0, 12.0, 0.0));
    let empty = grade(b" \n", &elastic());
    assert_eq!(lost(&empty), [(Check::Frames, Some(Mistake::EmptyFile))]);
    assert_eq!((empty.percent(), empty.checks.len()), (0.0, 12));
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
        // Unit tests are commented out, and so are their points.
        let asked = Check::ALL.into_iter().filter(|check| *check != Check::Interface);
        let points = asked.map(|check| (check, check.usual_points())).collect();
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
        ("grade", 2, "<SUBMISSION>"),
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

/// Discs that fall from different heights and stay where they touch the floor: what a damping far
/// above critical does.
fn sticky() -> String {
    let mut text = String::new();
    for k in 0..100 {
        for i in 0..10 {
            let (x, y) = (0.003 + 0.003 * f64::from(i), 0.02 + 0.001 * f64::from(i));
            let y = (y - 4e-6 * f64::from(k * k)).max(5e-4);
            writeln!(text, "{x:.8} {y:.8} 5e-4").unwrap();
        }
        text.push('\n');
    }
    text
}

#[test]
fn full_marks_for_little_are_said_to_be_for_little() {
    // Three discs that fall and meet nobody: free flight and energy, 5 of 11 points of motion.
    let frame = |k: usize| -> String {
        let fall = 4e-6 * (k * k) as f64;
        (1..4)
            .map(|i| format!("{} {:.9} 5e-4\n", 0.01 * f64::from(i), 0.03 - fall))
            .collect::<String>()
            + "\n"
    };
    let film: String = (0..60).map(frame).collect();
    let report = grade(film.as_bytes(), &elastic());
    assert_eq!(report.percent(), 100.0, "{:#?}", report.checks);
    assert!(report.notes.contains(&Note::LittleJudged));
    let usual = grade(Program::new(Bug::None, 1).output().as_bytes(), &elastic());
    assert!(!usual.notes.contains(&Note::LittleJudged));
}

#[test]
fn the_printed_eta_is_forgiven_with_a_note_unless_the_rubric_says_so() {
    let report = grade(sticky().as_bytes(), &Rubric::default());
    assert_eq!((lost(&report), &report.notes[..]), (vec![], &[Note::PrintedEta][..]));
    assert_eq!(report.percent(), 100.0);
    let strict = Rubric { printed_eta: PrintedEta::Wrong, ..Rubric::default() };
    let report = grade(sticky().as_bytes(), &strict);
    let expected = (Check::RestitutionWall, Some(Mistake::RestitutionWrong));
    assert_eq!((lost(&report), report.notes.len()), (vec![expected], 0));
    // Who was asked for it did it right, and needs no note of it (but discs that stay together show little else).
    let asked = Rubric { eta: 1.5e3, ..Rubric::default() };
    let report = grade(sticky().as_bytes(), &asked);
    assert_eq!((lost(&report), &report.notes[..]), (vec![], &[Note::LittleJudged][..]));
}

#[test]
fn snapshots_give_the_report_of_the_file_and_torn_ones_are_left_out() {
    let plain = Program::new(Bug::None, 2).output();
    let whole = grade(plain.as_bytes(), &elastic());
    let frames = plain.split_inclusive("\n\n").map(|frame| frame.trim_end().to_owned() + "\n");
    let mut frames: Vec<Vec<u8>> = frames.map(String::into_bytes).collect();
    let report = grade_film(Footage::Snapshots(&frames), &elastic());
    assert_eq!((&report.checks, report.frames), (&whole.checks, 400));
    // Caught while they were written: nothing yet, in a number, between lines.
    let cuts = [(50, 0), (100, 7), (150, 200), (200, frames[200].len() - 3)];
    for (k, length) in cuts {
        frames[k].truncate(length);
    }
    let report = grade_film(Footage::Snapshots(&frames), &elastic());
    assert_eq!(lost(&report), [], "{:#?}", report.checks);
    assert_eq!((report.frames, report.torn), (396, 3), "an empty one is no frame");
    let none = grade_film(Footage::Nothing, &elastic());
    assert_eq!(lost(&none), [(Check::Frames, Some(Mistake::NoFrames))]);
    let empty = grade_film(Footage::Snapshots(&vec![Vec::new(); 9]), &elastic());
    assert_eq!(lost(&empty), [(Check::Frames, Some(Mistake::EmptyFile))]);
}

#[test]
fn a_program_that_writes_its_history_anew_each_time_is_read_from_the_last_one() {
    let plain = Program { frames: 60, ..Program::new(Bug::None, 2) }.output();
    let ends = plain.match_indices("\n\n").map(|(at, _)| at + 2);
    let all: Vec<Vec<u8>> = ends.map(|end| plain.as_bytes()[..end].to_vec()).collect();
    assert_eq!(grade_film(Footage::Snapshots(&all), &elastic()).frames, 60);
}

/// A lattice of discs that fall freely.
fn lattice(n: usize) -> Vec<Vec<u8>> {
    let frame = |k: usize| {
        let rows = (0..n).map(|i| {
            let (x, y) = (0.001 + 0.0012 * (i % 32) as f64, 0.001 + 0.0012 * (i / 32) as f64);
            format!("{x:.8} {:.8} 5e-4\n", y - 4e-7 * (k * k) as f64)
        });
        rows.collect::<String>().into_bytes()
    };
    (0..12).map(frame).collect()
}

#[test]
fn a_thousand_discs_are_asked_for_after_all_else_and_judged_by_few_frames() {
    let report = |frames: &[Vec<u8>]| {
        let mut report = Report::of_submission(&elastic());
        add_many(&mut report, Footage::Snapshots(frames), 1000, &elastic());
        lost(&report)
    };
    assert_eq!(report(&lattice(1000)), []);
    assert_eq!(report(&lattice(100)), [(Check::Many, Some(Mistake::DiscLost))]);
    let mut bad = lattice(1000);
    bad[5] = String::from_utf8_lossy(&bad[5]).replacen("0.001", "nan", 1).into_bytes();
    assert_eq!(report(&bad), [(Check::Many, Some(Mistake::NotANumber))]);
    let mut near = lattice(1000);
    near[0] = String::from_utf8_lossy(&near[0]).replacen("0.0010", "0.0016", 1).into_bytes();
    assert_eq!(report(&near), [(Check::Many, Some(Mistake::PlacedOverlapping))]);
}

#[test]
fn what_goes_wrong_before_there_are_frames_skips_the_frames() {
    let mut report = Report::of_submission(&elastic());
    report.decide(Check::Files, || Status::Passed);
    report.decide(Check::Builds, || {
        Status::Failed(Failure::does_not_build("error: <b>expected</b> ';'\n"))
    });
    report.skip_the_rest();
    assert_eq!(lost(&report), [(Check::Builds, Some(Mistake::DoesNotBuild))]);
    let skipped = |(_, status): &&(Check, Status)| *status == Status::Skipped(Check::Builds);
    assert_eq!(report.checks.iter().filter(skipped).count(), 16);
    // What hangs on a build is lost with it, unless the rubric says otherwise.
    assert_eq!((report.earned(), report.lost(), report.open()), (1.0, 22.0, 0.0));
    let json = report.json(&ENGLISH);
    assert_eq!(json["checks"][1]["failure"]["said"], "error: <b>expected</b> ';'");
    assert_eq!(json["checks"][3]["needs"], "runs");
    // Of frames alone nothing is asked that needs a program.
    let json = grade(sticky().as_bytes(), &Rubric::default()).json(&ENGLISH);
    assert_eq!(
        (json["checks"].as_array().unwrap().len(), &json["checks"][0]["needs"]),
        (12, &().into())
    );
}

#[test]
fn a_rubric_may_leave_points_to_a_mistake_hide_a_check_and_say_it_in_its_own_words() {
    let rubric = Rubric::parse(
        "restitution = 1.0\n[partial]\nexplicit_euler = 0.75\n[visibility]\nenergy = \"after_due_date\"\n\
         [hints]\nexplicit_euler = \"See Eq. (3).\"\n",
    )
    .unwrap();
    let text = Program::new(Bug::ExplicitEuler, 1).output();
    let report = grade(text.as_bytes(), &rubric);
    assert_eq!(lost(&report), [(Check::Energy, Some(Mistake::ExplicitEuler))]);
    assert_eq!(report.lost(), 0.5, "a quarter of 2");
    let json = report.json(&ENGLISH);
    let energy = &json["checks"][10];
    assert_eq!((&energy["earned"], &energy["visibility"]), (&1.5.into(), &"after_due_date".into()));
    assert_eq!(energy["failure"]["cause"]["hint"], "See Eq. (3).");
    for (wrong, said) in [
        ("[partial]\nexplicit_euler = 2.0", "explicit_euler = 2 is out of range; it is 0 to 1"),
        ("[partial]\nexplicit_oiler = 0.5", "explicit_oiler"),
        ("[visibility]\nenergy = \"never\"", "after_due_date"),
        ("restitution_pair = 1.5", "restitution_pair = 1.5 is out of range"),
        ("law = \"soft\"", "spring"),
        ("corner = [0.0, inf]", "corner = inf"),
    ] {
        let why = Rubric::parse(wrong).unwrap_err();
        assert!(why.contains(said), "{wrong}: {why}");
    }
}

#[test]
fn a_failure_has_a_picture_that_the_json_does_not_hold_unasked() {
    let text = Program::new(Bug::GravitySign, 1).output();
    let mut report = Report::of_frames(&elastic());
    let film = add_film(&mut report, Footage::File(text.as_bytes()), &elastic());
    assert!(!report.json(&ENGLISH).to_string().contains("<svg"));
    let (_, failure) = report.failures().next().unwrap();
    let picture = failure.picture(&film.unwrap()).unwrap();
    let svg = roxmltree::Document::parse(&picture).unwrap();
    let circles = svg.descendants().filter(|node| node.has_tag_name("circle"));
    assert_eq!(circles.count(), 20);
}

/// A folder with the files that help and documents name.
fn desk() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    for name in ["out.txt", "a.txt", "good.txt"] {
        fs::write(path(name), Program::new(Bug::None, 1).output()).unwrap();
    }
    for name in ["b.txt", "bad.txt"] {
        fs::write(path(name), Program::new(Bug::GravitySign, 1).output()).unwrap();
    }
    let rubric = outcome(folder.path(), "grade --init-rubric").stdout;
    fs::write(path("course.toml"), rubric).unwrap();
    folder
}

#[test]
fn every_example_of_the_help_of_grade_runs() {
    let folder = desk();
    // Folders are graded where a sandbox works; elsewhere frames are.
    let doctor = outcome(folder.path(), "doctor --json");
    let found: serde_json::Value = serde_json::from_slice(&doctor.stdout).unwrap();
    let has_sandbox = !found["sandbox"]["tier"].is_null();
    fs::create_dir_all(folder.path().join("submissions/ada")).unwrap();
    let help = text(&outcome(folder.path(), "grade --help").stdout);
    let lines = help.lines().filter_map(|line| line.trim().strip_prefix("parsim2d "));
    let examples: Vec<&str> = lines.filter(|line| line.starts_with("grade ")).collect();
    assert!(examples.len() >= 5, "{help}");
    for example in examples {
        let words = example.split("  ").next().unwrap().split('>').next().unwrap();
        if words.contains("submissions/") && !has_sandbox {
            eprintln!("NOT TESTED: no sandbox works here: {words}");
            continue;
        }
        let words = &words.replace("submissions/*", "submissions/ada"); // as a shell does it
        let output = outcome(folder.path(), words);
        assert_eq!(output.status.code(), Some(0), "{words}: {}", text(&output.stderr));
        assert!(!output.stdout.is_empty(), "{words}");
    }
}

#[test]
fn the_guide_to_grading_shows_a_real_report_and_names_every_check() {
    let folder = desk();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join("docs/grading.md")).unwrap();
    let report = text(&outcome(folder.path(), "grade --frames bad.txt").stdout);
    assert!(page.contains(report.trim()), "docs/grading.md should show\n{report}");
    for check in Check::ALL {
        assert!(page.contains(&format!("`{}`", check.id())), "{} is not in the page", check.id());
    }
}
