//! The README keeps its word: links lead somewhere, sessions are what the program prints.

use std::path::Path;

use assert_cmd::Command;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn readme() -> String {
    std::fs::read_to_string(root().join("README.md")).unwrap()
}

#[test]
fn every_link_of_the_documents_leads_to_a_file() {
    let mut seen = 0;
    for name in ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"] {
        let text = std::fs::read_to_string(root().join(name)).unwrap();
        for target in text.split("](").skip(1).map(|rest| rest.split(')').next().unwrap()) {
            if !target.starts_with("http") {
                assert!(root().join(target).exists(), "{name}: {target}");
                seen += 1;
            }
        }
    }
    assert!(seen > 15, "{seen}");
}

#[test]
fn every_file_that_the_documents_name_exists() {
    for name in ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"] {
        let text = std::fs::read_to_string(root().join(name)).unwrap();
        let words = text.split(|c: char| c.is_whitespace() || "`(),;".contains(c));
        for word in words.filter(|word| {
            ["src/", "tests/", "plot/", "examples/", "docs/"]
                .iter()
                .any(|folder| word.starts_with(folder))
                && word.contains('.')
        }) {
            let path = word.trim_end_matches(['.', ':']);
            assert!(root().join(path).exists(), "{name}: {path}");
        }
    }
}

#[test]
fn sessions_are_what_the_program_prints() {
    // Blocks that begin with `$ cargo run -- ...`; lines with times and speeds are the machine's.
    let readme = readme();
    let mut seen = 0;
    for block in readme.split("```text\n").skip(1).map(|rest| rest.split("```").next().unwrap()) {
        let (command, shown) = block.split_once('\n').unwrap();
        let Some(arguments) = command.strip_prefix("$ cargo run -- ") else { continue };
        let folder = tempfile::tempdir().unwrap();
        let output = Command::cargo_bin("parsim2d")
            .unwrap()
            .current_dir(&folder)
            .args(arguments.split_whitespace())
            .output()
            .unwrap();
        let printed = [output.stderr, output.stdout].concat();
        let printed = String::from_utf8(printed).unwrap();
        let steady = |text: &str| {
            let lines = text.lines().filter(|line| !line.starts_with("speed "));
            lines.map(str::to_owned).collect::<Vec<_>>()
        };
        assert_eq!(steady(&printed), steady(shown), "{command}");
        seen += 1;
    }
    assert_eq!(seen, 4);
}
