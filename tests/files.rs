//! The files of a run, byte for byte, and read back.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use parsim2d::output::energy::HEADER;
use parsim2d::output::frames::read_frame;
use tempfile::TempDir;

/// Runs the program with `arguments` in a fresh folder.
fn run(arguments: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let words = arguments.split_whitespace();
    Command::cargo_bin("parsim2d")
        .unwrap()
        .current_dir(&folder)
        .args(words)
        .arg("-q")
        .assert()
        .success();
    folder
}

fn read(folder: &TempDir, name: &str) -> String {
    fs::read_to_string(folder.path().join(name)).unwrap()
}

/// One disc thrown upward from the middle: 3 steps of 1 ms, so that all digits can be told.
const THROW: &str = "--start start.txt --gravity 10 --dt 1ms --time 3ms --no-walls --eta 0 --kn 1 \
                     --seed 1 --every 2 --energy-every 1";

fn throw(more: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("start.txt"), "0.02 0.02 1e-4 0.5 1\n").unwrap();
    let words = THROW.split_whitespace().chain(more.split_whitespace());
    let mut command = Command::cargo_bin("parsim2d").unwrap();
    command.current_dir(&folder).args(words).arg("-q").assert().success();
    folder
}

#[test]
fn out_txt_is_the_last_frame_byte_for_byte() {
    // Eq. (3): v = 1 - 0.01 k; y = 0.02 + 1e-3 (0.99 + 0.98 + 0.97).
    let expected = "# step 3 time_s 0.003 n 1 side_m 0.04 columns x y r\n0.0215 0.02294 0.0001\n";
    assert_eq!(read(&throw(""), "out.txt"), expected);
}

#[test]
fn trajectory_txt_has_first_and_last_frame_and_gaps_before_all_but_the_first() {
    let expected = "\
# step 0 time_s 0 n 1 side_m 0.04 columns x y r vx vy m
0.02 0.02 0.0001 0.5 1 0.001


# step 2 time_s 0.002 n 1 side_m 0.04 columns x y r vx vy m
0.021 0.02197 0.0001 0.5 0.98 0.001


# step 3 time_s 0.003 n 1 side_m 0.04 columns x y r vx vy m
0.0215 0.02294 0.0001 0.5 0.97 0.001
";
    assert_eq!(read(&throw(""), "trajectory.txt"), expected);
}

#[test]
fn energy_csv_has_its_header_and_a_line_for_each_asked_step() {
    let text = read(&throw(""), "energy.csv");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], HEADER);
    assert_eq!(
        HEADER,
        "step,time_s,kinetic_J,gravitational_J,elastic_J,dissipated_J,total_J,work_error_J,supplied_J"
    );
    // K = m/2 (0.25 + 1), m g y = 1e-3 * 10 * 0.02.
    assert_eq!(lines[1], "0,0.0,0.000625,0.0002,0.0,0.0,0.000825,0.0,0.0");
    assert_eq!(lines.len(), 5);
    let times: Vec<&str> = lines[1..].iter().map(|l| l.split(',').nth(1).unwrap()).collect();
    assert_eq!(times, ["0.0", "0.001", "0.002", "0.003"]);
}

#[test]
fn energy_every_0_writes_no_ledger_and_every_1_a_line_a_step() {
    let folder = run("-n 3 --time 1ms --seed 1 --energy-every 0");
    assert!(!folder.path().join("energy.csv").exists());
    let folder = run("-n 3 --time 1ms --seed 1 --energy-every 1");
    assert_eq!(read(&folder, "energy.csv").lines().count(), 1 + 1 + 113); // 113 steps of 8.9 us
}

#[test]
fn default_outputs_have_about_200_frames_and_2000_lines() {
    let folder = run("-n 3 --time 0.1 --seed 1");
    let frames = read(&folder, "trajectory.txt").matches('#').count();
    assert!((190..=202).contains(&frames), "{frames}");
    let lines = read(&folder, "energy.csv").lines().count();
    assert!((1800..=2003).contains(&lines), "{lines}");
}

#[test]
fn the_border_follows_the_real_discs_and_touches_the_box_from_outside() {
    let folder = throw("--border");
    let text = read(&folder, "out.txt");
    let rows: Vec<Vec<f64>> = text
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| line.split(' ').map(|word| word.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), 1 + 4 * 200); // 0.04 m over discs of 2e-4 m
    assert_eq!(rows[0], [0.0215, 0.02294, 0.0001]);
    for row in &rows[1..] {
        let outside = [-row[0], -row[1], row[0] - 0.04, row[1] - 0.04];
        let distance = outside.into_iter().fold(f64::MIN, f64::max);
        assert!((distance - row[2]).abs() < 1e-12, "{row:?}"); // nine printed digits
    }
    // A reader that honours the header's n sees the one real disc.
    assert_eq!(read_frame(text.as_bytes(), None).unwrap().rows.len(), 1);
}

