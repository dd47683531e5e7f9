//! What the program says to the mistakes that people make: flags, files and scenarios, each with the words
//! that must be in the message, and the way out tried where it is a command.
#![allow(clippy::too_many_lines)] // tables of cases

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use tempfile::TempDir;

fn parsim2d(folder: &Path, words: &[&str]) -> Command {
    let mut command = Command::cargo_bin("parsim2d").unwrap();
    command.current_dir(folder).args(words);
    command
}

/// What is said to `words`, which must be refused.
fn refused(folder: &Path, words: &[&str]) -> String {
    let output = parsim2d(folder, words).output().unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{words:?}: {message}");
    assert!(message.starts_with("error: "), "{words:?}: {message}");
    message
}

/// A folder with one of each file that somebody may name: those of a run that can be resumed, and others.
fn folder_of_files() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let run = ["-n", "5", "--time", "2ms", "--seed", "1", "-q", "--checkpoint-every", "1h"];
    parsim2d(folder.path(), &run).assert().success();
    let rubric = parsim2d(folder.path(), &["grade", "--init-rubric"]).output().unwrap().stdout;
    let write = |name: &str, text: &[u8]| fs::write(folder.path().join(name), text).unwrap();
    write("rubric.toml", &rubric);
    write("summary.json", b"{\"kind\": \"energy-grown\"}\n");
    write("page.html", b"<!DOCTYPE html>\n<html></html>\n");
    write("draw.gp", b"plot 'out.txt'\n");
    write("main.c", b"int main(void) { return 0; }\n");
    write("positions.txt", b"0.01 0.02 1e-4\n0.02 0.02 1e-4\n"); // of another program
    for name in ["runs", "empty", "examples"] {
        fs::create_dir(folder.path().join(name)).unwrap();
    }
    write("runs/last-run.toml", b"n = 5\n");
    write("examples/bounce.toml", b"n = 5\n");
    folder
}

#[test]
fn what_is_no_scenario_is_told_by_what_it_is_and_the_way_out_works() {
    let folder = folder_of_files();
    // The name said, what it is, and the command that is offered for it.
    for (name, kind, way_out) in [
        (".", ". is a folder, not a scenario", "parsim2d resume parsim2d.ckpt"),
        ("runs", "runs is a folder", "parsim2d runs/last-run.toml --out-dir again"),
        ("empty", "empty is a folder", ""),
        ("out.txt", "out.txt is a file of frames", "parsim2d --start out.txt --out-dir next"),
        ("./out.txt", "a file of frames", "parsim2d plot frame out.txt"),
        ("trajectory.txt", "frames", "parsim2d --start trajectory.txt --out-dir next"),
        ("positions.txt", "a file of frames", "parsim2d --start positions.txt --out-dir next"),
        ("energy.csv", "an energy ledger", "parsim2d plot energy energy.csv"),
        ("parsim2d.ckpt", "a checkpoint", "parsim2d resume parsim2d.ckpt"),
        ("rubric.toml", "a rubric", "parsim2d grade --frames out.txt --rubric rubric.toml"),
        ("summary.json", "JSON", "parsim2d --print-config"),
        ("page.html", "a page or picture", ""),
        ("draw.gp", "a gnuplot script", ""),
        ("main.c", "source code", ""),
        ("bonce.toml", "there is no file bonce.toml", "parsim2d examples/bounce.toml"),
        ("bounce.toml", "there is no file bounce.toml", "parsim2d examples/bounce.toml"),
    ] {
        for words in [&[name][..], &["run", name], &["check", name]] {
            let message = refused(folder.path(), words);
            assert!(message.contains(kind), "{words:?}: {message}");
            assert!(message.contains("way out: ") && message.contains(way_out), "{message}");
        }
        if let Some(words) = way_out.strip_prefix("parsim2d ") {
            let words: Vec<&str> = words.split(' ').chain(["--time", "2ms"]).collect();
            let takes_time = !["plot", "grade"].contains(&words[0]);
            let words = if takes_time { &words[..] } else { &words[..words.len() - 2] };
            parsim2d(folder.path(), words).assert().success();
        }
    }
    let mut nothing = parsim2d(folder.path(), &["nothing_like_it.toml"]);
    let message = String::from_utf8(nothing.output().unwrap().stderr).unwrap();
    assert!(message.contains("cannot read the scenario nothing_like_it.toml"), "{message}");
}

