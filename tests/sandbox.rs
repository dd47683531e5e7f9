//! Submissions are built and run in a sandbox, and every frame they write is seen.
//!
//! Each test is done in every tier that works on the machine; which did not, and why, is printed.
#![cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]

use std::collections::BTreeMap;
use std::fs;
use std::net::TcpListener;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use parsim2d::grading::sandbox::{
    Captured, Invocation, Limits, Options, Outcome, Run, Sandbox, Submission, Tier, Workspace,
};
use tempfile::TempDir;

/// Writes numbered frames of fifty rows in the manner of its first argument, as many as its second (0: for ever).
const WRITER: &str = r#"
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void rows(FILE *f, int frame) {
    for (int i = 0; i < 50; i++) fprintf(f, "%d %d 0.0005\n", 1000000 + frame, i);
}

int main(int argc, char **argv) {
    const char *manner = argv[1];
    int frames = atoi(argv[2]);
    if (argc > 3) signal(SIGTERM, SIG_IGN);
    FILE *kept = NULL;
    if (!strcmp(manner, "rewinds") || !strcmp(manner, "truncates")) kept = fopen("out.txt", "w");
    for (int k = 0; frames == 0 || k < frames; k++) {
        if (!strcmp(manner, "overwrites")) {
            FILE *f = fopen("out.txt", "w");
            rows(f, k);
            fclose(f);
        } else if (!strcmp(manner, "overwrites by another path")) {
            int folder = open("/proc/self/cwd", O_RDONLY);
            if (folder < 0) folder = open(".", O_RDONLY);
            FILE *f = fdopen(openat(folder, "./out.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600), "w");
            rows(f, k);
            fclose(f);
            close(folder);
        } else if (!strcmp(manner, "appends")) {
            FILE *f = fopen("out.txt", "a");
            rows(f, k);
            fputs("\n", f);
            fclose(f);
        } else if (!strcmp(manner, "appends without a blank line")) {
            FILE *f = fopen("out.txt", "a");
            rows(f, k);
            fclose(f);
        } else if (!strcmp(manner, "renames")) {
            FILE *f = fopen("out.tmp", "w");
            rows(f, k);
            fclose(f);
            rename("out.tmp", "out.txt");
        } else if (!strcmp(manner, "removes")) {
            unlink("out.txt");
            FILE *f = fopen("out.txt", "w");
            rows(f, k);
            fclose(f);
        } else if (!strcmp(manner, "rewinds")) {
            rewind(kept);
            rows(kept, k);
            fflush(kept);
        } else if (!strcmp(manner, "truncates")) {
            rewind(kept);
            if (ftruncate(fileno(kept), 0)) return 1;
            rows(kept, k);
            fflush(kept);
        } else if (!strcmp(manner, "in children")) {
            if (fork() == 0) {
                FILE *f = fopen("out.txt", "w");
                rows(f, k);
                fclose(f);
                _exit(0);
            }
            while (usleep(0), access("/proc", F_OK) == 7) {}
            extern int wait(int *);
            wait(NULL);
        }
    }
    return 0;
}
"#;
const MAKEFILE: &str = "writer: writer.c\n\tcc -w -O1 -o writer writer.c\n";

/// The sandboxes that work here, each in its own sandbox.
fn sandboxes() -> Vec<Sandbox> {
    let mut open = Vec::new();
    for tier in Tier::ALL {
        match Sandbox::open(&options(tier)) {
            Ok(sandbox) => open.push(sandbox),
            Err(closed) => eprintln!("NOT TESTED in tier {tier}: {closed}"),
        }
    }
    if open.is_empty() {
        eprintln!("NOTHING TESTED: no sandbox works on this machine");
    }
    open
}

fn options(tier: Tier) -> Options {
    let helper = Some(PathBuf::from(env!("CARGO_BIN_EXE_parsim2d")));
    Options { tier: Some(tier), allow_unsandboxed: true, helper, ..Options::default() }
}

/// The sandboxes that hide the machine's files.
fn walled() -> impl Iterator<Item = Sandbox> {
    sandboxes().into_iter().filter(|sandbox| sandbox.tier() != Tier::D)
}

/// Limits short enough for tests.
fn limits() -> Limits {
    Limits {
        build_wall: Duration::from_secs(20),
        run_wall: Duration::from_secs(10),
        run_files: 8 << 20,
        ..Limits::default()
    }
}

fn handed_in(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn prepared<'a>(sandbox: &'a Sandbox, folder: &Path, build: &[&str]) -> Workspace<'a> {
    let build = build.iter().map(|&word| word.to_owned()).collect();
    let submission = Submission { folder: folder.to_owned(), files: Vec::new(), build };
    sandbox.prepare(&submission, &limits()).unwrap()
}

fn writer(sandbox: &Sandbox) -> Workspace<'_> {
    let folder = handed_in(&[("Makefile", MAKEFILE), ("writer.c", WRITER)]);
    let workspace = prepared(sandbox, folder.path(), &["make"]);
    let build = workspace.build.as_ref().unwrap();
    assert!(build.outcome.is_success(), "{:?}: {}", build.outcome, build.log);
    workspace
}