#[test]
fn the_same_seed_gives_the_same_bytes_in_every_file() {
    for arguments in [
        "-n 50 --radius 5e-4 --time 0.05 --seed 42",
        "-n 10 --speed 0.3 --time 0.02 --seed 42 --integrator velocity-verlet --border",
        "-n 10 --placement lattice --time 0.02 --seed 42 --restitution 0.5 --every 7",
    ] {
        let (one, two) = (run(arguments), run(arguments));
        for name in ["out.txt", "trajectory.txt", "energy.csv"] {
            assert_eq!(read(&one, name), read(&two, name), "{arguments}: {name}");
        }
    }
}

#[test]
fn outputs_change_no_bit_of_the_run() {
    let hash = |more: &str| {
        let folder = tempfile::tempdir().unwrap();
        let arguments = format!("-n 100 --radius 5e-4 --time 0.03 --seed 5 --json -q {more}");
        let output = Command::cargo_bin("parsim2d")
            .unwrap()
            .current_dir(&folder)
            .args(arguments.split_whitespace())
            .output()
            .unwrap();
        let summary: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        summary["state_hash"].as_str().unwrap().to_owned()
    };
    let plain = hash("");
    for more in ["--energy-every 0", "--every 1 --energy-every 3", "--border", "--slowdown 2"] {
        assert_eq!(hash(more), plain, "{more}");
    }
}

#[test]
fn a_run_started_from_a_frame_goes_on_from_it() {
    let first = run("-n 20 --radius 5e-4 --time 0.05 --seed 3 --every 1000");
    let file = first.path().join("trajectory.txt");
    let frames = read(&first, "trajectory.txt").matches('#').count();
    for (said, frame) in [("".to_owned(), frames - 1), (":0".to_owned(), 0), (":2".to_owned(), 2)] {
        let second = run(&format!("--start {}{said} --time 0 --seed 9", file.display()));
        let wanted = read_frame(read(&first, "trajectory.txt").as_bytes(), Some(frame)).unwrap();
        let got = read_frame(read(&second, "trajectory.txt").as_bytes(), None).unwrap();
        assert_eq!(wanted.rows, got.rows, "{said}");
    }
}

#[test]
fn frames_written_by_others_are_read() {
    let variants = [
        "0.01 0.02 1e-4\n0.03 0.02 1e-4\n",
        "# my own header\r\n0.01 0.02 1e-4\r\n0.03\t0.02   0.0001 \r\n\r\n",
        "# a box with n 1 big disc\n0.01 0.02 1e-4\n0.03 0.02 1e-4\n",
        "\u{feff}0.01 0.02 1e-4\n0.03 0.02 1e-4\n",
        "0 0 1\n\n0.01 0.02 1e-4\n0.03 0.02 1e-4",
        "0 0 1\n\n\n\n\n0.01 0.02 1e-4 17\n0.03 0.02 1e-4 0.5\n\n\n",
    ];
    for text in variants {
        let frame =
            read_frame(text.as_bytes(), None).unwrap_or_else(|why| panic!("{text:?}: {why}"));
        let rows = frame.rows;
        assert_eq!(rows.len(), 2, "{text:?}");
        assert_eq!((rows[1].position.x, rows[1].radius), (0.03, 1e-4));
        assert!(rows[0].velocity.is_none());
    }
}

#[test]
fn frames_that_cannot_be_read_say_where_and_why() {
    for (text, frame, expected) in [
        ("", None, "it holds no frame"),
        ("# only a header\n", None, "it holds no frame"),
        (
            "1 2\n",
            None,
            "line 1: 2 columns; a disc is `x y r` or `x y r vx vy`\n  way out: --radius 1e-3 is that of all discs, \
             with --start and convert",
        ),
        ("1 2 3\n1 two 3\n", None, "line 2: `two` is not a number"),
        ("1 2 nan\n", None, "line 1: `nan` is not finite"),
        ("1 2 3\n1 2 3 4 5\n", None, "line 2: fewer or more columns than the line before"),
        ("# step 0 n 2 side_m 1\n1 2 3\n", None, "the frame is cut off: 1 of 2 discs"),
        ("# step 0 n 2 side_m 1\n1 2 3\n1 2 3", None, "line 3: the line is cut off"),
        (
            "# step 0 n 2\n1 2 3\n\n\n# step 1 n 1\n1 2 3\n",
            Some(0),
            "the frame is cut off: 1 of 2 discs",
        ),
        ("1 2 3\n\n\n# step 5 time_s", None, "its last frame is cut off; frames 0 to 0 are whole"),
        ("1 2 3\n\n\n1 2 3\n", Some(2), "frame 2 was asked for; it holds frames 0 to 1"),
    ] {
        assert_eq!(read_frame(text.as_bytes(), frame).unwrap_err(), expected, "{text:?}");
    }
}

