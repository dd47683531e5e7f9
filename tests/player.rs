//! The player: what a page carries of a run comes back, thinned out and said so, and nothing else gets in.

use std::fs;
use std::io::BufReader;
use std::path::Path;

use glam::DVec2;
use parsim2d::analysis::energy::LedgerRow;
use parsim2d::figure::survey::Survey;
use parsim2d::output::energy;
use parsim2d::output::frames::{Frame, FrameRow, Frames};
use parsim2d::page::film::{ABSENT, BYTES, FASTEST, Film, MOST_FRAMES, MOST_PLACES, SCALE};
use parsim2d::page::player::alone;
use parsim2d::page::words::ENGLISH;
use proptest::prelude::*;
use serde_json::Value;

use crate::support::plotting::{plot, run, simulate};
use crate::support::steady;

/// What the page says to its script.
fn film_of(page: &str) -> Value {
    let (_, rest) = page.split_once("<script type=\"application/json\" id=\"film\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// RFC 4648, written anew.
fn from_base64(text: &str) -> Vec<u8> {
    let digit = |letter: u8| match letter {
        b'A'..=b'Z' => letter - b'A',
        b'a'..=b'z' => letter - b'a' + 26,
        b'0'..=b'9' => letter - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        other => panic!("{other}"),
    };
    let bits = text.bytes().filter(|letter| *letter != b'=').flat_map(|letter| {
        let digit = digit(letter);
        (0..6).rev().map(move |k| digit >> k & 1)
    });
    let bits: Vec<u8> = bits.collect();
    bits.chunks_exact(8).map(|eight| eight.iter().fold(0, |byte, bit| byte << 1 | bit)).collect()
}

/// The frames that a page carries: place (m), radius (m) and speed (m/s) of the discs that are there.
fn decoded(film: &Value) -> Vec<Vec<Option<(DVec2, f64, f64)>>> {
    let bytes = from_base64(film["places"].as_str().unwrap());
    let frames = film["frames"].as_u64().unwrap() as usize;
    let (corner, radii) = (numbers(&film["corner"]), numbers(&film["radii"]));
    let (corner, width) = (DVec2::new(corner[0], corner[1]), film["width"].as_f64().unwrap());
    let fastest = film["fastest"].as_f64().unwrap_or(0.0);
    let discs = bytes.len() / BYTES / frames;
    let disc = |(k, five): (usize, &[u8])| {
        let [x0, x1, y0, y1, speed] = five.try_into().unwrap();
        let place =
            DVec2::new(u16::from_le_bytes([x0, x1]).into(), u16::from_le_bytes([y0, y1]).into());
        let radius = if radii.len() == 1 { radii[0] } else { radii[k] };
        let speed_there = f64::from(speed) / f64::from(FASTEST) * fastest;
        (speed != ABSENT).then_some((
            corner + place / f64::from(SCALE) * width,
            radius,
            speed_there,
        ))
    };
    let frame = |bytes: &[u8]| bytes.chunks(BYTES).enumerate().map(disc).collect();
    bytes.chunks(discs * BYTES).map(frame).collect()
}

/// Each disc of the page is where it is in the file, to the last of the steps that it is counted in.
fn assert_same(seen: &[Option<(DVec2, f64, f64)>], frame: &Frame, step: usize, film: &Value) {
    let width = film["width"].as_f64().unwrap();
    let half_step = 0.5 * width / f64::from(SCALE) * (1.0 + 1e-9); // and round-off
    let half_shade = 0.5 * film["fastest"].as_f64().unwrap_or(0.0) / f64::from(FASTEST);
    assert_eq!(seen.len(), frame.rows.len().div_ceil(step));
    for (seen, row) in seen.iter().zip(frame.rows.iter().step_by(step)) {
        let (place, radius, speed) = seen.unwrap();
        let off = (place - row.position).abs();
        assert!(off.max_element() <= half_step, "{place} {}", row.position);
        assert!((radius / row.radius - 1.0).abs() < 1e-5, "six digits: {radius} {}", row.radius);
        let there = row.velocity.map_or(0.0, DVec2::length);
        assert!((speed - there).abs() <= half_shade * (1.0 + 1e-9), "{speed} {there}");
    }
}

fn frames_in(folder: &Path) -> Vec<Frame> {
    let file = fs::File::open(folder.join("trajectory.txt")).unwrap();
    Frames::of(BufReader::new(file)).map(Result::unwrap).collect()
}

#[test]
fn the_discs_of_a_page_are_those_of_the_file() {
    for arguments in [
        "-n 20 --time 0.05 --seed 1 -q",
        "-n 60 --time 0.02 --seed 1 -q --speed 0.5 --radius 1e-3 --restitution 0.5",
        "-n 1 --time 0.01 --seed 1 -q --gravity 0",
    ] {
        let folder = simulate(arguments);
        plot(folder.path(), "trajectory trajectory.txt --html");
        let film = film_of(&fs::read_to_string(folder.path().join("trajectory.html")).unwrap());
        let frames = frames_in(folder.path());
        let seen = decoded(&film);
        assert_eq!(seen.len(), frames.len(), "{arguments}");
        for (seen, frame) in seen.iter().zip(&frames) {
            assert_same(seen, frame, 1, &film);
        }
        let times: Vec<f64> = frames.iter().map(|frame| frame.time.unwrap()).collect();
        for (shown, time) in numbers(&film["times"]).iter().zip(times) {
            assert!((shown - time).abs() <= 1e-15, "{arguments}: {shown} {time}");
        }
        assert_eq!(film["side"].as_f64(), Some(0.04));
    }
}

#[test]
fn the_energies_of_a_page_are_those_of_the_ledger() {
    let folder = simulate("-n 20 --time 0.05 --seed 1 -q --restitution 0.5");
    plot(folder.path(), "trajectory trajectory.txt --html");
    let film = film_of(&fs::read_to_string(folder.path().join("trajectory.html")).unwrap());
    let rows = energy::read(fs::File::open(folder.path().join("energy.csv")).unwrap()).unwrap();
    let energies = &film["energies"];
    assert_eq!(energies["unit"], "mJ");
    let times = numbers(&energies["times"]);
    assert!(times.len() <= 600, "{}", times.len());
    // The reader of JSON may miss the last bit of a number.
    let is_at = |time: f64, row: &LedgerRow| (row.time_s - time).abs() <= 1e-15;
    assert!(is_at(times[0], &rows[0]) && is_at(times[times.len() - 1], &rows[rows.len() - 1]));
    for (name, value) in [
        ("total", (|row| row.total_J) as fn(&LedgerRow) -> f64),
        ("gravitational", |row| row.gravitational_J),
        ("kinetic", |row| row.kinetic_J),
        ("elastic", |row| row.elastic_J),
        ("dissipated", |row| row.dissipated_J),
    ] {
        let curves = energies["curves"].as_array().unwrap();
        let curve = curves.iter().find(|curve| curve["name"] == name).unwrap();
        for (time, shown) in times.iter().zip(numbers(&curve["values"])) {
            let row = rows.iter().find(|row| is_at(*time, row)).unwrap();
            // Six digits.
            assert!((shown * 1e-3 - value(row)).abs() <= 1e-5 * value(row).abs(), "{name} {time}");
        }
    }
}

/// A film of made-up frames, in which each disc goes its own way.
fn made_up(frames: usize, discs: usize) -> (Vec<Frame>, Film) {
    let row = |k: usize, disc: usize| {
        let mut row = template();
        row.position = DVec2::new((disc % 97) as f64, (disc / 97 + k) as f64) * 1e-3;
        row.radius = 1e-4 * (1 + disc % 3) as f64;
        row.velocity = Some(DVec2::new(k as f64, disc as f64) * 1e-3);
        row
    };
    let frame = |k: usize| {
        let mut frame = Frame::default();
        frame.time = Some(k as f64);
        frame.rows = (0..discs).map(|disc| row(k, disc)).collect();
        frame
    };
    let frames: Vec<Frame> = (0..frames).map(frame).collect();
    let mut survey = Survey::begin();
    frames.iter().for_each(|frame| survey.add(frame));
    let mut film = Film::begin(survey);
    frames.iter().for_each(|frame| film.add(frame));
    (frames, film)
}

/// A row as a file without more columns has it.
fn template() -> FrameRow {
    Frames::of("0 0 1e-4 0 0\n".as_bytes()).next().unwrap().unwrap().rows[0]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..steady() })]

    #[test]
    fn a_film_keeps_within_its_bounds_and_the_ends_of_the_run(
        frames in 1_usize..700,
        discs in prop_oneof![1_usize..40, 1000_usize..3000],
    ) {
        let (all, film) = made_up(frames, discs);
        let (kept, of) = film.frames();
        prop_assert_eq!(of, frames);
        prop_assert!(kept <= MOST_FRAMES && kept * film.discs() <= MOST_PLACES + kept);
        // Nothing is left out that there is room for.
        prop_assert!(film.disc_step() == 1 || kept * discs > MOST_PLACES);
        prop_assert!(kept == frames || kept == MOST_FRAMES || (kept + 1) * discs > MOST_PLACES);
        let times = film.times().unwrap();
        prop_assert_eq!(times.first(), Some(&0.0));
        prop_assert_eq!(times.last().copied(), Some((frames - 1) as f64));
        let data = film_of(&alone(&film, &[], &ENGLISH));
        for (seen, time) in decoded(&data).iter().zip(times) {
            assert_same(seen, &all[time as usize], film.disc_step(), &data);
        }
    }
}