fn invocation(command: &[&str], frames: Option<usize>) -> Invocation {
    let command = command.iter().map(|&word| word.to_owned()).collect();
    Invocation { command, frames, ..Invocation::default() }
}

/// What `script` does, in a folder with nothing in it.
fn shell(sandbox: &Sandbox, script: &str, limits: &Limits) -> Run {
    let empty = TempDir::new().unwrap();
    let workspace = prepared(sandbox, empty.path(), &[]);
    workspace.run(&invocation(&["/bin/sh", "-c", script], None), limits).unwrap()
}

/// The number of a frame of the writer, if all its fifty rows are there and of the same frame.
fn number(frame: &[u8]) -> Option<usize> {
    let text = std::str::from_utf8(frame).ok()?;
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(' ').collect()).collect();
    let first = rows.first()?.first()?.parse::<usize>().ok()?;
    let is_whole = rows.len() == 50
        && rows
            .iter()
            .enumerate()
            .all(|(i, row)| row[..] == [&*first.to_string(), &*i.to_string(), "0.0005"]);
    is_whole.then(|| first - 1_000_000)
}

fn numbers(film: &Captured) -> Vec<Option<usize>> {
    let Captured::Snapshots(frames) = film else { panic!("one file, or none: {film:?}") };
    frames.iter().map(|frame| number(frame)).collect()
}

/// Processes with `word` among their arguments.
fn processes(word: &str) -> usize {
    let entries = fs::read_dir("/proc").unwrap().flatten();
    let lines = entries.filter_map(|entry| fs::read(entry.path().join("cmdline")).ok());
    lines
        .filter(|line| line.split(|&byte| byte == 0).any(|argument| argument == word.as_bytes()))
        .count()
}

#[test]
fn every_frame_is_seen_whole_and_in_order_however_the_file_is_replaced() {
    let manners = [
        "overwrites",
        "overwrites by another path",
        "renames",
        "removes",
        "rewinds",
        "truncates",
        "in children",
    ];
    for sandbox in sandboxes() {
        let workspace = writer(&sandbox);
        for manner in manners {
            let run =
                workspace.run(&invocation(&["./writer", manner, "300"], None), &limits()).unwrap();
            assert!(run.outcome.is_success(), "{manner}: {:?} {}", run.outcome, run.log);
            let expected: Vec<_> = (0..300).map(Some).collect();
            if run.every_frame {
                assert_eq!(numbers(&run.captured), expected, "tier {}: {manner}", sandbox.tier());
            } else {
                eprintln!("NOT TESTED in tier {}: ptrace is refused", sandbox.tier());
            }
        }
    }
}

#[test]
fn frames_added_to_one_file_are_one_film() {
    for sandbox in sandboxes() {
        let workspace = writer(&sandbox);
        let run =
            workspace.run(&invocation(&["./writer", "appends", "40"], None), &limits()).unwrap();
        let Captured::File(bytes) = &run.captured else { panic!("{:?}", run.captured) };
        let text = String::from_utf8(bytes.clone()).unwrap();
        let frames: Vec<_> =
            text.split_terminator("\n\n").map(|frame| number(frame.as_bytes())).collect();
        assert_eq!(frames, (0..40).map(Some).collect::<Vec<_>>());
    }
}

