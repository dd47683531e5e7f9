//! `parsim2d convert`: the same numbers in every format.

use std::fs;
use std::path::Path;

use glam::DVec2;
use parsim2d::output::frames::writer::{Target, Writer};
use parsim2d::output::frames::{Frame, FrameRow, Frames};
use parsim2d::output::number::push_g9;
use proptest::prelude::*;

use crate::support::runs::{names, outcome, text};
use crate::support::steady;

/// A number as a file has it.
fn printed(value: f64) -> f64 {
    let mut text = Vec::new();
    push_g9(&mut text, value);
    String::from_utf8(text).unwrap().parse().unwrap()
}

/// Any number that a file may hold.
fn number() -> impl Strategy<Value = f64> {
    (-1.0..1.0, -30..30).prop_map(|(digits, power): (f64, i32)| printed(digits * 10f64.powi(power)))
}

fn positive() -> impl Strategy<Value = f64> {
    number().prop_map(|value| printed(value.abs() + 1e-30))
}

/// x, y, vx, vy; radius and mass.
type Numbers = ([f64; 4], [f64; 2]);

fn row() -> impl Strategy<Value = Numbers> {
    ([number(), number(), number(), number()], [positive(), positive()])
}

/// Frames of a run: all say the same things.
fn frames() -> impl Strategy<Value = Vec<Frame>> {
    let things = proptest::collection::vec(any::<bool>(), 6);
    let rows = proptest::collection::vec(row(), 1..6);
    let frames = proptest::collection::vec(rows, 1..4);
    (things, frames, positive()).prop_map(|(has, frames, side)| {
        let frame = |(index, rows): (usize, Vec<Numbers>)| {
            let row = |(k, ([x, y, vx, vy], [radius, mass])): (usize, Numbers)| FrameRow {
                position: DVec2::new(x, y),
                radius,
                velocity: has[0].then_some(DVec2::new(vx, vy)),
                mass: has[1].then_some(mass),
                id: Some(if has[2] { 3 * k as u64 + 1 } else { k as u64 }),
            };
            let mut frame = Frame::default();
            frame.rows = rows.into_iter().enumerate().map(row).collect();
            frame.step = has[3].then_some(10 * index as u64);
            frame.time = has[4].then_some(printed(0.1 * index as f64));
            frame.side = has[5].then_some(side);
            frame
        };
        frames.into_iter().enumerate().map(frame).collect()
    })
}

const TARGETS: [Target; 4] = [Target::Frames, Target::Csv, Target::Xyz, Target::LammpsDump];

fn written(frames: &[Frame], target: Target) -> Vec<u8> {
    let (mut writer, mut text) = (Writer::new(target), Vec::new());
    for frame in frames {
        writer.fits(frame).unwrap();
        writer.add(&mut text, frame).unwrap();
    }
    text
}

fn read(text: &[u8]) -> Vec<Frame> {
    let frames: Result<Vec<Frame>, String> = Frames::of(text).collect();
    frames.unwrap_or_else(|why| panic!("{why}:\n{}", String::from_utf8_lossy(text)))
}

/// What a frame says; discs without a number count from 0.
type Said = (Vec<(FrameRow, u64)>, Option<u64>, Option<f64>, Option<f64>);

fn said(frame: &Frame) -> Said {
    let row =
        |(k, row): (usize, &FrameRow)| (FrameRow { id: None, ..*row }, row.id.unwrap_or(k as u64));
    (frame.rows.iter().enumerate().map(row).collect(), frame.step, frame.time, frame.side)
}

proptest! {
    #![proptest_config(steady())]

    #[test]
    fn frames_come_back_from_every_format_with_the_same_numbers(frames in frames()) {
        for target in TARGETS {
            let back = read(&written(&frames, target));
            prop_assert_eq!(back.len(), frames.len());
            for (index, (back, frame)) in back.iter().zip(&frames).enumerate() {
                let mut expected = said(frame);
                let mut seen = said(back);
                if target == Target::LammpsDump {
                    // A dump has a step and a box always.
                    expected.1 = expected.1.or(Some(index as u64));
                    seen.3 = seen.3.filter(|_| frame.side.is_some());
                }
                prop_assert_eq!(seen, expected, "{:?}", target);
            }
        }
    }
}

