//! Frames that others wrote: what each column is, and what is said where that is not certain.
#![allow(clippy::too_many_lines)] // tables of cases

use std::fs;

use parsim2d::output::frames::format::Format;
use parsim2d::output::frames::{Frame, Frames, Reading, Told, read_frame, read_frame_as};
use tempfile::TempDir;

use crate::support::runs::{outcome, text};

fn read(text: &str, columns: Option<&str>) -> Result<(Frame, Told), String> {
    let columns = columns.map(|columns| columns.parse().unwrap());
    read_frame_as(text.as_bytes(), &Reading { columns, ..Reading::default() }, None)
}

/// x, y, r, velocity and mass of each disc, 0 for what is not there; and whether they are.
type Disc = ([f64; 6], [bool; 2]);

fn discs(frame: &Frame) -> Vec<Disc> {
    let disc = |row: &parsim2d::output::frames::FrameRow| {
        let (p, v) = (row.position, row.velocity.unwrap_or_default());
        let numbers = [p.x, p.y, row.radius, v.x, v.y, row.mass.unwrap_or(0.0)];
        (numbers, [row.velocity.is_some(), row.mass.is_some()])
    };
    frame.rows.iter().map(disc).collect()
}

/// Two discs of radius 0.02 m at (0.25, 0.5) and (0.45, 0.5) m, with these velocities and mass.
fn pair(velocity: Option<[f64; 2]>, mass: Option<f64>) -> Vec<Disc> {
    let disc = |x, sign: f64| {
        let [vx, vy] = velocity.map_or([0.0; 2], |[vx, vy]| [sign * vx, vy]);
        let numbers = [x, 0.5, 0.02, vx, vy, mass.unwrap_or(0.0)];
        (numbers, [velocity.is_some(), mass.is_some()])
    };
    vec![disc(0.25, 1.0), disc(0.45, -1.0)]
}

const MOVING: Option<[f64; 2]> = Some([0.1, 0.0]);

#[test]
fn each_column_is_what_its_heading_says() {
    let [bare, moving, whole, heavy] =
        [pair(None, None), pair(MOVING, None), pair(MOVING, Some(1e-3)), pair(None, Some(1e-3))];
    for (file, expected) in [
        (
            "# step 0 time_s 0 n 2 side_m 1 columns x y r vx vy m\n0.25 0.5 0.02 0.1 0 1e-3\n0.45 0.5 0.02 -0.1 0 1e-3\n",
            &whole,
        ),
        (
            "# step 0 time_s 0 n 2 side_m 1 columns x y r vx vy\n0.25 0.5 0.02 0.1 0\n0.45 0.5 0.02 -0.1 0\n",
            &moving,
        ),
        ("# r x y m\n0.02 0.25 0.5 1e-3\n0.02 0.45 0.5 1e-3\n", &heavy),
        ("# x [m] y [m] r [m]\n0.25 0.5 0.02\n0.45 0.5 0.02\n", &bare),
        ("% x y r\n0.25 0.5 0.02\n0.45 0.5 0.02\n", &bare),
        ("# Position and radius of each\n0.25 0.5 0.02\n0.45 0.5 0.02\n", &bare),
        ("X Y Diameter\n0.25 0.5 0.04\n0.45 0.5 0.04\n", &bare),
        ("x,y,vx,vy,radius,mass\n0.25,0.5,0.1,0,0.02,1e-3\n0.45,0.5,-0.1,0,0.02,1e-3\n", &whole),
        (
            "\"id\",\"x\",\"y\",\"r\",\"species\"\n7,0.25,0.5,0.02,\"sand\"\n9,0.45,0.5,0.02,\"salt\"\n",
            &bare,
        ),
        ("x;y;z;r\n0,25;0,5;0,01;0,02\n0,45;0,5;0,01;0,02\n", &bare),
        ("x\ty\tr\n0.25\t0.5\t0.02\n0.45\t0.5\t0.02\n", &bare),
        (
            ",frame,time_s,x,y,r\n0,0,0.0,9,9,9\n1,1,0.1,0.25,0.5,0.02\n2,1,0.1,0.45,0.5,0.02\n",
            &bare,
        ),
        // As pandas writes a table with its index, by tabs.
        ("\tx\ty\tr\n0\t0.25\t0.5\t0.02\n1\t0.45\t0.5\t0.02\n", &bare),
        (
            "\"Position.X\" \"Position.Y\" \"Radius\" \"Particle Identifier\"\n0.25 0.5 0.02 1\n0.45 0.5 0.02 2\n",
            &bare,
        ),
        ("2\nx y r\n0.25 0.5 0.02\n0.45 0.5 0.02\n", &bare),
        (
            "2\nProperties=species:S:1:pos:R:3:radius:R:1:velo:R:3:mass:R:1\nX 0.25 0.5 0 0.02 0.1 0 0 1e-3\nX 0.45 0.5 0 0.02 -0.1 0 0 1e-3\n",
            &whole,
        ),
        (
            "2\nProperties=id:I:1:pos:R:2:velo:R:2:radius:R:1\n1 0.25 0.5 0.1 0 0.02\n2 0.45 0.5 -0.1 0 0.02\n",
            &moving,
        ),
        (
            "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n0 1\n0 1\n-1 1\nITEM: ATOMS id type x y radius vx vy mass\n2 1 0.45 0.5 0.02 -0.1 0 1e-3\n1 1 0.25 0.5 0.02 0.1 0 1e-3\n",
            &whole,
        ),
        (
            "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n0 0.5\n0 1\n-1 1\nITEM: ATOMS id xs ys diameter\n1 0.5 0.5 0.04\n2 0.9 0.5 0.04\n",
            &bare,
        ),
    ] {
        let (frame, told) = read(file, None).unwrap_or_else(|why| panic!("{file}: {why}"));
        assert_eq!(discs(&frame), *expected, "{file}");
        assert!(told.names_columns || file.contains("of each"), "{file}");
    }
}

