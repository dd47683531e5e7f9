//! Pictures of what happens over time: histories of single discs, moments of many, runs without walls, and the
//! levels of a drift study.

use std::process::Command;

use parsim2d::figure::paths::Travel;
use parsim2d::output::frames::{Frame, read_frame};
use tempfile::TempDir;

use crate::support::gnuplot_is_missing;
use crate::support::plotting::{plot, read, run, simulate, write, write_study};

/// Points of the lines of a picture, px, without those of its legend.
fn lines(svg: &str) -> Vec<Vec<(f64, f64)>> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let pair = |point: &str| {
        let (x, y) = point.split_once(',').unwrap();
        (x.parse().unwrap(), y.parse().unwrap())
    };
    let lines = document.descendants().filter(|node| node.has_tag_name("polyline"));
    lines.map(|node| node.attribute("points").unwrap().split(' ').map(pair).collect()).collect()
}

fn texts(svg: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let texts = document.descendants().filter(|node| node.has_tag_name("text"));
    texts.filter_map(|node| node.text().map(str::to_owned)).collect()
}

/// Two discs in eleven frames: the first falls from rest at 2 m/s2, the second flies to the right.
fn two_discs() -> TempDir {
    let folder = TempDir::new().unwrap();
    let frame = |k: usize| {
        let t = 0.1 * k as f64;
        format!(
            "# step {k} time_s {t:.1} n 2 side_m 4\n1 {} 0.1 0 {}\n{} 2 0.1 0.5 0\n",
            3.0 - t * t,
            -2.0 * t,
            1.0 + 0.5 * t
        )
    };
    write(&folder, "frames.txt", &(0..=10).map(frame).collect::<Vec<_>>().join("\n\n"));
    folder
}

#[test]
fn a_falling_disc_is_a_parabola_over_time_and_its_velocity_a_line() {
    let folder = two_discs();
    plot(folder.path(), "history frames.txt --disc 0 y vy");
    let svg = read(&folder, "history.svg");
    let [height, velocity] = &lines(&svg)[..] else { panic!("two panels of one curve") };
    assert_eq!((height.len(), velocity.len()), (11, 11));
    // Of the whole way down, (k/10)^2 is done after k frames; two decimals of a pixel are written.
    let part = |line: &[(f64, f64)], k: usize| (line[k].1 - line[0].1) / (line[10].1 - line[0].1);
    for k in 0..=10 {
        let along = k as f64 / 10.0;
        assert!((part(height, k) - along * along).abs() < 2e-3, "{k}");
        assert!((part(velocity, k) - along).abs() < 2e-3, "{k}");
    }
    for text in ["Disc 0, 11 frames", "y, m", "vy, m/s", "time, s"] {
        assert!(texts(&svg).iter().any(|said| said == text), "{text}: {:?}", texts(&svg));
    }
}

#[test]
fn every_named_disc_has_a_curve_and_its_name_at_the_end_of_it() {
    let folder = two_discs();
    for (arguments, discs, panels) in [
        ("", 2, 1), // all of few discs, y
        ("x y vx vy speed", 2, 5),
        ("--disc 1 speed", 1, 1),
        ("--disc 1,0 y", 2, 1),
        ("--disc 1 --disc 0 --until 3 y", 2, 1),
    ] {
        plot(folder.path(), &format!("history frames.txt {arguments}"));
        let svg = read(&folder, "history.svg");
        assert_eq!(lines(&svg).len(), discs * panels, "{arguments}");
        let names = texts(&svg).iter().filter(|text| text.starts_with("disc ")).count();
        assert_eq!(names, discs * panels, "{arguments}");
    }
}

#[test]
fn what_a_history_cannot_show_is_said_with_a_way_out() {
    let folder = two_discs();
    write(&folder, "still.txt", "1 2 0.1\n2 2 0.1\n");
    for (arguments, why, way_out) in [
        ("history frames.txt --disc 2", "disc 2 was asked for", "--disc 1"),
        ("history still.txt vx", "has no velocities", "x and y only"),
        ("history frames.txt z", "'z'", "speed"),
        ("history none.txt", "cannot read none.txt", "way out"),
    ] {
        let output = run(folder.path(), arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
        assert!(said.contains(why) && said.contains(way_out), "{arguments}: {said}");
        assert!(!folder.path().join("history.svg").exists(), "{arguments}");
    }
    // Frames that say no time are counted.
    plot(folder.path(), "history still.txt x");
    assert!(texts(&read(&folder, "history.svg")).contains(&"frame".to_owned()));
}

fn frames(places: &[f64]) -> Vec<Frame> {
    let frame = |y: &f64| read_frame(format!("0 {y} 1e-3\n").as_bytes(), None).unwrap();
    places.iter().map(frame).collect()
}

fn moments(places: &[f64]) -> Vec<usize> {
    let mut travel = Travel::default();
    frames(places).iter().for_each(|frame| travel.add(frame));
    travel.moments()
}

#[test]
fn moments_are_those_at_which_something_happens() {
    // Steady motion: equally far apart. At rest: the same, for nothing tells them apart.
    let steady: Vec<f64> = (0..=200).map(f64::from).collect();
    assert_eq!(moments(&steady), [0, 40, 80, 120, 160, 200]);
    assert_eq!(moments(&[7.0; 201]), [0, 40, 80, 120, 160, 200]);
    // A fall in the first tenth of the run and rest after it: all but the last moment show the fall.
    let fall: Vec<f64> = (0..=200).map(|k| 20.0 - f64::from(k).min(20.0)).collect();
    assert_eq!(moments(&fall), [0, 4, 8, 12, 16, 200]);
    // Up and down again is a way, too; a jump leaves each frame its turn.
    assert_eq!(moments(&[0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0]), [0, 2, 3, 4, 5, 6]);
    assert_eq!(moments(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 9.0]), [0, 3, 4, 5, 6, 7]);
    for few in 1..=6 {
        assert_eq!(moments(&steady[..few]), (0..few).collect::<Vec<_>>());
    }
}