#[test]
fn a_program_that_runs_for_ever_is_stopped_after_enough_frames() {
    for sandbox in sandboxes() {
        let workspace = writer(&sandbox);
        for words in
            [["./writer", "overwrites", "0"].as_slice(), &["./writer", "overwrites", "0", "deaf"]]
        {
            let run = workspace.run(&invocation(words, Some(100)), &limits()).unwrap();
            assert_eq!(run.outcome, Outcome::EnoughFrames, "{}", run.log);
            let seen = numbers(&run.captured);
            assert_eq!(seen.len(), 100, "tier {}", sandbox.tier());
            assert!(seen.iter().all(Option::is_some), "a torn frame");
            if run.every_frame {
                assert_eq!(seen, (0..100).map(Some).collect::<Vec<_>>());
            }
        }
        for (manner, rows) in [("appends", None), ("appends without a blank line", Some(50))] {
            let invocation =
                Invocation { rows, ..invocation(&["./writer", manner, "0"], Some(30)) };
            let run = workspace.run(&invocation, &limits()).unwrap();
            assert_eq!(run.outcome, Outcome::EnoughFrames, "{manner}");
            let Captured::File(bytes) = &run.captured else { panic!("{:?}", run.captured) };
            assert!(bytes.iter().filter(|&&byte| byte == b'\n').count() >= 30 * 50);
            assert!(bytes.ends_with(b"\n"), "a torn row");
        }
    }
}

#[test]
fn a_program_that_takes_too_long_is_stopped_and_its_frames_are_kept() {
    let short = Limits { run_wall: Duration::from_millis(500), ..limits() };
    for sandbox in sandboxes() {
        let run = shell(
            &sandbox,
            "echo 1 2 3 > out.txt; echo 4 5 >> out.txt; printf 6 >> out.txt; sleep 60",
            &short,
        );
        assert_eq!(run.outcome, Outcome::TimeUp);
        assert_eq!(run.captured, Captured::File(b"1 2 3\n4 5\n".to_vec()));
        assert!(run.took < Duration::from_secs(3), "{:?}", run.took);
        let run = shell(&sandbox, "while :; do :; done", &Limits { cpu: 1, ..limits() });
        assert_eq!(run.outcome, Outcome::CpuUp);
    }
}

#[test]
fn nothing_is_left_of_a_submission_that_leaves_processes_behind() {
    for sandbox in sandboxes() {
        let tier = sandbox.tier();
        let word = format!("6{}.{tier:?}", std::process::id())
            .replace(['A', 'B', 'C', 'D'], &format!("{}", tier as u8 + 1));
        let script =
            format!("setsid sleep {word} & (sleep {word} &) ; sleep 0.2; echo 1 1 1 > out.txt");
        let run = shell(&sandbox, &script, &limits());
        assert!(run.outcome.is_success(), "{:?} {}", run.outcome, run.log);
        assert_eq!(run.captured, Captured::File(b"1 1 1\n".to_vec()));
        assert_eq!(processes(&word), 0, "tier {tier}");
    }
}

#[test]
fn too_many_processes_and_too_much_memory_are_stopped() {
    for sandbox in sandboxes() {
        let word = format!("7{}.{}", std::process::id(), sandbox.tier() as u8 + 1);
        let script = format!("k=0; while [ $k -lt 200 ]; do sleep {word} & k=$((k+1)); done; wait");
        let run = shell(&sandbox, &script, &Limits { processes: 20, ..limits() });
        assert_eq!(run.outcome, Outcome::TooManyProcesses, "{}", run.log);
        assert!(run.took < Duration::from_secs(5));
        assert_eq!(processes(&word), 0);
        let hungry = "x=xxxxxxxxxxxxxxxx; while :; do x=$x$x; done";
        let run = shell(&sandbox, hungry, &Limits { memory: 64 << 20, ..limits() });
        assert_eq!(run.outcome, Outcome::MemoryUp, "{}", run.log);
    }
}

#[test]
fn a_program_that_writes_too_much_is_stopped_before_the_disc_is_full() {
    let one_file = "yes > out.txt";
    let deaf = "trap '' XFSZ; yes > out.txt; exit 0";
    let many_files = "k=0; while :; do head -c 1000000 /dev/zero > f$k; k=$((k+1)); done";
    let outside = "k=0; while :; do head -c 1000000 /dev/zero > $TMPDIR/f$k; k=$((k+1)); done";
    for sandbox in sandboxes() {
        for script in [one_file, deaf, many_files, outside] {
            let run = shell(&sandbox, script, &limits());
            assert_eq!(run.outcome, Outcome::OutputTooLarge, "tier {}: {script}", sandbox.tier());
        }
    }
}