#[test]
fn without_a_heading_only_what_is_certain_is_read_and_nothing_is_guessed_in_silence() {
    let [bare, moving] = [pair(None, None), pair(MOVING, None)];
    for (file, expected, is_said) in [
        // As ever.
        ("0.25 0.5 0.02\n0.45 0.5 0.02\n", &bare, false),
        ("0.25 0.5 0.02 0.1 0\n0.45 0.5 0.02 -0.1 0\n", &moving, false),
        ("0.25,0.5,0.02\n0.45,0.5,0.02\n", &bare, false),
        ("0.25 0.5 0.02\r0.45 0.5 0.02\r", &bare, false),
        ("0.25 0.5 0.02\r0.45 0.5 0.02", &bare, false),
        ("# x y r\r0.25 0.5 0.02\r0.45 0.5 0.02\r\n", &bare, false),
        ("\u{feff}0.25 0.5 0.02\r\n0.45 0.5 0.02\r\n", &bare, false),
        ("2.5D-1 0.5 2d-2\n0.45 0.5 0.02\n", &bare, false),
        // A count that nobody could read as radius.
        ("0.25 0.5 0.02 17\n0.45 0.5 0.02 19\n", &bare, true),
        // z = 0 is no radius, nor is a velocity to the left.
        ("0.25 0.5 0 0.02\n0.45 0.5 0 0.02\n", &bare, true),
        ("0.25 0.5 0.1 0 0.02\n0.45 0.5 -0.1 0 0.02\n", &moving, true),
        ("0,25 0,5 0,02\n0,45 0,5 0,02\n", &bare, true),
        ("0,25;0,5;0,02\n0,45;0,5;0,02\n", &bare, true),
        ("0.25 0.5 0.02 0.1 0 1e9\n0.45 0.5 0.02 -0.1 0 7\n", &moving, true),
    ] {
        let read = read(file, None);
        let Ok((frame, told)) = read else {
            let why = read.unwrap_err();
            panic!("{file}: {why}");
        };
        assert_eq!(discs(&frame), *expected, "{file}");
        assert_eq!(!told.remarks.is_empty(), is_said, "{file}: {:?}", told.remarks);
    }
}

#[test]
fn what_may_be_read_in_two_ways_is_refused_with_both() {
    let file = "0.25 0.5 0.01 0.02\n0.45 0.5 0.01 0.02\n";
    let why = read(file, None).unwrap_err();
    for part in ["`x y r -`", "`x y z r`", "--columns x,y,r,-", "--columns x,y,-,r"] {
        assert!(why.contains(part), "{part:?} is not in {why}");
    }
    // Poeschel and Schwager's columns without their head.
    let book = "0.25 0.5 0.031 0.1 0 0 0.02 1e-3\n0.45 0.5 0.031 -0.1 0 0 0.02 1e-3\n";
    let why = read(book, None).unwrap_err();
    assert!(why.contains("--columns x,y,-,vx,vy,-,r,m"), "{why}");
    let (frame, _) = read(book, Some("x,y,-,vx,vy,-,r,m")).unwrap();
    assert_eq!(discs(&frame), pair(MOVING, Some(1e-3)));
    let (frame, told) = read(file, Some("x,y,-,r")).unwrap();
    assert_eq!((discs(&frame), told.names_columns), (pair(None, None), true));
    let (frame, _) = read(file, Some("x,y,r")).unwrap();
    assert_eq!(frame.rows[0].radius, 0.01);
}