#[test]
fn a_page_of_many_discs_stays_small_and_says_what_it_leaves_out() {
    let (_, film) = made_up(150, 20_000);
    let page = alone(&film, &[], &ENGLISH);
    assert!(page.len() < 4_000_000, "{}", page.len());
    assert!(page.contains("It has 100 of the 150 frames of the file."), "{}", film.frames().0);
    assert!(page.contains("It shows one disc of every 4"));
    let (_, film) = made_up(150, 20);
    assert!(!alone(&film, &[], &ENGLISH).contains("frames of the file"));
}

#[test]
fn discs_that_are_not_in_every_frame_keep_their_numbers() {
    let frames: Vec<Frame> =
        Frames::of("# step 0 n 1\n1 1 0.1\n\n\n# step 1 n 2\n1 2 0.1\n3 4 0.2\n".as_bytes())
            .map(Result::unwrap)
            .collect();
    let mut survey = Survey::begin();
    frames.iter().for_each(|frame| survey.add(frame));
    let mut film = Film::begin(survey);
    frames.iter().for_each(|frame| film.add(frame));
    let data = film_of(&alone(&film, &[], &ENGLISH));
    let seen = decoded(&data);
    assert!(seen[0][0].is_some() && seen[0][1].is_none());
    assert_same(&seen[1], &frames[1], 1, &data);
    // No times, no speeds, no box, no energies.
    for key in ["times", "fastest", "side", "energies"] {
        assert!(data[key].is_null(), "{key}");
    }
}