#[test]
fn what_is_printed_is_bounded_and_cannot_command_a_terminal() {
    let small = Limits { log: 4096, ..limits() };
    for sandbox in sandboxes() {
        let script = r"printf 'first \033[31mred\033[0m\n'; yes | head -c 20000000; printf '\033]0;x\007\rlast\n' >&2";
        let run = shell(&sandbox, script, &small);
        assert!(run.outcome.is_success(), "{:?}", run.outcome);
        assert!(run.log.starts_with("first red\ny\n"), "{}", run.log);
        assert!(run.log.ends_with("]0;xlast\n"), "{}", run.log);
        assert!(run.log.contains("bytes left out]") && run.log.len() < 4200);
    }
}

#[test]
fn there_is_no_network() {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    listener.set_nonblocking(true).unwrap();
    let port = listener.local_addr().unwrap().port();
    let call = format!("exec 3<>/dev/tcp/127.0.0.1/{port} && echo through");
    if !Path::new("/bin/bash").exists() {
        return eprintln!("NOT TESTED: there is no bash to call with");
    }
    assert!(Command::new("/bin/bash").args(["-c", &call]).status().unwrap().success());
    assert!(listener.accept().is_ok(), "the call itself works");
    for sandbox in sandboxes() {
        let empty = TempDir::new().unwrap();
        let workspace = prepared(&sandbox, empty.path(), &[]);
        let run = workspace.run(&invocation(&["/bin/bash", "-c", &call], None), &limits()).unwrap();
        assert!(!run.log.contains("through"), "tier {}", sandbox.tier());
        assert!(listener.accept().is_err(), "tier {}", sandbox.tier());
    }
}

#[test]
fn files_of_others_are_neither_read_nor_changed() {
    for sandbox in walled() {
        let beside = handed_in(&[("secret", "the secret"), ("mine", "as it was")]);
        let other = writer(&sandbox);
        let (secret, mine) = (beside.path().join("secret"), beside.path().join("mine"));
        let script = format!(
            "cat {secret}; cat {other}/writer.c; cat ../*/*/writer.c; cat /root/* /home/*/* /etc/shadow; \
             echo x > {mine}; echo x >> {mine}; rm {mine}; mv {mine} here; ln {secret} here; echo x > {new}; \
             chmod 777 {mine}; touch {mine}; truncate -s 0 {mine}; mkdir {new}; ln -s {secret} link; cat link; \
             echo x > /usr/bin/x; echo x > /x; echo x > ../../x; mknod /tmp/x c 1 1; exit 0",
            secret = secret.display(),
            mine = mine.display(),
            new = beside.path().join("new").display(),
            other = other.folder().display(),
        );
        let before = fs::metadata(&mine).unwrap();
        let run = shell(&sandbox, &script, &limits());
        let tier = sandbox.tier();
        assert!(run.outcome.is_success(), "{:?} {}", run.outcome, run.log);
        assert!(
            !run.log.contains("the secret") && !run.log.contains("#include"),
            "tier {tier}: {}",
            run.log
        );
        assert_eq!(fs::read_to_string(&mine).unwrap(), "as it was", "tier {tier}");
        let after = fs::metadata(&mine).unwrap();
        assert_eq!(after.permissions(), before.permissions(), "tier {tier}");
        assert_eq!(after.modified().unwrap(), before.modified().unwrap(), "tier {tier}");
        assert_eq!(fs::read_dir(beside.path()).unwrap().count(), 2, "tier {tier}");
        assert!(!Path::new("/usr/bin/x").exists() && !Path::new("/x").exists());
    }
}

#[test]
fn processes_of_others_are_left_alone() {
    for sandbox in sandboxes() {
        let mut other = Command::new("sleep").arg("60").spawn().unwrap();
        let pid = other.id();
        let run = shell(
            &sandbox,
            &format!("kill {pid}; kill -9 {pid}; kill -KILL -- -{pid}; exit 0"),
            &limits(),
        );
        assert!(run.outcome.is_success(), "{:?} {}", run.outcome, run.log);
        assert!(other.try_wait().unwrap().is_none(), "tier {}", sandbox.tier());
        other.kill().unwrap();
        other.wait().unwrap();
    }
}

#[test]
fn an_out_txt_that_is_no_file_holds_nobody_up_and_leads_nowhere() {
    for sandbox in sandboxes() {
        let outside = handed_in(&[("secret", "1 1 1\n")]);
        let link = format!("ln -s {} out.txt", outside.path().join("secret").display());
        for script in [&*link, "ln -s /dev/zero out.txt", "mkfifo out.txt", "mkdir out.txt", ":"] {
            let run = shell(&sandbox, script, &limits());
            assert!(run.outcome.is_success(), "{script}: {:?} {}", run.outcome, run.log);
            assert_eq!(run.captured, Captured::Nothing, "tier {}: {script}", sandbox.tier());
        }
        let run = shell(&sandbox, ": > out.txt", &limits());
        assert_eq!(run.captured, Captured::File(Vec::new()));
    }
}

