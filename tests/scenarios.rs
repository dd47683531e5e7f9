//! Scenario files and flags: layers, checks, and the way back to a file.
#![allow(clippy::too_many_lines)] // tables of cases

use std::fs;
use std::path::{Path, PathBuf};

use parsim2d::scenario::gravity::Gravity;
use parsim2d::scenario::settings::Settings;
use parsim2d::scenario::{DtSetBy, Scenario, StepChoice, file};
use proptest::prelude::*;

fn folder(name: &str) -> impl Iterator<Item = PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
}

#[test]
fn every_bad_scenario_gets_the_message_it_carries() {
    // Each file holds, after `#^`, parts of the message it must give.
    let (mut seen, mut wrong) = (0, Vec::new());
    for path in folder("tests/scenarios/bad") {
        let text = fs::read_to_string(&path).unwrap();
        let error = file::read(&path)
            .and_then(|settings| Scenario::resolve(&settings, || 1))
            .and_then(|scenario| scenario.build().map(|_| ()))
            .expect_err(&path.display().to_string())
            .to_string();
        let expected: Vec<&str> =
            text.lines().filter_map(|line| line.strip_prefix("#^ ")).collect();
        assert!(!expected.is_empty(), "{} expects nothing", path.display());
        for part in expected.iter().filter(|part| !error.contains(**part)) {
            wrong.push(format!("{}: {part:?} is not in\n{error}\n", path.display()));
        }
        seen += 1;
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(seen >= 39, "{seen}");
}

#[test]
fn every_example_is_a_good_scenario() {
    let mut seen = 0;
    for path in folder("examples") {
        let settings = file::read(&path).unwrap_or_else(|error| panic!("{error}"));
        let scenario = Scenario::resolve(&settings, || 1).unwrap_or_else(|error| panic!("{error}"));
        scenario.build().unwrap_or_else(|error| panic!("{error}"));
        seen += 1;
    }
    assert!(seen >= 7, "{seen}");
}

fn settings(text: &str) -> Settings {
    file::parse(text, Path::new("test")).unwrap_or_else(|error| panic!("{error}"))
}

fn layered(flags: &str, file: &str) -> Scenario {
    Scenario::resolve(&settings(flags).over(settings(file)), || 1)
        .unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn flags_override_the_file_and_the_file_the_preset() {
    let scenario = layered("radius = 2e-4", "preset = 'guide-listing'\nradius = 3e-4\nn = 7");
    assert_eq!((scenario.radius, scenario.n()), (2e-4, 7));
    assert_eq!(layered("", "preset = 'guide-listing'").radius, 5e-4);
    // A damping or time step in a flag replaces another kind in the file.
    let scenario = layered("gamma = 10\nnt = 40", "eta = 0.5\ndt = 1e-6");
    assert_eq!(scenario.damping.flag_and_value(), ("--gamma", 10.0));
    assert_eq!((scenario.step, scenario.dt_set_by), (StepChoice::Nt(40.0), DtSetBy::Nt));
    assert!(layered("walls = true", "no_walls = true").walls);
    // So do discs of another kind.
    assert_eq!(layered("n = 5", "[[disc]]\nposition = [0.02, 0.02]").n(), 5);
}

#[test]
fn the_guides_numbers_are_the_defaults() {
    let scenario = layered("", "");
    assert_eq!(
        (scenario.n(), scenario.side, scenario.radius, scenario.mass, scenario.gravity),
        (20, 0.04, 1e-4, 1e-3, Gravity::down(9.81))
    );
    assert_eq!((scenario.stiffness, scenario.time), (5e4, 1.0));
    assert_eq!(scenario.damping.flag_and_value(), ("--eta", 1.5e-3));
    assert_eq!((scenario.step, scenario.dt_set_by), (StepChoice::Nt(50.0), DtSetBy::Preset));
    // Eq. (2): pi sqrt(1e-3 / 5e4) / 50 = 8.8858e-6 s, so 112,540 steps.
    assert_eq!(scenario.steps(), 112_540);
}

#[test]
fn eq_2_takes_the_lightest_disc() {
    let text =
        "mass = 1e-3\n[[population]]\nn = 2\nmass = 4e-3\n[[population]]\nn = 2\nmass = 2.5e-4";
    let scenario = layered("", text);
    assert_eq!(scenario.mass_range(), (2.5e-4, 4e-3));
    // Half the default step, for a quarter of the mass.
    assert!((scenario.dt() - 0.5 * layered("", "").dt()).abs() < 1e-20);
}

#[test]
fn presets_read_the_guide_in_four_ways() {
    // Restitution of pair and wall, as derived for the guide's printed 1.5e3 read as a rate.
    let notes = |text: &str| {
        let scenario = layered("", text);
        let discs = scenario.build().unwrap();
        scenario.notes(discs.particles()).join("\n")
    };
    let scaled = notes("preset = 'guide-mass-scaled'");
    assert!(scaled.contains("0.790 for a pair and 0.715 at a wall"), "{scaled}");
    let printed = notes("preset = 'guide-printed'");
    assert!(printed.contains("zeta = 150.000"), "{printed}");
    let guide = notes("");
    assert!(guide.contains("eta_n = 1.5e-3 kg/s for the guide's printed 1.5e3"), "{guide}");
    assert!(guide.contains("discs as soft as its numbers make them"), "{guide}");
    let softer = notes("gravity = 20"); // whose own doing that is
    assert!(softer.contains("1.79 r deep; try --radius 7e-4 or --kn 2.4e6"), "{softer}");
    let listing = notes("preset = 'guide-listing'");
    assert!(!listing.contains("soft"), "{listing}");
}

#[test]
fn every_way_out_of_a_refusal_works() {
    let refused = [
        "eta = 1.5e3",
        "eta = 1.5e3\nn = 1",
        "eta = 40\nnt = 10\nn = 2",
        "gamma = 1e6",
        "dt = 1e-3",
        "kn = 5e10\ndt = 8.9e-6",
        "mass = 1e-9\ndt = 8.9e-6",
        "nt = 1",
        "nt = 3.8",
        "preset = 'guide-printed'\nnt = 50",
        "preset = 'guide-printed'\nnt = 667",
        "eta = 1e9",
        "dt = 1e9",
        "restitution = 1e-9\ndt = 5e-5",
    ];
    for text in refused {
        let error = Scenario::resolve(&settings(text), || 1).expect_err(text).to_string();
        let ways_out = error.lines().find_map(|line| line.trim().strip_prefix("ways out: "));
        let ways_out: Vec<_> = ways_out.expect(&error).split(", or ").collect();
        assert!(ways_out.len() >= 2, "{text}: {error}");
        for way_out in ways_out {
            let bare = way_out.trim_end_matches(" in place of --dt");
            let (flag, value) = bare.split_once(' ').unwrap();
            let value = if value == "auto" { "'auto'" } else { value };
            let flags = settings(&format!("{} = {value}", flag.trim_start_matches("--")));
            let mended = Scenario::resolve(&flags.over(settings(text)), || 1);
            assert!(mended.is_ok(), "{text}: {way_out} does not help: {}", mended.unwrap_err());
        }
    }
}

#[test]
fn ways_out_of_a_box_too_full_find_room() {
    for text in [
        "n = 1000\nradius = 5.6e-4",
        "n = 2\nradius = 0.0199",
        "n = 10\nradius = 0.01",
        "n = 5\nradius = 0.015",
        "n = 3000\nradius = 1e-3\nplacement = 'lattice'",
        "n = 101\nradius = 2e-3\nplacement = 'lattice'",
        "n = 2\nradius = 0.0199\nplacement = 'lattice'",
        "n = 40000\nradius = 1.3e-4\nplacement = 'lattice'",
        "n = 1\nradius = 0.03\nwalls = false",
        "n = 20\nradius = 1\nwalls = false",
        "[[disc]]\nposition = [0.02, 0.02]\n[[population]]\nn = 1150\nradius = 5e-4",
    ] {
        for seed in 1..4 {
            let text = format!("seed = {seed}\n{text}");
            let error = layered("", &text).build().map(|_| ()).expect_err(&text).to_string();
            let ways_out = error.lines().find_map(|line| line.trim().strip_prefix("way out: "));
            let ways_out: Vec<_> = ways_out.expect(&error).split(", or ").collect();
            assert!(!ways_out.is_empty(), "{error}");
            for way_out in ways_out {
                let bare = way_out.trim_end_matches(" in place of --dt");
                let (flag, value) = bare.split_once(' ').unwrap();
                let value = if value == "lattice" { "'lattice'" } else { value };
                let flags = format!("{} = {value}", flag.trim_start_matches('-'));
                let mended = layered(&flags, &text).build();
                assert!(mended.is_ok(), "{text}: {way_out}: {}", mended.err().unwrap());
            }
        }
    }
}

#[test]
fn an_offered_nt_does_not_blow_up() {
    // N_t = 4 is below the limit and multiplies an elastic heap's energy; what is offered is not.
    let text = "n = 300\nradius = 5e-4\neta = 0\nseed = 1\nnt = 1\ntime = 0.3";
    let error = Scenario::resolve(&settings(text), || 1).unwrap_err().to_string();
    let nt = error.split("--nt ").nth(2).expect(&error).split(',').next().unwrap();
    let scenario = layered(&format!("nt = {nt}"), text);
    let mut simulation = scenario.build().unwrap();
    let energy = |s: &_| parsim2d::analysis::energy::MechanicalEnergy::of(s).total();
    let start = energy(&simulation);
    (0..scenario.steps()).for_each(|_| simulation.step());
    // N_t = 10 gains a few per cent a second in a crowded box.
    assert!(energy(&simulation) < 1.1 * start, "--nt {nt}: {}", energy(&simulation) / start);
}

#[test]
fn a_radius_that_no_disc_has_is_not_judged() {
    let text = "side = 1e-4\n[[disc]]\nposition = [5e-5, 5e-5]\nradius = 1e-6";
    assert_eq!(layered("", text).n(), 1);
}

#[test]
fn stability_is_judged_by_the_number_of_discs() {
    // (2/omega0)(sqrt(1+zeta²) - zeta) sqrt(k/m): 2 for one disc, sqrt 2 for a pair in the open, 2/sqrt(2.618)
    // for a pair of which a wall holds one, and 2/sqrt(6.1) = 0.8098 from three discs on.
    let unit = (1e-3f64 / 5e4).sqrt();
    let golden = 0.5 * (1.0 + 5.0f64.sqrt()); // its square is 2.618
    for (discs, limit) in [
        ("n = 1", 2.0),
        ("n = 1\nwalls = false", 2.0),
        ("n = 2\nwalls = false", 2.0f64.sqrt()),
        ("n = 2", 2.0 / golden),
        ("n = 3", 2.0 / 6.1f64.sqrt()),
        ("n = 3\nwalls = false", 2.0 / 6.1f64.sqrt()),
        ("n = 1000", 0.80978),
    ] {
        for (factor, accepted) in [(0.999, true), (1.001, false)] {
            let dt = factor * limit * unit;
            // Without gravity: a fall would be fast enough to pass by others in such steps.
            let text = format!("{discs}\neta = 0\ngravity = 0\ndt = {dt:e}");
            assert_eq!(Scenario::resolve(&settings(&text), || 1).is_ok(), accepted, "{text}");
        }
    }
}

#[test]
fn the_limit_of_two_unequal_discs_in_the_open_is_that_of_their_reduced_mass() {
    // omega² = k (1/m_i + 1/m_j): 5e4 * (1000 + 250) 1/s², limit 2/omega.
    let limit = 2.0 / (5e4f64 * 1250.0).sqrt();
    for (factor, accepted) in [(0.999, true), (1.001, false)] {
        let text = format!(
            "eta = 0\nwalls = false\ngravity = 0\ndt = {:e}\n[[disc]]\nposition = [0.01, 0.02]\n\
             [[disc]]\nposition = [0.03, 0.02]\nmass = 4e-3",
            factor * limit
        );
        assert_eq!(Scenario::resolve(&settings(&text), || 1).is_ok(), accepted, "{text}");
    }
}

#[test]
fn restitution_is_met_with_and_without_tension() {
    for tension in ["no_tension = true", "no_tension = false"] {
        for e in [0.9, 0.5, 0.2] {
            let text = format!(
                "{tension}\nrestitution = {e}\nnt = 2000\ngravity = 0\nradius = 5e-4\n\
                 [[disc]]\nposition = [0.02, 0.000501]\nvelocity = [0, -0.5]"
            );
            let mut simulation = layered("", &text).build().unwrap();
            (0..10_000).for_each(|_| simulation.step());
            let measured = simulation.particles()[0].velocity.y / 0.5;
            // First order in the step: 2000 steps a contact.
            assert!((measured - e).abs() < 2e-3, "{tension} {e}: {measured}");
        }
    }
}

#[test]
fn speed_is_the_rms_speed_at_the_start() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("start.txt");
    fs::write(&file, "0.01 0.01 1e-4\n0.02 0.01 1e-4\n").unwrap();
    let from_file = format!("start = {:?}", file.to_str().unwrap());
    for discs in ["n = 50", "[[population]]\nn = 50", &from_file] {
        let simulation = layered("speed = 0.25", discs).build().unwrap();
        let discs = simulation.particles();
        let squares: f64 = discs.iter().map(|disc| disc.velocity.length_squared()).sum();
        let rms = (squares / discs.len() as f64).sqrt();
        assert!((rms - 0.25).abs() < 1e-14, "{rms}"); // directions are of length 1 to rounding
        assert_ne!(discs[0].velocity, discs[1].velocity);
    }
}

#[test]
fn sticking_contacts_are_told_of_by_the_most_damped_one() {
    // gamma = 16000 1/s: zeta = gamma sqrt(m_eff / k) / 2 is 0.80 for a pair, 1.13 at a wall.
    let notes = layered("", "gamma = 16000").notes(&[]).join("\n");
    assert!(notes.contains("zeta = 1.131"), "{notes}");
    assert!(!layered("", "gamma = 14000").notes(&[]).join("\n").contains("never separate"));
}

#[test]
fn groups_on_a_lattice_are_mixed() {
    let text = "placement = 'lattice'\nseed = 1\n[[population]]\nn = 100\n[[population]]\nn = 100\nmass = 2e-3";
    let simulation = layered("", text).build().unwrap();
    let mean = |discs: &[parsim2d::particle::Particle]| {
        discs.iter().map(|disc| disc.position.y).sum::<f64>() / discs.len() as f64
    };
    let (one, other) = simulation.particles().split_at(100);
    // 0.02 each; a mean of 100 heights uniform over 0.04 m scatters by 0.0012 m.
    assert!((mean(one) - mean(other)).abs() < 5.0 * 0.0012, "{} {}", mean(one), mean(other));
}

#[test]
fn the_printed_damping_with_its_preset_stays_in_the_box() {
    // A shorter version of -n 300 --radius 5e-4 --preset guide-printed: a small box, so that the
    // heap is made within 0.03 s.
    let text =
        "preset = 'guide-printed'\nn = 40\nradius = 5e-4\nside = 0.01\nseed = 1\ntime = 0.03";
    let scenario = layered("", text);
    let mut simulation = scenario.build().unwrap();
    let fall = (2.0f64 * 9.81 * 0.01).sqrt();
    for step in 0..scenario.steps() {
        simulation.step();
        if step % 100 == 0 {
            for disc in simulation.particles() {
                let inside =
                    disc.position.min_element() > 0.0 && disc.position.max_element() < 0.01;
                assert!(inside && disc.velocity.length() < fall, "step {step}: {disc:?}");
            }
        }
    }
    assert!(simulation.largest_overlap() > 1e-3, "no contact, no test");
}

#[test]
fn an_unstable_run_is_allowed_if_asked_for() {
    let scenario = layered("", "eta = 1.5e3\nallow_unstable = true");
    let notes = scenario.notes(&[]).join("\n");
    assert!(notes.contains("unstable on purpose"), "{notes}");
}

#[test]
fn explicit_euler_is_warned_about_with_its_gain_and_not_refused() {
    // In any damping up to the limit of Eq. (3), though its own is far below.
    let scenario = layered("", "integrator = 'explicit-euler'\neta = 5\nnt = 12");
    assert!(scenario.notes(&[]).join("").contains("explicit-euler gains energy"));
    let scenario = layered("", "integrator = 'explicit-euler'");
    let notes = scenario.notes(&[]).join("\n");
    assert!(
        notes.contains("about 22 % at an elastic wall bounce, 32 % when two discs collide"),
        "{notes}"
    );
}

/// A scenario file with some keys said, in their ranges.
fn some_scenario() -> impl Strategy<Value = String> {
    let one = |key: &'static str, values: &'static [&'static str]| {
        prop::option::of(prop::sample::select(values))
            .prop_map(move |value| value.map(|v| format!("{key} = {v}\n")).unwrap_or_default())
    };
    let keys = vec![
        one("preset", &["'guide'", "'guide-listing'", "'guide-mass-scaled'", "'guide-printed'"]),
        one("seed", &["0", "7", "9223372036854775807"]),
        one("side", &["0.05", "'6cm'"]),
        one("radius", &["1.23456789012345e-4", "'0.2mm'"]),
        one("gravity", &["0", "-9.81", "1.62", "[1.5, -9.81]", "[0, 0]", "[-3, '2cm/s2']"]),
        one("kn", &["1e5", "'50 kN/m'"]),
        one("restitution", &["1", "0.3", "0.1"]),
        one("no_tension", &["true", "false"]),
        one("walls", &["true", "false"]),
        one("dt", &["'auto'", "1e-7", "'0.1us'"]),
        one("time", &["0", "'1ms'"]),
        one("integrator", &["'velocity-verlet'", "'explicit-euler'", "'symplectic-euler'"]),
        one("placement", &["'lattice'", "'random'"]),
        one("speed", &["0.1", "'5 cm/s'"]),
        one("every", &["1", "1000"]),
        one("energy_every", &["0", "10"]),
        one("slowdown", &["2.5"]),
        one("border", &["true"]),
        one("out_dir", &["'some where'", "'a\\b'", "\"it's\""]),
    ];
    let tables = prop::sample::select(vec![
        "n = 3\n",
        "",
        "[[disc]]\nposition = [0.01, '2cm']\nvelocity = [0.1, -0.2]\n[[disc]]\nposition = [0.03, 0.02]\nmass = '2g'\n",
        "[[population]]\nn = 3\nradius = 2e-4\nspeed = 0.3\n[[disc]]\nposition = [0.01, 0.02]\n",
    ]);
    (keys, tables).prop_map(|(keys, tables)| keys.concat() + tables)
}

proptest! {
    #![proptest_config(crate::support::steady())]

    #[test]
    fn a_printed_scenario_is_read_back_as_the_same(text in some_scenario()) {
        // Listed discs alone take no speed and no placement.
        let scenario = Scenario::resolve(&settings(&text), || 1);
        prop_assume!(scenario.is_ok());
        let scenario = scenario.unwrap();
        let again = layered("", &scenario.to_toml());
        prop_assert_eq!(&scenario, &again);
        prop_assert_eq!(scenario.build().unwrap().state_hash(), again.build().unwrap().state_hash());
    }

    #[test]
    fn no_text_makes_the_reader_panic(characters in proptest::collection::vec(any::<char>(), 0..200)) {
        let _ = Scenario::from_toml(&characters.into_iter().collect::<String>());
    }

    #[test]
    fn no_mixture_of_keys_and_values_makes_the_reader_panic(
        lines in prop::collection::vec((
            prop::sample::select(vec!["n", "side", "radius", "mass", "kn", "eta", "dt", "nt", "time",
                "seed", "speed", "position", "[[disc]]\nposition", "[[population]]\nn", "walls"]),
            prop::sample::select(vec!["0", "-1", "1", "1e308", "1e-308", "nan", "inf", "-inf", "''",
                "'1e400 m'", "[]", "[1, 2]", "[nan, 1]", "true", "9223372036854775807", "{}"]),
        ), 0..8)
    ) {
        let text: String = lines.iter().map(|(key, value)| format!("{key} = {value}\n")).collect();
        let _ = Scenario::from_toml(&text);
    }
}
