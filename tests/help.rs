//! Help, manual pages and completions: complete, accepted by the programs they are for, and every example of
//! every `--help` typed into a shell.
#![cfg(unix)] // a shell, and the programs that read what is written for them

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use tempfile::TempDir;

/// What a shell does with `line`, with parsim2d on its path, in `folder`.
fn shell(folder: &Path, line: &str) -> Output {
    let program = Path::new(env!("CARGO_BIN_EXE_parsim2d")).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap());
    let mut shell = Command::new("timeout");
    shell.args(["60", "sh", "-c", line]).current_dir(folder);
    shell.env("PATH", path).env("HOME", folder).env("PROFILE", "profile.ps1");
    shell.output().unwrap()
}

fn printed(folder: &Path, line: &str) -> String {
    let Output { status, stdout, stderr } = shell(folder, line);
    assert!(status.success(), "{line}: {}", String::from_utf8_lossy(&stderr));
    String::from_utf8(stdout).unwrap()
}

/// All subcommands, as typed: "", "run", "plot", "plot frame", ...
fn subcommands() -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let mut all = vec![String::new()];
    let mut next = 0;
    while let Some(above) = all.get(next).cloned() {
        let help = printed(folder.path(), &format!("parsim2d {above} -h"));
        let listed = help.split("Commands:\n").nth(1).unwrap_or_default();
        let names = listed.lines().take_while(|line| line.starts_with("  "));
        let names = names.filter_map(|line| line.split_whitespace().next());
        let below = names.filter(|name| *name != "help");
        all.extend(below.map(|name| format!("{above} {name}").trim().to_owned()));
        next += 1;
    }
    assert!(all.len() >= 19, "{all:?}");
    all
}

/// A folder in which every example of the help can be typed: a run that can be resumed, the files and folders
/// that the examples name.
fn folder_of_examples() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    for name in [
        "examples",
        ".zfunc",
        ".local/share/bash-completion/completions",
        ".config/fish/completions",
    ] {
        fs::create_dir_all(path.join(name)).unwrap();
    }
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    for name in ["settling.toml", "bounce.toml"] {
        fs::copy(examples.join(name), path.join("examples").join(name)).unwrap();
    }
    let run = "-n 5 --speed 0.3 --time 4ms --every 50 --seed 1 -q --checkpoint-every 1h";
    printed(path, &format!("parsim2d {run} && parsim2d {run} --out-dir a"));
    printed(path, "cp out.txt a.txt; cp out.txt b.txt; cp parsim2d.ckpt parsim2d.previous.ckpt");
    printed(path, "parsim2d grade --init-rubric > course.toml");
    printed(path, "parsim2d convert -q trajectory.txt dump.lammpstrj");
    fs::write(path.join("old.dat"), "0.25 0.5 0.01 0.02\n0.45 0.5 0.01 0.02\n").unwrap();
    folder
}

/// The commands among the lines of a help: those that begin with the program's name, up to their remark.
fn examples(help: &str) -> impl Iterator<Item = &str> {
    help.lines().filter_map(|line| {
        let line = line.strip_prefix("  ")?;
        let command = line.split("  ").next()?;
        (command == "parsim2d" || command.starts_with("parsim2d ")).then_some(command)
    })
}

#[test]
fn every_example_of_every_help_does_what_it_shows() {
    let template = folder_of_examples();
    let mut seen = BTreeSet::new();
    for subcommand in subcommands() {
        let help = printed(template.path(), &format!("parsim2d {subcommand} --help"));
        for example in examples(&help) {
            // Programs of students are built and run by tests of their own.
            if example.contains("submissions/*") || !seen.insert(example.to_owned()) {
                continue;
            }
            let first = example.split(' ').nth(1).unwrap_or_default();
            let runs = first.starts_with('-') || first.starts_with("examples/");
            let runs = runs || ["", "run", "check", "drift"].contains(&first);
            // The run as shown, cut short.
            let short = if runs && !example.contains("--time") { " --time 2ms" } else { "" };
            let line = example.replace("--time 0.5s", "--time 2ms") + short;
            let folder = tempfile::tempdir().unwrap();
            printed(template.path(), &format!("cp -r . '{}'", folder.path().display()));
            let output = shell(folder.path(), &line);
            let code = output.status.code().unwrap();
            // One shows a refusal, one a limit that a short run may miss.
            let may_be = match example {
                _ if example.contains("--eta 1.5e3") => code == 2,
                _ if example.contains("--fail-under") => code <= 1,
                _ => code == 0,
            };
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(may_be, "{example}: {code}: {said}");
        }
    }
    assert!(seen.len() >= 40, "{seen:?}");
}