#[test]
fn a_diagnosis_for_a_script_names_a_file_that_is_no_scenario_in_its_usual_keys() {
    let folder = folder_of_files();
    let output = parsim2d(folder.path(), &["check", "out.txt", "--json"]).output().unwrap();
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(answer["fault"], "out.txt");
    assert!(answer["ways_out"][0].as_str().unwrap().contains("--start out.txt"), "{answer}");
}

#[test]
fn files_named_to_other_subcommands_are_told_by_what_they_are() {
    let folder = folder_of_files();
    for (words, parts) in [
        ("resume out.txt", ["out.txt is a file of frames, not a checkpoint", "--start out.txt"]),
        ("resume last-run.toml", ["is a scenario, not a checkpoint", "parsim2d last-run.toml"]),
        ("resume nothing", ["cannot read the checkpoint nothing", "resume parsim2d.ckpt"]),
        ("report out.txt", ["out.txt is a file, not the folder of a run", "parsim2d report ."]),
        ("report runs/last-run.toml", ["not the folder of a run", "parsim2d report runs"]),
        ("plot out.txt", ["the kind of picture comes first", "parsim2d plot frame out.txt"]),
        ("plot energy.csv", ["the kind of picture comes first", "plot energy energy.csv"]),
        ("plot frame energy.csv", ["cannot draw energy.csv", "parsim2d plot energy energy.csv"]),
        ("plot energy out.txt", ["cannot draw out.txt", "parsim2d plot frame out.txt"]),
        ("plot frame last-run.toml", ["cannot draw", "a scenario: parsim2d last-run.toml"]),
        ("plot speeds out.txt", ["no velocities", "way out: trajectory.txt, which has them\n"]),
        ("plot velocity out.txt", ["no velocities", "trajectory.txt, which has them; or"]),
        ("--start last-run.toml", ["is a scenario, not a file of frames", "last-run.toml"]),
        ("--start parsim2d.ckpt", ["is a checkpoint, not a file of frames", "parsim2d resume"]),
    ] {
        let message = refused(folder.path(), &words.split(' ').collect::<Vec<_>>());
        for part in parts {
            assert!(message.contains(part), "{words}: {part:?} is not in\n{message}");
        }
    }
}

