//! Runs of the program in folders of their own, and the comparison of what they leave.
#![allow(dead_code)] // each test file uses its own part

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

pub fn parsim2d(folder: &Path, arguments: &str) -> Command {
    let mut command = super::heeding(env!("CARGO_BIN_EXE_parsim2d"));
    command.current_dir(folder).args(arguments.split_whitespace());
    command
}

pub fn outcome(folder: &Path, arguments: &str) -> Output {
    parsim2d(folder, arguments).output().unwrap()
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// What there is in a folder, in the order of names.
pub fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Every file of a folder but checkpoints.
pub fn files(folder: &Path) -> BTreeMap<String, String> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries
        .filter(|path| path.extension().is_none_or(|extension| extension != "ckpt"))
        .map(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            (name, fs::read_to_string(path).unwrap())
        })
        .collect()
}

/// The same bytes in every file, and the same files; says where they differ and not all they hold.
pub fn assert_same(folder: &Path, reference: &Path, what: &str) {
    let (these, those) = (files(folder), files(reference));
    let names = |files: &BTreeMap<String, String>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&these), names(&those), "{what}");
    for (name, text) in &those {
        let pairs = text.lines().zip(these[name].lines()).enumerate();
        if let Some((line, (this, that))) = pairs.into_iter().find(|(_, (a, b))| a != b) {
            panic!("{what}: {name}, line {}: {that:?}, not {this:?}", line + 1);
        }
        assert_eq!(text.len(), these[name].len(), "{what}: {name} is longer or shorter");
    }
}

/// A finished run in a folder of its own, with its summary.
pub fn reference(arguments: &str) -> (TempDir, Value) {
    let folder = tempfile::tempdir().unwrap();
    let output = outcome(folder.path(), arguments);
    (folder, summary(&output))
}

/// The summary without what depends on the machine.
pub fn summary(output: &Output) -> Value {
    let mut summary: Value = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|_| panic!("no summary: {}{}", text(&output.stdout), text(&output.stderr)));
    // Of the machine and the moment; a restart makes a list of its own, too.
    for key in ["wall_s", "particle_steps_per_s", "peak_memory_MB", "list_rebuilds"] {
        summary.as_object_mut().unwrap().remove(key).unwrap();
    }
    summary
}

/// A folder with a finished run of two checkpoints.
pub fn with_two_checkpoints() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let case = "-n 100 --radius 5e-4 --seed 2 --time 0.1 -q --checkpoint-every 1ms";
    assert!(outcome(folder.path(), case).status.success());
    folder
}
