//! A run that starts from a frame has what the discs of the frame have, and says what it takes for the rest.

use std::fs;
use std::path::Path;

use parsim2d::analysis::collision::damping_ratio_for;
use parsim2d::figure::forces::{discs, links, walls};
use parsim2d::output::frames::read_frame;
use parsim2d::scenario::Scenario;
use serde_json::Value;
use tempfile::TempDir;

use crate::support::runs::{outcome, text};

/// Two kinds of discs, of masses 8 g and 1 g.
const KINDS: &str = "radius = 5e-4\nrestitution = 0.8\nseed = 3\ntime = 0.05\n\
                     [[population]]\nn = 10\nradius = 1e-3\nmass = 8e-3\n\
                     [[population]]\nn = 20\nradius = 5e-4\nmass = 1e-3\n";

fn two_kinds() -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("kinds.toml"), KINDS).unwrap();
    let output = outcome(folder.path(), "kinds.toml -q");
    assert!(output.status.success(), "{}", text(&output.stderr));
    folder
}

/// The summary of a run, and what it said.
fn run(folder: &Path, arguments: &str) -> (Value, String) {
    let output = outcome(folder, &format!("{arguments} --json"));
    let said = text(&output.stderr);
    assert!(output.status.success(), "{arguments}: {said}");
    (serde_json::from_slice(&output.stdout).unwrap(), said)
}

/// The energy (J) in the first or last line of a ledger, but for what was dissipated.
fn mechanical_energy(folder: &Path, line: fn(&str) -> Option<&str>) -> f64 {
    let ledger = fs::read_to_string(folder.join("energy.csv")).unwrap();
    let numbers = line(&ledger).unwrap().split(',').map(|word| word.parse::<f64>().unwrap());
    numbers.skip(2).take(3).sum()
}

#[test]
fn a_second_run_begins_with_the_energy_with_which_the_first_ended() {
    let folder = two_kinds();
    let end = mechanical_energy(folder.path(), |ledger| ledger.lines().last());
    run(folder.path(), "--start trajectory.txt --restitution 0.8 --time 1ms --out-dir next");
    let start = mechanical_energy(&folder.path().join("next"), |ledger| ledger.lines().nth(1));
    // A frame has nine digits; the elastic energy of overlaps loses two or three of them.
    assert!((start / end - 1.0).abs() < 1e-7, "{start} J, not {end} J");
    assert!((end - 1.486_613e-2).abs() < 1e-8, "{end} J"); // as its ledger said before frames had masses
}

#[test]
fn a_repeated_frame_is_the_frame() {
    let folder = two_kinds();
    let (_, said) = run(folder.path(), "--start trajectory.txt --time 0 --out-dir next");
    assert!(!said.contains("holds no"), "{said}");
    let last = |path: &str| {
        let text = fs::read(folder.path().join(path)).unwrap();
        read_frame(&text[..], None).unwrap().rows
    };
    assert_eq!(last("trajectory.txt"), last("next/trajectory.txt"));
    assert_eq!(last("trajectory.txt")[0].mass, Some(8e-3));
}

#[test]
fn one_note_says_what_a_frame_does_not_hold_and_what_is_taken() {
    let folder = two_kinds();
    let rows = "0.01 0.02 1e-3 0.1 0\n0.03 0.02 1e-3 0 0\n";
    fs::write(folder.path().join("moving.txt"), rows).unwrap();
    fs::write(folder.path().join("heavy.txt"), "# x y r m\n0.01 0.02 1e-3 0.5\n").unwrap();
    for (arguments, note) in [
        (
            "--start out.txt",
            "note: out.txt holds no velocities and no masses: all discs start at rest, with 1e-3 kg (--mass); \
             trajectory.txt of the same run has both\n",
        ),
        (
            "--start out.txt --mass 2g --speed 0.1",
            "note: out.txt holds no velocities and no masses: all discs are thrown with an rms speed of 0.1 m/s \
             (--speed), with 2e-3 kg (--mass); trajectory.txt of the same run has both\n",
        ),
        (
            "--start moving.txt",
            "note: moving.txt holds no masses: each disc has 1e-3 kg (--mass)\n",
        ),
        ("--start heavy.txt", "note: heavy.txt holds no velocities: all discs start at rest\n"),
        (
            "--start trajectory.txt --mass 2g",
            "note: trajectory.txt has the mass of each disc: mass = 2e-3 kg is not used\n",
        ),
    ] {
        let arguments = format!("{arguments} --time 0 --seed 1 --out-dir next");
        let (_, said) = run(folder.path(), &arguments);
        assert!(said.contains(note), "{arguments}: {said}");
        assert_eq!(
            said.matches("holds no").count() + said.matches("is not used").count(),
            1,
            "{said}"
        );
        assert!(!text(&outcome(folder.path(), &format!("{arguments} -q")).stderr).contains("note"));
    }
    let heavy = fs::read(folder.path().join("next/trajectory.txt")).unwrap();
    assert_eq!(read_frame(&heavy[..], None).unwrap().rows[0].mass, Some(8e-3));
}

