//! `parsim2d plot`: what is in the pictures, what the gnuplot scripts beside them do, and what is
//! said of files that cannot be drawn.
#![allow(clippy::too_many_lines)] // tables of cases

use std::fs::{self, File};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output};

use glam::DVec2;
use parsim2d::figure::forces::links;
use parsim2d::figure::paths::moments;
use parsim2d::figure::speeds::{Histogram, Moments, maxwell};
use parsim2d::figure::{colour, label, svg, ticks};
use parsim2d::force::HalfPlane;
use parsim2d::output::drift::{CurveRow, DriftRow};
use parsim2d::output::frames::{Frames, read_frame};
use parsim2d::particle::{Contact, ContactLaw, Damping, Particle, SpringDashpot};
use proptest::prelude::*;
use tempfile::TempDir;

mod support;
use support::steady;

/// Every kind of picture on the files of a run, with its picture's name.
const KINDS: [(&str, &str); 11] = [
    ("frame out.txt", "frame.svg"),
    ("frame trajectory.txt --vectors -o arrows.svg", "arrows.svg"),
    ("frame trajectory.txt --colour radius --frame 1 -o radius.svg", "radius.svg"),
    ("trajectory trajectory.txt", "trajectory.svg"),
    ("trajectory trajectory.txt --gif --every 40 --size 100 -o film.gif", "film.gif"),
    ("energy energy.csv", "energy.svg"),
    ("energy energy.csv energy.csv -o two.svg", "two.svg"),
    ("velocity trajectory.txt", "velocity.svg"),
    ("forces trajectory.txt", "forces.svg"),
    ("speeds trajectory.txt --pool", "speeds.svg"),
    ("drift drift.csv", "drift.svg"),
];

/// Runs whose pictures are drawn: few discs, many with contacts, one, at rest.
const RUNS: [&str; 4] = [
    "-n 5 --time 0.01 --seed 1 -q --speed 0.5",
    "-n 60 --time 0.01 --seed 1 -q --speed 0.5 --radius 1e-3 --restitution 0.5",
    "-n 1 --time 0.01 --seed 1 -q --gravity 0 --speed 0.5 --radius 2e-3",
    "-n 2 --time 0.001 --seed 1 -q --gravity 0",
];

#[test]
fn every_picture_is_well_formed_and_says_that_it_was_written() {
    for run in RUNS {
        let folder = simulate(run);
        write_study(folder.path());
        for (arguments, picture) in KINDS {
            let output = plot(folder.path(), arguments);
            let script = picture.replace(".svg", ".gp").replace(".gif", ".gp");
            let said = String::from_utf8(output.stdout).unwrap();
            assert_eq!(said, format!("wrote {picture} and {script}\n"), "{run}: {arguments}");
            assert!(folder.path().join(&script).exists(), "{arguments}");
            if picture.ends_with("svg") {
                let text = read(&folder, picture);
                let document = roxmltree::Document::parse(&text)
                    .unwrap_or_else(|why| panic!("{run}: {arguments}: {why}"));
                assert_eq!(document.root_element().tag_name().name(), "svg");
                // One element a line, and no number that is none.
                let longest = text.lines().filter(|line| !line.contains("points=")).map(str::len);
                assert!(longest.max().unwrap() < 300, "{arguments}");
                for word in ["NaN", "inf\"", "nan"] {
                    assert!(!text.contains(word), "{run}: {arguments}: {word}");
                }
            }
        }
    }
}

#[test]
fn the_same_files_give_the_same_bytes() {
    let [first, second] = [0, 1].map(|_| {
        let folder = simulate(RUNS[1]);
        write_study(folder.path());
        KINDS.map(|(arguments, picture)| {
            plot(folder.path(), arguments);
            let script = Path::new(picture).with_extension("gp");
            [picture.into(), script].map(|name| fs::read(folder.path().join(name)).unwrap())
        })
    });
    assert!(first == second);
}

#[test]
fn discs_are_to_scale_in_both_directions() {
    let folder = TempDir::new().unwrap();
    let discs = [(0.01, 0.03, 2e-3), (0.02, 0.02, 5e-4), (0.035, 0.004, 3e-3)];
    let rows = discs.map(|(x, y, r)| format!("{x} {y} {r} 0 0\n")).concat();
    let header = "# step 7 time_s 0.25 n 3 side_m 0.04 columns x y r vx vy\n";
    write(&folder, "frames.txt", &(header.to_owned() + &rows));
    plot(folder.path(), "frame frames.txt --colour none");
    let text = read(&folder, "frame.svg");
    let document = roxmltree::Document::parse(&text).unwrap();
    let number =
        |node: roxmltree::Node, name| -> f64 { node.attribute(name).unwrap().parse().unwrap() };
    let walls = document.descendants().find(|node| node.attribute("class") == Some("box")).unwrap();
    let [left, top, width, height] = ["x", "y", "width", "height"].map(|name| number(walls, name));
    assert!((width - height).abs() < 0.02, "not square");
    assert!(width > 500.0, "a small box");
    let circles: Vec<_> =
        document.descendants().filter(|node| node.has_tag_name("circle")).collect();
    assert_eq!(circles.len(), 3);
    for ((x, y, r), circle) in discs.into_iter().zip(circles) {
        let expected = [left + x / 0.04 * width, top + (1.0 - y / 0.04) * height, r / 0.04 * width];
        for (name, expected) in ["cx", "cy", "r"].into_iter().zip(expected) {
            // Two decimals are written, of the box too.
            assert!((number(circle, name) - expected).abs() < 0.02, "{name} of the disc at {x}");
        }
    }
    assert!(text.contains("t = 0.2500 s, 3 discs"), "no title");
}

