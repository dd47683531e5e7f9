//! What may lie where a run wants to write: folders, links, pipes. Nothing old is lost to a run that cannot be, no
//! link is replaced without a word, and nobody waits over a pipe that he did not name.

#![cfg(unix)]

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use tempfile::TempDir;

use crate::support::heeding;

/// Every name that a run gives to a file, now or later.
const NAMES: [&str; 8] = [
    "out.txt",
    "trajectory.txt",
    "energy.csv",
    "last-run.toml",
    "failure.json",
    "parsim2d.ckpt",
    "parsim2d.previous.ckpt",
    ".parsim2d.lock",
];

/// Those of the files of a run that has ended well.
const WRITTEN: [&str; 4] = ["out.txt", "trajectory.txt", "energy.csv", "last-run.toml"];

const RUN: &str = "-n 3 --seed 1 --time 1ms -q";

/// The program, ended after ten seconds with 124: nothing here takes one.
fn parsim2d(folder: &Path, arguments: &str) -> Output {
    Command::new("timeout")
        .args(["10", env!("CARGO_BIN_EXE_parsim2d")])
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .output()
        .unwrap()
}

fn folder_of_a_run() -> TempDir {
    let folder = TempDir::new().unwrap();
    let done = parsim2d(folder.path(), RUN);
    assert!(done.status.success(), "{done:?}");
    folder
}

fn message(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Names and contents of everything in `folder`, links as what they say.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let content = |entry: fs::DirEntry| {
        let (path, name) = (entry.path(), entry.file_name().into_string().unwrap());
        let said = match entry.file_type().unwrap() {
            kind if kind.is_symlink() => {
                fs::read_link(&path).unwrap().into_os_string().into_encoded_bytes()
            }
            kind if kind.is_file() => fs::read(&path).unwrap(),
            kind => format!("{kind:?}").into_bytes(),
        };
        (name, said)
    };
    entries.map(content).collect()
}

/// Puts something at a path.
type Lay = fn(&Path);

/// What may lie at the name of a file, and cannot be replaced by one.
const OBSTACLES: [(&str, Lay, &str); 5] = [
    ("a folder", |path| fs::create_dir(path).unwrap(), "folder"),
    ("a pipe", fifo, "pipe"),
    ("a link to a folder", |path| symlink("/", path).unwrap(), "folder"),
    ("a link to a device", |path| symlink("/dev/null", path).unwrap(), "device"),
    ("a link to itself", |path| symlink(path.file_name().unwrap(), path).unwrap(), "circle"),
];

fn fifo(path: &Path) {
    assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
}

#[test]
fn what_is_in_the_way_of_any_file_is_named_before_anything_old_is_gone() {
    for (what, lay, says) in OBSTACLES {
        for name in NAMES {
            let folder = folder_of_a_run();
            let path = folder.path().join(name);
            let _ = fs::remove_file(&path);
            lay(&path);
            let before = contents(folder.path());
            let refused = parsim2d(folder.path(), RUN);
            let said = message(&refused);
            assert_eq!(refused.status.code(), Some(2), "{what} as {name}: {said}");
            let is_named = said.contains(name) && said.contains("way out");
            let is_lock = name.ends_with(".lock");
            let is_kept_apart = name.ends_with(".ckpt") && said.contains("is no checkpoint");
            assert!(
                is_named && (is_lock || is_kept_apart || said.contains(says)),
                "{what} as {name}: {said}"
            );
            assert!(before == contents(folder.path()), "{what} as {name} cost a file");
        }
    }
}

#[test]
fn a_folder_with_the_temporary_name_of_any_file_costs_nothing_old() {
    for name in WRITTEN {
        let folder = folder_of_a_run();
        let before = contents(folder.path());
        let script =
            format!("mkdir {name}.$$.tmp && exec {} {RUN}", env!("CARGO_BIN_EXE_parsim2d"));
        let refused =
            Command::new("sh").args(["-c", &script]).current_dir(folder.path()).output().unwrap();
        assert_eq!(refused.status.code(), Some(2), "{name}: {}", message(&refused));
        let mut after = contents(folder.path());
        after.retain(|file, _| !file.ends_with(".tmp"));
        assert!(before == after, "{name}");
    }
}

#[test]
fn a_link_with_a_temporary_name_is_not_written_through() {
    let commands = [(RUN, "out.txt"), ("plot frame trajectory.txt", "frame.svg")];
    for (command, name) in commands {
        let folder = folder_of_a_run();
        fs::write(folder.path().join("mine"), "mine").unwrap();
        let program = env!("CARGO_BIN_EXE_parsim2d");
        let script = format!("ln -s mine {name}.$$.tmp && exec {program} {command}");
        let done =
            Command::new("sh").args(["-c", &script]).current_dir(folder.path()).output().unwrap();
        assert!(done.status.success(), "{command}: {}", message(&done));
        assert_eq!(fs::read_to_string(folder.path().join("mine")).unwrap(), "mine", "{command}");
        let is_left = contents(folder.path()).keys().any(|name| name.ends_with(".tmp"));
        assert!(!is_left, "{command}");
    }
}