#[test]
fn a_printed_scenario_of_a_start_gives_the_same_run() {
    let folder = two_kinds();
    let columns = "# nothing is named here\n0.01 0.02 0 1e-3\n0.03 0.02 0 1e-3\n";
    fs::write(folder.path().join("xyzr.txt"), columns).unwrap();
    for (k, start) in [
        "--start trajectory.txt:7",
        "--start out.txt --mass 2g",
        "--start xyzr.txt --columns x,y,-,r",
    ]
    .into_iter()
    .enumerate()
    {
        let arguments = format!("{start} --time 2ms --seed 4");
        let (first, _) = run(folder.path(), &format!("{arguments} --out-dir first{k}"));
        let printed = outcome(folder.path(), &format!("{arguments} --print-config"));
        fs::write(folder.path().join("printed.toml"), printed.stdout).unwrap();
        let (second, _) = run(folder.path(), &format!("printed.toml --out-dir second{k}"));
        // The record lists the discs, each with its mass.
        let (third, _) = run(folder.path(), &format!("first{k}/last-run.toml --out-dir third{k}"));
        for other in [second, third] {
            assert_eq!(other["state_hash"], first["state_hash"], "{start}");
        }
    }
}

#[test]
fn a_run_from_a_frame_is_resumed_with_its_masses() {
    let folder = two_kinds();
    let whole = "--start trajectory.txt --time 4ms --seed 4";
    let (reference, _) = run(folder.path(), &format!("{whole} --out-dir whole"));
    run(
        folder.path(),
        "--start trajectory.txt --time 2ms --seed 4 --checkpoint-every 10s --out-dir parts",
    );
    fs::remove_file(folder.path().join("trajectory.txt")).unwrap();
    let (resumed, _) = run(folder.path(), "resume parts --time 4ms");
    assert_eq!(resumed["state_hash"], reference["state_hash"]);
}

/// Two discs of 1 kg, a hair before they touch at 1 m/s, and a hair after.
const MEETING: &str = "gravity = 0\nradius = 0.05\nside = 1\nkn = 1e4\nrestitution = 0.5\ndt = 1e-6\nevery = 1\n\
                       time = 1e-4\n[[disc]]\nposition = [0.44999999, 0.5]\nvelocity = [1.0, 0.0]\nmass = 1.0\n\
                       [[disc]]\nposition = [0.54999999, 0.5]\nmass = 1.0\n";