#[test]
fn the_longest_arrow_is_5_percent_of_the_box_and_all_point_along_the_velocities() {
    let folder = TempDir::new().unwrap();
    let text = "# step 0 time_s 0 n 2 side_m 0.04\n0.01 0.01 1e-3 3 4\n0.03 0.03 1e-3 -2.5 0\n";
    write(&folder, "frames.txt", text);
    for (arguments, picture) in
        [("velocity frames.txt", "velocity.svg"), ("frame frames.txt --vectors", "frame.svg")]
    {
        plot(folder.path(), arguments);
        let text = read(&folder, picture);
        let document = roxmltree::Document::parse(&text).unwrap();
        let number =
            |node: roxmltree::Node, name| -> f64 { node.attribute(name).unwrap().parse().unwrap() };
        let walls = document.descendants().find(|n| n.attribute("class") == Some("box")).unwrap();
        let side = number(walls, "width");
        let tips = document.descendants().filter(|node| node.has_tag_name("polygon")).map(|head| {
            let tip = head.attribute("points").unwrap().split(' ').next().unwrap();
            let (x, y) = tip.split_once(',').unwrap();
            DVec2::new(x.parse().unwrap(), y.parse().unwrap())
        });
        let arrows = document.descendants().filter(|n| n.attribute("class") == Some("arrow"));
        let arrows: Vec<_> = arrows
            .zip(tips)
            .map(|(line, tip)| tip - DVec2::new(number(line, "x1"), number(line, "y1")))
            .collect();
        let expected = [DVec2::new(0.6, -0.8) * 0.05 * side, DVec2::new(-0.025 * side, 0.0)];
        assert_eq!(arrows.len(), 2, "{arguments}");
        for (arrow, expected) in arrows.iter().zip(expected) {
            assert!((*arrow - expected).length() < 0.05, "{arguments}: {arrow} is not {expected}");
        }
    }
}

#[test]
fn discs_far_outside_are_counted_and_do_not_shrink_the_box() {
    let folder = TempDir::new().unwrap();
    let text = "# step 0 time_s 0 n 2 side_m 0.04\n0.01 0.01 1e-3 0 0\n1e200 0.03 1e-3 1e250 0\n";
    write(&folder, "frames.txt", text);
    for kind in ["frame", "velocity", "forces", "speeds", "trajectory"] {
        plot(folder.path(), &format!("{kind} frames.txt"));
        let text = read(&folder, &format!("{kind}.svg"));
        roxmltree::Document::parse(&text).unwrap();
        let outside = text.contains("1 of 2 discs outside the picture");
        assert_eq!(outside, kind != "speeds", "{kind}");
    }
    plot(folder.path(), "trajectory frames.txt --gif");
}

proptest! {
    #![proptest_config(steady())]

    #[test]
    fn ticks_are_few_round_ascending_and_within_the_range(
        low in mantissa_and_power(), width in mantissa_and_power(), wanted in 1..20usize,
    ) {
        for (low, high) in [(low, low + width.abs()), (-width.abs(), width.abs()), (low, low), (0.0, width.abs())] {
            let marks = ticks::linear(low, high, wanted);
            prop_assert!(marks.iter().all(|mark| *mark >= low && *mark <= high));
            prop_assert!(marks.windows(2).all(|two| two[0] < two[1]), "{marks:?}");
            prop_assert!(marks.len() <= 3 * wanted + 3);
            let is_narrow = (high - low) / wanted as f64 <= 1e-12 * low.abs().max(high.abs());
            if is_narrow {
                // Its ends: there is nothing rounder.
                prop_assert!(!marks.is_empty() && marks.len() <= 2);
            } else if marks.len() > 2 {
                let step = marks[1] - marks[0];
                let digit = step / 10f64.powf((step.log10() + 1e-6).floor());
                let slack = 1e-3; // of a step, where low is many steps from zero
                let round = [1.0, 2.0, 5.0].iter().any(|round| (digit - round).abs() < slack * round);
                prop_assert!(round, "steps of {step}");
            }
        }
    }

    #[test]
    fn logarithmic_ticks_are_few_ascending_and_within_the_range(
        low in mantissa_and_power(), factor in 0.0..600.0f64, wanted in 2..20usize,
    ) {
        let low = low.abs().max(1e-300);
        let high = 10f64.powf((low.log10() + factor).min(300.0)).max(low);
        let marks = ticks::log(low, high, wanted);
        prop_assert!(marks.windows(2).all(|two| two[0] < two[1]), "{marks:?}");
        prop_assert!(marks.iter().all(|m| *m >= low * (1.0 - 1e-8) && *m <= high * (1.0 + 1e-8)));
        prop_assert!(marks.len() <= 3 * wanted + 10, "{marks:?}");
    }

    #[test]
    fn any_number_is_written_for_svg_and_for_people(value in any::<f64>(), digits in 1..9usize) {
        let written: f64 = svg::number(value).parse().unwrap();
        prop_assert!(written.abs() <= 1e5);
        prop_assert!(value.is_nan() || (written - value.clamp(-1e5, 1e5)).abs() <= 0.0051);
        prop_assert!(!label::short(value, digits).is_empty());
        let (_, power) = label::prefix(value);
        prop_assert!(power % 3 == 0);
    }

    #[test]
    fn any_text_survives_the_way_through_xml(text in any::<String>()) {
        let document = format!("<t>{}</t>", svg::escaped(&text));
        let parsed = roxmltree::Document::parse(&document).unwrap();
        let allowed: String = text
            .chars()
            .map(|c| if c < ' ' || ['\u{fffe}', '\u{ffff}'].contains(&c) { '\u{fffd}' } else { c })
            .collect();
        prop_assert_eq!(parsed.root_element().text().unwrap_or(""), allowed);
    }
}