#[test]
fn columns_said_by_hand_are_taken_whatever_the_file_says() {
    for (file, columns) in [
        ("# r y x\n0.25 0.5 0.02\n0.45 0.5 0.02\n", "x,y,r"),
        ("a,b,c,d\n0.02,9,0.5,0.25\n0.02,9,0.5,0.45\n", "r,-,y,x"),
        ("2\n\nA 0.25 0.5 0 0.02\nB 0.45 0.5 0 0.02\n", "-,x,y,-,r"),
        (
            "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS x y q\n0.25 0.5 0.02\n0.45 0.5 0.02\n",
            "x,y,r",
        ),
        ("# step 0 n 2 columns x y m\n0.25 0.5 0.04\n0.45 0.5 0.04\n", "x,y,d"),
    ] {
        let (frame, _) = read(file, Some(columns)).unwrap_or_else(|why| panic!("{file}: {why}"));
        assert_eq!(discs(&frame), pair(None, None), "{file}");
    }
}

#[test]
fn what_cannot_be_read_says_what_is_missing_and_what_to_do() {
    let atoms = "# of LAMMPS\n\n1 atoms\n\nAtoms";
    for (file, parts) in [
        (
            "# x y z vx vy vz\n1 2 0 1 2 0\n",
            &["is a radius", "--columns x,y,z,vx,vy,r if it is column 6"][..],
        ),
        ("x,y,m\n1,2,3\n", &["is a radius", "`x,y,m`"]),
        ("# x[mm] y[mm] r[mm]\n1 2 0.5\n", &["SI units", "x[mm]"]),
        ("x y r vx\n1 2 0.5 1\n", &["vx and vy"]),
        ("# x y r vx vy m\n1 2 3 4 5\n", &[]),
        (
            "# step 0 n 1 columns x y r vx vy m\n1 2 3 4 5\n",
            &["line 2", "fewer columns", "`x y r vx vy m`"],
        ),
        ("x,y,r,vx,vy\n1,2,3,,5\n", &["line 2: column 4, vx, is empty"]),
        ("x,y,r\n1,2,three\n", &["line 2", "`three` is not a number"]),
        ("x,y,r,id\n1,2,3,1.5\n", &["line 2", "an id is a whole number"]),
        ("1.000,5 2 3\n", &["decimals have a point"]),
        ("1\nno more\n", &["cut off: 0 of 1 discs"]),
        (
            "2\n\nAr 0 0 0\nAr 1 1 1\n",
            &["which of its 4 columns is the radius", "--radius 1e-3", "--columns -,x,y,r"],
        ),
        ("2\nProperties=species:S:1:pos:R:3\nA 0 0 0\nA 1 1 1\n", &["is a radius"]),
        ("1\nProperties=pos\n1 2\n", &["name:type:columns"]),
        (
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id x y\n1 0 0\n",
            &["is a radius", "dump custom"],
        ),
        (
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id x y radius\n1 0 0 1\n",
            &["cut off: 1 of 2"],
        ),
        (&format!("{atoms} # atomic\n\n1 1 0 0 0\n"), &["`atomic` have no radius"]),
        (&format!("{atoms}\n\n1 1 0 0 0\n"), &["`atomic` have no radius"]),
        (&format!("{atoms} # sphere\n"), &["cut off: 0 of 1"]),
        (
            "0,25,0,5,0,02\n0,45,0,5,0,02\n",
            &["part columns or stand before decimals", "semicolons"],
        ),
    ] {
        let answer = read(file, None).map(|(frame, _)| discs(&frame));
        // Names that are not those of the row are a remark, and no heading.
        let Err(why) = answer else {
            assert!(parts.is_empty(), "{file}: {answer:?}");
            continue;
        };
        for part in parts {
            assert!(why.contains(part), "{part:?} is not in {why}");
        }
    }
    for start in [&b"\x1f\x8b\x08\x00"[..], b"\xff\xfex\0", b"<?xml version", b"# vtk DataFile 3"] {
        let why = Format::of(start).unwrap_err();
        assert!(why.contains("save") || why.contains("unpack"), "{why}");
    }
}

