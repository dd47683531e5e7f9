//! What comes from outside may be of any size and hold anything: numbers, texts, lists. The program says in a sentence
//! what it does not take, soon, and without a word that a terminal would obey.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use tempfile::TempDir;

fn parsim2d(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_parsim2d"));
    command.current_dir(folder).args(arguments).output().unwrap()
}

/// What the program says of the scenario `text` on standard error, and its exit code.
fn said_of(text: &str, arguments: &[&str]) -> (String, Option<i32>) {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("it.toml"), text).unwrap();
    let output = parsim2d(folder.path(), &[&["it.toml"], arguments].concat());
    (String::from_utf8(output.stderr).unwrap(), output.status.code())
}

/// Flags that take a number.
const NUMBERS: [&str; 19] = [
    "-n",
    "--seed",
    "--side",
    "--radius",
    "--mass",
    "--gravity",
    "--kn",
    "--eta",
    "--gamma",
    "--restitution",
    "--nt",
    "--dt",
    "--time",
    "--speed",
    "--every",
    "--energy-every",
    "--slowdown",
    "--threads",
    "--checkpoint-every",
];

#[test]
fn no_number_is_too_much_for_the_program() {
    let folder = TempDir::new().unwrap();
    for flag in NUMBERS {
        // Beyond the largest Duration; the smallest number there is; 2^63, 2^64.
        for value in
            ["2e19", "1e308", "-1e308", "5e-324", "9223372036854775808", "18446744073709551616"]
        {
            // No step is made, and where time is what is said nothing is run: some numbers would take for ever.
            let arguments = match flag {
                "--time" => vec!["check", flag, value],
                _ => vec![flag, value, "--time", "0", "-q", "--allow-unstable"],
            };
            let output = parsim2d(folder.path(), &arguments);
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(matches!(output.status.code(), Some(0 | 2)), "{arguments:?}: {said}");
            assert!(!said.contains("panicked"), "{arguments:?}: {said}");
        }
    }
}

#[test]
fn intervals_that_no_clock_can_tell_are_refused_with_their_range() {
    for (said, reason) in [
        (
            "checkpoint_every = 2e19",
            "checkpoint_every = 2e19 is not possible: must be from 1e-3 to 1e9",
        ),
        ("checkpoint_every = 1e-308", "checkpoint_every = 1e-308 is not possible"),
        ("slowdown = 1e308", "slowdown = 1e308 is not possible: must be from 1e-9 to 1e9"),
        ("slowdown = -1", "slowdown = -1 is not possible"),
    ] {
        let (message, code) = said_of(said, &["--time", "1ms"]);
        assert!(message.contains(reason) && message.contains("way out: --"), "{said}: {message}");
        assert_eq!(code, Some(2), "{said}");
    }
}

/// What a terminal would obey.
const CODES: &str = "\u{1b}]0;owned\u{7}\u{1b}[31mred\u{9b}2J\r\u{202e}";

#[test]
fn nothing_said_in_a_scenario_is_obeyed_by_a_terminal() {
    let string = serde_json::to_string(CODES).unwrap(); // JSON's escapes are TOML's too
    let scenarios = [
        format!("radius = {string}"),
        format!("n = {string}"),
        format!("dt = {string}"),
        format!("preset = {string}"),
        format!("{string} = 1"),
        format!("start = {string}"),
        format!("out_dir = {}", serde_json::to_string(&format!("/dev/null/{CODES}")).unwrap()),
        format!("[[disc]]\nposition = [{string}, 1]"),
        format!("[[disc]]\n{string} = 1"),
    ];
    for text in scenarios {
        let (message, code) = said_of(&text, &["-q"]);
        assert_eq!(code, Some(2), "{text}: {message}");
        let obeyed: Vec<char> =
            message.chars().filter(|&c| (c.is_control() && c != '\n') || c == '\u{202e}').collect();
        assert!(obeyed.is_empty(), "{text}: {obeyed:?} in {message:?}");
        assert!(message.contains("red"), "{text}: what was said is not shown: {message}");
    }
}

#[cfg(unix)]
#[test]
fn no_name_of_a_file_and_no_word_of_the_command_is_obeyed_by_a_terminal() {
    let folder = TempDir::new().unwrap();
    let name = format!("{CODES}.txt");
    fs::write(folder.path().join(&name), format!("1 2 {CODES}\n")).unwrap();
    for arguments in [
        vec![name.as_str()],
        vec![CODES],
        vec!["--start", &name],
        vec!["--radius", CODES],
        vec!["--preset", CODES],
        vec![&*format!("--{CODES}")],
        vec!["plot", "frame", &name],
        vec!["plot", "energy", &name],
        vec!["report", CODES],
        vec!["resume", &name],
        vec!["grade", "--frames", &name],
        vec!["grade", &name],
        vec!["grade", "--explain", CODES],
        vec!["grade", "--rubric", &name, "--frames", &name],
    ] {
        let output = parsim2d(folder.path(), &arguments);
        for bytes in [output.stderr, output.stdout] {
            let said = String::from_utf8(bytes).unwrap();
            let is_obeyed = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
            assert!(!said.contains(is_obeyed), "{arguments:?}: {said:?}");
        }
    }
}

#[test]
fn long_values_are_shown_by_their_begin_and_end() {
    let long = "a".repeat(3_000_000);
    for text in [
        format!("radius = '{long}'"),
        format!("n = '{long}'"),
        format!("preset = '{long}'"),
        format!("{long} = 1"),
        format!("start = '{long}'"),
        format!("dt = '{long}'"),
    ] {
        let what = &text[..20];
        let begun = Instant::now();
        let (message, code) = said_of(&text, &["-q"]);
        assert_eq!(code, Some(2), "{what}: {message}");
        assert!(message.len() < 2_000, "{what}: {} bytes", message.len());
        // The nearest known word to one of 3 MB was looked for in time squared.
        assert!(begun.elapsed() < Duration::from_secs(20), "{what}: {:?}", begun.elapsed());
    }
}