#[test]
fn every_flag_of_every_subcommand_is_explained() {
    let folder = tempfile::tempdir().unwrap();
    let mut seen = 0;
    for subcommand in subcommands() {
        let help = printed(folder.path(), &format!("parsim2d {subcommand} -h"));
        let lines: Vec<&str> = help.lines().collect();
        for (k, line) in lines.iter().enumerate().filter(|(_, line)| line.trim().starts_with('-')) {
            // Behind it, or below it where it is long.
            let beside = line.trim().split_once("  ").is_some_and(|(_, words)| !words.is_empty());
            let below = lines.get(k + 1).is_some_and(|line| line.starts_with("          "));
            assert!(beside || below, "{subcommand}: {line}");
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}

fn is_there(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok()
}

#[test]
fn completions_are_accepted_by_their_shells_and_complete() {
    let folder = tempfile::tempdir().unwrap();
    for (shell, check) in [
        ("bash", Some("bash -n script")),
        ("zsh", Some("zsh -n script")),
        ("fish", Some("fish --no-execute script")),
        ("powershell", None),
        ("elvish", Some("elvish -compileonly script")),
    ] {
        let script = printed(folder.path(), &format!("parsim2d completions {shell} | tee script"));
        for word in ["plot", "trajectory", "restitution", "from-nowhere"] {
            assert_eq!(script.contains(word), word != "from-nowhere", "{shell}: {word}");
        }
        if let Some(check) = check.filter(|_| is_there(shell)) {
            printed(folder.path(), check);
        }
    }
    if is_there("bash") {
        printed(folder.path(), "parsim2d completions bash > script");
        // As bash asks: the command, the word to complete, and the word before it.
        let complete = |words: &str| {
            let all: Vec<&str> = words.split(' ').collect();
            let (last, before) = (all[all.len() - 1], all[all.len() - 2]);
            let ask = format!(
                "source ./script; COMP_WORDS=({words}); COMP_CWORD={}; _parsim2d parsim2d {last} {before}",
                all.len() - 1
            );
            printed(folder.path(), &format!("bash -c '{ask}; echo ${{COMPREPLY[@]}}'"))
        };
        for (words, completed) in [
            ("parsim2d plot traj", "trajectory\n"),
            ("parsim2d --resti", "--restitution\n"),
            ("parsim2d --integrator vel", "velocity-verlet\n"),
            ("parsim2d -q tr", "\n"), // a switch takes no word
        ] {
            assert_eq!(complete(words), completed, "{words}");
        }
    }
}

#[test]
fn manual_pages_are_read_without_a_warning_and_keep_the_lines_of_examples() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let said = printed(path, "parsim2d man --out-dir man1 && parsim2d man > all.1");
    let names = subcommands();
    assert_eq!(said, format!("wrote {} pages to man1\n", names.len()));
    for name in &names {
        let page = format!("man1/parsim2d {name}").trim().replace(' ', "-") + ".1";
        let text = fs::read_to_string(path.join(&page)).unwrap();
        assert!(text.contains(".SH NAME") && text.contains(".SH SYNOPSIS"), "{page}");
    }
    let all = fs::read_to_string(path.join("all.1")).unwrap();
    assert_eq!(all.matches("\n.TH ").count() + usize::from(all.starts_with(".TH ")), names.len());
    for (program, command) in [
        ("groff", "groff -man -Tutf8 -ww $page 2>&1 > /dev/null"),
        ("mandoc", "mandoc -T lint -W error $page 2>&1"),
    ] {
        if is_there(program)
            || program == "mandoc" && shell(path, "command -v mandoc").status.success()
        {
            for page in ["all.1", "man1/*.1"] {
                let warnings = printed(path, &command.replace("$page", page));
                assert_eq!(warnings, "", "{program} {page}");
            }
        }
    }
    if is_there("groff") {
        let read = printed(path, "groff -man -Tascii -P-c all.1 | sed 's/.\\x08//g'");
        let example = "parsim2d -n 1000 --radius 5e-4           its harder case";
        assert!(read.lines().any(|line| line.trim() == example), "{read:.3000}");
    }
}