#[test]
fn a_data_file_of_lammps_gives_balls_of_its_densities_in_order_of_their_ids() {
    let file = "LAMMPS data file\n\n2 atoms\n1 atom types\n\n0 1 xlo xhi\n0 1 ylo yhi\n-0.5 0.5 zlo zhi\n\nAtoms # sphere\n\n\
                8 1 0.04 2500 0.45 0.5 0 0 0 0\n3 1 0.04 1000 0.25 0.5 0 0 0 0\n\nVelocities\n\n3 0.1 0 0 0 0 0\n8 -0.1 0 0 0 0 0\n";
    let (frame, told) = read(file, None).unwrap();
    let mut expected = pair(MOVING, Some(0.0));
    let ball = 4.0 / 3.0 * std::f64::consts::PI * 0.02f64.powi(3);
    for (disc, density) in expected.iter_mut().zip([1000.0, 2500.0]) {
        disc.0[5] = density * 4.0 / 3.0 * std::f64::consts::PI * 0.02f64.powi(3);
        assert!((disc.0[5] - density * ball).abs() < 1e-12 * density * ball); // rounding
    }
    assert_eq!(discs(&frame), expected);
    assert_eq!(frame.side, Some(1.0));
    assert!(told.remarks[0].contains("balls of its densities"), "{:?}", told.remarks);
}

#[test]
fn frames_are_parted_as_each_format_parts_them() {
    let xyz = |x: f64, t: f64| {
        format!(
            "1\nLattice=\"2 0 0 0 2 0 0 0 1\" Properties=pos:R:2:radius:R:1 Time={t}\n{x} 1 0.1\n"
        )
    };
    let dump = |x: f64, t: f64| {
        format!(
            "ITEM: TIME\n{t}\nITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff pp\n0 2\n0 2\n0 0\n\
                 ITEM: ATOMS id x y radius\n1 {x} 1 0.1\n"
        )
    };
    let book = |x: f64, t: f64| {
        format!(
            "#NewFrame\n#no_of_particles: 1\n#type: SphereXYPhiVxVyOmegaRM\n#gravity: 0 -9.81 0\n#Time: {t}\n\
                 #timestep: 1e-5\n#lx: 2\n#ly: 2\n#EndOfHeader\n{x} 1 0 0 0 0 0.1 1 0\n"
        )
    };
    let ours =
        |x: f64, t: f64| format!("# step 3 time_s {t} n 1 side_m 2 columns x y r\n{x} 1 0.1\n");
    let time = |x: f64, t: f64| format!("# t = {t}\n{x} 1 0.1\n");
    let two = |frame: &dyn Fn(f64, f64) -> String| frame(0.5, 0.0) + &frame(0.75, 0.25);
    for (file, has_side) in [
        (two(&xyz), true),
        (two(&dump), true),
        (two(&book), true),
        (two(&ours), true),
        (two(&|x, t| ours(x, t).replace('\n', "\r") + "\r\r"), true),
        (two(&time), false),
        ("frame,time_s,side_m,x,y,r\n0,0,2,0.5,1,0.1\n1,0.25,2,0.75,1,0.1\n".to_owned(), true),
        ("t x y r\n0 0.5 1 0.1\n0.25 0.75 1 0.1\n".to_owned(), false),
    ] {
        let frames: Result<Vec<Frame>, String> = Frames::of(file.as_bytes()).collect();
        let frames = frames.unwrap_or_else(|why| panic!("{file}: {why}"));
        let seen: Vec<_> =
            frames.iter().map(|f| (f.rows.len(), f.rows[0].position.x, f.time, f.side)).collect();
        let side = has_side.then_some(2.0);
        assert_eq!(seen, [(1, 0.5, Some(0.0), side), (1, 0.75, Some(0.25), side)], "{file}");
    }
}

#[test]
fn a_box_that_is_not_ours_is_told_and_not_taken() {
    for (head, part) in [
        ("Lattice=\"1 0 0 0 2 0 0 0 1\"", "not a square"),
        ("Lattice=\"2 0 0 0 2 0 0 0 1\" Origin=\"-1 -1 0\"", "begins at (-1 m, -1 m)"),
    ] {
        let (frame, told) =
            read(&format!("1\n{head} Properties=pos:R:2:radius:R:1\n0.5 1 0.1\n"), None).unwrap();
        assert_eq!(frame.side, None, "{head}");
        assert!(told.remarks[0].contains(part), "{:?}", told.remarks);
    }
}