fn mantissa_and_power() -> impl Strategy<Value = f64> {
    (-10.0..10.0f64, -300..300i32).prop_map(|(mantissa, power)| mantissa * 10f64.powi(power) / 10.0)
}

#[test]
fn ticks_of_known_ranges_are_these() {
    for (low, high, wanted, marks) in [
        (0.0, 1.0, 5, &[0.0, 0.2, 0.4, 0.6, 0.8, 1.0][..]),
        (0.3, 9.7, 4, &[2.0, 4.0, 6.0, 8.0]),
        (-1e-6, 1e-6, 4, &[-1e-6, -5e-7, 0.0, 5e-7, 1e-6]),
        (7.0, 7.0, 5, &[7.0]),
        (f64::NAN, 1.0, 5, &[]),
    ] {
        assert_eq!(ticks::linear(low, high, wanted), marks, "{low} to {high}");
    }
    for (low, high, wanted, marks) in [
        (1e-18, 1.0, 7, &[1e-18, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1.0][..]),
        (3.0, 40.0, 5, &[5.0, 10.0, 20.0]),
        (0.0, 1.0, 5, &[]),
    ] {
        assert_eq!(ticks::log(low, high, wanted), marks, "{low} to {high}");
    }
}

#[test]
fn the_scale_of_colours_grows_lighter_and_stays_readable_on_white() {
    // Relative luminance of WCAG 2.1; its contrast with white is 1.05 / (luminance + 0.05).
    let luminance = |fraction| {
        let linear = colour::at(fraction).map(|channel| {
            let c = f64::from(channel) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    };
    for k in 0..100 {
        let (here, next) = (luminance(f64::from(k) / 100.0), luminance(f64::from(k + 1) / 100.0));
        assert!(next > here - 1e-3, "darker at {k} %"); // steps of 1/255 scatter a little
        assert!(1.05 / (next + 0.05) > 2.0, "too light at {k} %");
    }
}

#[test]
fn maxwells_curve_has_the_area_1_and_the_mean_square_2_s2() {
    for s in [1e-3, 0.5, 70.0] {
        // Simpson's rule to 12 s, beyond which e^-72 is left; its error is far below 1e-8.
        let n = 2000;
        let h = 12.0 * s / f64::from(n);
        let sum = |power: i32| -> f64 {
            let term = |k: i32| {
                let v = f64::from(k) * h;
                let weight = [2.0, 4.0][k as usize % 2] - if k == 0 || k == n { 1.0 } else { 0.0 };
                weight * v.powi(power) * maxwell(v, s)
            };
            (0..=n).map(term).sum::<f64>() * h / 3.0
        };
        assert!((sum(0) - 1.0).abs() < 1e-8);
        assert!((sum(2) / (2.0 * s * s) - 1.0).abs() < 1e-8);
        let at_peak = maxwell(s, s) * s; // the most likely speed is s itself
        assert!((at_peak - (-0.5f64).exp()).abs() < 1e-14);
    }
}

#[test]
fn the_histogram_counts_every_speed_once_and_knows_mean_and_rms() {
    // Speeds 0, 1, ... 99 m/s.
    let rows = (0..100).map(|v| format!("0 0 1 {v} 0\n")).collect::<String>();
    let frame = read_frame(rows.as_bytes(), None).unwrap();
    let mut moments = Moments::default();
    moments.add(&frame);
    assert!((moments.mean() - 49.5).abs() < 1e-12);
    assert!((moments.rms() - 3283.5f64.sqrt()).abs() < 1e-12); // 99 * 199 / 6
    let mut histogram = Histogram::new(moments);
    histogram.add(&frame);
    let bars = histogram.bars();
    let area: f64 = bars.iter().map(|(_, density)| density * histogram.width()).sum();
    assert!((area - 1.0).abs() < 1e-12);
    assert_eq!(histogram.width(), 10.0); // about 2 * 100^(1/3) = 9 bins
    for (_, density) in bars {
        assert!((density - 0.01).abs() < 1e-12); // ten of a hundred in 10 m/s
    }
}

#[test]
fn contact_forces_are_those_of_the_law() {
    let law = SpringDashpot { stiffness: 5e4, damping: Damping::Coefficient(0.5), tension: true };
    let disc = |x, y, vx| {
        let mut disc = Particle::at_rest(DVec2::new(x, y), 1e-3, 1e-3);
        disc.velocity.x = vx;
        disc
    };
    // Two that part and pull, one pressed into the right wall, one alone.
    let discs = [
        disc(0.01, 0.02, -1.0),
        disc(0.01199, 0.02, 1.0),
        disc(0.0392, 0.02, 0.0),
        disc(0.02, 0.03, 0.0),
    ];
    let found = links(&discs, &law, &HalfPlane::square(0.04));
    let [wall, pair] = found.as_slice() else { panic!("{found:?}") };
    assert!((wall.push - 5e4 * 2e-4).abs() < 1e-9);
    assert!((wall.to - DVec2::new(0.04, 0.02)).length() < 1e-15);
    let contact = Contact::between(&discs[0], &discs[1]).unwrap();
    assert_eq!(pair.push, law.push(&contact));
    assert!((pair.push - (5e4 * 1e-5 - 0.5 * 2.0)).abs() < 1e-9); // -0.5 N
    let apart = SpringDashpot { tension: false, ..law };
    assert_eq!(links(&discs, &apart, &[])[0].push, 0.0);
}

#[test]
fn forces_take_the_flags_of_the_run_and_say_the_largest() {
    let folder = TempDir::new().unwrap();
    let text = "# step 0 time_s 0 n 2 side_m 0.04\n0.01 0.02 1e-3 0.5 0\n0.0119 0.02 1e-3 0 0\n";
    write(&folder, "frames.txt", text);
    for (flags, largest) in [
        ("--eta 0", "5 N"),                                // 5e4 * 1e-4
        ("--kn 1e5 --eta 0", "10 N"),                      // 1e5 * 1e-4
        ("--eta 2", "6 N"),                                // 5 + 2 * 0.5
        ("--gamma 2e3 --mass 4g", "7 N"),                  // 5 + 2e-3 * 2e3 * 0.5
        ("--restitution 1 --no-walls", "5 N"),             // no dashpot
        ("--preset guide-mass-scaled --kn 1e5", "10.4 N"), // 10 + 5e-4 * 1.5e3 * 0.5
    ] {
        plot(folder.path(), &format!("forces frames.txt {flags}"));
        let expected = format!("1 contact, the largest force {largest}");
        let text = read(&folder, "forces.svg");
        assert!(text.contains(&expected), "{flags}: {expected}\n{text}");
    }
}

#[test]
fn a_gif_has_every_frame_and_its_colours_where_the_discs_are() {
    let folder = TempDir::new().unwrap();
    // One slow and one fast disc that change places from frame to frame.
    let frame = |k: usize| {
        let (slow, fast) = if k % 2 == 0 { (0.01, 0.03) } else { (0.03, 0.01) };
        format!(
            "# step {k} time_s {k} n 2 side_m 0.04\n{slow} 0.01 4e-3 0 0\n{fast} 0.02 4e-3 0 2\n"
        )
    };
    let text = (0..7).map(frame).collect::<Vec<_>>().join("\n\n");
    write(&folder, "frames.txt", &text);
    for (flags, shown) in [
        ("", &[0, 1, 2, 3, 4, 5, 6][..]),
        ("--every 3", &[0, 3, 6]),
        ("--until 4 --every 2", &[0, 2, 4]),
    ] {
        plot(folder.path(), &format!("trajectory frames.txt --gif --size 212 --fps 10 {flags}"));
        let file = File::open(folder.path().join("trajectory.gif")).unwrap();
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::RGBA);
        let mut decoder = options.read_info(file).unwrap();
        assert_eq!([decoder.width(), decoder.height()], [212, 232]);
        assert!(decoder.global_palette().unwrap().len() / 3 <= 128);
        let mut frames = 0;
        while let Some(picture) = decoder.read_next_frame().unwrap() {
            assert_eq!(picture.delay, 10); // hundredths of a second
            let at = |x: f64, y: f64| {
                // The view is 1.06 boxes wide, 3 % beyond each wall.
                let pixel = |v: f64| (v / 0.04 + 0.03) / 1.06 * 212.0;
                let (column, row) = (pixel(x) as usize, (232.0 - pixel(y)) as usize);
                let start = 4 * (row * 212 + column);
                [0, 1, 2].map(|k| picture.buffer[start + k])
            };
            let (slow, fast) = if shown[frames] % 2 == 0 { (0.01, 0.03) } else { (0.03, 0.01) };
            assert_eq!(at(slow, 0.01), colour::at(0.0), "frame {frames}");
            assert_eq!(at(fast, 0.02), colour::at(1.0), "frame {frames}");
            // A tenth of the radius within and without the edge.
            assert_eq!(at(slow + 3.6e-3, 0.01), colour::at(0.0), "frame {frames}");
            assert_eq!(at(slow + 4.4e-3, 0.01), [255; 3], "frame {frames}");
            assert_eq!(at(0.02, 0.03), [255; 3], "frame {frames}");
            frames += 1;
        }
        assert_eq!(frames, shown.len(), "{flags}");
    }
}

#[test]
fn paths_of_few_discs_and_moments_of_many() {
    for (n, paths, panels) in [(50, 50, 1), (51, 0, 6)] {
        let folder = simulate(&format!("-n {n} --time 0.005 --seed 1 -q"));
        plot(folder.path(), "trajectory trajectory.txt");
        let text = read(&folder, "trajectory.svg");
        assert_eq!(text.matches("<polyline").count(), paths, "{n}");
        assert_eq!(text.matches("class=\"box\"").count(), panels, "{n}");
    }
    assert_eq!(moments(201), [0, 40, 80, 120, 160, 200]);
    assert_eq!(moments(3), [0, 1, 2]);
    assert_eq!(moments(1), [0]);
}

#[test]
fn a_path_passes_through_the_places_of_its_disc() {
    let folder = TempDir::new().unwrap();
    let frame = |k: usize| format!("# step {k} time_s {k} n 1 side_m 1\n0.{k} 0.{k} 1e-3 0 0\n");
    write(&folder, "frames.txt", &(1..9).map(frame).collect::<Vec<_>>().join("\n\n"));
    plot(folder.path(), "trajectory frames.txt");
    let text = read(&folder, "trajectory.svg");
    let line = text.lines().find(|line| line.starts_with("<polyline")).unwrap();
    let points = line.split('"').nth(1).unwrap().split(' ').collect::<Vec<_>>();
    assert_eq!(points.len(), 9, "{points:?}"); // eight places, and the last disc itself
    let [first, second, last] = [0, 1, 7].map(|k| {
        let (x, y) = points[k].split_once(',').unwrap();
        DVec2::new(x.parse().unwrap(), y.parse().unwrap())
    });
    let step = second - first;
    assert!(step.x > 10.0 && (step.x + step.y).abs() < 0.02, "{step}"); // along the diagonal
    assert!((last - first - 7.0 * step).length() < 0.1); // two decimals are written
}

#[test]
fn the_frames_of_a_file_come_one_by_one_as_read_frame_reads_them() {
    let folder = simulate(RUNS[0]);
    let text = read(&folder, "trajectory.txt");
    let all: Vec<_> = Frames::of(text.as_bytes()).map(Result::unwrap).collect();
    assert_eq!(all.len(), text.matches('#').count());
    for (k, frame) in all.iter().enumerate() {
        assert_eq!(*frame, read_frame(text.as_bytes(), Some(k)).unwrap(), "frame {k}");
    }
    assert!(all.windows(2).all(|two| two[0].time < two[1].time && two[0].step < two[1].step));
    // After an error there is nothing, and the frames before it have come.
    let cut = &text[..text.len() - 3];
    let cut: Vec<_> = Frames::of(cut.as_bytes()).collect();
    assert_eq!(cut.len(), all.len());
    assert!(cut.last().unwrap().is_err() && cut[..cut.len() - 1].iter().all(Result::is_ok));
}

#[test]
fn the_energy_picture_has_every_curve_and_a_fitting_unit() {
    let folder = simulate(RUNS[1]);
    plot(folder.path(), "energy energy.csv");
    let text = read(&folder, "energy.svg");
    for part in [
        ">total<",
        ">gravitational<",
        ">kinetic<",
        ">elastic<",
        ">dissipated<",
        ">integration error: gain<",
        ">integration error: loss<",
        ">work residue (round-off)<",
        ">energy, mJ<",
        ">10⁻¹⁵<",
    ] {
        assert!(text.contains(part), "{part}");
    }
}

#[test]
fn the_energies_of_a_run_that_explodes_stand_on_a_logarithmic_axis() {
    let folder = simulate("-n 20 --seed 1 --eta 1.5e3 --allow-unstable --time 0.1 -q");
    let output = plot(folder.path(), "energy energy.csv");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("energy.csv: 1299 rows that are not finite are left out"), "{said}");
    let text = read(&folder, "energy.svg");
    assert!(text.contains("|energy|, J") && text.contains("10²⁰⁰"), "{text}");
}