#[test]
fn pandas_numpy_and_gnuplot_conventions_hold() {
    // Numbers use a dot and no thousands separator; every row of a file has the same columns.
    let folder = run("-n 30 --radius 5e-4 --time 0.05 --seed 3");
    for (name, columns, separator) in
        [("out.txt", 3, ' '), ("trajectory.txt", 6, ' '), ("energy.csv", 9, ',')]
    {
        let text = read(&folder, name);
        let rows = text.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
        for row in rows.filter(|row| !row.starts_with("step")) {
            let words: Vec<&str> = row.split(separator).collect();
            assert_eq!(words.len(), columns, "{name}: {row}");
            assert!(words.iter().all(|word| word.parse::<f64>().is_ok()), "{name}: {row}");
        }
    }
    assert!(!read(&folder, "trajectory.txt").ends_with("\n\n"), "a phantom frame for gnuplot");
}

#[test]
fn a_failed_creation_leaves_the_old_files_as_they_were() {
    for blocked in ["out.txt", "trajectory.txt", "energy.csv"] {
        let folder = tempfile::tempdir().unwrap();
        let names = ["out.txt", "trajectory.txt", "energy.csv"];
        for name in names.into_iter().filter(|&name| name != blocked) {
            fs::write(folder.path().join(name), "precious").unwrap();
        }
        fs::create_dir(folder.path().join(blocked)).unwrap();
        let assert = Command::cargo_bin("parsim2d").unwrap().current_dir(&folder).assert();
        let output = assert.code(2).get_output().clone();
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(message.contains(blocked) && message.contains("way out"), "{message}");
        for name in names.into_iter().filter(|&name| name != blocked) {
            assert_eq!(read(&folder, name), "precious", "{blocked} blocked");
        }
        assert_no_temporaries(folder.path());
    }
}

fn assert_no_temporaries(folder: &Path) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        assert!(path.extension().is_none_or(|extension| extension != "tmp"), "{}", path.display());
    }
}

#[test]
fn what_a_run_killed_at_its_start_left_goes_with_the_next_run() {
    let folder = tempfile::tempdir().unwrap();
    let left = ["out.txt.12345.tmp", "energy.csv.7.tmp", "parsim2d.ckpt.31.tmp"];
    let own = ["out.txt.tmp", "notes.12.tmp", "out.txt.old.tmp"];
    for name in left.iter().chain(&own) {
        fs::write(folder.path().join(name), "some bytes").unwrap();
    }
    let mut command = Command::cargo_bin("parsim2d").unwrap();
    command.current_dir(&folder).args(["--time", "1ms", "-q"]).assert().success();
    for name in left {
        assert!(!folder.path().join(name).exists(), "{name}");
    }
    for name in own {
        assert_eq!(read(&folder, name), "some bytes");
    }
}

#[test]
fn a_trajectory_cut_anywhere_is_told_from_a_whole_one() {
    let folder = run("-n 5 --time 1ms --seed 3");
    let whole = read(&folder, "trajectory.txt");
    for cut in 1..200 {
        let text = &whole[..whole.len() - cut];
        if let Ok(frame) = read_frame(text.as_bytes(), None) {
            // Cut between frames: the frame before is whole.
            assert_eq!(frame.rows.len(), 5, "{cut} bytes cut");
            assert!(
                text.trim_end().ends_with(|c: char| c.is_ascii_digit()) && text.ends_with('\n')
            );
        }
    }
}

#[test]
fn a_start_takes_the_side_of_its_file() {
    let first = run("-n 5 --side 0.1 --radius 1e-3 --time 0 --seed 4");
    let file = first.path().join("trajectory.txt");
    let second = run(&format!("--start {} --time 0", file.display()));
    assert_eq!(read(&first, "trajectory.txt"), read(&second, "trajectory.txt"));
}

#[test]
fn a_run_without_ledger_leaves_no_ledger_of_a_former_run() {
    let folder = run("-n 2 --time 1ms --seed 1");
    assert!(folder.path().join("energy.csv").exists());
    let again = ["-n", "2", "--time", "1ms", "--energy-every", "0", "-q"];
    Command::cargo_bin("parsim2d").unwrap().current_dir(&folder).args(again).assert().success();
    assert!(!folder.path().join("energy.csv").exists());
}
