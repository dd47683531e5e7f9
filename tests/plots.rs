//! The gnuplot scripts of `plot/`, each run on what the program wrote, its picture read back.
//! Discs, arrows and curves are the only things in colour: axes, box and letters are black.

use std::fs::{self, File};

use tempfile::TempDir;

use crate::support::gnuplot_is_missing;
use crate::support::scripts::{
    MOVING, Picture, gnuplot, in_colour, light_grey, plot, said, simulate, start,
};

/// Damped discs with many contacts.
const CROWDED: &str = "-n 50 --time 0.02 --seed 1 -q --speed 0.5 --radius 1e-3 --restitution 0.5";
/// One large disc that does not move.
const RESTING: &str = "-n 1 --time 0.001 --seed 1 -q --gravity 0 --radius 5e-3";

#[test]
fn replay_plot_draws_one_frame_or_an_animation() {
    if gnuplot_is_missing("the replay") {
        return;
    }
    let folder = simulate(MOVING);
    let discs = [("first.png", "; frame=0"), ("last.png", "")].map(|(name, frame)| {
        let output = plot(&folder, "replay", &format!("png='{name}'{frame}"));
        assert_eq!(said(&output), format!("wrote {name}\n"));
        Picture::read(&folder, name).places(in_colour)
    });
    assert!(discs[0].len() > 1000, "twenty discs, no pixels");
    assert!(discs[0] != discs[1], "nothing moved");
    plot(&folder, "replay", "gif='some.gif'; first=10; last=30; step=5");
    assert_eq!(frames_of_gif(&fs::read(folder.path().join("some.gif")).unwrap()), 5);
}

#[test]
fn energy_plot_draws_every_curve() {
    if gnuplot_is_missing("the energy plot") {
        return;
    }
    // At rest all curves lie on one another: what is left of a colour is its legend.
    let [moving, resting] = [CROWDED, RESTING].map(|run| {
        let folder = simulate(run);
        plot(&folder, "energy", "png='energy.png'");
        let picture = Picture::read(&folder, "energy.png");
        let (upper, lower) = picture.pixels.split_at(picture.pixels.len() / 2);
        [upper.to_vec(), lower.to_vec()]
    });
    for (panel, curve, colour) in [
        (0, "gravitational", [0x00, 0x72, 0xB2]),
        (0, "kinetic", [0xD5, 0x5E, 0x00]),
        (0, "elastic", [0x00, 0x9E, 0x73]),
        (0, "dissipated", [0xCC, 0x79, 0xA7]),
        (1, "integration error: gain", [0xE6, 0x9F, 0x00]),
        (1, "integration error: loss", [0x56, 0xB4, 0xE9]),
        (1, "work residue", [0x88, 0x22, 0x55]),
    ] {
        let near = |pixel: &&[u8; 3]| pixel.iter().zip(colour).all(|(a, b)| a.abs_diff(b) < 12);
        let [drawn, legend] = [&moving, &resting].map(|of| of[panel].iter().filter(near).count());
        let least = match curve {
            "dissipated" => 200, // drawn last, so at rest too
            _ => legend + 100,
        };
        assert!(drawn > least, "{curve}: {drawn} pixels, at rest {legend}");
    }
}

#[test]
fn velocity_plot_draws_arrows_along_the_velocities() {
    if gnuplot_is_missing("the velocity field") {
        return;
    }
    let radius = 2e-3;
    let folder = simulate("-n 1 --time 0.01 --seed 3 -q --gravity 0 --speed 0.5 --radius 2e-3");
    plot(&folder, "velocity", "png='velocity.png'");
    let picture = Picture::read(&folder, "velocity.png");
    let [left, right, top, bottom] = picture.bounds(light_grey);
    let pixel = 2.0 * radius / (right - left + 1) as f64; // m
    let centre = [(left + right) as f64 / 2.0, (top + bottom) as f64 / 2.0];

    let text = fs::read_to_string(folder.path().join("trajectory.txt")).unwrap();
    let row = text.lines().last().unwrap();
    let row: Vec<f64> = row.split(' ').map(|word| word.parse().unwrap()).collect();
    let speed = row[3].hypot(row[4]);
    let along = [row[3] / speed, -row[4] / speed]; // rows of pixels count downward

    let arrow = picture.places(in_colour);
    assert!(arrow.len() > 20, "no arrow");
    let mut farthest = 0.0_f64;
    for (x, y) in arrow {
        let [dx, dy] = [x as f64 - centre[0], y as f64 - centre[1]];
        let (forward, aside) = (dx * along[0] + dy * along[1], dx * along[1] - dy * along[0]);
        assert!(
            forward > -3.0 && aside.abs() < 6.0,
            "({dx}, {dy}) from the centre is not on an arrow along {along:?}"
        );
        farthest = farthest.max(forward);
    }
    let expected = 0.05 * 0.04 / pixel; // 5 % of the box
    assert!(
        (farthest - expected).abs() < 4.0,
        "the fastest arrow has {farthest} pixels, not {expected}"
    );
}