#[test]
fn several_ledgers_are_compared_by_name() {
    let folder = simulate(RUNS[0]);
    fs::copy(folder.path().join("energy.csv"), folder.path().join("a<b & c.csv")).unwrap();
    let output =
        parsim2d(folder.path()).args(["plot", "energy", "energy.csv", "a<b & c.csv"]).output();
    assert!(output.unwrap().status.success());
    let text = read(&folder, "energy.svg");
    let document = roxmltree::Document::parse(&text).unwrap();
    let texts: Vec<_> = document.descendants().filter_map(|node| node.text()).collect();
    for name in ["energy.csv", "a<b & c.csv", "total energy, mJ"] {
        assert!(texts.contains(&name), "{name}: {texts:?}");
    }
}

#[test]
fn the_drift_study_has_its_slopes_and_a_panel_a_case() {
    let folder = TempDir::new().unwrap();
    write_study(folder.path());
    plot(folder.path(), "drift drift.csv");
    let text = read(&folder, "drift.svg");
    for part in [
        "slope 1",
        "slope 2",
        "wall, symplectic-euler",
        "pair, explicit-euler",
        "Many contacts: box",
        "Many contacts: dense",
        "N_t = 50",
    ] {
        assert!(text.contains(part), "{part}");
    }
    // Errors that fall as dt² lie along the guide of slope 2: 1.6 times above it, everywhere.
    let points = |line: &str| -> Vec<DVec2> {
        let pair = |p: &str| {
            let (x, y) = p.split_once(',').unwrap();
            DVec2::new(x.parse().unwrap(), y.parse().unwrap())
        };
        line.split('"').nth(1).unwrap().split(' ').map(pair).collect()
    };
    let lines: Vec<_> = text.lines().filter(|line| line.starts_with("<polyline")).collect();
    let with = |what: &str| {
        let longest = |line: &&&str| points(line).last().unwrap().x - points(line)[0].x;
        let same = lines.iter().filter(|line| line.contains(what));
        points(same.max_by(|a, b| longest(a).total_cmp(&longest(b))).unwrap())
    };
    let (guide, data) = (with("stroke-dasharray=\"2 4\""), with("#0072B2"));
    let slope = |points: &[DVec2]| {
        let along = *points.last().unwrap() - points[0];
        along.y / along.x
    };
    assert!((slope(&guide) - slope(&data)).abs() < 1e-3, "{guide:?} {data:?}");
}

