//! The drift study: what one contact and a box of many do to the energy, and what is said of it.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Output;

use assert_cmd::Command;
use parsim2d::analysis::drift::{Course, observed_order};
use parsim2d::output::drift::{CurveRow, DriftRow, read, read_curves};
use parsim2d::scenario::settings::Settings;
use parsim2d::scenario::study::{Case, Study};
use serde_json::Value;

/// All contacts of the study at these N_t (and twice the last): courses by case, integrator, N_t.
fn contacts(nt: &[f64]) -> BTreeMap<(&'static str, &'static str), Vec<(f64, Course)>> {
    let settings = Settings { n: Some(20), ..Settings::default() };
    let mut courses = BTreeMap::<_, Vec<_>>::new();
    for run in Study::new(&settings, nt).unwrap().runs() {
        if run.case.is_one_contact() {
            let key = (run.case.name(), run.integrator.name());
            courses.entry(key).or_default().push((run.nt, run.course(&|_| {}).unwrap()));
        }
    }
    courses
}

fn order(courses: &[(f64, Course)], error: fn(&Course) -> f64) -> f64 {
    let errors: Vec<_> = courses.iter().map(|(nt, course)| (*nt, error(course))).collect();
    observed_order(&errors).unwrap()
}

#[test]
fn one_contact_shows_each_integrators_order_after_it_and_inside() {
    for ((case, integrator), courses) in contacts(&[400.0]) {
        let (after, inside) = match integrator {
            "explicit-euler" => (1.0, 1.0),
            "symplectic-euler" => (2.0, 1.0),
            _ => (2.0, 2.0),
        };
        // Between N_t = 400 and 800 the next order still shows by about pi/800 of the first-order
        // errors: measured at most 0.013 off; the second-order ones at most 0.002.
        let found = order(&courses, |course| course.final_error);
        assert!((found - after).abs() < 0.02, "{case} {integrator} after: {found}");
        let found = order(&courses, |course| course.largest_error);
        assert!((found - inside).abs() < 0.02, "{case} {integrator} inside: {found}");
    }
}

#[test]
fn the_worse_of_two_courses_has_the_larger_errors_with_their_signs() {
    let course = |largest_error, final_error| Course {
        dt: 1e-5,
        largest_error,
        final_error,
        energy_at_start: 1.0,
        dissipated: 0.0,
        work_error: final_error * 1e-12,
        stopped_at: None,
        curve: Vec::new(),
    };
    let (a, b) = (course(0.3, 0.01), course(0.2, -0.02));
    for worse in [a.clone().worse(&b), b.worse(&a)] {
        assert_eq!((worse.largest_error, worse.final_error), (0.3, -0.02));
        assert_eq!(worse.work_error, -0.02 * 1e-12);
    }
}

#[test]
fn one_contact_shows_the_known_errors_at_n_t_50() {
    let courses = contacts(&[50.0]);
    let errors = |case, integrator| {
        let (_, course) = &courses[&(case, integrator)][0];
        [course.final_error, course.largest_error]
    };
    // (case, integrator, after, inside): quoted to two digits in textbooks of this program, at
    // 50 steps; the study has 50.5 at a wall, 50.2 for a pair: 1 % less.
    for (case, integrator, after, inside) in [
        ("wall", "explicit-euler", 0.22, 0.22),
        ("pair", "explicit-euler", 0.32, 0.32),
        ("wall", "symplectic-euler", 9.7e-4, 0.032),
        ("wall", "velocity-verlet", 9.7e-4, 9.7e-4),
        ("pair", "symplectic-euler", 1.96e-3, 0.046),
    ] {
        let [found_after, found_inside] = errors(case, integrator);
        assert!(
            (found_after.abs() / after - 1.0).abs() < 0.025,
            "{case} {integrator} {found_after}"
        );
        assert!((found_inside / inside - 1.0).abs() < 0.025, "{case} {integrator} {found_inside}");
    }
}

#[test]
fn free_fall_shows_the_saw_tooth_of_eq_3() {
    let study = Study::new(&Settings { n: Some(1), ..Settings::default() }, &[]).unwrap();
    for nt in [10.0, 50.0] {
        let fall = study.saw_tooth(nt).unwrap();
        // Rounding of some thousand steps of 4e-4 J against 3e-8 J.
        assert!((fall.measured / fall.formula - 1.0).abs() < 1e-6, "{fall:?}");
        assert!((fall.speed / (9.81f64 * 0.04).sqrt() - 1.0).abs() < 1e-3, "{fall:?}"); // dt/t
    }
}

#[test]
fn phases_and_numbers_of_discs_are_those_asked_for() {
    let settings = Settings { n: Some(7), ..Settings::default() };
    let study = Study::new(&settings, &[50.0, 10.0, 10.0]).unwrap();
    assert_eq!(study.nt, [10.0, 50.0]);
    assert_eq!(study.boxes.each_ref().map(|scenario| scenario.n()), [20, 7]);
    let runs = study.runs();
    let wall = runs.iter().find(|run| run.case == Case::Wall).unwrap();
    // 16 phases of one disc over 1.5 contacts of 10.5 steps and two more: 18 steps.
    assert_eq!((wall.nt, wall.particle_steps()), (10.5, 16 * 18));
}