#[test]
fn mistyped_flags_and_values_are_told_by_what_was_probably_meant() {
    let folder = folder_of_files();
    for (words, says, way_out) in [
        ("-radius 5e-4", "-radius has one dash", "--radius"),
        ("-radius=5e-4", "-radius has one dash", "--radius=5e-4"),
        ("-seed 3", "-seed has one dash", "--seed"),
        ("-nt 50", "-nt has one dash", "--nt"),
        ("-out-dir x", "-out-dir has one dash", "--out-dir"),
        ("check -k_n 5e4", "-k_n has one dash", "--kn"),
        ("plot frame out.txt -frame 0", "-frame has one dash", "--frame"),
        ("plot frame out.txt -out x.svg", "-out has one dash", "--out"),
        ("-radios 4", "there is no flag -radios", "--radius"),
        ("-r 4", "there is no flag -r", "--radius"),
        ("-e 0.5", "there is no flag -e", "--restitution"),
        ("-5", "there is no flag -5", "a value goes behind its flag"),
        ("–radius 5e-4", "begins with a long dash", "--radius"),
        ("—radius", "begins with a long dash", "--radius"),
        ("--radius 4 mm", "`4 mm` are two words", "no space before the unit: 4mm"),
        ("--radius 4 mm examples/bounce.toml", "are two words", "4mm"),
        ("--radius = 4mm", "spaces around `=`", "--radius=5e-4"),
        ("--radius 4kg", "not a number (in m, or with one of: m, cm, mm", "--help"),
        ("--radius 0,5", "write a dot, not a comma", "--help"),
        ("-- --radius 5e-4", "what stands behind `--` is no flag", "leave out the `--`"),
        ("examples/bounce.toml -- -q", "what stands behind `--`", "leave out the `--`"),
        ("a.toml b.toml", "a run takes one scenario", "one command for each"),
        (
            "--integrator velocty-verlet",
            "knows no `velocty-verlet`",
            "--integrator velocity-verlet",
        ),
        ("--preset Guide", "knows no `Guide`", "--preset guide"),
        ("--placement grid", "[possible values: random, lattice]", ""),
        ("plot frame out.txt --frame -1", "cannot be negative", "--frame K: which frame, from 0"),
        ("plot frame out.txt --frame=-1", "a whole number, 0 or more", "--frame K: which frame"),
        ("plot frame out.txt --frame 1.5", "a whole number, 0 or more", "--frame K"),
        ("plot trajectory out.txt --every 0", "a whole number, 1 or more", "--every K"),
        ("plot trajectory out.txt --every -3", "cannot be negative", "--every K"),
        ("grade --frames out.txt -j -2", "-j -2 is not possible", "--jobs N"),
        ("rum", "did you mean `run`?", ""),
        ("chek", "did you mean `check`?", ""),
        ("reprot", "did you mean `report`?", ""),
        ("run run", "a subcommand comes first: parsim2d run", ""),
        ("run check", "a subcommand comes first: parsim2d check", ""),
        ("--no-walls true", "a switch takes it with `=`: --no-walls=true", ""),
        ("plot frme out.txt", "'frame'", ""),
        ("plto frame out.txt", "did you mean `plot`?", "parsim2d plot frame out.txt"),
        ("plto frame out.txt --frame 0", "did you mean `plot`?", "plot frame out.txt --frame 0"),
        ("resum parsim2d.ckpt", "did you mean `resume`?", "parsim2d resume parsim2d.ckpt"),
        ("n 1000", "n is a flag, and flags begin with dashes", "way out: -n 1000\n"),
        ("run n 1000", "n is a flag", "way out: -n 1000\n"),
        ("check examples/bounce.toml n 1000", "n is a flag", "way out: -n 1000\n"),
        ("n=1000", "n is a flag", "way out: -n 1000\n"),
        ("n = 1000", "n is a flag", "way out: -n 1000\n"),
        ("N=5", "N is a flag", "way out: -n 5\n"),
        ("k_n=5e4", "k_n is a flag", "way out: --kn 5e4\n"),
        ("radius=0.5mm", "radius is a flag", "way out: --radius 0.5mm\n"),
        ("out_dir next", "out_dir is a flag", "way out: --out-dir next\n"),
        ("walls=false", "walls is a flag", "way out: --walls=false\n"),
        ("--unit mm", "there is no flag --unit", "without a blank, as in --radius 0.1mm"),
        ("--units=cm -n 5", "there is no flag --units", "as in --radius 0.1cm"),
        ("completions tcsh", "[possible values: bash", "zsh"),
    ] {
        let message = refused(folder.path(), &words.split(' ').collect::<Vec<_>>());
        assert!(message.contains(says), "{words}: {says:?} is not in\n{message}");
        assert!(message.contains(way_out), "{words}: {way_out:?} is not in\n{message}");
        assert!(!message.contains("use '-- "), "{words}: {message}");
        assert!(!message.contains("'--quiet'"), "{words}: {message}");
    }
}

#[test]
fn a_box_too_full_offers_only_what_nothing_else_refuses() {
    let folder = tempfile::tempdir().unwrap();
    // Discs so small sink through each other or move too far in a step; 1e8 of them take 26 GB.
    for (words, offered, not) in [
        ("-n 1e8 --radius 1e-4", "way out: -n 20371\n", "--side"),
        ("-n 1e8 --placement lattice", "way out: -n 45770\n", "--side"),
        ("-n 1e6", "way out: -n 20371\n", "--side"), // a fall through a box of 0.29 m sinks them 3 r
        ("-n 1000 --radius 2e-3", "-n 50, or --radius 4.3e-4, or --side 0.19", "lattice"),
        // Nothing of it is firm: what runs is offered still.
        ("-n 1e6 --kn 5e3", "-n ", "lattice"),
    ] {
        let message = refused(folder.path(), &words.split(' ').collect::<Vec<_>>());
        assert!(message.contains("too full") || message.contains("too small"), "{message}");
        let way_out = message.split("way out").nth(1).unwrap();
        assert!(message.contains(offered) && !way_out.contains(not), "{words}: {message}");
    }
}

#[test]
fn check_says_how_long_a_run_takes_in_a_unit_that_suits_it() {
    let folder = tempfile::tempdir().unwrap();
    // 20 million particle-steps a second are taken for usual; 112500 steps a second of the guide's run.
    for (words, says) in [
        ("check", "particle-steps, under a second\n"),
        ("check --time 100", "particle-steps, roughly 11 seconds\n"),
        ("check --time 10 -n 1000 --nt 100", "particle-steps, roughly 1.9 minutes\n"),
    ] {
        let words: Vec<&str> = words.split(' ').collect();
        let output = parsim2d(folder.path(), &words).output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(text.contains(says), "{words:?}: {text}");
    }
}