#[test]
fn a_build_is_held_like_a_run() {
    let short = Limits { build_wall: Duration::from_millis(800), ..limits() };
    let makefiles = BTreeMap::from([
        ("endless", ("all:\n\twhile :; do sleep 0.1; done\n", Outcome::TimeUp)),
        ("endless in make", ("x := $(shell sleep 60)\nall:\n", Outcome::TimeUp)),
        ("failing", ("all:\n\t@echo no; false\n", Outcome::Ended(2))),
        ("flood", ("all:\n\t@yes | head -c 30000000\n", Outcome::Ended(0))),
    ]);
    for sandbox in sandboxes() {
        for (name, (makefile, expected)) in &makefiles {
            let folder = handed_in(&[("Makefile", makefile)]);
            let build = vec!["make".to_owned()];
            let submission =
                Submission { folder: folder.path().to_owned(), files: vec!["a.cpp".into()], build };
            let start = Instant::now();
            let workspace = sandbox.prepare(&submission, &short).unwrap();
            let build = workspace.build.as_ref().unwrap();
            assert_eq!(build.outcome, *expected, "{name}: {}", build.log);
            assert!(build.log.len() < 80_000);
            assert!(start.elapsed() < Duration::from_secs(10), "{name}");
            assert_eq!(workspace.missing, [PathBuf::from("a.cpp")]);
        }
    }
}

#[test]
fn frames_that_were_there_before_the_run_do_not_count() {
    for sandbox in sandboxes() {
        let folder =
            handed_in(&[("Makefile", "all:\n\techo 9 9 9 > out.txt\n"), ("out.txt", "8 8 8\n")]);
        let workspace = prepared(&sandbox, folder.path(), &["make"]);
        let run = workspace.run(&invocation(&["/bin/true"], None), &limits()).unwrap();
        assert_eq!(run.captured, Captured::Nothing, "tier {}", sandbox.tier());
    }
}

#[test]
fn links_and_pipes_handed_in_are_named_and_not_copied() {
    for sandbox in sandboxes() {
        let folder = handed_in(&[("a.txt", "a")]);
        fs::create_dir(folder.path().join("deep")).unwrap();
        fs::write(folder.path().join("deep/b.txt"), "b").unwrap();
        symlink("/etc/passwd", folder.path().join("link")).unwrap();
        symlink("/etc", folder.path().join("deep/folder")).unwrap();
        let pipe = folder.path().join("pipe");
        assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let workspace = prepared(&sandbox, folder.path(), &[]);
        let left_out: BTreeMap<_, _> = workspace.left_out.iter().cloned().collect();
        let expected = [("deep/folder", "a link"), ("link", "a link"), ("pipe", "no regular file")];
        assert_eq!(left_out, expected.map(|(name, why)| (PathBuf::from(name), why)).into());
        let run =
            workspace.run(&invocation(&["find", ".", "-type", "f"], None), &limits()).unwrap();
        let mut found: Vec<_> = run.log.lines().collect();
        found.sort_unstable();
        assert_eq!(found, ["./a.txt", "./deep/b.txt"]);
    }
}

#[test]
fn an_end_is_told_as_it_was() {
    for sandbox in sandboxes() {
        let cases = [
            ("exit 3", Outcome::Ended(3)),
            ("kill -SEGV $$", Outcome::Signal(11)),
            ("kill -ABRT $$", Outcome::Signal(6)),
            ("kill -40 $$", Outcome::Signal(40)), // a real-time signal
        ];
        for (script, expected) in cases {
            assert_eq!(
                shell(&sandbox, script, &limits()).outcome,
                expected,
                "tier {}: {script}",
                sandbox.tier()
            );
        }
        let empty = TempDir::new().unwrap();
        let workspace = prepared(&sandbox, empty.path(), &[]);
        let run = workspace.run(&invocation(&["./parSim2D"], None), &limits()).unwrap();
        assert_eq!(run.outcome, Outcome::NotStarted);
        assert!(run.log.contains("parSim2D"), "{}", run.log);
    }
}