#[test]
fn bad_input_is_one_clear_message_that_names_the_file() {
    let folder = simulate("-n 3 --time 0.001 --seed 1 -q");
    let path = folder.path();
    let whole = read(&folder, "trajectory.txt");
    let frames = whole.matches('#').count();
    write(&folder, "cut.txt", &whole[..whole.len() - 7]);
    write(&folder, "nan.txt", &format!("{whole}\n\n# step 9 n 1 side_m 0.04\nnan 0 1 0 0\n"));
    write(&folder, "empty.txt", "");
    fs::write(path.join("binary.txt"), [0xff, 0xfe, 0, 1, 10, 200, 3]).unwrap();
    let energy = read(&folder, "energy.csv");
    write(&folder, "cut.csv", &energy[..energy.len() - 40]);
    write(
        &folder,
        "one.csv",
        &energy.lines().take(2).map(|l| format!("{l}\n")).collect::<String>(),
    );
    write_study(path);
    fs::create_dir(path.join("alone")).unwrap();
    fs::copy(path.join("drift.csv"), path.join("alone/drift.csv")).unwrap();
    let last = frames - 1;
    let before = fs::read_dir(path).unwrap().count();
    for (arguments, file, reason) in [
        ("frame none.txt", "none.txt", "`parsim2d` writes it"),
        ("drift none.csv", "none.csv", "`parsim2d drift` writes it"),
        ("drift alone/drift.csv", "drift_energy.csv", "`parsim2d drift` writes it"),
        ("frame .", ".", "directory"),
        ("frame energy.csv", "energy.csv", "parsim2d plot energy"),
        ("speeds drift.csv", "drift.csv", "parsim2d plot drift"),
        ("energy trajectory.txt", "trajectory.txt", "parsim2d plot frame"),
        ("energy drift.csv", "drift.csv", "parsim2d plot drift"),
        ("drift energy.csv", "energy.csv", "parsim2d plot energy"),
        ("drift drift_energy.csv", "drift_energy.csv", "the file to name"),
        ("frame trajectory.txt --frame 9999", "trajectory.txt", "it holds frames 0 to"),
        ("trajectory trajectory.txt --until 9999", "trajectory.txt", "it holds frames 0 to"),
        ("velocity out.txt", "out.txt", "no velocities"),
        ("speeds out.txt", "out.txt", "no velocities"),
        ("speeds out.txt --pool", "out.txt", "no velocities"),
        ("frame out.txt --vectors", "out.txt", "no velocities"),
        ("frame out.txt --colour speed", "out.txt", "no velocities"),
        ("frame cut.txt", "cut.txt", "the line is cut off"),
        ("trajectory cut.txt", "cut.txt", "the line is cut off"),
        ("trajectory cut.txt --gif", "cut.txt", "the line is cut off"),
        ("frame nan.txt", "nan.txt", "`nan` is not finite"),
        ("velocity nan.txt", "nan.txt", "frames 0 to"),
        ("forces nan.txt", "nan.txt", "--frame"),
        ("speeds nan.txt --pool", "nan.txt", "--until"),
        ("trajectory nan.txt --gif", "nan.txt", "--until"),
        ("frame empty.txt", "empty.txt", "it holds no frame"),
        ("trajectory empty.txt --gif", "empty.txt", "it holds no frame"),
        ("energy empty.txt", "empty.txt", "its columns are"),
        ("frame binary.txt", "binary.txt", "this is not text"),
        ("energy binary.txt", "binary.txt", "not"),
        ("energy cut.csv", "cut.csv", "line"),
        ("energy one.csv", "one.csv", "1 of its 1 rows are finite"),
        ("frame out.txt trajectory.txt", "plot frame draws one file", "2 were named"),
        ("drift drift.csv drift.csv", "plot drift draws one file", "2 were named"),
        ("frame out.txt -o picture.png", "picture.png", "this picture is a .svg file"),
        ("trajectory trajectory.txt --gif -o film.svg", "film.svg", "this picture is a .gif file"),
        ("frame out.txt -o none/picture.svg", "none/picture.svg", "there is no folder none"),
        ("forces trajectory.txt --kn -1", "kn = -1", "above 0"),
        ("forces trajectory.txt --restitution 2", "restitution = 2", "at most 1"),
    ] {
        let output = run(path, arguments);
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
        assert!(said.starts_with("error: ") && said.contains(file), "{arguments}: {said}");
        assert!(said.contains(reason), "{arguments}: {said}");
        assert!(said.contains("way out: "), "{arguments}: {said}");
        assert!(output.stdout.is_empty(), "{arguments}");
    }
    assert_eq!(fs::read_dir(path).unwrap().count(), before, "something was written");
    // The way out that is offered works.
    plot(path, &format!("frame nan.txt --frame {last}"));
    plot(path, &format!("trajectory nan.txt --gif --until {last}"));
}

