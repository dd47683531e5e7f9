//! Submissions to grade: the corpus, the command, and small programs that go wrong in one way.
#![allow(dead_code)] // each test file uses its own part

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/submissions")
}

/// `parsim2d grade` in the corpus.
pub fn grade(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_parsim2d"))
        .arg("grade")
        .args(arguments)
        .current_dir(corpus())
        .output()
        .unwrap()
}

/// Whether submissions can be built and run here; says loudly if not.
pub fn can_grade() -> bool {
    let tools = ["make", "g++", "python3"];
    let is_there = |tool: &&str| Command::new(tool).arg("--version").output().is_ok();
    if let Some(tool) = tools.iter().find(|tool| !is_there(tool)) {
        eprintln!("NOT TESTED: there is no {tool}, so no submission can be built");
        return false;
    }
    let doctor = Command::new(env!("CARGO_BIN_EXE_parsim2d")).args(["doctor", "--json"]).output();
    let found: serde_json::Value = serde_json::from_slice(&doctor.unwrap().stdout).unwrap();
    if found["sandbox"]["tier"].is_null() {
        eprintln!("NOT TESTED: no sandbox works here: {}", found["sandbox"]["error"]);
        return false;
    }
    true
}

/// A folder with these files, each with its text; a text that begins with `#!` may be executed.
pub fn hand_in(folder: &Path, files: &[(&str, &str)]) {
    fs::create_dir_all(folder).unwrap();
    for (name, text) in files {
        let path = folder.join(name);
        fs::write(&path, text).unwrap();
        if text.starts_with("#!") {
            fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
        }
    }
}

/// What is said of a folder graded by a rubric of this text.
pub fn said_of(folder: &Path, rubric: &str) -> String {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("course.toml");
    fs::write(&path, rubric).unwrap();
    let graded = grade(&[folder.to_str().unwrap(), "--rubric", path.to_str().unwrap()]);
    let said = String::from_utf8_lossy(&graded.stdout).into_owned();
    assert_eq!(graded.status.code(), Some(0), "{said}{}", String::from_utf8_lossy(&graded.stderr));
    said
}
