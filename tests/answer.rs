//! The analytic answer beside runs of one or two discs: theory against known numbers, measurement
//! against theory, silence where theory has nothing to say.
#![allow(clippy::too_many_lines)] // tables of cases

use crate::support::{MASS, STIFFNESS};
use assert_cmd::Command;
use parsim2d::analysis::answer::{Answer, AnswerRow, Question};
use parsim2d::analysis::bounce::Touch;
use parsim2d::analysis::collision::{
    ContactEnd, angular_frequency, largest_overlap, restitution, scaled_duration,
};
use parsim2d::scenario::{DiscSource, Scenario, StepChoice};
use serde_json::Value;

fn touch(zeta: f64, speed: f64, push: f64, end: ContactEnd) -> Touch {
    let eta = 2.0 * zeta * (STIFFNESS * MASS).sqrt();
    Touch { stiffness: STIFFNESS, eta, reduced_mass: MASS, speed, push, end }
}

#[test]
fn without_gravity_the_bounce_is_that_of_the_closed_forms() {
    let omega0 = angular_frequency(STIFFNESS, MASS);
    for zeta in [0.0, 0.05, 0.1, 0.2, 0.5, 0.9, 1.0, 1.5] {
        for end in [ContactEnd::OverlapZero, ContactEnd::ForceZero] {
            let case = format!("zeta = {zeta}, {end:?}");
            let bounce = touch(zeta, 0.5, 0.0, end).bounce();
            let depth = largest_overlap(0.5, zeta, STIFFNESS, MASS);
            // Round-off; at zeta = 1, w = 0 is taken for w t < 1e-6.
            assert!((bounce.depth / depth - 1.0).abs() < 1e-10, "{case}: {} {depth}", bounce.depth);
            let duration = scaled_duration(zeta, end) / omega0;
            let Some(parting) = bounce.parting else {
                // An overdamped contact with tension decays for ever.
                assert!(zeta >= 1.0 && end == ContactEnd::OverlapZero, "{case}");
                continue;
            };
            assert!((parting.duration / duration - 1.0).abs() < 1e-10, "{case}");
            let e = parting.speed / 0.5;
            assert!((e - restitution(zeta, end)).abs() < 1e-10, "{case}: {e}");
        }
    }
}

#[test]
fn gravity_lowers_restitution_as_known_for_slow_bounces() {
    // zeta = 0.0335 with force clip: e at v omega0 / g = 1000, 30, 10, 3, 1; two to three digits.
    let omega0 = angular_frequency(STIFFNESS, MASS);
    for (scaled, e, digits) in [
        (1000.0, 0.902, 5e-4),
        (30.0, 0.898, 5e-4),
        (10.0, 0.888, 5e-4),
        (3.0, 0.846, 5e-4),
        (1.0, 0.59, 5e-3),
    ] {
        let speed = scaled * 9.81 / omega0;
        let bounce = touch(0.0335, speed, 9.81, ContactEnd::ForceZero).bounce();
        let found = bounce.parting.unwrap().speed / speed;
        assert!((found - e).abs() < digits, "{scaled}: {found}, known {e}");
    }
}

#[test]
fn a_disc_too_slow_to_leave_stays() {
    // Strong damping and a touch at a hundredth of g / omega0: it sinks to m g / k and rests.
    let omega0 = angular_frequency(STIFFNESS, MASS);
    let bounce = touch(0.5, 0.01 * 9.81 / omega0, 9.81, ContactEnd::OverlapZero).bounce();
    assert_eq!(bounce.parting, None);
    // It overshoots m g / k by exp(-pi zeta / sqrt(1 - zeta²)) = 0.163 if begun from rest.
    let rest = MASS * 9.81 / STIFFNESS;
    assert!((bounce.depth / rest - 1.163).abs() < 2e-3, "{}", bounce.depth / rest);
}

fn answer(toml: &str) -> Answer {
    let scenario = Scenario::from_toml(toml).unwrap();
    let question = Question {
        discs: scenario.build().unwrap().particles().to_vec(),
        law: scenario.law(),
        gravity: scenario.gravity_vector(),
        side: scenario.walls.then_some(scenario.side),
        dt: scenario.dt(),
        time: scenario.time,
    };
    question.answer(&|discs, dt| {
        let discs = DiscSource::Listed(discs, Vec::new());
        Scenario { discs, step: StepChoice::Seconds(dt), ..scenario.clone() }.build().ok()
    })
}

