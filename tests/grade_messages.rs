//! What the grader says to students and instructors about what is not physics: in words that tell what to do.
#![cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::time::{Duration, SystemTime};

use crate::support::handed_in;
use crate::support::runs;
use crate::support::student;

use handed_in::{can_grade, grade, hand_in, said_of};
use parsim2d::grading::feedback::Graded;
use parsim2d::grading::feedback::text::text_of_student;
use parsim2d::grading::feedback::words::ENGLISH;
use parsim2d::grading::judge::check::Check;
use parsim2d::grading::judge::rubric::Rubric;
use parsim2d::grading::judge::verdict::{Report, Status};
use runs::{names as files, outcome, text};
use student::{Bug, Program};

const MAKEFILE: &str = "parSim2D: simulation.cpp\n\tg++ -o parSim2D simulation.cpp\n";
/// Only what is told here is asked for.
const RUBRIC: &str =
    "[program]\nfiles = ['Makefile']\nwarnings = []\nsanitizer = []\nrun_seconds = 2.0\n";

fn holds(said: &str, parts: &[&str]) {
    for part in parts {
        assert!(said.contains(part), "{part:?} is not in\n{said}");
    }
}

#[test]
fn missing_files_have_their_label_and_an_archive_left_packed_is_named() {
    if !can_grade() {
        return;
    }
    let place = tempfile::tempdir().unwrap();
    let [packed, bare] = ["Ada", "Bob"].map(|name| place.path().join(name));
    hand_in(&packed, &[("Ada.ZIP", "PK"), ("notes.txt", "")]);
    hand_in(&bare, &[("Makefile", "all:\n"), ("particle.h", "")]);
    let files = "Makefile, particle.h, particle.cpp, simulation.cpp";
    let said = said_of(&packed, "");
    holds(&said, &[&format!("| missing: {files}\n"), "| still packed: Ada.ZIP\n"]);
    holds(&said, &["[archive_not_unpacked]"]);
    let said = said_of(&bare, "");
    holds(&said, &["| missing: particle.cpp, simulation.cpp\n"]);
    assert!(!said.contains("still packed") && !said.contains("what was printed"), "{said}");
}

#[test]
fn files_are_found_however_many_single_folders_were_packed_around_them() {
    if !can_grade() {
        return;
    }
    let place = tempfile::tempdir().unwrap();
    let handed_in = place.path().join("Ada");
    let inner = handed_in.join("Assignment 3/parsim final");
    hand_in(&handed_in.join("__MACOSX"), &[("Makefile", "")]);
    hand_in(&handed_in.join("Assignment 3"), &[("report.pdf", "")]);
    hand_in(&inner, &[("Makefile", "all:\n"), ("particle.h", "")]);
    holds(&said_of(&handed_in, ""), &["| missing: particle.cpp, simulation.cpp\n"]);
    // Of two it is not known which is meant.
    hand_in(&handed_in.join("Assignment 3/old"), &[("Makefile", "")]);
    holds(&said_of(&handed_in, ""), &["| missing: Makefile, particle.h, particle.cpp"]);
}

#[test]
fn a_tool_that_the_machine_lacks_is_nobodys_mistake_and_can_be_named() {
    if !can_grade() {
        return;
    }
    let place = tempfile::tempdir().unwrap();
    // Submissions may have a uid of their own, which has to come in.
    fs::set_permissions(place.path(), fs::Permissions::from_mode(0o755)).unwrap();
    let [handed_in, tools] = ["Ada", "tools"].map(|name| place.path().join(name));
    hand_in(&handed_in, &[("parSim2D", "#!/bin/sh\necho 0 0 1 > out.txt\n"), ("Makefile", "")]);
    hand_in(&tools.join("bin"), &[("course-make", "#!/bin/sh\necho made > made.txt\n")]);
    let path = place.path().join("course.toml");
    fs::write(&path, format!("{RUBRIC}build = 'course-make'\n")).unwrap();
    let [handed_in, path, tools] =
        [&handed_in, &path, &tools].map(|path| path.to_str().unwrap().to_owned());
    let without = grade(&[&handed_in, "--rubric", &path]);
    assert_eq!(without.status.code(), Some(3));
    let said = String::from_utf8_lossy(&without.stderr);
    holds(&said, &["`course-make`", "/usr/bin", "nothing was graded", "--tools FOLDER"]);
    assert!(without.stdout.is_empty());
    let with = grade(&[&handed_in, "--rubric", &path, "--tools", &tools]);
    holds(&String::from_utf8_lossy(&with.stdout), &[":) builds"]);
    let nowhere = grade(&[&handed_in, "--rubric", &path, "--tools", "nowhere"]);
    assert_eq!(nowhere.status.code(), Some(2));
}