#[test]
fn a_file_that_is_too_long_for_a_scenario_is_refused_at_once() {
    let folder = TempDir::new().unwrap();
    fs::File::create(folder.path().join("long.toml")).unwrap().set_len(1 << 40).unwrap();
    let output = parsim2d(folder.path(), &["long.toml"]);
    let message = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(
        message.contains("more than 16000000 bytes") && message.contains("--start FILE"),
        "{message}"
    );
}

#[test]
fn crammed_discs_are_refused_in_a_time_that_grows_with_their_number() {
    let cases = [
        ("at one place", 0.0, "discs 0 and 1 have the same centre"),
        ("near one place", 1e-12, "discs 0 and 1 overlap by 2 radii"),
    ];
    for (what, gap, says) in cases {
        let x = |k: usize| 0.02 + k as f64 * gap; // m
        let disc = |k: usize| format!("[[disc]]\nposition = [{:?}, 0.02]\n", x(k));
        let text: String = (0..30_000).map(disc).collect();
        let begun = Instant::now();
        let (message, code) = said_of(&text, &["-q"]);
        assert!(message.contains(says), "{what}: {message}");
        assert_eq!(code, Some(2));
        // 4.5e8 pairs took 40 s, and 3.6 GB.
        assert!(begun.elapsed() < Duration::from_secs(20), "{what}: {:?}", begun.elapsed());
    }
}

/// The program in so much address space, kB.
#[cfg(target_os = "linux")]
fn within(kilobytes: u64, folder: &Path, arguments: &str) -> (String, Option<i32>) {
    let program = env!("CARGO_BIN_EXE_parsim2d");
    let script = format!("ulimit -v {kilobytes}; exec '{program}' {arguments}");
    let output = Command::new("bash").args(["-c", &script]).current_dir(folder).output().unwrap();
    (String::from_utf8_lossy(&output.stderr).into_owned(), output.status.code())
}

#[cfg(target_os = "linux")]
#[test]
fn thousands_of_groups_take_little_memory() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("groups.toml"), "[[population]]\nn = 1\n".repeat(4_000)).unwrap();
    // They took 1.5 GB.
    let (message, code) = within(200_000, folder.path(), "check groups.toml");
    assert_eq!(code, Some(0), "{message}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_run_that_does_not_fit_in_memory_is_refused_with_the_bytes_and_the_way_out_works() {
    let folder = TempDir::new().unwrap();
    let run = "--threads 1 --radius 1e-6 --gravity 0 --time 0 --seed 1 -q --placement lattice -n";
    let (message, code) = within(300_000, folder.path(), &format!("{run} 2000000"));
    assert_eq!(code, Some(2), "{message}");
    assert!(
        message.contains("n = 2000000 is not possible: so many discs need about 532 MB"),
        "{message}"
    );
    assert!(message.contains("ulimit -v"), "{message}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    let offered =
        message.split("way out: -n ").nth(1).and_then(|rest| rest.split(',').next()).unwrap();
    let (message, code) = within(300_000, folder.path(), &format!("{run} {offered}"));
    assert_eq!(code, Some(0), "-n {offered}: {message}");
    // `check` says the same.
    let (message, code) = within(300_000, folder.path(), &format!("check {run} 2000000"));
    assert!(message.contains("532 MB") && code == Some(2), "{message}");
}

#[cfg(target_os = "linux")]
#[test]
fn memory_that_cannot_be_had_is_told_in_a_sentence() {
    let folder = TempDir::new().unwrap();
    // A scenario that takes more memory to be understood than there is.
    fs::write(
        folder.path().join("big.toml"),
        "[[disc]]\nposition = [0.02, 0.02]\n".repeat(300_000),
    )
    .unwrap();
    let (message, code) = within(60_000, folder.path(), "big.toml");
    assert_eq!(code, Some(3), "{message}");
    assert!(message.contains("out of memory") && message.contains("way out"), "{message}");
}

#[cfg(target_os = "linux")]
#[test]
fn what_finds_no_room_on_standard_output_is_an_error() {
    let folder = TempDir::new().unwrap();
    assert!(parsim2d(folder.path(), &["-n", "3", "--time", "1ms", "-q"]).status.success());
    for arguments in [
        "--help",
        "--version",
        "help",
        "run --help",
        "grade --help",
        "presets",
        "doctor",
        "doctor --json",
        "check",
        "check --json",
        "--print-config",
        "--time 1ms",
        "--time 1ms --json",
        "drift -n 2 --time 1ms --nt 10",
        "drift -n 2 --time 1ms --nt 10 --json",
        "drift --twin --time 1ms",
        "plot frame trajectory.txt",
        "report",
        "grade --frames trajectory.txt",
        "grade --frames trajectory.txt --json",
        "grade --init-rubric",
        "grade --explain energy_pump",
    ] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_parsim2d"))
            .args(arguments.split_whitespace())
            .current_dir(folder.path())
            .stdout(full)
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(said.contains("writing to standard output failed"), "{arguments}: {said}");
        // In grading 1 says that somebody is below --fail-under.
        let grades = arguments.starts_with("grade --") && arguments != "grade --help";
        assert_eq!(output.status.code(), Some(if grades { 3 } else { 1 }), "{arguments}");
    }
}