#[test]
fn velocity_plot_of_discs_at_rest_has_no_arrows() {
    if gnuplot_is_missing("the velocity field at rest") {
        return;
    }
    let folder = simulate(RESTING);
    let output = plot(&folder, "velocity", "png='velocity.png'");
    assert_eq!(said(&output), "wrote velocity.png\n");
    let picture = Picture::read(&folder, "velocity.png");
    assert_eq!(picture.places(in_colour), []);
}

#[test]
fn discs_are_drawn_to_scale() {
    if gnuplot_is_missing("the scale of the discs") {
        return;
    }
    let folder = simulate(RESTING);
    for (script, disc) in [
        ("loop", in_colour as fn([u8; 3]) -> bool),
        ("replay", in_colour),
        ("velocity", light_grey),
    ] {
        let name = format!("{script}.png");
        plot(&folder, script, &format!("png='{name}'"));
        let picture = Picture::read(&folder, &name);
        let [left, right, top, bottom] = picture.bounds(disc);
        let [west, east, north, south] = picture.walls();
        assert!((east - west).abs_diff(south - north) <= 1, "{script}: not square");
        for (size, side) in [(right - left + 1, east - west), (bottom - top + 1, south - north)] {
            let expected = side as f64 * 2.0 * 5e-3 / 0.04;
            assert!(
                (size as f64 - expected).abs() <= 3.0,
                "{script}: {size} pixels, not {expected}"
            );
        }
    }
}

#[test]
fn a_missing_or_empty_file_is_one_clear_message() {
    if gnuplot_is_missing("missing files") {
        return;
    }
    for (script, file) in
        [("replay", "trajectory.txt"), ("velocity", "trajectory.txt"), ("energy", "energy.csv")]
    {
        let folder = TempDir::new().unwrap();
        for state in ["missing", "empty"] {
            let output = start(gnuplot(&folder, script, "png='no.png'")).finish();
            let said = said(&output);
            assert_eq!(output.status.code(), Some(1), "{script}, {state}: {said}");
            assert_eq!(said.lines().count(), 1, "{script}, {state}: {said}");
            assert!(said.starts_with(file) && said.contains("run the simulator"), "{said}");
            File::create(folder.path().join(file)).unwrap();
        }
        assert!(!folder.path().join("no.png").exists());
    }
}

#[test]
fn a_frame_that_is_not_there_is_one_clear_message() {
    if gnuplot_is_missing("wrong frame numbers") {
        return;
    }
    let folder = simulate(RESTING);
    for script in ["replay", "velocity"] {
        let output = start(gnuplot(&folder, script, "png='no.png'; frame=999")).finish();
        let said = said(&output);
        assert_eq!(output.status.code(), Some(1), "{script}: {said}");
        assert!(said.starts_with("trajectory.txt holds frames 0 to 113;"), "{said}");
        assert_eq!(said.lines().count(), 1, "{said}");
    }
}

#[test]
fn a_gnuplot_without_windows_writes_files_or_text() {
    if gnuplot_is_missing("gnuplot without windows") {
        return;
    }
    let folder = simulate(RESTING);
    for (script, file) in [
        ("replay", "replay.gif"),
        ("velocity", "velocity.png"),
        ("energy", "energy.png"),
        ("loop", ""),
    ] {
        // `set output` sends the text picture to a file.
        let settings = if script == "loop" { "redraws=1; set output 'drawn.txt'" } else { "" };
        let mut command = gnuplot(&folder, script, settings);
        command.env("GNUTERM", "unknown");
        let output = start(command).finish();
        let said = said(&output);
        if script == "loop" {
            // The live view is drawn as text.
            assert!(output.status.success(), "{said}");
            let drawn = fs::read_to_string(folder.path().join("drawn.txt")).unwrap();
            assert!(drawn.contains("t = ") && drawn.contains('*'), "{drawn}{said}");
        } else {
            assert!(output.status.success(), "{said}");
            assert!(said.ends_with(&format!("wrote {file}\n")), "{said}");
            assert!(folder.path().join(file).exists());
        }
    }
}

/// Number of pictures in a GIF, found by walking over its blocks.
fn frames_of_gif(bytes: &[u8]) -> usize {
    let table = |flags: u8| {
        if flags & 0x80 == 0 { 0 } else { 3 << ((flags & 7) + 1) }
    };
    let (mut at, mut frames) = (13 + table(bytes[10]), 0);
    loop {
        at += match bytes[at] {
            0x21 => 2, // an extension
            0x2C => {
                frames += 1;
                11 + table(bytes[at + 9])
            }
            end => {
                assert_eq!(end, 0x3B, "not the end of a GIF");
                return frames;
            }
        };
        while bytes[at] != 0 {
            at += 1 + bytes[at] as usize; // a block of data
        }
        at += 1;
    }
}