fn drift(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::cargo_bin("parsim2d").unwrap();
    command.current_dir(folder).arg("drift").args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// A small study: 60 discs, 0.05 s.
const SMALL: [&str; 6] = ["-n", "60", "--time", "0.05s", "--nt", "10,50"];

#[test]
fn files_have_the_promised_columns_and_read_back() {
    let folder = tempfile::tempdir().unwrap();
    let output = drift(folder.path(), &[&SMALL[..], &["--json"]].concat());
    assert!(output.status.success(), "{}", text(&output.stderr));
    let path = folder.path().join("drift.csv");
    let header =
        "case,integrator,restitution,nt,dt_s,largest_error,final_error,dissipated_J,work_error_J";
    assert!(fs::read_to_string(&path).unwrap().starts_with(header));
    let rows: Vec<DriftRow> = read(fs::File::open(&path).unwrap()).unwrap();
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    let printed: Vec<DriftRow> = serde_json::from_value(report["rows"].clone()).unwrap();
    assert_eq!(rows.len(), printed.len());
    for (row, printed) in rows.iter().zip(&printed) {
        assert_eq!(
            (&row.case, &row.integrator, row.nt.round()),
            (&printed.case, &printed.integrator, printed.nt.round())
        );
        // This reader of JSON may miss the last bit.
        let off = row.largest_error / printed.largest_error - 1.0;
        assert!(off.abs() < 1e-15 && row.final_error * printed.final_error > 0.0, "{row:?}");
    }
    for case in ["wall", "pair", "box", "dense"] {
        assert!(rows.iter().any(|row| row.case == case), "{case}");
    }
    let curve = folder.path().join("drift_energy.csv");
    let header = "case,integrator,restitution,nt,time_s,error";
    assert!(fs::read_to_string(&curve).unwrap().starts_with(header));
    let curves: Vec<CurveRow> = read_curves(fs::File::open(&curve).unwrap()).unwrap();
    let one = |row: &&CurveRow| {
        (row.case.as_str(), row.integrator.as_str(), row.restitution, row.nt)
            == ("box", "symplectic-euler", 1.0, 50.0)
    };
    assert!((300..=401).contains(&curves.iter().filter(one).count()));
    // The end of a curve is the row's final error.
    let row = rows.iter().find(|row| row.case == "box" && row.nt == 50.0).unwrap();
    assert_eq!(curves.iter().rfind(one).unwrap().error, row.final_error);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 4, "temporary files were left");
}

#[test]
fn the_same_study_gives_the_same_bytes() {
    let files = || {
        let folder = tempfile::tempdir().unwrap();
        let output = drift(folder.path(), &SMALL);
        let read = |name| fs::read(folder.path().join(name)).unwrap();
        (output.stdout, read("drift.csv"), read("drift_energy.csv"))
    };
    assert_eq!(files(), files());
}

#[test]
fn the_answer_has_the_measured_numbers_and_changes_with_them() {
    let folder = tempfile::tempdir().unwrap();
    let report = |arguments: &[&str]| -> (Value, String) {
        let output = drift(folder.path(), &[arguments, &["--json"]].concat());
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        let words = report["words"].as_array().unwrap().iter();
        let words = words.map(|word| word.as_str().unwrap()).collect::<Vec<_>>().join("\n");
        (report, words)
    };
    let (guide, words) = report(&SMALL);
    let contact = |report: &Value, case: &str, integrator: &str| {
        let contacts = report["answer"]["contacts"].as_array().unwrap().clone();
        contacts.into_iter().find(|c| c["case"] == case && c["integrator"] == integrator).unwrap()
    };
    let gain = contact(&guide, "wall", "explicit-euler")["after"].as_f64().unwrap();
    assert!(
        words.contains(&format!("Explicit Euler: no. It gains {:.1} %", 100.0 * gain)),
        "{words}"
    );
    assert!(words.contains("Eq. (3), the guide's Euler: nearly."), "{words}");
    assert!(words.contains("the same as Eq. (3)"), "{words}");
    assert!(words.contains("a saw-tooth, not a loss"), "{words}");
    assert!(words.contains("round-off, the bookkeeping is right"), "{words}");
    assert!(guide["answer"]["work_error"].as_f64().unwrap() < 1e-11);
    // So coarse that Eq. (3) is off by tens of percent at a bounce: other sentences.
    let (coarse, words) = report(&["-n", "60", "--time", "0.05s", "--nt", "5"]);
    let error = contact(&coarse, "wall", "symplectic-euler")["after"].as_f64().unwrap();
    assert!(error.abs() > 0.01 && words.contains("not at so coarse a step"), "{error} {words}");
    // So fine that explicit Euler's gain is small, and so short that it cannot double.
    let (fine, words) = report(&["-n", "5", "--time", "2ms", "--nt", "1000"]);
    let gain = contact(&fine, "wall", "explicit-euler")["after"].as_f64().unwrap();
    assert!(gain < 0.011 && words.contains("did not double"), "{gain} {words}");
    assert!(words.contains("says nothing of many contacts"), "{words}");
}