#[test]
fn a_run_without_walls_has_none_drawn() {
    let cases = [("--no-walls", false), ("", true)];
    for (flags, has_walls) in cases {
        let folder = simulate(&format!("-n 3 --time 0.005 --seed 1 -q --speed 0.2 {flags}"));
        for kind in ["frame out.txt", "trajectory trajectory.txt", "velocity trajectory.txt"] {
            plot(folder.path(), &format!("{kind} -o picture.svg"));
            let svg = read(&folder, "picture.svg");
            assert_eq!(svg.contains("class=\"box\""), has_walls, "{kind} {flags}");
            let script = read(&folder, "picture.gp");
            assert_eq!(script.contains("set object 1 rectangle"), has_walls, "{kind} {flags}");
        }
    }
    if gnuplot_is_missing("scripts of a run without walls") {
        return;
    }
    // The record beside the frames says it; of a run with one disc at rest all else in the picture is the same.
    let [open, closed] = cases.map(|(flags, _)| {
        let run = format!("-n 1 --time 0.001 --seed 1 -q --gravity 0 --radius 2e-3 {flags}");
        let folder = simulate(&run);
        ["loop", "replay", "velocity"].map(|script| {
            let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("plot").join(script);
            let file = if script == "loop" { "out.txt" } else { "trajectory.txt" };
            let there = folder.path().join(file);
            let settings = format!("file='{}'; png='{script}.png'", there.display());
            let mut gnuplot = Command::new("gnuplot");
            gnuplot.args(["-d", "-e", &settings]).arg(path.with_extension("plot"));
            let output = gnuplot.current_dir(&folder).output().unwrap();
            assert!(output.status.success(), "{script}: {output:?}");
            std::fs::read(folder.path().join(script).with_extension("png")).unwrap()
        })
    });
    for (open, closed) in open.iter().zip(&closed) {
        assert!(open != closed, "the box is in both or in neither");
    }
}

#[test]
fn one_of_anything_is_no_plural() {
    let folder = simulate("-n 1 --time 0.005 --seed 1 -q");
    for kind in ["trajectory trajectory.txt", "frame out.txt", "history trajectory.txt"] {
        plot(folder.path(), &format!("{kind} -o picture.svg"));
        let svg = read(&folder, "picture.svg");
        assert!(!svg.contains("1 discs") && !svg.contains("1 frames"), "{kind}");
    }
    plot(folder.path(), "trajectory trajectory.txt --until 0");
    assert!(
        read(&folder, "trajectory.svg").contains("Path of 1 disc until t = 0.0000 s, 1 frame<")
    );
    let mut once = Command::new(env!("CARGO_BIN_EXE_parsim2d"));
    let output = once.args("-n 1 --dt 1e-6 --time 1e-6".split(' ')).current_dir(&folder).output();
    let said = String::from_utf8(output.unwrap().stdout).unwrap();
    assert!(said.contains("n        1 disc, ") && said.contains("run      1 step to "), "{said}");
}

#[test]
fn the_levels_of_a_drift_study_are_few_named_lines_without_noise() {
    let folder = TempDir::new().unwrap();
    write_study(folder.path());
    plot(folder.path(), "drift drift.csv");
    let svg = read(&folder, "drift.svg");
    let names = texts(&svg);
    // Beside the single contacts two panels, each of N_t = 10, 20 and 50 and one run of explicit Euler.
    for (name, times) in [
        ("N_t = 10", 2),
        ("N_t = 20", 2),
        ("N_t = 50", 2),
        ("explicit-euler, N_t = 50", 2),
        ("time, s", 2),
        ("time step, s", 1),
    ] {
        assert_eq!(names.iter().filter(|text| *text == name).count(), times, "{name}: {names:?}");
    }
    // Names that would overlap are moved apart: by more than their letters are high.
    let document = roxmltree::Document::parse(&svg).unwrap();
    let mut labels: Vec<(f64, f64)> = document
        .descendants()
        .filter(|node| node.text().is_some_and(|text| text.contains("N_t = ")))
        .filter_map(|node| {
            Some((node.attribute("x")?.parse().ok()?, node.attribute("y")?.parse().ok()?))
        })
        .collect();
    labels.sort_by(|a, b| a.partial_cmp(b).unwrap());
    for two in labels.windows(2) {
        assert!(two[0].0 != two[1].0 || two[1].1 - two[0].1 > 14.0, "{labels:?}");
    }
    let script = read(&folder, "drift.gp");
    for label in ["set xlabel 'time step, s'", "set xlabel 'time, s'", "set xtics ('"] {
        assert!(script.contains(label), "{label}");
    }
}