/// The files that people brought, each with what is right.
#[test]
fn files_of_others_start_a_run_with_the_right_radius() {
    let book = "#gravity: 0 -9.81 0\n#timestep: 1e-5\n#nstep: 1000\n#Time: 0\n#lx: 1\n#ly: 1\n\
                0.25\t0.5\t0.031\t0.1\t0\t0\t0.02\t0.001\t0\t1e5\t1\t0\t0\n\
                0.45\t0.5\t0.031\t-0.1\t0\t0\t0.02\t0.001\t0\t1e5\t1\t0\t0\n";
    let rows = "0 0.2500 0.5000 0.0200\n1 0.4500 0.5000 0.0200\n2 0.6500 0.5000 0.0200\n3 0.8500 0.5000 0.0200\n";
    for (file, note) in [
        (book.to_owned(), "Poeschel and Schwager"),
        (rows.to_owned(), "`id x y r`"),
        (format!("4 1.000000 10\n{rows}"), "`4 1.000000 10`"),
        ("0.25 0.5 0.02 0.1 0\r0.45 0.5 0.02 -0.1 0\r".to_owned(), "holds no masses"),
    ] {
        let folder = TempDir::new().unwrap();
        fs::write(folder.path().join("start.txt"), &file).unwrap();
        let output = outcome(folder.path(), "--start start.txt --side 1 --time 0 --seed 1");
        let said = text(&output.stderr);
        assert!(output.status.success() && said.contains(note), "{said}");
        let written = fs::read(folder.path().join("out.txt")).unwrap();
        let first = read_frame(&written[..], None).unwrap().rows;
        assert_eq!((first[0].position.x, first[1].position.x), (0.25, 0.45), "{file}");
        assert!(first.iter().all(|row| row.radius == 0.02), "{file}");
    }
}

#[test]
fn a_deep_overlap_in_a_file_without_heading_does_not_blame_the_discs() {
    let folder = TempDir::new().unwrap();
    for (heading, part) in [("", "--columns"), ("# x y r\n", "move the discs of the file apart")] {
        fs::write(
            folder.path().join("start.txt"),
            format!("{heading}0.02 0.02 0.01\n0.021 0.02 0.01\n"),
        )
        .unwrap();
        let said = text(&outcome(folder.path(), "--start start.txt --time 0").stderr);
        assert!(said.contains("overlap by") && said.contains(part), "{said}");
        assert!(!said.contains("harder"), "{said}");
    }
}

#[test]
fn rows_of_one_disc_after_another_and_an_id_twice_in_a_frame_are_refused() {
    for (file, parts) in [
        // Sorted by id; as many frames of one disc, else.
        (
            "frame,id,x,y,r\n0,0,0.25,0.5,0.02\n1,0,0.25,0.4,0.02\n0,1,0.45,0.5,0.02\n",
            &["line 4: frame 0 comes after frame 1", "sort the rows by frame"][..],
        ),
        (
            "step,id,x,y,r\n0,0,0.25,0.5,0.02\n9,0,0.25,0.4,0.02\n0,1,0.45,0.5,0.02\n",
            &["line 4: step 0 comes after step 9", "sort the rows by step"],
        ),
        (
            "t,id,x,y,r\n0,0,0.25,0.5,0.02\n0.1,0,0.25,0.4,0.02\n0,1,0.45,0.5,0.02\n",
            &["line 4: time_s 0 comes after time_s 0.1", "sort the rows by time_s"],
        ),
        (
            "id,x,y,r\n7,0.25,0.5,0.02\n8,0.45,0.5,0.02\n7,0.25,0.4,0.02\n",
            &["line 4: id 7 comes twice", "probably these are several frames", "--columns -,x,y,r"],
        ),
        (
            "frame,id,x,y,r\n3,7,0.25,0.5,0.02\n3,7,0.45,0.5,0.02\n",
            &["line 3: id 7 comes twice", "a number of its own"],
        ),
        (
            "2\nProperties=id:I:1:pos:R:2:radius:R:1\n7 0.25 0.5 0.02\n7 0.45 0.5 0.02\n",
            &["line 4: id 7 comes twice"],
        ),
        (
            "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id x y radius\n7 0.25 0.5 0.02\n7 0.45 0.5 0.02\n",
            &["line 7: id 7 comes twice"],
        ),
    ] {
        // The first frame alone says nothing of it.
        for wanted in [None, Some(0)] {
            let why = read_frame(file.as_bytes(), wanted).unwrap_err();
            for part in parts {
                assert!(why.contains(part), "{part:?} is not in {why}");
            }
        }
    }
    // The same ids in the next frame are no others, and a single disc may have many frames.
    let file = "frame,id,x,y,r\n0,7,0.25,0.5,0.02\n1,7,0.25,0.4,0.02\n2,7,0.25,0.3,0.02\n";
    assert_eq!(read_frame(file.as_bytes(), Some(1)).unwrap().rows[0].position.y, 0.4);
    assert_eq!(Frames::of(file.as_bytes()).count(), 3);
}