fn write(folder: &Path, name: &str, text: &str) {
    fs::write(folder.join(name), text).unwrap();
}

#[test]
fn a_run_goes_through_every_format_and_comes_back_to_the_byte() {
    let folder = tempfile::tempdir().unwrap();
    assert!(outcome(folder.path(), "-n 5 --time 10ms --seed 1 --every 300 -q").status.success());
    let mut name = "trajectory.txt".to_owned();
    for next in ["a.csv", "b.xyz", "c.dump", "d.extxyz", "e.lammpstrj", "f.txt"] {
        let output = outcome(folder.path(), &format!("convert {name} {next}"));
        assert!(output.status.success(), "{next}: {}", text(&output.stderr));
        assert_eq!(text(&output.stdout), format!("wrote {next}: 5 frames\n"));
        assert_eq!(text(&output.stderr), "", "{next}: nothing is missing");
        name = next.to_owned();
    }
    let [first, last] =
        ["trajectory.txt", "f.txt"].map(|name| fs::read(folder.path().join(name)).unwrap());
    assert_eq!(text(&last), text(&first));
    // One table for pandas: a first line of names, and as many words in each row.
    let table = fs::read_to_string(folder.path().join("a.csv")).unwrap();
    assert_eq!(table.lines().next(), Some("frame,step,time_s,side_m,id,x,y,r,vx,vy,m"));
    assert!(table.lines().all(|line| line.split(',').count() == 11));
    assert_eq!(table.lines().count(), 1 + 5 * 5);
}

#[test]
fn one_frame_or_the_first_ones_may_be_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    assert!(outcome(folder.path(), "-n 2 --time 10ms --seed 1 --every 300 -q").status.success());
    for (arguments, steps) in
        [("--frame 2", &[600][..]), ("--until 1", &[0, 300]), ("", &[0, 300, 600, 900, 1125])]
    {
        let output =
            outcome(folder.path(), &format!("convert trajectory.txt part.xyz -q {arguments}"));
        assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty());
        let frames = read(&fs::read(folder.path().join("part.xyz")).unwrap());
        assert_eq!(frames.iter().map(|frame| frame.step.unwrap()).collect::<Vec<_>>(), steps);
    }
}

#[test]
fn what_is_missing_is_said_and_not_invented() {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), "rows.txt", "0.25 0.5 0.02\n0.45 0.5 0.02\n");
    for (name, absent, notes) in [
        (
            "a.csv",
            &["vx", ",m", "time", "side"][..],
            &["no velocities", "no masses", "no times", "no side"][..],
        ),
        (
            "a.xyz",
            &["velo", "mass", "Time", "Lattice"],
            &["no velocities", "no masses", "no times", "no side"],
        ),
        (
            "a.dump",
            &["vx", "mass", "TIME\n"],
            &["TIMESTEP counts", "BOX BOUNDS are those of its discs"],
        ),
        ("a.txt", &["vx", " m", "time", "side"], &["no velocities", "no masses"]),
    ] {
        let output = outcome(folder.path(), &format!("convert rows.txt {name}"));
        let (said, file) =
            (text(&output.stderr), fs::read_to_string(folder.path().join(name)).unwrap());
        for word in absent {
            assert!(!file.contains(word), "{name}: {word} in\n{file}");
        }
        for note in notes {
            assert!(
                said.contains(&format!("note: rows.txt holds {note}")) || said.contains(note),
                "{name}: {said}"
            );
        }
    }
}