#[test]
fn a_crowded_elastic_box_heats_at_n_t_10_and_hardly_at_50() {
    let folder = tempfile::tempdir().unwrap();
    let output = drift(folder.path(), &["--nt", "10,50", "--json"]);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    let answer = &report["answer"];
    let rate = |integrator: &str, nt: f64| {
        let dense = answer["dense"].as_array().unwrap();
        let run = dense.iter().find(|run| run["integrator"] == integrator && run["nt"] == nt);
        run.unwrap()["rate_per_s"].as_f64().unwrap()
    };
    // Known over a whole second: +3.6 % at N_t = 10, 3e-5 at 50 (other seeds and times: 3 to 5 %).
    for integrator in ["symplectic-euler", "velocity-verlet"] {
        assert!((0.02..0.08).contains(&rate(integrator, 10.0)), "{integrator}: {answer}");
    }
    assert!(rate("symplectic-euler", 50.0).abs() < 0.004, "{answer}"); // a swing of the bed
    // Explicit Euler gains 22 % at a bounce: four bounces double the energy.
    let doubled = answer["doubled"].as_array().unwrap();
    let guide = doubled.iter().find(|run| run["case"] == "box" && run["nt"] == 50.0).unwrap();
    assert!((0.1..1.0).contains(&guide["time_s"].as_f64().unwrap()), "{guide}");
    // What damping takes is many times what is missing.
    let [taken, missing] =
        ["taken", "final_error"].map(|key| answer["damped"][key].as_f64().unwrap());
    assert!(taken > 0.3 && missing.abs() < 2e-3, "{taken} {missing}");
    let words = report["words"].to_string();
    for part in [
        "Many contacts add such errors up.",
        "a matter of dt, not of the method",
        "N_t = 50 was, of those tried",
        "What damping takes is no error",
    ] {
        assert!(words.contains(part), "{part:?} is not in {words}");
    }
}

#[test]
fn nonsense_is_refused_with_range_and_way_out_and_nothing_written() {
    for (arguments, reason) in [
        (&["--nt", "3"][..], "must be from 4 to 1000"),
        (&["--nt", "4"], "1.03 times the largest stable step for a heap of discs"),
        (&["--nt", "10", "--restitution", "0.001"], "way out: --nt"),
        (&["--nt", "10,nan"], "must be from 4 to 1000"),
        (&["--nt", "10,ten"], "not a number"),
        (&["-n", "0"], "n = 0 is not possible"),
        (&["-n", "3000"], "packing fraction"),
        (&["--radius", "0.03"], "below half the side"),
        (&["--mass", "-1"], "mass = -1 is not possible"),
        (&["--kn", "0"], "kn = 0 is not possible"),
        (&["--time", "-1"], "time = -1 is not possible"),
        (&["--time", "1e-9"], "at least one step"),
        (&["--restitution", "1.1"], "must be above 0 and at most 1"),
        (&["--seed", "-1"], "seed = -1 is not possible"),
        (&["--out-dir", "file"], "it is a file"),
        (&["--twin", "-n", "0"], "n = 0 is not possible"),
    ] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("file"), "").unwrap();
        let output = drift(folder.path(), arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(message.contains(reason), "{arguments:?}: {reason:?} is not in\n{message}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "{arguments:?} wrote a file");
    }
}

#[test]
fn a_broken_file_is_told_with_its_line() {
    let broken = "case,integrator,restitution,nt,time_s,error\nbox,x,1,50,0.0,soon\n";
    let message = read_curves(broken.as_bytes()).unwrap_err();
    assert!(message.contains("line 2"), "{message}");
    let message = read(broken.as_bytes()).unwrap_err();
    assert!(message.contains("its columns are"), "{message}");
}

#[test]
fn quiet_writes_files_only() {
    let folder = tempfile::tempdir().unwrap();
    let output = drift(folder.path(), &[&SMALL[..], &["-q"]].concat());
    assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty());
    assert!(folder.path().join("drift.csv").exists());
}

#[test]
fn growth_is_that_of_the_later_half_and_doubts_its_scatter() {
    // A jump while the discs begin to meet, then 3 % a second with a swing of 0.1 %.
    let curve: Vec<(f64, f64)> = (0..=400)
        .map(|k| {
            let time = 0.001 * f64::from(k);
            let jump = if k < 200 { 0.0 } else { 0.5 };
            (time, jump + 0.03 * time + 1e-3 * (40.0 * time).sin())
        })
        .collect();
    let course = parsim2d::analysis::drift::Course {
        dt: 1e-5,
        largest_error: 0.513,
        final_error: 0.512,
        energy_at_start: 1.0,
        dissipated: 0.0,
        work_error: 0.0,
        stopped_at: None,
        curve,
    };
    let growth = course.growth().unwrap();
    // Twice the rms of the swing, 0.7e-3, over the 0.2 s of the later half, give 0.007 a second.
    assert!((growth.rate - 0.03).abs() < growth.doubt, "{growth:?}");
    assert!((0.004..0.009).contains(&growth.doubt), "{growth:?}");
}