#[test]
fn a_column_that_is_passed_over_is_said() {
    for (file, part) in [
        ("0.01 0.02 0.001 0.1\n0.01 0.02 0.001 0.1\n", "`x y r -` (column 4 is passed over)"),
        ("0.01 0.02 0.001 0.1\n0.03 0.02 0.001 0.1\n", "`x y r -` (column 4 is passed over)"),
        ("0.25 0.5 0.02 0 0 1e9 8\n0.45 0.5 0.02 0 0 7 8\n", "(columns 6 to 7 are passed over)"),
    ] {
        let (_, told) = read(file, None).unwrap();
        assert!(told.remarks.len() == 1 && told.remarks[0].contains(part), "{:?}", told.remarks);
    }
}

#[test]
fn a_radius_said_by_hand_is_that_of_all_discs_of_a_file_that_says_none() {
    for (file, columns) in [
        ("x,y\n0.25,0.5\n0.45,0.5\n", None),
        ("0.25 0.5\n0.45 0.5\n", None),
        ("# step 0 n 2 columns x y\n0.25 0.5\n0.45 0.5\n", None),
        ("2\n\nX 0.25 0.5 0\nX 0.45 0.5 0\n", None),
        ("2\nProperties=species:S:1:pos:R:3\nX 0.25 0.5 0\nX 0.45 0.5 0\n", None),
        ("0.25 0.5 9\n0.45 0.5 9\n", Some("x,y")),
        (
            "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id x y\n1 0.25 0.5\n2 0.45 0.5\n",
            None,
        ),
    ] {
        let columns = columns.map(|columns| columns.parse().unwrap());
        let said = Reading { columns, radius: Some(0.02), format: None };
        let (frame, _) = read_frame_as(file.as_bytes(), &said, None).unwrap();
        assert_eq!((discs(&frame), frame.has_radii()), (pair(None, None), false), "{file}");
        let without = Reading { radius: None, ..said };
        if without.columns.is_none() {
            let why = read_frame_as(file.as_bytes(), &without, None).unwrap_err();
            assert!(why.contains("--radius 1e-3") && !why.contains("x,y,-,r"), "{why}");
        }
    }
    // What the file says is taken.
    let said = Reading { radius: Some(9.0), ..Reading::default() };
    let (frame, _) =
        read_frame_as(&b"x,y,d\n0.25,0.5,0.04\n0.45,0.5,0.04\n"[..], &said, None).unwrap();
    assert_eq!((discs(&frame), frame.has_radii()), (pair(None, None), true));
}

#[test]
fn of_a_periodic_box_it_is_said_that_a_run_has_walls() {
    let rows = "ITEM: ATOMS id x y radius\n1 0.25 0.5 0.02\n";
    let dump = |kinds: &str| {
        format!(
            "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS {kinds}\n0 1\n0 1\n-1 1\n{rows}"
        )
    };
    let xyz =
        |pbc: &str| format!("1\nProperties=pos:R:2:radius:R:1 pbc=\"{pbc}\"\n0.25 0.5 0.02\n");
    for (file, is_said) in [
        (dump("pp pp pp"), true),
        (dump("ff pp pp"), true),
        (dump("ff ff pp"), false),
        (xyz("T T F"), true),
        (xyz("F F T"), false),
    ] {
        let (_, told) = read(&file, None).unwrap();
        let remarks = told.remarks.concat();
        assert_eq!(
            remarks.contains("periodic") && remarks.contains("--no-walls"),
            is_said,
            "{file}"
        );
    }
}