#[test]
fn an_old_program_that_was_handed_in_is_told_from_one_that_was_built() {
    if !can_grade() {
        return;
    }
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("Ada");
    let files = [
        ("Makefile", MAKEFILE),
        ("simulation.cpp", "int main() { return 4; }\n"),
        ("parSim2D", "#!/bin/sh\nexit 3\n"),
    ];
    hand_in(&folder, &files);
    let age = |name: &str, seconds: u64| {
        let file = fs::File::options().append(true).open(folder.join(name)).unwrap();
        file.set_modified(SystemTime::now() - Duration::from_secs(seconds)).unwrap();
    };
    for (source, program, is_old) in [(200, 100, true), (100, 200, false)] {
        age("simulation.cpp", source);
        age("parSim2D", program);
        let said = said_of(&folder, RUBRIC);
        holds(&said, &[&format!("exit code: {}\n", if is_old { 3 } else { 4 })]);
        assert_eq!(said.contains("[program_not_rebuilt]"), is_old, "{said}");
        assert_eq!(said.contains("the program that ran was handed in as it is"), is_old, "{said}");
    }
}

#[test]
fn a_program_that_waits_for_somebody_to_type_is_told_so() {
    if !can_grade() {
        return;
    }
    let waits = "#include <cstdio>\nint main() { int n; while (scanf(\"%d\", &n) != 1); }\n";
    let ends = "#include <cstdio>\nint main() { int n; return scanf(\"%d\", &n) == 1 ? 0 : 1; }\n";
    let asks_twice = "#include <iostream>\nint main() { int n, m; std::cin >> n >> m; return std::cin ? 0 : 1; }\n";
    let deaf = "int main() { for (;;); }\n";
    let given = format!("{RUBRIC}stdin = \"{{n}}\\n\"\n");
    let place = tempfile::tempdir().unwrap();
    let cases = [
        (waits, RUBRIC, "waits_for_input"),
        (ends, RUBRIC, "waits_for_input"),
        (ends, &given, "ends_without_frames"),
        (asks_twice, &given, "waits_for_input"),
        (deaf, RUBRIC, "too_slow"),
    ];
    for (k, (program, rubric, cause)) in cases.into_iter().enumerate() {
        let folder = place.path().join(k.to_string());
        hand_in(&folder, &[("Makefile", MAKEFILE), ("simulation.cpp", program)]);
        let said = said_of(&folder, rubric);
        holds(&said, &[&format!("[{cause}]")]);
    }
}

#[test]
fn many_is_not_asked_where_the_program_is_not_told_how_many_and_that_is_said() {
    let said = |text: &str| {
        let mut report = Report::of_submission(&Rubric::parse(text).unwrap());
        report.decide(Check::Many, || Status::NotSeen);
        text_of_student(&Graded::new("Ada", "Ada", report), &ENGLISH)
    };
    holds(&said(""), &["many: ", "the program is not told how many discs ({n} is neither in"]);
    for told in ["arguments = ['{n}']", "stdin = '{n}'", "many = 0"] {
        let said = said(&format!("[program]\n{told}"));
        assert!(!said.contains("is not told how many"), "{told}: {said}");
    }
}

/// A folder with a class of frames, right ones and some with radii of 1 mm.
fn desk() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let right = Program::new(Bug::None, 1).output();
    for name in ["Ada", "Bob", "Eve"] {
        fs::create_dir_all(folder.path().join("class").join(name)).unwrap();
        fs::write(folder.path().join("class").join(name).join("out.txt"), &right).unwrap();
        fs::write(folder.path().join("class").join(format!("{name}.txt")), &right).unwrap();
    }
    folder
}

#[test]
fn what_is_refused_says_how_to_write_it_and_is_refused_before_anything_is_graded() {
    let folder = desk();
    fs::write(folder.path().join("one.toml"), "mass = 1e-3\nradius = 1e-4\n").unwrap();
    fs::write(folder.path().join("big.toml"), "radius = [1e-3, 2e-3]\n").unwrap();
    fs::write(folder.path().join("words.toml"), "[program]\narguments = \"{n} {seed}\"\n").unwrap();
    let told = "n = [20, 1000]\n[program]\nn = 10\narguments = ['{n}']\n";
    fs::write(folder.path().join("told.toml"), told).unwrap();
    let cases = [
        ("--rubric words.toml", 2, "way out: a list, arguments = [\"{n}\", \"{seed}\"]\n"),
        (
            "--rubric told.toml",
            2,
            "program.n = 10 is what programs are told, and n = [20, 1000] is",
        ),
        ("--rubric one.toml", 2, "way out: a list, radius = [1e-4]\n"),
        ("--out nowhere/results.json", 2, "--out nowhere/results.json: there is no such folder"),
        ("--out class", 2, "--out class: there is no such folder, or it is one itself"),
        // What was printed, and all that would have been right.
        (
            "--rubric big.toml",
            0,
            "printed, m: 5e-4\n    asked for, m: 1e-3\n    asked for, m: 2e-3\n",
        ),
    ];
    for (arguments, code, said) in cases {
        let output = outcome(folder.path(), &format!("grade --frames class/Ada.txt {arguments}"));
        let all = text(&output.stdout) + &text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments}: {all}");
        holds(&all, &[said]);
        assert_eq!(output.stdout.is_empty(), code == 2, "{arguments}: {all}");
    }
    let left = ["big.toml", "class", "one.toml", "told.toml", "words.toml"];
    assert_eq!(files(folder.path()), left);
}