fn row<'a>(answer: &'a Answer, what: &str) -> &'a AnswerRow {
    let rows = answer.rows().iter().find(|row| row.what == what);
    rows.unwrap_or_else(|| panic!("no {what:?} in {answer:?}"))
}

/// A disc that falls from near the top of the guide's box.
const FALL: &str = "radius = 1e-4\nrestitution = 1\n[[disc]]\nposition = [0.02, 0.0390]\n";

#[test]
fn the_guides_fall_is_answered_in_known_numbers() {
    let answer = answer(FALL);
    // 0.0389 m of fall: v/omega0 = 1.2355 r, and the weight's m g / k = 0.00196 r more.
    let depth = row(&answer, "largest overlap");
    let free = largest_overlap((2.0f64 * 9.81 * 0.0389).sqrt(), 0.0, STIFFNESS, MASS) / 1e-4;
    assert!((depth.theory - free - 0.00196).abs() < 1e-5, "{depth:?}");
    assert_eq!(depth.unit, "r");
    assert!((row(&answer, "restitution").theory - 1.0).abs() < 1e-12);
    // Elastic: pi / omega0, and 2 g / (v omega0²) more for the weight.
    let speed = (2.0f64 * 9.81 * 0.0389).sqrt();
    let omega0 = angular_frequency(STIFFNESS, MASS);
    let time = std::f64::consts::PI / omega0 + 2.0 * 9.81 / (speed * omega0 * omega0);
    // The next term is (g / v omega0)² = 1e-5 of it smaller.
    assert!((row(&answer, "contact time").theory / time - 1.0).abs() < 1e-5);
    let height = row(&answer, "height after bounce 1");
    assert!((height.theory - 0.0390).abs() < 1e-12, "{height:?}");
}

