//! `parsim2d plot` as a person meets it: files written, messages, and the gnuplot scripts beside the
//! pictures, each run in gnuplot.
#![allow(clippy::too_many_lines)] // tables of cases

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::support::gnuplot_is_missing;
use crate::support::plotting::{
    KINDS, RUNS, parsim2d, plot, read, run, simulate, write, write_study,
};

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
        ("frame .", ".", "it is a folder"),
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
    fs::copy(path.join("energy.csv"), path.join("'it's_{2}.csv")).unwrap();
    let cases = [
        (["velocity", data], "my pictures/it's fast.svg"),
        (["energy", "'it's_{2}.csv"], "my pictures/energy.svg"),
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