#[test]
fn numbers_that_only_look_doubtful_are_taken() {
    let folder = folder_of_files();
    for words in [
        "-n 1e1 --gravity -9.81 --time 1ms",
        "-n5 --time=1ms --radius=0.2mm",
        "--time 1ms -qn 3",
        "plot frame out.txt --frame 0 -o picture.svg",
    ] {
        parsim2d(folder.path(), &words.split(' ').collect::<Vec<_>>()).assert().success();
    }
    let spaced = ["--radius", "0.2 mm", "--time", "1 ms", "-q"];
    parsim2d(folder.path(), &spaced).assert().success();
}

/// Mistakes in TOML, each with what it is told. A message that ends with a line to write ends with one that
/// can be written: see below.
const TOML: [(&str, &str); 56] = [
    ("radius = 0.5mm", "a number with a unit stands in quotes: radius = '0.5mm'"),
    ("radius = 0.5 mm  # half", "stands in quotes: radius = '0.5 mm'"),
    ("speed = 1 m/s", "stands in quotes: speed = '1 m/s'"),
    ("radius = '0.5mm", "the quote does not end: radius = '0.5mm'"),
    ("radius = “0.5mm”", "quotes are straight ones"),
    ("integrator = velocity-verlet", "text stands in quotes: integrator = 'velocity-verlet'"),
    ("dt = auto", "text stands in quotes: dt = 'auto'"),
    (
        "integrator = 'velocty-verlet'",
        "unknown name `velocty-verlet`; did you mean `velocity-verlet`?",
    ),
    ("n = 20\nn = 30", "`n` is said twice, first on line 1: leave one of them"),
    ("[disc]\nposition = [0.01, 0.02]", "write [[disc]] or [[population]], in two brackets"),
    ("[disc]\nradius = 1e-4\n[disc]\nradius = 1e-4", "first on line 1: lists take two brackets"),
    ("[[disc]\nposition = [0.01, 0.02]", "two brackets on each side"),
    ("[[discs]]\nposition = [0.01, 0.02]", "unknown key `discs`; did you mean `disc`?"),
    ("[[disc]]\nradius = 1e-4", "each [[disc]] wants its centre: position = [0.01, 0.02]"),
    ("[[population]]\nradius = 1e-4", "each [[population]] wants its number of discs: n = 100"),
    ("[[disc]]\nposition = [0.01]", "expected [x, y], found one number"),
    ("[[disc]]\nposition = [0,01, 0,02]", "numbers take a dot, not a comma"),
    ("[[disc]]\nposition = [1,5, 2,5]", "numbers take a dot, not a comma"),
    ("[[disc]]\nposition = 0.01, 0.02", "two numbers stand in brackets: position = [0.01, 0.02]"),
    ("[[disc]]\nposition = 0.01", "x and y: position = [0.01, 0.02]"),
    ("[[disc]]\nposition = [0.01, 0.02\nvelocity = [0, 0]", "the list does not end"),
    ("radius = 0,5", "numbers take a dot, not a comma: radius = 0.5"),
    ("kn = 50,000", "nothing between thousands: kn = 50000"),
    ("n = 20.5", "`n` takes a whole number, and this is 20.5"),
    ("n = 1e3", "a whole number has no quotes, dot or exponent: n = 1000"),
    ("n = '20'", "a whole number has no quotes, dot or exponent: n = 20"),
    ("n = 020", "no leading zero, and a digit on each side of its dot: n = 20"),
    ("nt = .5", "a digit on each side of its dot: nt = 0.5"),
    ("kn = 5.e4", "a digit on each side of its dot: kn = 5e4"),
    ("kn = 5*10^4", "a number stands alone and is written out, as 5e-4: 5*10^4 is none"),
    ("n = 5 discs", "a number stands alone"),
    ("walls = yes", "write true or false, in small letters: walls = true"),
    ("walls = False", "write true or false, in small letters: walls = false"),
    ("walls = 1", "`walls` takes true or false: walls = true"),
    ("radius 5e-4", "a line is KEY = VALUE: radius = 5e-4"),
    ("radius: 5e-4", "a line is KEY = VALUE: radius = 5e-4"),
    ("--out-dir x", "a line is KEY = VALUE: out_dir = 'x'"),
    ("--radius = 5e-4", "did you mean `radius`?"),
    ("radius =", "nothing stands behind `radius =`"),
    ("= 5", "line 1, column 1"),
    ("radius = 5e-4; n = 20", "one KEY = VALUE a line"),
    ("radius = 5e-4 n = 20", "one KEY = VALUE a line"),
    ("// a remark", "remarks begin with #"),
    ("; a remark", "remarks begin with #"),
    ("#include <stdio.h>\nint main(){}", "a line is KEY = VALUE, for example: radius = 5e-4"),
    ("time = '1 sec'", "`1 sec` is not a number (in s, or with one of: s, ms"),
    ("r = 5e-4", "unknown key `r`; did you mean `radius`?"),
    ("out-dir = 'x'", "did you mean `out_dir`?"),
    ("[[disc]]\nposition = [1cm, 2cm]", "in quotes, each: position = ['1cm', '2cm']"),
    ("[[disc]]\nposition = [0, 2 cm]  # two", "in quotes, each: position = [0, '2 cm']"),
    ("gravity = [0, -9,81]", "numbers take a dot, not a comma: gravity = [0, -9.81]"),
    ("[[disc]]\nposition = [0.01, 0,02]", "not a comma: position = [0.01, 0.02]"),
    ("[[disc]]\nposition = [1,5, 2,5]", "not a comma: position = [1.5, 2.5]"),
    ("integrator = verlet", "text stands in quotes: integrator = 'velocity-verlet'"),
    ("placement = latice", "text stands in quotes: placement = 'lattice'"),
    ("{\"n\": 5}", "t.toml is JSON, not a scenario"),
];