#[test]
fn a_folder_that_cannot_be_written_keeps_its_files() {
    // Nobody, not even root, makes files there.
    let refused = parsim2d(Path::new("/"), &format!("{RUN} --out-dir /proc"));
    let said = message(&refused);
    assert_eq!(refused.status.code(), Some(2), "{said}");
    assert!(said.contains("cannot write to /proc/out.txt") && said.contains("way out"), "{said}");
}

#[test]
fn a_link_is_followed_to_its_file_and_stays_a_link() {
    let wanted = contents(folder_of_a_run().path());
    for (what, is_there) in [("to a file", true), ("to nothing yet", false)] {
        for name in WRITTEN {
            let (folder, elsewhere) = (TempDir::new().unwrap(), TempDir::new().unwrap());
            let target = elsewhere.path().join("target");
            if is_there {
                fs::write(&target, "# parsim2d old\n").unwrap();
            }
            // In two steps, the first one relative.
            symlink("step", folder.path().join(name)).unwrap();
            symlink(&target, folder.path().join("step")).unwrap();
            let done = parsim2d(folder.path(), RUN);
            assert!(done.status.success(), "{name}, {what}: {}", message(&done));
            let is_link = folder.path().join(name).is_symlink();
            assert!(is_link, "the link {name}, {what}, was replaced");
            let found = (fs::read(&target).unwrap(), contents(elsewhere.path()).len());
            assert!(found == (wanted[name].clone(), 1), "{name}, {what}: {found:?}");
        }
    }
}

#[test]
fn a_checkpoint_that_is_a_link_is_kept_where_it_leads() {
    let (folder, elsewhere) = (TempDir::new().unwrap(), TempDir::new().unwrap());
    let run = "-n 3 --seed 1 --time 1ms --checkpoint-every 1h";
    assert!(parsim2d(folder.path(), run).status.success());
    let (link, target) = (folder.path().join("parsim2d.ckpt"), elsewhere.path().join("kept"));
    fs::rename(&link, &target).unwrap();
    symlink(&target, &link).unwrap();
    let resumed = parsim2d(folder.path(), "resume parsim2d.ckpt --time 2ms");
    assert!(resumed.status.success(), "{}", message(&resumed));
    assert!(link.is_symlink());
    let again = parsim2d(folder.path(), "resume parsim2d.ckpt --time 3ms");
    assert!(message(&again).contains("going on from step 225 of 338"), "{}", message(&again));
}

#[test]
fn pictures_pages_and_studies_follow_links_and_refuse_what_is_no_file() {
    let commands = [
        ("plot frame trajectory.txt", "frame.svg"),
        ("plot frame trajectory.txt", "frame.gp"),
        ("plot energy energy.csv -o energy.svg", "energy.gp"),
        ("report", "report.html"),
        ("drift -n 2 --time 1ms --nt 10", "drift.csv"),
        ("drift -n 2 --time 1ms --nt 10", "drift.gp"),
    ];
    for (command, name) in commands {
        for (what, lay, _) in OBSTACLES {
            let folder = folder_of_a_run();
            lay(&folder.path().join(name));
            let before = contents(folder.path());
            let refused = parsim2d(folder.path(), command);
            let code = refused.status.code();
            assert!(
                matches!(code, Some(1 | 2)),
                "{command}, {what} as {name}: {}",
                message(&refused)
            );
            let after = contents(folder.path());
            assert!(before == after, "{command}, {what} as {name}: {:?}", after.keys());
        }
        let folder = folder_of_a_run();
        symlink("there", folder.path().join(name)).unwrap();
        let done = parsim2d(folder.path(), command);
        assert!(done.status.success(), "{command}: {}", message(&done));
        let is_followed =
            folder.path().join(name).is_symlink() && folder.path().join("there").is_file();
        assert!(is_followed, "{command}: the link {name} was replaced");
    }
}

#[test]
fn a_sheet_is_not_written_over_a_link_that_may_have_been_handed_in() {
    let folder = folder_of_a_run();
    fs::write(folder.path().join("mine"), "mine").unwrap();
    symlink("mine", folder.path().join("sheet.html")).unwrap();
    let refused =
        parsim2d(folder.path(), "grade --frames trajectory.txt --format html --out sheet.html");
    assert!(message(&refused).contains("it is a link"), "{}", message(&refused));
    assert!(!refused.status.success());
    assert_eq!(fs::read_to_string(folder.path().join("mine")).unwrap(), "mine");
}

