//! Two runs a bit apart: chaos where discs meet, none where they do not.

use assert_cmd::Command;
use parsim2d::analysis::twin::{Growth, distances, separation_time};
use parsim2d::output::drift::TwinRow;
use parsim2d::scenario::settings::Settings;
use parsim2d::scenario::study::{twin_box, twins};

/// Growth of the twins (x moved, dt longer) of `n` discs over `time` s, and when they part.
fn growth(n: i64, nt: f64, time: f64) -> [(Option<Growth>, Option<f64>); 2] {
    let settings = Settings { n: Some(n), time: Some(time.into()), ..Settings::default() };
    let scenario = twin_box(&settings, &[nt]).unwrap();
    let (mut run, mut twins) = twins(&scenario).unwrap();
    let found = distances(&mut run, &mut twins, scenario.steps(), 500, &mut |_| {});
    let one = |k: usize| {
        let radius = scenario.radius;
        (Growth::of(&found[k], radius), separation_time(&found[k], radius))
    };
    [one(0), one(1)]
}

#[test]
fn a_gas_of_discs_forgets_a_last_bit_exponentially() {
    for (growth, parted) in growth(20, 50.0, 2.0) {
        let growth = growth.unwrap();
        // From 1e-18 m to 1e-6 m within the second that discs take to meet: some tens a second.
        assert!((10.0..300.0).contains(&growth.rate), "{growth:?}");
        assert!((growth.doubling_time() * growth.rate - 2.0f64.ln()).abs() < 1e-12);
        // The fit ends where the twins have parted.
        assert_eq!(parted, Some(growth.until));
        // Extrapolated over the range, the rate gives the twelve decades between the bit and 1 %.
        let decades = growth.rate * (growth.until - growth.from) / 10.0f64.ln();
        assert!((6.0..14.0).contains(&decades), "{decades}");
    }
}

#[test]
fn one_bouncing_disc_keeps_a_bit_for_ever() {
    // Moved along the floor: nothing it meets depends on x.
    let [(moved, parted), _] = growth(1, 50.0, 2.0);
    assert_eq!((moved, parted), (None, None));
    // dt a bit longer: with a fine step the bounces stay in step.
    let [_, (longer, parted)] = growth(1, 1000.0, 2.0);
    assert_eq!((longer, parted), (None, None));
}

#[test]
fn a_coarse_step_makes_one_bouncing_disc_chaotic() {
    // The error of a bounce hangs on its phase in the step; finer steps tame it.
    let rate = |nt| growth(1, nt, 2.0)[1].0.map_or(0.0, |growth| growth.rate);
    let (coarse, finer) = (rate(50.0), rate(200.0));
    assert!(coarse > 2.0 * finer && finer > 0.0, "{coarse} {finer}");
}

#[test]
fn twins_that_have_met_nothing_stay_together() {
    for (growth, parted) in growth(20, 50.0, 0.01) {
        assert_eq!((growth, parted), (None, None));
    }
}

fn twin(arguments: &[&str]) -> (String, Vec<TwinRow>, Vec<u8>) {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::cargo_bin("parsim2d").unwrap();
    let command = command.current_dir(&folder).args(["drift", "--twin"]).args(arguments);
    let output = command.output().unwrap();
    assert!(output.status.success());
    let path = folder.path().join("twin.csv");
    let bytes = std::fs::read(&path).unwrap();
    let rows = csv::Reader::from_reader(bytes.as_slice()).into_deserialize();
    (String::from_utf8(output.stdout).unwrap(), rows.collect::<Result<_, _>>().unwrap(), bytes)
}

#[test]
fn the_command_says_rate_doubling_time_and_how_long_to_compare() {
    let (words, rows, bytes) = twin(&[]);
    for part in ["grows like exp(", "doubling every", "1 % of a radius, at", "disc by disc"] {
        assert!(words.replace('\n', " ").contains(part), "{part:?} is not in\n{words}");
    }
    assert!(bytes.starts_with(b"time_s,distance_m\n"));
    assert_eq!(rows[0].time_s, 0.0);
    assert!(rows[0].distance_m > 0.0 && rows[0].distance_m < 1e-17, "{:?}", rows[0]);
    assert!(rows.last().unwrap().distance_m > 1e-3); // as far apart as strangers
    assert_eq!(twin(&[]), (words, rows, bytes)); // the same bytes again
}

#[test]
fn the_command_says_so_if_nothing_grows() {
    let (words, ..) = twin(&["-n", "1", "--nt", "1000", "--time", "0.5s"]);
    assert_eq!(words.matches("no exponential growth").count(), 2, "{words}");
    let words = words.replace('\n', " ");
    assert!(words.contains("over these 0.5 s two correct programs may be compared"), "{words}");
    assert!(!words.contains("Two causes mix"), "{words}");
    // One disc and a coarse step: the step is named as the cause.
    let (words, ..) = twin(&["-n", "1", "--time", "1s"]);
    assert!(words.replace('\n', " ").contains("the time step's doing"), "{words}");
}

#[test]
fn twins_are_apart_once_a_hundredth_of_a_radius_is_between_them() {
    let radius = 1e-4;
    let at = |share: f64| vec![(0.0, 1e-18), (0.1, 0.5 * share * radius), (0.2, share * radius)];
    assert_eq!(separation_time(&at(0.0101), radius), Some(0.2));
    assert_eq!(separation_time(&at(0.0099), radius), None);
}