#[test]
fn a_folder_that_was_locked_or_dug_deep_is_read_and_removed_all_the_same() {
    for sandbox in sandboxes() {
        let empty = TempDir::new().unwrap();
        let workspace = prepared(&sandbox, empty.path(), &[]);
        let script = "k=0; while [ $k -lt 300 ]; do mkdir aaaaaaaaaaaaaaaaaaaa; cd aaaaaaaaaaaaaaaaaaaa; \
                      : > file; k=$((k+1)); done; cd $HOME; echo 1 1 1 > out.txt; chmod 0 aaaaaaaaaaaaaaaaaaaa .";
        let run = workspace.run(&invocation(&["/bin/sh", "-c", script], None), &limits()).unwrap();
        assert_eq!(
            run.captured,
            Captured::File(b"1 1 1\n".to_vec()),
            "{:?} {}",
            run.outcome,
            run.log
        );
        let folder = workspace.folder();
        let again = workspace.run(&invocation(&["/bin/true"], None), &limits()).unwrap();
        assert_eq!(again.captured, Captured::Nothing);
        drop(workspace);
        assert!(!folder.exists() && !folder.parent().unwrap().exists(), "tier {}", sandbox.tier());
    }
}

#[test]
fn a_submission_sees_its_input_and_nothing_of_the_graders_environment() {
    for sandbox in sandboxes() {
        let empty = TempDir::new().unwrap();
        let workspace = prepared(&sandbox, empty.path(), &[]);
        let invocation = Invocation {
            stdin: b"20 7\n".to_vec(),
            ..invocation(&["/bin/sh", "-c", "cat; env; ls /proc/self/fd"], None)
        };
        let run = workspace.run(&invocation, &limits()).unwrap();
        assert!(run.log.starts_with("20 7\n"), "{}", run.log);
        let keys = run.log.lines().filter_map(|line| line.split_once('=')).map(|(key, _)| key);
        let unknown: Vec<_> = keys
            .filter(|key| {
                !["PATH", "HOME", "PWD", "TMPDIR", "LANG", "_", "SHLVL", "OLDPWD"].contains(key)
            })
            .collect();
        assert!(unknown.is_empty(), "tier {}: {unknown:?}", sandbox.tier());
    }
}

#[test]
fn without_ptrace_frames_may_be_missed_but_none_is_torn() {
    for tier in Tier::ALL {
        let Ok(sandbox) = Sandbox::open(&Options { untraced: true, ..options(tier) }) else {
            continue;
        };
        let workspace = writer(&sandbox);
        // Who looks seldom meets few whole frames of a program that never pauses: on a busy machine not
        // twenty in the time there is.
        let short = Limits { run_wall: Duration::from_secs(2), ..limits() };
        let run =
            workspace.run(&invocation(&["./writer", "overwrites", "0"], Some(20)), &short).unwrap();
        assert!(
            [Outcome::EnoughFrames, Outcome::TimeUp].contains(&run.outcome),
            "{:?}",
            run.outcome
        );
        assert!(!run.every_frame);
        let seen = numbers(&run.captured);
        assert!(
            seen.iter().all(Option::is_some) && seen.is_sorted(),
            "tier {tier}: {:?}",
            run.captured
        );
        let slow = "for k in 1 2 3 4 5; do echo $k 0 0 > out.txt; sleep 0.1; done";
        let run = shell(&sandbox, slow, &limits());
        let expected = (1..=5).map(|k| format!("{k} 0 0\n").into_bytes()).collect();
        assert_eq!(run.captured, Captured::Snapshots(expected), "tier {tier}");
        let added = "for k in 1 2 3 4 5; do printf '%s 0 0\\n\\n' $k >> out.txt; sleep 0.05; done";
        let run = shell(&sandbox, added, &limits());
        let expected = (1..=5).map(|k| format!("{k} 0 0\n\n")).collect::<String>().into_bytes();
        assert_eq!(run.captured, Captured::File(expected), "tier {tier}");
        let run =
            workspace.run(&invocation(&["./writer", "appends", "0"], Some(30)), &limits()).unwrap();
        assert_eq!(run.outcome, Outcome::EnoughFrames, "tier {tier}");
        assert!(matches!(run.captured, Captured::File(_)), "tier {tier}");
        let run = shell(&sandbox, "kill -SEGV $$", &limits());
        assert_eq!(run.outcome, Outcome::Signal(11), "tier {tier}");
    }
}