#[test]
fn bad_usage_names_the_flag() {
    let folder = simulate("-n 3 --time 0.001 --seed 1 -q");
    for (arguments, part) in [
        ("", "Usage"),
        ("picture out.txt", "picture"),
        ("frame", "<FILE>"),
        ("frame out.txt --frame -1", "-1"),
        ("trajectory trajectory.txt --every 0", "--every"),
        ("trajectory trajectory.txt --gif --fps 0", "0.1 to 50"),
        ("trajectory trajectory.txt --gif --size 9", "64..=2000"),
        ("trajectory trajectory.txt --size 300", "--gif"),
        ("forces trajectory.txt --eta 1 --gamma 1", "--gamma"),
        ("speeds trajectory.txt --pool --frame 1", "--frame"),
    ] {
        let output = run(folder.path(), arguments);
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
        assert!(said.contains(part), "{arguments}: {said}");
    }
}

#[test]
fn the_examples_of_the_help_work() {
    let folder = simulate("-n 5 --time 0.002 --seed 1 -q --speed 0.3");
    let output = run(folder.path(), "--help");
    let help = String::from_utf8(output.stdout).unwrap();
    let mut seen = 0;
    for line in help.lines().filter_map(|line| line.trim().strip_prefix("parsim2d plot ")) {
        let Some((arguments, _)) = line.split_once("   ") else { continue };
        plot(folder.path(), arguments);
        seen += 1;
    }
    assert_eq!(seen, 8, "{help}");
}