#[test]
fn mistakes_in_a_scenario_file_are_told_with_the_line_as_it_should_be() {
    let folder = tempfile::tempdir().unwrap();
    for (text, says) in TOML {
        fs::write(folder.path().join("t.toml"), format!("{text}\n")).unwrap();
        let message = refused(folder.path(), &["t.toml"]);
        assert!(message.contains(says), "{text}: {says:?} is not in\n{message}");
        assert!(!message.contains("expected nothing"), "{text}: {message}");
        // The last word of a message is often the line as it should be: then it is TOML.
        let line = message.trim_end().rsplit(": ").next().unwrap();
        if line.contains(" = ") && says.ends_with(line) {
            assert!(line.parse::<toml::Table>().is_ok(), "{text}: {line}");
        }
    }
    fs::write(folder.path().join("t.toml"), [0xff, 0xfe, b'n', 0, b'=', 0, b'5', 0]).unwrap();
    assert!(refused(folder.path(), &["t.toml"]).contains("it is not UTF-8"));
    fs::write(folder.path().join("t.toml"), "\u{feff}n = 5\r\ntime = '1ms'\r\n").unwrap();
    parsim2d(folder.path(), &["t.toml"]).assert().success();
}

#[test]
fn the_verdicts_of_a_diagnosis_have_colours_where_somebody_sees_them() {
    let folder = tempfile::tempdir().unwrap();
    let shown = |arguments: &[&str], variables: &[(&str, &str)]| {
        let mut command = parsim2d(folder.path(), arguments);
        for name in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE"] {
            command.env_remove(name);
        }
        let output = command.envs(variables.iter().copied()).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let good = ["check", "--radius", "5e-4"];
    let unstable = ["check", "--eta", "1.5e3"];
    let forced = ("CLICOLOR_FORCE", "1"); // as if the pipe were a terminal
    let in_green = "\x1b[32mgood\x1b[0m: ";
    assert!(shown(&good, &[forced]).contains(in_green), "{:?}", shown(&good, &[forced]));
    let text = shown(&unstable, &[forced]);
    assert!(
        text.contains("\x1b[31munstable\x1b[0m: ") && text.contains("\x1b[32mgood"),
        "{text:?}"
    );
    assert!(shown(&["check", "--nt", "10"], &[forced]).contains("\x1b[33mcoarse"));
    for arguments in [&good[..], &unstable, &["check", "--eta", "1.5e3", "--json"]] {
        for variables in [&[][..], &[forced, ("NO_COLOR", "1")]] {
            assert!(!shown(arguments, variables).contains('\x1b'), "{arguments:?} {variables:?}");
        }
    }
}