#[test]
fn nobody_waits_over_a_pipe_in_a_folder() {
    let commands = [
        "resume",
        "resume parsim2d.ckpt",
        "report",
        "plot frame trajectory.txt",
        "plot trajectory trajectory.txt",
        "plot forces trajectory.txt",
        "plot energy energy.csv",
        "plot drift drift.csv",
    ];
    for command in commands {
        for name in NAMES.into_iter().chain(["drift.csv", "drift_energy.csv"]) {
            let folder = folder_of_a_run();
            let path = folder.path().join(name);
            let _ = fs::remove_file(&path);
            fifo(&path);
            let output = parsim2d(folder.path(), command);
            assert_ne!(output.status.code(), Some(124), "{command} waits over {name}");
        }
    }
}

/// Whether `arguments` come to an end, within seconds, once they are asked to by `signal`.
fn ends_by(signal: &str, folder: &Path, arguments: &str) -> bool {
    let mut child = heeding(env!("CARGO_BIN_EXE_parsim2d"))
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(300));
    assert!(child.try_wait().unwrap().is_none(), "{arguments}: it does not wait over the pipe");
    Command::new("kill").args([&format!("-{signal}"), &child.id().to_string()]).status().unwrap();
    let asked = Instant::now();
    while asked.elapsed() < Duration::from_secs(5) {
        if child.try_wait().unwrap().is_some() {
            return true;
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    false
}

#[test]
fn who_names_a_pipe_and_waits_over_it_can_be_asked_to_end() {
    let folder = folder_of_a_run();
    fifo(&folder.path().join("pipe"));
    for command in ["pipe", "run ./pipe", "check pipe", "--start pipe", "grade --frames pipe"] {
        for signal in ["TERM", "INT"] {
            assert!(ends_by(signal, folder.path(), command), "{command} does not heed SIG{signal}");
        }
    }
}

#[test]
fn resume_keeps_somebodys_own_record() {
    let folder = TempDir::new().unwrap();
    assert!(parsim2d(folder.path(), &format!("{RUN} --checkpoint-every 1h")).status.success());
    fs::write(folder.path().join("last-run.toml"), "n = 5 # my notes\n").unwrap();
    let before = contents(folder.path());
    let refused = parsim2d(folder.path(), "resume --time 2ms");
    assert_eq!(refused.status.code(), Some(2), "{}", message(&refused));
    assert!(message(&refused).contains("was not written by a run"), "{}", message(&refused));
    assert!(before == contents(folder.path()));
}

#[test]
fn a_resume_that_cannot_write_a_file_changes_none() {
    for name in ["trajectory.txt", "energy.csv", "out.txt", "failure.json", "last-run.toml"] {
        let folder = TempDir::new().unwrap();
        assert!(parsim2d(folder.path(), &format!("{RUN} --checkpoint-every 1h")).status.success());
        let path = folder.path().join(name);
        let _ = fs::remove_file(&path);
        fs::create_dir(&path).unwrap();
        let before = contents(folder.path());
        let refused = parsim2d(folder.path(), "resume --time 2ms");
        assert_eq!(refused.status.code(), Some(2), "{name}: {}", message(&refused));
        assert!(before == contents(folder.path()), "{name}");
    }
}

#[test]
fn grading_writes_over_nothing_that_it_reads() {
    let folder = TempDir::new().unwrap();
    let path = folder.path();
    assert!(parsim2d(path, RUN).status.success());
    let rubric = parsim2d(path, "grade --init-rubric").stdout;
    fs::write(path.join("course.toml"), &rubric).unwrap();
    fs::copy(path.join("trajectory.txt"), path.join("class.csv")).unwrap();
    symlink("trajectory.txt", path.join("link.txt")).unwrap();
    let before = contents(path);
    for out in [
        "--frames trajectory.txt --out trajectory.txt",
        "--frames trajectory.txt --out ./trajectory.txt --format json",
        "--frames trajectory.txt --out link.txt",
        "--frames trajectory.txt --rubric course.toml --out course.toml",
        "--frames class.csv --out-dir .",
    ] {
        let output = parsim2d(path, &format!("grade {out}"));
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{out}: {message}");
        assert!(message.contains("would be written over"), "{out}: {message}");
        assert_eq!(contents(path), before, "{out}");
    }
}

#[test]
fn grading_ends_with_3_where_a_result_finds_no_room_and_reads_nothing_without_an_end() {
    let folder = TempDir::new().unwrap();
    let path = folder.path();
    assert!(parsim2d(path, RUN).status.success());
    for arguments in
        ["--frames trajectory.txt > /dev/full", "--frames /dev/zero", "--frames no_such_file"]
    {
        let line = format!("'{}' grade {arguments}", env!("CARGO_BIN_EXE_parsim2d"));
        let shell = Command::new("bash").args(["-c", &line]).current_dir(path).output().unwrap();
        let message = String::from_utf8_lossy(&shell.stderr).into_owned();
        assert_eq!(shell.status.code(), Some(3), "{arguments}: {message}");
        assert!(message.starts_with("error: "), "{arguments}: {message}");
    }
}
