//! The matrix of state hashes, in short: this build, two scenes. `make hash-matrix` runs the whole of it.
#![cfg(unix)] // it is a shell script

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output};

const THIS_BUILD: &str = env!("CARGO_BIN_EXE_parsim2d");

fn matrix(programs: &[&Path], scenes: &str) -> Output {
    Command::new("sh")
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/hash_matrix.sh"))
        .args(programs)
        .env("PARSIM2D_MATRIX_SCENES", scenes)
        .env("PARSIM2D_MATRIX_THREADS", "1 3")
        .env("PARSIM2D_MATRIX_OUTPUTS", "often seldom")
        .output()
        .unwrap()
}

#[test]
fn threads_and_outputs_change_no_bit_of_a_run() {
    let output = matrix(&[Path::new(THIS_BUILD)], "dense corner");
    let (table, said) = (String::from_utf8_lossy(&output.stdout), output.stderr);
    assert!(output.status.success(), "{table}{}", String::from_utf8_lossy(&said));
    assert!(table.ends_with("8 runs, one state for each scene\n"), "{table}");
}

/// A program that is this build with `flags` and then does `more`, and the folder it is in.
fn other_program(flags: &str, more: &str) -> (tempfile::TempDir, std::path::PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("other");
    let program = format!("#!/bin/sh\nset -e\n'{THIS_BUILD}' \"$@\" {flags}\n{more}\n");
    fs::write(&path, program).unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    (folder, path)
}

#[test]
fn the_matrix_finds_a_build_that_does_otherwise() {
    // Another start; the same run with more in its files, whose folder is the last argument.
    let more = |file: &str| format!("for last; do :; done; echo >>\"$last/{file}\"");
    let cases = [
        ("--seed 99", String::new(), " 1:"),
        ("", more("trajectory.txt"), " 3:trajectory.txt"),
        ("", more("energy.csv"), " 3:energy.csv"),
    ];
    for (flags, more, found) in cases {
        let (_folder, other) = other_program(flags, &more);
        let output = matrix(&[Path::new(THIS_BUILD), &other], "dense");
        let table = String::from_utf8_lossy(&output.stdout);
        assert_eq!(output.status.code(), Some(1), "{flags} {more}: {table}");
        let differs = table.lines().find(|line| line.contains("DIFFERS"));
        assert!(differs.is_some_and(|line| line.contains(found)), "{flags} {more}: {table}");
    }
}

#[test]
fn a_scene_without_contacts_or_new_lists_is_no_test() {
    let (_folder, still) = other_program("--time 1e-5", "");
    let output = matrix(&[&still], "dense");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("is no test"), "{said}");
}