#[test]
fn a_run_without_walls_has_no_box() {
    let folder = simulate("-n 3 --time 0.01 --seed 1 -q --no-walls");
    plot(folder.path(), "trajectory trajectory.txt --html");
    let page = fs::read_to_string(folder.path().join("trajectory.html")).unwrap();
    assert!(film_of(&page)["side"].is_null());
}

#[test]
fn a_player_takes_no_energies_of_another_run() {
    let [folder, other] = ["0.01", "0.002"]
        .map(|time| simulate(&format!("-n 3 --time {time} --seed 1 -q --speed 0.5")));
    fs::copy(other.path().join("energy.csv"), folder.path().join("energy.csv")).unwrap();
    let output = plot(folder.path(), "trajectory trajectory.txt --html");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("of another time than the frames"), "{said}");
    let page = fs::read_to_string(folder.path().join("trajectory.html")).unwrap();
    assert!(film_of(&page)["energies"].is_null());
}

#[test]
fn a_player_writes_one_page_and_never_over_its_frames() {
    let folder = simulate("-n 3 --time 0.001 --seed 1 -q");
    let names = || fs::read_dir(folder.path()).unwrap().count();
    let before = names();
    let said = plot(folder.path(), "trajectory trajectory.txt --html").stdout;
    assert_eq!(String::from_utf8(said).unwrap(), "wrote trajectory.html\n");
    assert_eq!(names(), before + 1);
    fs::rename(folder.path().join("trajectory.txt"), folder.path().join("frames.html")).unwrap();
    for (arguments, part) in [
        ("trajectory frames.html --html -o frames.html", "frames.html is what is to be drawn"),
        ("trajectory frames.html --html -o film.svg", "this picture is a .html file"),
        ("trajectory frames.html --html --gif", "cannot be used with"),
        ("trajectory none.txt --html", "none.txt"),
    ] {
        let output = run(folder.path(), arguments);
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(!output.status.success() && said.contains(part), "{arguments}: {said}");
    }
    let frames = fs::read_to_string(folder.path().join("frames.html")).unwrap();
    assert!(frames.starts_with("# step 0"), "{frames}");
}

#[test]
fn the_script_is_short_and_asks_nobody() {
    let script = include_str!("../src/page/player.js");
    assert!(script.lines().count() < 300);
    for word in ["http", "fetch", "import", "eval", "innerHTML", "localStorage", "cookie"] {
        assert!(!script.contains(word), "{word}");
    }
}