#[test]
fn drawn_forces_are_those_of_each_discs_own_mass() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("meeting.toml"), MEETING).unwrap();
    assert!(outcome(folder.path(), "meeting.toml -q").status.success());
    let trajectory = fs::read(folder.path().join("trajectory.txt")).unwrap();
    let frame = read_frame(&trajectory[..], Some(1)).unwrap();
    let law = Scenario::from_toml(MEETING).unwrap().law();
    let drawn = links(&discs(&frame, 1e-3), &law, &walls(&frame));
    // k delta + eta v, after one step at 1 m/s: delta = 1e-6 m, eta = 2 zeta sqrt(k m_eff).
    let end = parsim2d::analysis::collision::ContactEnd::OverlapZero;
    let eta = 2.0 * damping_ratio_for(0.5, end) * (1e4f64 * 0.5).sqrt();
    let [one, other] = [frame.rows[0], frame.rows[1]];
    let speed = one.velocity.unwrap().x - other.velocity.unwrap().x;
    let overlap = 0.1 - one.position.distance(other.position);
    let closed_form = 1e4 * overlap + eta * speed;
    assert_eq!(drawn.len(), 1);
    assert!((drawn[0].push - closed_form).abs() < 1e-9, "{} N, not {closed_form} N", drawn[0].push); // rounding
    // And by hand, to the digits of a frame: 1e-9 of 0.45 m is 4.5e-6 N.
    assert!((drawn[0].push - 30.478).abs() < 1e-3, "{} N", drawn[0].push);
    let plot = |more: &str| {
        text(
            &outcome(folder.path(), &format!("plot forces trajectory.txt --frame 1 {more}")).stderr,
        )
    };
    let largest = || {
        let picture = fs::read_to_string(folder.path().join("forces.svg")).unwrap();
        let (_, after) = picture.split_once("the largest force ").unwrap();
        after.split('<').next().unwrap().to_owned()
    };
    assert_eq!((plot(""), largest()), (String::new(), "30.5 N".to_owned()));
    assert!(plot("--mass 1g").contains("--mass is not used") && largest() == "30.5 N");
    // Without masses in the file it says which it took.
    let bare = text(&trajectory).replace(" vx vy m\n", " vx vy\n").replace(" 1\n", "\n");
    fs::write(folder.path().join("trajectory.txt"), bare).unwrap();
    assert_eq!(
        plot(""),
        "note: the frame has no masses; each disc is taken to have 1e-3 kg (--mass)\n"
    );
    assert_eq!(largest(), "0.973 N");
    plot("--mass 1kg");
    assert_eq!(largest(), "30.5 N");
}

#[test]
fn a_picture_of_a_file_that_gnuplot_does_not_read_has_a_script_that_says_so() {
    let folder = two_kinds();
    assert!(outcome(folder.path(), "convert trajectory.txt run.xyz").status.success());
    for kind in ["frame", "velocity", "trajectory"] {
        let pictures = ["trajectory.txt", "run.xyz"].map(|file| {
            let output = outcome(folder.path(), &format!("plot {kind} {file}"));
            assert!(output.status.success(), "{}", text(&output.stderr));
            let is_told = text(&output.stderr).contains("parsim2d convert run.xyz frames.txt");
            let script = fs::read_to_string(folder.path().join(format!("{kind}.gp"))).unwrap();
            assert_eq!(
                [
                    is_told,
                    script.contains("exit status 1\n")
                        && script.starts_with("# gnuplot does not read")
                ],
                [file == "run.xyz"; 2]
            );
            fs::read_to_string(folder.path().join(format!("{kind}.svg"))).unwrap()
        });
        assert!(pictures[0] == pictures[1], "{kind}");
    }
}

#[test]
fn columns_may_be_said_in_a_scenario_and_not_without_a_file() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("xyzr.txt"), "0.01 0.02 0.005 1e-3\n0.03 0.02 0.005 1e-3\n")
        .unwrap();
    fs::write(
        folder.path().join("start.toml"),
        "start = 'xyzr.txt'\ncolumns = 'x,y,-,r'\ntime = 0\n",
    )
    .unwrap();
    run(folder.path(), "start.toml --out-dir next");
    let frame = fs::read(folder.path().join("next/out.txt")).unwrap();
    assert!(read_frame(&frame[..], None).unwrap().rows.iter().all(|row| row.radius == 1e-3));
    for (arguments, part) in [
        ("--start xyzr.txt", "--columns x,y,r,-, or --columns x,y,-,r"),
        ("--start xyzr.txt --columns x,y", "is a radius"),
        ("--start xyzr.txt --columns x,y,foo,r", "`foo` is none of x, y, z, r"),
        ("--start xyzr.txt --columns x,y,r,vx,vy", "fewer columns than the 5"),
        ("--columns x,y,-,r", "it says how the file of --start is read"),
    ] {
        let output = outcome(folder.path(), arguments);
        let said = text(&output.stderr);
        assert!(output.status.code() == Some(2) && said.contains(part), "{arguments}: {said}");
    }
}

