//! The diagnosis before a run: its numbers against closed forms, its verdicts at their borders, and
//! every change it offers tried.
#![allow(clippy::too_many_lines)] // tables of cases

use std::path::Path;

use parsim2d::analysis::stability::COARSE;
use parsim2d::scenario::finding::{Matter, Verdict};
use parsim2d::scenario::settings::Settings;
use parsim2d::scenario::{Scenario, file};
use proptest::prelude::*;

fn settings(text: &str) -> Settings {
    file::parse(text, Path::new("test")).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn scenario(text: &str) -> Scenario {
    let lesson = format!("allow_unstable = true\n{text}");
    Scenario::resolve(&settings(&lesson), || 1).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Equal to rounding of a few operations.
fn close(value: f64, expected: f64) -> bool {
    (value / expected - 1.0).abs() < 1e-9
}

#[test]
fn the_guides_contacts_are_as_the_closed_forms_say() {
    let elastic = scenario("eta = 0");
    let (pair, wall) = (elastic.expected_pair(), elastic.expected_wall());
    // omega0 = sqrt(k/m_eff), tau = pi/omega0; Eq. (2) with N_t = 50 counts the wall's.
    assert!(close(pair.angular_frequency, 1e4) && close(wall.angular_frequency, 5e7f64.sqrt()));
    assert!(close(wall.steps, 50.0) && close(pair.steps, 50.0 / 2f64.sqrt()));
    assert!(close(pair.restitution, 1.0) && close(wall.restitution, 1.0));
    // A fall of sqrt(2 g l) sinks v/omega0.
    let fall = (2.0f64 * 9.81 * 0.04).sqrt();
    assert!(close(wall.largest_overlap, fall / 5e7f64.sqrt() / 1e-4));
    assert!(close(pair.largest_overlap, fall / 1e4 / 1e-4));
    assert!(close(elastic.expected_travel(), fall * elastic.dt() / 1e-4));
    // m g/k, and as many layers as the discs make side by side: 1000 * 1 mm / 40 mm.
    assert!(close(wall.static_overlap, 9.81e-3 / 5e4 / 1e-4));
    let heap = scenario("n = 1000\nradius = 5e-4").expected_wall();
    assert!(close(heap.foot_overlap, 25.0 * heap.static_overlap));
    assert!(close(scenario("n = 3").expected_wall().foot_overlap, wall.static_overlap));
}

#[test]
fn speeds_are_those_of_the_fall_and_of_the_start() {
    let fall = (2.0f64 * 9.81 * 0.04).sqrt();
    // Of many discs twice the rms speed is common; two keep theirs.
    assert!(close(scenario("speed = 0.5").expected_speed(), fall.hypot(1.0)));
    assert!(close(scenario("n = 2\nspeed = 0.5").expected_speed(), fall.hypot(0.5)));
    assert!(close(scenario("walls = false\nspeed = 0.5").expected_speed(), 1.0));
    let listed = "gravity = 0\n[[disc]]\nposition = [0.01, 0.02]\nvelocity = [3, 4]";
    assert!(close(scenario(listed).expected_speed(), 5.0));
}

#[test]
fn the_deepest_contact_is_one_that_can_happen() {
    // Ten kilograms and one gram, of one size, without walls: their reduced mass is a gram.
    let unequal = "walls = false\ngravity = 0\nradius = 1e-3\neta = 0\n\
        [[disc]]\nposition = [0.01, 0.02]\nmass = 10\nvelocity = [0.1, 0]\n\
        [[disc]]\nposition = [0.03, 0.02]";
    let mass = 10.0 * 1e-3 / 10.001;
    let depth = 0.1 / (5e4f64 / mass).sqrt() / 1e-3;
    assert!(close(scenario(unequal).expected_overlap(), depth));
    assert!(close(scenario(unequal).expected_pair().angular_frequency, (5e4f64 / mass).sqrt()));
    // One disc without walls meets nobody.
    assert_eq!(scenario("n = 1\nwalls = false\ngravity = 0\nspeed = 10").expected_overlap(), 0.0);
}

#[test]
fn verdicts_change_at_their_borders() {
    let about = |text: &str, matter: Matter| {
        let findings = scenario(text).findings();
        findings.into_iter().find(|finding| finding.matter == matter).map(|found| found.verdict)
    };
    let limit = scenario("n = 20\nradius = 5e-4\neta = 0").limit().dt;
    let dt = |factor: f64| format!("radius = 5e-4\neta = 0\ndt = {:e}", factor * limit);
    let coarse = Some(Verdict::Coarse);
    for (text, matter, verdict) in [
        // Ten steps in a pair's contact: N_t = 14.14.
        ("radius = 5e-4\neta = 0\nnt = 14.2".to_owned(), Matter::Step, None),
        ("radius = 5e-4\neta = 0\nnt = 14.1".to_owned(), Matter::Step, coarse),
        // One disc has ten steps at a wall with N_t = 10.
        ("n = 1\nradius = 5e-4\neta = 0\nnt = 10.1".to_owned(), Matter::Step, None),
        ("n = 1\nradius = 5e-4\neta = 0\nnt = 9.9".to_owned(), Matter::Step, coarse),
        (dt(0.999), Matter::Step, coarse),
        (dt(1.001), Matter::Step, Some(Verdict::Unstable)),
        (dt(1.1e-4), Matter::Step, None),
        (dt(0.9e-4), Matter::Step, coarse), // needlessly small
        // Overlap 0.5 r after a fall: r = 2.5056e-4 m.
        ("radius = 2.51e-4\neta = 0".to_owned(), Matter::Softness, None),
        ("radius = 2.49e-4\neta = 0".to_owned(), Matter::Softness, coarse),
        // A quarter of a radius in a step, and a whole one: 0.885889 m/s.
        ("radius = 1e-4\ndt = 2.81e-5".to_owned(), Matter::Travel, None),
        ("radius = 1e-4\ndt = 2.83e-5".to_owned(), Matter::Travel, coarse),
        ("radius = 1e-4\ndt = 1.12e-4".to_owned(), Matter::Travel, coarse),
        ("radius = 1e-4\ndt = 1.14e-4".to_owned(), Matter::Travel, Some(Verdict::Unstable)),
        ("n = 1\nradius = 1e-4\ndt = 1.14e-4".to_owned(), Matter::Travel, None),
        ("integrator = 'explicit-euler'".to_owned(), Matter::Integrator, coarse),
    ] {
        assert_eq!(about(&text, matter), verdict, "{text}");
    }
    // Strong damping makes a large step of one that has steps enough in a contact without it.
    let fraction = |text: &str| scenario(text).dt() / scenario(text).limit().dt;
    // The bed's zeta at which sqrt(1 + zeta²) - zeta has fallen to 0.485: eta = 4.51 kg/s.
    for (eta, verdict) in [(4.4, None), (4.6, coarse)] {
        let text = format!("radius = 5e-4\neta = {eta}\nnt = 20");
        let large = fraction(&text) > COARSE;
        assert_eq!(large, verdict.is_some(), "{text}: {}", fraction(&text));
        assert_eq!(about(&text, Matter::Step), verdict, "{text}");
    }
}

#[test]
fn a_start_whose_discs_fly_apart_is_told_before_and_not_called_soft_after() {
    let apart = |gap: f64| {
        format!(
            "radius = 5e-4\n[[disc]]\nposition = [0.01, 0.02]\n\
             [[disc]]\nposition = [{}, 0.02]",
            0.01 + 1e-3 + gap
        )
    };
    let start = |text: &str| {
        let findings = scenario(text).findings();
        findings.into_iter().find(|finding| finding.matter == Matter::Start)
    };
    // delta omega0 = 1e4/s delta against a fall of 0.886 m/s: from 8.86e-5 m on.
    assert_eq!(start(&apart(1e-5)), None);
    assert_eq!(start(&apart(-8.8e-5)), None);
    let found = start(&apart(-4.8e-4)).expect("0.96 r");
    assert_eq!(found.fault, "discs 0 and 1: position");
    assert!(found.what.contains("0.96 r") && found.what.contains("4.8 m/s"), "{}", found.what);
    let wall = start("radius = 5e-4\n[[disc]]\nposition = [1e-4, 0.02]").expect("0.8 r");
    assert_eq!(wall.fault, "disc 0: position");
}

#[test]
fn the_parameter_that_does_most_is_blamed() {
    for (text, fault) in [
        ("eta = 1.5e3", "--eta"),
        ("eta = 1.5e3\ndt = 1e-5", "--eta"),
        ("nt = 4\nrestitution = 0.9\nradius = 5e-4", "--nt"),
        ("dt = 1e-3\nmass = 2e-3", "--dt"),
        ("mass = 1e-9\ndt = 8.9e-6", "--mass"),
        ("[[population]]\nn = 5\nspeed = 1000", "population 0: speed"),
        ("[[population]]\nn = 5\nradius = 1e-8", "population 0: radius"),
        (
            "[[disc]]\nposition = [0.01, 0.02]\n[[disc]]\nposition = [0.02, 0.02]\nradius = 1e-9",
            "disc 1: radius",
        ),
        (
            "[[disc]]\nposition = [0.01, 0.02]\nvelocity = [100, 0]\n[[disc]]\nposition = [0.03, 0.02]\n\
          velocity = [-100, 0]",
            "disc 0: velocity",
        ),
    ] {
        let finding = scenario(text).refusal().unwrap_or_else(|| panic!("{text}"));
        assert_eq!(finding.fault, fault, "{text}: {finding}");
    }
}

/// A way out as keys of a scenario file; nothing for one that is not a flag.
fn as_keys(way_out: &str) -> Option<String> {
    let flags = way_out.replace(" with ", " ").replace(" in place of --dt", "");
    let words: Vec<&str> = flags.split_whitespace().collect();
    let pairs = words.chunks(2).map(|pair| match pair {
        [flag, value] => {
            let key = flag.strip_prefix("--")?;
            let quoted = if *value == "auto" { "'auto'" } else { value };
            Some(format!("{} = {quoted}\n", key.replace('-', "_")))
        }
        _ => None,
    });
    pairs.collect()
}

fn some_parameters() -> impl Strategy<Value = String> {
    let power = |low: f64, high: f64| (low..high).prop_map(|power| 10f64.powf(power));
    (
        prop::sample::select(vec![1, 2, 3, 20, 300]),
        power(-5.0, -2.5),
        prop::option::of(power(-6.0, 0.0)),
        prop::option::of(power(1.0, 8.0)),
        prop::option::of(prop_oneof![
            power(-3.0, 4.0).prop_map(|eta| format!("eta = {eta:e}\n")),
            power(0.0, 5.0).prop_map(|gamma| format!("gamma = {gamma:e}\n")),
            (0.05..1.0f64).prop_map(|e| format!("restitution = {e}\n")),
        ]),
        prop::option::of(prop_oneof![
            power(-8.0, -3.0).prop_map(|dt| format!("dt = {dt:e}\n")),
            (1.0..200.0f64).prop_map(|nt| format!("nt = {nt}\n")),
        ]),
        prop::option::of(prop::sample::select(vec![0.0, -9.81, 981.0, 9810.0])),
        prop::option::of(power(-2.0, 2.0)),
    )
        .prop_map(|(n, radius, mass, kn, damping, step, gravity, speed)| {
            let key = |name: &str, value: Option<f64>| {
                value.map(|value| format!("{name} = {value:e}\n")).unwrap_or_default()
            };
            [
                format!("n = {n}\nradius = {radius:e}\n"),
                key("mass", mass),
                key("kn", kn),
                damping.unwrap_or_default(),
                step.unwrap_or_default(),
                key("gravity", gravity),
                key("speed", speed),
            ]
            .concat()
        })
}

proptest! {
    #![proptest_config(crate::support::steady())]

    #[test]
    fn every_way_out_runs_and_mends_what_it_is_offered_for(text in some_parameters()) {
        for finding in scenario(&text).findings() {
            for way_out in finding.ways_out.iter().filter_map(|way_out| as_keys(way_out)) {
                let said = settings(&way_out).over(settings(&text));
                let mended = Scenario::resolve(&said, || 1);
                if finding.matter == Matter::Softness {
                    // A firmer disc may need more: what is promised is that it is firm.
                    let lesson = settings("allow_unstable = true").over(said);
                    let mended = Scenario::resolve(&lesson, || 1).unwrap();
                    prop_assert!(!mended.is_soft(), "{text}\n{way_out}{}", mended.expected_overlap());
                    continue;
                }
                prop_assert!(mended.is_ok(), "{text}\n{way_out}\n{}", mended.unwrap_err());
                let again = mended.unwrap().findings();
                let is_as_grave = |other: &parsim2d::scenario::finding::Finding| {
                    other.matter == finding.matter && other.verdict >= finding.verdict
                };
                prop_assert!(!again.iter().any(is_as_grave), "{text}\n{way_out}\n{again:?}");
            }
        }
    }
}

#[test]
fn a_way_out_beside_a_time_step_that_was_said_stands_in_its_place() {
    for (text, is_said) in [
        ("radius = 5e-4\ndt = 2e-4", true),
        ("radius = 5e-4\ndt = 1e-4", true),
        ("radius = 5e-4\nrestitution = 0.01\ndt = 'auto'", true),
        ("radius = 5e-4\nnt = 4", false),
    ] {
        let findings = scenario(text).findings();
        let finer: Vec<&String> = findings
            .iter()
            .flat_map(|finding| &finding.ways_out)
            .filter(|way_out| way_out.starts_with("--nt "))
            .collect();
        assert!(!finer.is_empty(), "{text}: {findings:?}");
        for way_out in finer {
            assert_eq!(way_out.ends_with(" in place of --dt"), is_said, "{text}: {way_out}");
        }
    }
}

#[test]
fn no_way_out_leads_to_discs_that_sink_through_each_other() {
    // Overlaps, in radii, of a fall with these: 123 and 39; the last two are mended by another stiffness.
    for (text, offers, not) in [
        ("kn = 5", "--kn 5e4", "--nt"),
        ("mass = 1", "--mass 1e-3", "--nt"),
        ("dt = 1e-2\nspeed = 500\nkn = 5", "", "--nt"),
    ] {
        let finding = scenario(text).refusal().unwrap_or_else(|| panic!("{text}"));
        let ways_out = finding.ways_out.join(", or ");
        assert!(ways_out.contains(offers) && !ways_out.contains(not), "{text}: {ways_out}");
        for way_out in &finding.ways_out {
            let Some(keys) = as_keys(way_out) else { continue };
            let mended = Scenario::resolve(&settings(&keys).over(settings(text)), || 1).unwrap();
            assert!(mended.expected_overlap() <= 2.0, "{text}: {way_out}");
        }
    }
}

#[test]
fn walls_count_for_two_discs() {
    // One on the other on the floor: omega² = (3 + sqrt 5)/2 k/m. A light one between floor and a disc a
    // thousand times heavier: 2 k/m, and a hair more as that gives way, m/M of a quarter.
    let stack = "radius = 5e-4\neta = 0\ndt = 1.85e-4\ntime = 1\n[[disc]]\nposition = [0.02, 4.996076e-4]\n\
                 [[disc]]\nposition = [0.02, 1.499411e-3]";
    let squeezed = "side = 0.1\nkn = 1e6\neta = 0\ndt = 1.8e-6\ntime = 0.2\n[[disc]]\n\
                    position = [0.05, 4.9999018e-4]\nradius = 5e-4\nmass = 1e-6\n[[disc]]\n\
                    position = [0.05, 5.99998037e-3]\nradius = 5e-3\nmass = 1e-3";
    let golden = 0.5 * (1.0 + 5.0f64.sqrt());
    for (text, limit, open) in [
        (stack, 2.0 / golden * (1e-3f64 / 5e4).sqrt(), 2.000e-4),
        (squeezed, (2.0f64 * 1e-6 / 1e6).sqrt(), 1.999e-6),
    ] {
        let diagnosis = scenario(text).diagnosis();
        assert_eq!(diagnosis.verdict, Verdict::Unstable, "{text}");
        assert!((diagnosis.limit_s / limit - 1.0).abs() < 3e-4, "{} {limit}", diagnosis.limit_s);
        assert!(
            diagnosis.sentence.contains("for a pair of discs at a wall"),
            "{}",
            diagnosis.sentence
        );
        // In the open the pair's own limit stays, and such a step is below it.
        let in_the_open = scenario(&format!("walls = false\n{text}"));
        assert!((in_the_open.limit().dt / open - 1.0).abs() < 3e-4, "{}", in_the_open.limit().dt);
        assert!(in_the_open.refusal().is_none(), "{text}");
    }
    assert!((scenario(stack).limit().dt - 1.748e-4).abs() < 5e-8);
    assert!((scenario(squeezed).limit().dt - 1.414e-6).abs() < 5e-10);
}

#[test]
fn a_restitution_that_the_step_misses_is_told_with_the_step_that_meets_it() {
    let about = |text: &str| {
        let findings = scenario(text).findings();
        findings.into_iter().find(|finding| finding.matter == Matter::Restitution)
    };
    // With N_t = 50 a contact of two discs gives 0.0910 for 0.1, and half of 0.01.
    for (e, percent, nts) in [
        (0.1, "(-9 %)", 100.0..140.0),
        (0.01, "(-49 %)", 500.0..800.0),
        (1e-4, "(-100 %)", 3600.0..5000.0),
    ] {
        let text = format!("radius = 5e-4\nrestitution = {e}");
        let found = about(&text).unwrap_or_else(|| panic!("{text}"));
        assert!(found.what.contains(percent) && found.what.contains("of two discs"), "{found:?}");
        assert_eq!((found.verdict, found.fault.as_str()), (Verdict::Coarse, "--nt"));
        let [way_out] = &found.ways_out[..] else { panic!("{found:?}") };
        let nt = way_out.strip_prefix("--nt ").unwrap();
        assert!(nts.contains(&nt.parse().unwrap()), "{nt}");
        assert_eq!(about(&format!("{text}\nnt = {nt}")), None, "{way_out}");
        // Not much finer than needed: with a third less it is missed still.
        let two_thirds = 0.66 * nt.parse::<f64>().unwrap();
        assert!(about(&format!("{text}\nnt = {two_thirds}")).is_some(), "{way_out}");
    }
    for text in [
        "",
        "preset = 'guide-mass-scaled'",
        "preset = 'guide-printed'",
        "radius = 5e-4\nrestitution = 0.3",
        "radius = 5e-4\nrestitution = 1\nnt = 20",
        // It has a finding of its own.
        "radius = 5e-4\nintegrator = 'explicit-euler'",
    ] {
        assert_eq!(about(text), None, "{text}");
    }
}

#[test]
fn a_disc_so_far_out_that_its_steps_are_lost_is_told_of() {
    let far = |at: &str, velocity: &str| {
        let text =
            format!("walls = false\ngravity = 0\n[[disc]]\nposition = {at}\nvelocity = {velocity}");
        let findings = scenario(&text).findings();
        findings.into_iter().find(|finding| finding.what.starts_with("far out"))
    };
    // dt = 8.9e-6 s; numbers near 1e9 m are 1.2e-7 m apart, near 1e3 m 1.1e-13 m.
    for (at, velocity, says) in [
        ("[1e9, 0]", "[1e-3, 0]", Some("stands still")),
        ("[0, -1e9]", "[0, 1e-3]", Some("stands still")),
        ("[1e9, 0]", "[1e-3, 1e-3]", Some("stands still")),
        ("[1e9, 0]", "[2e-2, 0]", Some("by jumps")),
        ("[1e9, 0]", "[1, 0]", None),
        ("[1e9, 0]", "[0, 1e-3]", None),
        ("[1e9, 0]", "[0, 0]", None),
        ("[1e3, 0]", "[1e-3, 0]", None),
    ] {
        let found = far(at, velocity).map(|finding| finding.what);
        assert_eq!(found.is_some(), says.is_some(), "{at} {velocity}: {found:?}");
        assert!(found.is_none_or(|what| what.contains(says.unwrap())), "{at} {velocity}");
    }
    // It is as it is told: the disc does not move at all.
    let text = "walls = false\ngravity = 0\n[[disc]]\nposition = [1e9, 0]\nvelocity = [1e-3, 0]";
    let mut run = scenario(text).build().unwrap();
    run.step_until(1000);
    assert_eq!(run.particles()[0].position.x, 1e9);
}