#[test]
fn measurement_agrees_with_theory_and_the_finer_the_better() {
    let pair = "gravity = 0\nwalls = false\nradius = 5e-4\ntime = 0.02\n";
    let discs = "[[disc]]\nposition = [0.015, 0.02]\nvelocity = [0.5, 0]\n[[disc]]\nposition = [0.018, 0.02]\n";
    let floor = "radius = 5e-4\n[[disc]]\nposition = [0.02, 0.0205]\n";
    for (integrator, elastic_order) in
        [("symplectic-euler", 2.0), ("velocity-verlet", 2.0), ("explicit-euler", 1.0)]
    {
        let named = format!("integrator = '{integrator}'\nnt = 100\n");
        // Elastic head-on pair: the order of the energy after a contact.
        let elastic = answer(&format!("{named}restitution = 1\n{pair}{discs}"));
        let e = row(&elastic, "restitution");
        let order = e.order.unwrap();
        // Measured: 2.00 to 2.03 and 1.05, where N_t = 100 is a little coarse.
        assert!((order - elastic_order).abs() < 0.1, "{integrator}: {order}");
        // At N_t = 100: explicit Euler gains 15 % of energy, 7 % of speed; the others 5e-4.
        let bound = if integrator == "explicit-euler" { 0.08 } else { 6e-4 };
        for damping in
            ["restitution = 1", "restitution = 0.5", "restitution = 0.5\nno_tension = true"]
        {
            for case in [format!("{pair}{discs}"), floor.to_owned()] {
                let answer = answer(&format!("{named}{damping}\n{case}"));
                assert!(answer.rows().len() >= 3, "{damping} {case}: {answer:?}");
                for row in answer.rows().iter().filter(|row| !row.what.starts_with("height")) {
                    // The damped ones are of first order: pi/100 of the contact, at most.
                    let bound = if damping == "restitution = 1" { bound } else { bound + 0.032 };
                    let bound = if row.what == "restitution" { bound } else { bound + 0.032 };
                    assert!(row.error.abs() < bound, "{integrator} {damping}: {row:?}");
                    assert!(
                        row.order.is_none_or(|order| order > 0.4),
                        "{integrator} {damping}: {row:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn asked_restitution_is_the_answer_of_a_pair_for_both_ends() {
    for (e, tension) in [(0.9, true), (0.3, true), (0.9, false), (0.3, false)] {
        let answer = answer(&format!(
            "gravity = 0\nwalls = false\nradius = 5e-4\nrestitution = {e}\nno_tension = {}\ntime = 0.02\n\
             [[disc]]\nposition = [0.015, 0.02]\nvelocity = [0.5, 0]\n\
             [[disc]]\nposition = [0.018, 0.02]\nmass = 3e-3\n",
            !tension
        ));
        assert!((row(&answer, "restitution").theory - e).abs() < 1e-10, "{e} {tension}");
        assert_eq!(answer.remark, None);
    }
}

#[test]
fn an_oblique_meeting_is_answered_with_a_remark() {
    let scenario = include_str!("../examples/oblique.toml");
    let answer = answer(scenario);
    assert!(answer.remark.as_ref().unwrap().contains("rad"), "{answer:?}");
    // The normal turns by under 0.1 rad, so that the head-on theory is off by less than 1 %.
    assert!(row(&answer, "restitution").error.abs() < 0.01);
}

#[test]
fn nothing_is_said_where_theory_does_not_apply() {
    let disc = |position: &str, velocity: &str| {
        format!("[[disc]]\nposition = {position}\nvelocity = {velocity}\n")
    };
    let open = "gravity = 0\nwalls = false\nradius = 5e-4\n";
    for (why, toml) in [
        ("many discs", "n = 5".to_owned()),
        ("nothing to meet", format!("{open}{}", disc("[0.02, 0.02]", "[1, 0]"))),
        ("no contact in time", format!("time = 0.01\n{}", disc("[0.02, 0.03]", "[0, 0]"))),
        (
            "passing by",
            format!("{open}{}{}", disc("[0.01, 0.02]", "[1, 0]"), disc("[0.02, 0.03]", "[0, 0]")),
        ),
        (
            "parting",
            format!("{open}{}{}", disc("[0.01, 0.02]", "[-1, 0]"), disc("[0.02, 0.02]", "[0, 0]")),
        ),
        ("in contact", format!("radius = 5e-4\n{}", disc("[0.02, 4e-4]", "[0, 0]"))),
        ("a corner", format!("gravity = 0\nradius = 5e-4\n{}", disc("[0.02, 0.02]", "[1, 1]"))),
        (
            "a wall beside",
            format!(
                "radius = 5e-4\n{}{}",
                disc("[0.01, 0.0006]", "[1, 0]"),
                disc("[0.02, 0.0006]", "[0, 0]")
            ),
        ),
        (
            "so soft that discs pass through",
            format!(
                "{open}kn = 1\n{}{}",
                disc("[0.01, 0.02]", "[0.05, 0]"),
                disc("[0.02, 0.02]", "[0, 0]")
            ),
        ),
    ] {
        let answer = answer(&toml);
        assert!(answer.is_empty() && answer.remark.is_none(), "{why}: {answer:?}");
    }
}

fn run(arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("fall.toml"), FALL).unwrap();
    let mut command = Command::cargo_bin("parsim2d").unwrap();
    let output = command.current_dir(&folder).args(arguments).output().unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn the_summary_shows_the_answer_of_one_disc_and_not_of_twenty() {
    let arguments = ["fall.toml", "--time", "0.2s"];
    let summary = run(&arguments);
    assert!(summary.contains("order in dt") && summary.contains("restitution  "), "{summary}");
    let json: Value = serde_json::from_str(&run(&[&arguments[..], &["--json"]].concat())).unwrap();
    let rows = json["answer"]["rows"].as_array().unwrap();
    assert!(rows.iter().any(|row| row["what"] == "contact time" && row["unit"] == "s"), "{json}");
    let crowd = ["--seed", "1", "--time", "1ms"];
    assert!(!run(&crowd).contains("order in dt"));
    let json: Value = serde_json::from_str(&run(&[&crowd[..], &["--json"]].concat())).unwrap();
    assert!(json["answer"].is_null());
}