#[test]
fn what_cannot_be_converted_is_refused_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let row = "# step 0 n 1 columns x y r\n1 2 3\n";
    write(folder.path(), "rows.txt", "1 2 3\n");
    write(folder.path(), "cut.txt", &format!("{row}\n\n# step 1 n 2 columns x y r\n1 2 3\n"));
    write(folder.path(), "mixed.txt", &format!("{row}\n\n# step 1 n 1 columns x y r m\n1 2 3 4\n"));
    write(folder.path(), "words.txt", "no numbers\n");
    let before = names(folder.path());
    for (arguments, parts) in [
        ("rows.txt rows.txt", &["read and written at once", "another name"][..]),
        ("rows.txt ./rows.txt", &["read and written at once"]),
        ("rows.txt out.pdf", &["the ending of out.pdf", "--to frames"]),
        ("rows.txt out", &["the ending of out"]),
        ("none.txt out.csv", &["cannot read none.txt"]),
        (". out.csv", &["it is a folder"]),
        ("words.txt out.csv", &["`no` is not a number", "--columns or --from"]),
        ("cut.txt out.csv", &["cut off: 1 of 2 discs", "frames 0 to 0 are whole: --until 0"]),
        ("mixed.txt out.csv", &["frame 1 says other things"]),
        ("rows.txt out.csv --frame 3", &["frame 3 was asked for; it holds frames 0 to 0"]),
        ("rows.txt out.csv --columns x,y", &["is a radius"]),
        ("rows.txt none/out.csv", &["none/out.csv"]),
    ] {
        let output = outcome(folder.path(), &format!("convert {arguments}"));
        let said = text(&output.stderr);
        assert_eq!(
            output.status.code(),
            Some(if arguments.contains("none/") { 1 } else { 2 }),
            "{arguments}: {said}"
        );
        for part in parts {
            assert!(said.contains(part), "{arguments}: {part:?} is not in\n{said}");
        }
        assert_eq!(names(folder.path()), before, "{arguments}");
    }
    // The other two go.
    assert!(outcome(folder.path(), "convert mixed.txt out.xyz").status.success());
    assert!(outcome(folder.path(), "convert cut.txt out.csv --until 0").status.success());
}

#[test]
fn what_is_no_whole_trajectory_is_refused_whichever_frame_is_wanted() {
    let folder = tempfile::TempDir::new().unwrap();
    let sorted = "frame,id,x,y,r\n0,0,0.25,0.5,0.02\n1,0,0.25,0.4,0.02\n0,1,0.45,0.5,0.02\n1,1,0.45,0.4,0.02\n";
    fs::write(folder.path().join("sorted.csv"), sorted).unwrap();
    fs::write(folder.path().join("xy.csv"), "x,y\n0.01,0.02\n").unwrap();
    fs::write(folder.path().join("energy.csv"), "step,time_s,kinetic_J\n0,0,1\n").unwrap();
    for (arguments, parts) in [
        ("sorted.csv out.xyz", ["line 4: frame 0 comes after frame 1", "sort the rows by frame"]),
        ("sorted.csv out.xyz --frame 0", ["frame 0 comes after frame 1", "sort the rows by frame"]),
        ("sorted.csv out.xyz --until 0", ["frame 0 comes after frame 1", "sort the rows by frame"]),
        ("xy.csv out.xyz", ["`x y` is a radius", "--radius 1e-3"]),
        ("xy.csv out.xyz --radius 0", ["above 0", "--radius 1mm"]),
        (
            "energy.csv out.xyz",
            ["is an energy ledger, not a file of frames", "plot energy energy.csv"],
        ),
    ] {
        let output = outcome(folder.path(), &format!("convert {arguments}"));
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
        for part in parts {
            assert!(said.contains(part), "{arguments}: {part:?} is not in {said}");
        }
        assert!(!folder.path().join("out.xyz").exists());
    }
    let output = outcome(folder.path(), "convert xy.csv out.xyz --radius 1mm");
    let said = text(&output.stderr);
    assert!(
        output.status.success() && said.contains("holds no radii: each disc has 0.001 m"),
        "{said}"
    );
}