#[test]
fn every_script_draws_its_picture_in_gnuplot() {
    if gnuplot_is_missing("the scripts beside the pictures") {
        return;
    }
    for run in &RUNS[..] {
        let folder = simulate(run);
        write_study(folder.path());
        for (arguments, picture) in KINDS {
            plot(folder.path(), arguments);
            let script = Path::new(picture).with_extension("gp");
            let drawn = Path::new(picture).with_extension(if picture.ends_with("gif") {
                "gif"
            } else {
                "png"
            });
            let own = fs::read(folder.path().join(picture)).unwrap();
            let _ = fs::remove_file(folder.path().join(&drawn)); // the GIF of our own
            let said = gnuplot(folder.path(), &[], &script);
            let bytes = fs::read(folder.path().join(&drawn)).unwrap();
            if picture.ends_with("gif") {
                let frames = |bytes: &[u8]| {
                    let mut decoder = gif::DecodeOptions::new().read_info(bytes).unwrap();
                    let size = (decoder.width(), decoder.height());
                    let frames =
                        std::iter::from_fn(|| decoder.next_frame_info().unwrap().map(|_| ()));
                    (frames.count(), size)
                };
                assert_eq!(frames(&bytes), frames(&own), "{run}: {arguments}");
            } else {
                // The two residues of a run at rest are all zero, which gnuplot remarks on.
                assert!(
                    said.is_empty() || said.contains("Warning: empty y range"),
                    "{run}: {arguments}: {said}"
                );
                assert!(inked(&bytes) > 0.001, "{run}: {arguments}: an empty picture");
            }
        }
    }
}