#[test]
fn causes_are_explained_as_checks_are_and_a_slip_is_met_with_what_was_meant() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("course.toml"),
        "[hints]\nexplicit_euler = \"See Eq. (3).\"\n[partial]\nexplicit_euler = 0.5\n",
    )
    .unwrap();
    let cases = [
        ("explicit_euler", 0, "explicit_euler: looks like a position that is updated with the old"),
        ("explicit_euler", 0, "hint: in Eq. (3), which velocity"),
        ("explicit_euler", 0, "part of the points that it leaves: 0 %\n"),
        ("explicit_euler --rubric course.toml", 0, "hint: See Eq. (3).\n"),
        ("explicit_euler --rubric course.toml", 0, "leaves: 50 %\n"),
        ("box", 0, "box: nobody leaves the box (1 point)\n"),
        ("energy", 0, "(2 points)\n"),
        ("explicit_oiler", 2, "did you mean `explicit_euler`?"),
        ("enrgy", 2, "did you mean `energy`?"),
        ("zzz", 2, "there is no check and no cause `zzz`\n  checks: files, "),
    ];
    for (arguments, code, said) in cases {
        let output = outcome(folder.path(), &format!("grade --explain {arguments}"));
        let all = text(&output.stdout) + &text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments}: {all}");
        holds(&all, &[said]);
    }
}

#[test]
fn a_part_of_a_class_does_not_take_the_others_out_of_its_tables_unless_told_to() {
    let folder = desk();
    let grade = |arguments: &str| {
        let output = outcome(folder.path(), &format!("grade --out-dir done {arguments}"));
        (output.status.code(), text(&output.stderr))
    };
    let rows = || fs::read_to_string(folder.path().join("done/class.csv")).unwrap().lines().count();
    assert_eq!(grade("--frames class/Ada.txt class/Bob.txt").0, Some(0));
    let names = files(&folder.path().join("done"));
    assert!(names.contains(&"Ada.txt.html".to_owned()), "no folder before the name: {names:?}");
    let (code, said) = grade("--frames class/Bob.txt");
    assert_eq!((code, rows()), (Some(2), 3), "{said}");
    holds(&said, &["not now: class/Ada.txt", "way out", "--replace-class"]);
    // All of them from elsewhere and one more.
    let all = "--frames ./class/Eve.txt ./class/Bob.txt ./class/Ada.txt";
    assert_eq!((grade(all).0, rows()), (Some(0), 4));
    assert_eq!((grade("--frames class/Bob.txt --replace-class").0, rows()), (Some(0), 2));
    // Files that all have the same name have those of their folders.
    let same = "--frames class/Ada/out.txt class/Bob/out.txt --replace-class";
    assert_eq!((grade(same).0, rows()), (Some(0), 3));
    assert!(files(&folder.path().join("done")).contains(&"Ada_out.txt.html".to_owned()));
}

/// A program that does this and nothing else.
fn program(body: &str) -> String {
    format!(
        "#include <cstdio>\n#include <cstdlib>\n#include <unistd.h>\nint main(int argc, char **argv) {{ (void)argc; (void)argv; {body} }}\n"
    )
}