#[test]
fn a_start_without_radii_takes_that_of_the_flag_and_says_so() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("h6.csv"), "x,y\n0.01,0.02\n0.03,0.02\n").unwrap();
    fs::write(folder.path().join("xyr.csv"), "x,y,r\n0.01,0.02,1e-3\n").unwrap();
    let start = "--start h6.csv --radius 1mm --time 1ms --seed 1";
    let (first, said) = run(folder.path(), &format!("{start} --out-dir first"));
    assert!(
        said.contains("note: h6.csv holds no radii: each disc has 1e-3 m (--radius)\n"),
        "{said}"
    );
    let printed = outcome(folder.path(), &format!("{start} --print-config"));
    fs::write(folder.path().join("printed.toml"), printed.stdout).unwrap();
    let (second, _) = run(folder.path(), "printed.toml --out-dir second");
    let (third, _) = run(folder.path(), "first/last-run.toml --out-dir third");
    assert_eq!([&second["state_hash"], &third["state_hash"]], [&first["state_hash"]; 2]);
    for (arguments, part) in [
        ("--start h6.csv", "way out: --radius 1e-3 is that of all discs"),
        ("--start h6.csv --radius=-1", "--radius 1mm"),
        ("--start xyr.csv --radius 1e-3", "both say the radii"),
    ] {
        let output = outcome(folder.path(), arguments);
        let said = text(&output.stderr);
        assert!(output.status.code() == Some(2) && said.contains(part), "{arguments}: {said}");
    }
}

#[test]
#[allow(clippy::too_many_lines)] // a table of cases
fn what_is_offered_for_a_frame_that_cannot_start_works_when_typed() {
    let folder = TempDir::new().unwrap();
    for (file, more, parts, offer) in [
        (
            "# step 0 n 2 side_m 0.5 columns x y r\n0.25 0.4 0.001\n0.45 0.4 0.001\n",
            "--side 4cm",
            &["outside the box", "--side 0.5, as the frame itself says"][..],
            Some("--side 0.5"),
        ),
        (
            "# x y r\n10 20 0.5\n30 39 0.5\n",
            "",
            &["lengths are read in m, and these may be in mm", "--side 40 holds"],
            Some("--side 40"),
        ),
        (
            "# x y r\n0.01 0.02 0.001\n0.05 0.02 0.001\n",
            "",
            &["--side 0.051 holds the discs as they are"],
            Some("--side 0.051"),
        ),
        (
            "# x y r\n-0.01 0.02 0.001\n0.01 0.02 0.001\n",
            "",
            &["shift the positions", "--no-walls"],
            Some("--no-walls"),
        ),
        (
            "# x y r\n0.01 0.02 0.001\n0.01 0.02 0.001\n",
            "",
            &["have the same centre", "one row too many"],
            None,
        ),
        (
            "0.01 0.02 0.001 0.1\n0.01 0.02 0.001 0.1\n",
            "",
            &["have the same centre", "read as `x y r -` (column 4 is passed over)", "--columns"],
            None,
        ),
        (
            "# x y r\n0.01 0.02 0.001\n0.03 0.02 0.001\n\n\n0.01 0.02 0.001\n0.0101 0.02 0.001\n",
            "",
            &["overlap by 1.9 radii", "the first frame of the file, --start bad.txt:0"],
            Some("--start bad.txt:0"),
        ),
    ] {
        fs::write(folder.path().join("bad.txt"), file).unwrap();
        let arguments = |more: &str| format!("--start bad.txt {more} --time 0 --seed 1");
        let output = outcome(folder.path(), &arguments(more));
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{file}: {said}");
        for part in parts {
            assert!(said.contains(part), "{part:?} is not in {said}");
        }
        assert!(!said.contains("harder"), "{said}");
        if let Some(offer) = offer {
            let start = if offer.starts_with("--start") { "" } else { "--start bad.txt " };
            run(folder.path(), &format!("{start}{offer} --time 0 --seed 1 --out-dir next"));
        }
    }
}
