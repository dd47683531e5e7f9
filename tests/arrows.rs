//! The arrows between the rooms go one way: who may `use crate::` whom.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::imports::{Sources, circles};

/// Which rooms each room may know. A room is a file or folder of `src/`, or of `src/grading/`.
const ARROWS: [(&str, &[&str]); 33] = [
    ("named", &[]),
    ("number", &[]),
    ("table", &[]),
    ("particle", &[]),
    ("boundary", &[]),
    ("field", &["particle"]),
    ("wall", &["force"]),
    ("pair", &["particle", "boundary"]),
    ("neighbours", &["particle"]),
    ("integrator", &["particle"]),
    ("force", &["particle"]),
    ("work", &["particle"]),
    ("placement", &["particle", "neighbours"]),
    ("discs", &["particle", "force", "integrator", "work"]),
    (
        "simulation",
        &["particle", "neighbours", "force", "integrator", "discs", "placement", "work"],
    ),
    (
        "engine",
        &[
            "particle",
            "boundary",
            "field",
            "wall",
            "pair",
            "neighbours",
            "force",
            "integrator",
            "work",
            "discs",
            "simulation",
        ],
    ),
    ("analysis", &["named", "number", "particle", "neighbours", "work", "simulation"]),
    ("output", &["echo", "number", "simulation", "analysis"]),
    (
        "scenario",
        &[
            "echo",
            "named",
            "number",
            "particle",
            "neighbours",
            "integrator",
            "force",
            "placement",
            "discs",
            "engine",
            "simulation",
            "analysis",
            "output",
        ],
    ),
    ("session", &["simulation", "analysis", "output", "scenario"]),
    ("figure", &["named", "number", "particle", "neighbours", "force", "analysis", "output"]),
    ("page", &["number", "table", "analysis", "output", "figure", "scenario"]),
    ("echo", &[]),
    ("grading::sandbox", &["named", "table"]),
    ("grading::judge", &["named", "table", "analysis", "figure"]),
    (
        "grading::feedback",
        &["named", "number", "table", "grading::judge", "figure", "output", "page"],
    ),
    ("grading::pipeline", &["grading::sandbox", "grading::judge", "grading::feedback"]),
    ("grading::validation", &["grading::judge"]),
    ("grading", &[]),
    (
        "cli",
        &[
            "echo",
            "named",
            "number",
            "scenario",
            "session",
            "simulation",
            "analysis",
            "output",
            "figure",
            "page",
            "grading::sandbox",
            "grading::judge",
            "grading::feedback",
            "grading::pipeline",
            "grading::validation",
        ],
    ),
    ("allocator", &[]),
    ("main", &[]),
    ("lib", &[]),
];

/// The outside crates that the physics may know; files and formats, clap and clocks may not.
const PHYSICS: [&str; 14] = [
    "particle",
    "boundary",
    "field",
    "wall",
    "pair",
    "neighbours",
    "integrator",
    "force",
    "work",
    "placement",
    "discs",
    "engine",
    "simulation",
    "analysis",
];
const PHYSICS_CRATES: [&str; 8] =
    ["std", "glam", "wide", "rand", "rand_pcg", "thiserror", "serde", "crate"];

#[test]
fn no_two_files_import_each_other_in_a_circle() {
    let imports = Sources::below(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src")).imports();
    let count: usize = imports.values().map(|targets| targets.len()).sum();
    assert!(
        count > 1000,
        "only {count} imports were found: does this test still read the sources?"
    );
    if let Some(circle) = circles(&imports).first() {
        let arrows = circle.iter().map(|file| {
            let others = imports[file].intersection(circle).map(|other| other.join("/"));
            format!("\n  {} imports {}", file.join("/"), others.collect::<Vec<_>>().join(", "))
        });
        panic!("files import each other in a circle:{}", arrows.collect::<String>());
    }
}

#[test]
fn arrows_go_one_way() {
    let allowed: BTreeMap<&str, &[&str]> = ARROWS.into();
    let mut seen = 0;
    for (room, path, word) in uses() {
        let Some(target) = word.strip_prefix("crate::") else {
            continue;
        };
        let target = room_named(target);
        if target == room {
            continue;
        }
        seen += 1;
        let may = allowed.get(room.as_str()).unwrap_or_else(|| panic!("no arrows for room {room}"));
        assert!(may.contains(&target.as_str()), "{} uses crate::{target}", path.display());
    }
    assert!(seen > 20, "only {seen} arrows were found: does this test still read the sources?");
}

#[test]
fn paths_in_the_text_follow_the_arrows_too() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let allowed: BTreeMap<&str, &[&str]> = ARROWS.into();
    let mut seen = 0;
    for path in files_below(&source) {
        let room = room_of(&path, &source);
        let text = fs::read_to_string(&path).unwrap();
        let code = text.lines().map(str::trim).filter(|line| !line.starts_with("//"));
        for word in code.flat_map(|line| line.split("crate::").skip(1)) {
            let target = room_named(word);
            let may = allowed.get(room.as_str()).is_some_and(|may| may.contains(&target.as_str()));
            assert!(may || target == room, "{} names crate::{target}", path.display());
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}

#[test]
fn physics_knows_no_files_formats_or_command_line() {
    for (room, path, word) in uses().filter(|(room, ..)| PHYSICS.contains(&room.as_str())) {
        let outside = word.split("::").next().unwrap().trim_end_matches(';');
        let local = ["super", "self"].contains(&outside);
        assert!(
            local || PHYSICS_CRATES.contains(&outside),
            "{} ({room}) uses {outside}",
            path.display()
        );
        for forbidden in ["std::fs", "std::io", "std::time", "std::net", "std::env"] {
            assert!(!word.starts_with(forbidden), "{} uses {word}", path.display());
        }
    }
}

/// The room that `path` belongs to.
fn room_of(path: &Path, source: &Path) -> String {
    let inside = path.strip_prefix(source).unwrap().with_extension("");
    let parts: Vec<_> = inside.iter().map(|part| part.to_str().unwrap()).collect();
    room_named(&parts.join("::"))
}

/// The room that a path (what follows `crate::`) leads into.
fn room_named(path: &str) -> String {
    let mut names =
        path.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|name| !name.is_empty());
    match (names.next().unwrap(), names.next()) {
        (house @ "grading", Some(room)) => format!("{house}::{room}"),
        (room, _) => room.to_owned(),
    }
}

/// Every `use` line of `src/`: its room, its file, and what it uses.
fn uses() -> impl Iterator<Item = (String, PathBuf, String)> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = files_below(&source);
    files.into_iter().flat_map(move |path| {
        let room = room_of(&path, &source);
        let text = fs::read_to_string(&path).unwrap();
        let lines: Vec<_> = text
            .lines()
            .filter_map(|line| line.trim().strip_prefix("pub ").or(Some(line.trim())))
            .filter_map(|line| line.strip_prefix("use "))
            .map(|word| (room.clone(), path.clone(), word.to_owned()))
            .collect();
        lines
    })
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries
        .flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] })
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .collect()
}
