//! What is in the pictures of `parsim2d plot`: scale, marks, colours, curves, frames of a film.
#![allow(clippy::too_many_lines)] // tables of cases

use std::fs::{self, File};

use glam::DVec2;
use parsim2d::figure::forces::links;
use parsim2d::figure::speeds::{Histogram, Moments, maxwell};
use parsim2d::figure::{colour, label, svg, ticks};
use parsim2d::force::HalfPlane;
use parsim2d::number::typographic;
use parsim2d::output::frames::{Frames, read_frame};
use parsim2d::particle::{Contact, ContactLaw, Damping, Particle, SpringDashpot};
use proptest::prelude::*;
use tempfile::TempDir;

use crate::support::plotting::{RUNS, parsim2d, plot, read, simulate, write, write_study};
use crate::support::steady;

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
        let written: f64 = svg::coordinate(value).parse().unwrap();
        prop_assert!(written.abs() <= 1e5);
        prop_assert!(value.is_nan() || (written - value.clamp(-1e5, 1e5)).abs() <= 0.0051);
        prop_assert!(!typographic(value, digits).is_empty());
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
fn discs_of_several_masses_have_the_sum_of_their_distributions_at_one_temperature() {
    // Two of 1 kg at 2 m/s and one of 4 kg at 1 m/s: kT = (4 + 4 + 4) / 3 / 2 = 2 J.
    let rows = "# x y r vx vy m\n0 0 1 2 0 1\n5 0 1 0 -2 1\n0 5 1 1 0 4\n";
    let mut moments = Moments::default();
    moments.add(&read_frame(rows.as_bytes(), None).unwrap());
    let histogram = Histogram::new(moments);
    for speed in [0.3, 1.0, 2.5] {
        let closed_form =
            2.0 / 3.0 * maxwell(speed, 2f64.sqrt()) + maxwell(speed, 0.5f64.sqrt()) / 3.0;
        assert!((histogram.equilibrium(speed) - closed_form).abs() < 1e-15); // rounding
    }
    // Equal masses, said or not: the one distribution.
    for rows in ["0 0 1 2 0\n5 0 1 0 1\n", "# x y r vx vy m\n0 0 1 2 0 7\n5 0 1 0 1 7\n"] {
        let mut moments = Moments::default();
        moments.add(&read_frame(rows.as_bytes(), None).unwrap());
        let density = Histogram::new(moments).equilibrium(1.0);
        assert!((density - maxwell(1.0, (2.5f64 / 2.0).sqrt())).abs() < 1e-15); // rounding
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
    assert!(
        said.contains("energy.csv: 1299 rows left out, with numbers that are not finite"),
        "{said}"
    );
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