#[test]
#[allow(clippy::too_many_lines)] // a table of cases
fn what_a_program_did_instead_of_writing_frames_is_told_by_name() {
    if !can_grade() {
        return;
    }
    let rows =
        "for (int i = 0; i < 20; i++) fprintf(f, \"%.4f 0.02 5e-4\\n\", 0.001 + 0.0015 * i);";
    let frames = |n: &str, blank: &str, end: &str| {
        format!(
            "FILE *f = fopen(\"out.txt\", \"w\"); for (int k = 0; k < 30; k++) {{ double y = 0.03 - 4e-6 * k * k; \
             for (int i = 0; i < {n}; i++) fprintf(f, \"%.6f %.6f 5e-4\\n\", 0.001 + 0.0018 * (i % 21), y + 0.0012 * (i / 21)); \
             fprintf(f, \"{blank}\"); }} fclose(f); {end}"
        )
    };
    let told = format!("{RUBRIC}arguments = ['{{n}}']\nmany = 30\n");
    let counted = format!("n = [20]\n{RUBRIC}");
    let full = "static char block[1 << 20]; FILE *f = fopen(\"big.dat\", \"w\"); for (;;) fwrite(block, 1, sizeof block, f);";
    let cases = [
        (
            format!("FILE *f = stdout; {rows} {rows}"),
            RUBRIC,
            "frames: out.txt",
            "[printed_on_the_screen]",
        ),
        (
            format!("FILE *f = stdout; {rows} {rows} fflush(f); for (;;) sleep(1);"),
            RUBRIC,
            "frames: out.txt",
            "[printed_on_the_screen]",
        ),
        (
            format!("FILE *f = fopen(\"out.txt\", \"w\"); {rows}"),
            RUBRIC,
            "frames: 1\n",
            "[only_the_last_frame]",
        ),
        (frames("20", "\\n", ""), &told, ":( many", "[number_of_discs_ignored]"),
        (frames("atoi(argv[1])", "\\n", ""), &told, ":) many: a box of many discs", ""),
        (frames("(atoi(argv[1]) > 25 ? 25 : 20)", "\\n", ""), &told, ":( many", "[disc_lost]"),
        // It writes enough and then hangs: frames are counted without blank lines, too.
        (frames("20", "", "for (;;) sleep(1);"), &counted, ":) runs", ":) frames"),
        (frames("20", "t = 0.1\\n", "for (;;) sleep(1);"), RUBRIC, ":) runs", ":) frames"),
        (full.to_owned(), RUBRIC, ":( runs", "    | big.dat\n"),
    ];
    let place = tempfile::tempdir().unwrap();
    for (k, (body, rubric, where_, cause)) in cases.into_iter().enumerate() {
        let folder = place.path().join(k.to_string());
        hand_in(&folder, &[("Makefile", MAKEFILE), ("simulation.cpp", &program(&body))]);
        let said = said_of(&folder, rubric);
        holds(&said, &[where_, cause]);
        assert!(!said.contains("written, bytes: 0\n"), "{said}");
        assert!(!said.contains("[disc_lost]") || cause == "[disc_lost]", "{said}");
    }
}

#[test]
fn a_rubric_by_which_nothing_can_be_earned_or_that_says_two_things_is_refused() {
    let all = Check::ALL.map(|check| format!("{} = 0\n", check.id())).concat();
    let probe = "[interface]\nprobe = 'p.cpp'\nbuild = ['make']\nrun = ['./p']\n";
    for (text, said) in [
        (format!("[points]\n{all}"), "points are 0 for every check"),
        ("[points]\ninterface = 2".to_owned(), "points.interface = 2, and there is no [interface]"),
        ("eta = 0.5\nrestitution = 0.8".to_owned(), "way out: leave out eta, or restitution"),
        ("eta = 0.5\nrestitution_wall = 0.8\nrestitution_pair = 0.8".to_owned(), "leave out eta"),
        ("side = \"4cm\"".to_owned(), "way out: a number in m, without quotes: side = 0.04\n"),
        ("kn = '5e4'".to_owned(), "way out: a number in N/m, without quotes: kn = 5e4\n"),
        (
            "[program]\nmany_frames = \"9\"".to_owned(),
            "way out: a number, without quotes: many_frames = 12\n",
        ),
        (probe.to_owned(), "[interface] has no [[interface.case]]"),
    ] {
        let why = Rubric::parse(&text).unwrap_err();
        assert!(why.contains(said), "{text}: {why}");
    }
    let alone = "[points]\n".to_owned() + &all.replace("energy = 0", "energy = 1");
    let usual = parsim2d::grading::judge::rubric::COMMENTED;
    let elastic = usual.replace("# restitution = 1.0", "restitution = 1.0");
    for text in [usual, &elastic, &alone, "eta = 0.5\nrestitution_wall = 0.8", "restitution = 0.8"]
    {
        assert!(Rubric::parse(text).is_ok(), "{text}: {:?}", Rubric::parse(text));
    }
}

#[test]
fn what_a_mac_adds_to_a_zip_is_no_submission() {
    if !can_grade() {
        return;
    }
    let class = tempfile::tempdir().unwrap();
    let [ada, mac] = ["Ada", "__MACOSX"].map(|name| class.path().join(name));
    hand_in(&ada, &[("Makefile", "all:\n")]);
    hand_in(&mac, &[("._Makefile", "")]);
    let arguments = [ada.to_str().unwrap(), mac.to_str().unwrap(), "--format", "json"];
    let graded = handed_in::grade(&arguments);
    let said = text(&graded.stderr);
    holds(&said, &["__MACOSX is left out"]);
    let all: serde_json::Value = serde_json::from_slice(&graded.stdout).unwrap();
    assert_eq!(all.as_array().map(Vec::len), Some(1), "{all}");
}