#[test]
fn a_script_finds_its_data_from_anywhere_and_makes_a_pdf_too() {
    if gnuplot_is_missing("scripts in other folders") {
        return;
    }
    let folder = simulate(RUNS[0]);
    let path = folder.path();
    // Names that mean something to gnuplot or a shell.
    let data = "<it's 100% \"_x_\" `ls`.txt";
    fs::create_dir(path.join("my pictures")).unwrap();
    fs::copy(path.join("trajectory.txt"), path.join(data)).unwrap();
    fs::copy(path.join("energy.csv"), path.join("it's_{2}.csv")).unwrap();
    let cases = [
        (["velocity", data], "my pictures/it's fast.svg"),
        (["energy", "it's_{2}.csv"], "my pictures/energy.svg"),
        (["trajectory", data], "paths.svg"),
    ];
    for ([kind, data], picture) in cases {
        let output = parsim2d(path).args(["plot", kind, data, "-o", picture]).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let script = Path::new(picture).with_extension("gp");
        let png = path.join(picture).with_extension("png");
        let above = path.parent().unwrap();
        let from_above = Path::new(path.file_name().unwrap()).join(&script);
        let inside = path.join(&script);
        for (start, script) in [
            (path, script.as_path()),
            (above, &from_above),
            (inside.parent().unwrap(), Path::new(script.file_name().unwrap())),
        ] {
            let said = gnuplot(start, &[], script);
            assert_eq!(said, "", "{picture} from {}", start.display());
            assert!(inked(&fs::read(&png).unwrap()) > 0.001);
            fs::remove_file(&png).unwrap();
        }
        gnuplot(path, &["-e", "out='other.pdf'"], &script);
        assert!(fs::read(path.join("other.pdf")).unwrap().starts_with(b"%PDF"));
    }
}

#[test]
fn a_script_says_what_endings_it_knows() {
    if gnuplot_is_missing("a picture with another ending") {
        return;
    }
    let folder = simulate(RUNS[0]);
    plot(folder.path(), "energy energy.csv");
    let mut command = Command::new("gnuplot");
    command.args(["-d", "-e", "out='energy.bmp'", "energy.gp"]).current_dir(&folder);
    let output = command.output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert_eq!(String::from_utf8_lossy(&output.stderr), "out must end in: png pdf\n");
}

/// True, and says so, if there is no gnuplot to test `what` with.
fn gnuplot_is_missing(what: &str) -> bool {
    let there = Command::new("gnuplot").arg("--version").output().is_ok();
    if !there {
        let message = format!("SKIPPED: gnuplot is not installed, so {what} was not tested");
        assert!(std::env::var_os("PARSIM2D_REQUIRE_GNUPLOT").is_none(), "{message}");
        // Not `eprintln!`, which the test runner hides.
        std::io::stderr().write_all(format!("{message}\n").as_bytes()).unwrap();
    }
    !there
}

/// Runs a script to its good end; what it said.
fn gnuplot(folder: &Path, variables: &[&str], script: &Path) -> String {
    let mut command = Command::new("gnuplot");
    command.arg("-d").args(variables).arg(script).current_dir(folder);
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{}: {said}", script.display());
    said
}

/// What part of a PNG is not white.
fn inked(bytes: &[u8]) -> f64 {
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    pixels.iter().filter(|byte| **byte != 255).count() as f64 / pixels.len() as f64
}

fn parsim2d(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_parsim2d"));
    command.current_dir(folder);
    command
}

fn run(folder: &Path, arguments: &str) -> Output {
    parsim2d(folder).arg("plot").args(arguments.split_whitespace()).output().unwrap()
}

/// Draws; it must work.
fn plot(folder: &Path, arguments: &str) -> Output {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{arguments}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

/// A folder with the files of a run.
fn simulate(arguments: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    let output = parsim2d(folder.path()).args(arguments.split_whitespace()).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    folder
}

fn write(folder: &TempDir, name: &str, text: &str) {
    fs::write(folder.path().join(name), text).unwrap();
}

fn read(folder: &TempDir, name: &str) -> String {
    fs::read_to_string(folder.path().join(name)).unwrap()
}

/// A drift study whose errors fall exactly as the orders say: dt for explicit Euler, dt² for Eq. (3).
fn write_study(folder: &Path) {
    let (mut rows, mut curves) = (Vec::new(), Vec::new());
    for (case, size) in [("wall", 1.0), ("pair", 2.0), ("box", 1.0), ("dense", 1.0)] {
        for (integrator, order) in [("symplectic-euler", 2), ("explicit-euler", 1)] {
            for nt in [10.0, 20.0, 50.0] {
                let error = size / f64::powi(nt, order);
                let (case, integrator) = (case.to_owned(), integrator.to_owned());
                let key = (case.clone(), integrator.clone());
                rows.push(DriftRow {
                    case,
                    integrator,
                    restitution: 1.0,
                    nt,
                    dt_s: 4.4e-4 / nt,
                    largest_error: 2.0 * error,
                    final_error: error,
                    dissipated_J: 0.0,
                    work_error_J: 1e-18,
                });
                if ["box", "dense"].contains(&key.0.as_str()) {
                    let point = |k: u32| CurveRow {
                        case: key.0.clone(),
                        integrator: key.1.clone(),
                        restitution: 1.0,
                        nt,
                        time_s: 0.1 * f64::from(k),
                        error: error * f64::from(k),
                    };
                    curves.extend((0..10).map(point));
                }
            }
        }
    }
    parsim2d::output::drift::write(&folder.join("drift.csv"), &rows).unwrap();
    parsim2d::output::drift::write(&folder.join("drift_energy.csv"), &curves).unwrap();
}
