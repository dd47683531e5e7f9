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
fn every_test_that_the_makefile_asks_for_by_name_is_there() {
    let makefile = std::fs::read_to_string(root().join("Makefile")).unwrap();
    let asked = makefile.split("--test all ").skip(1).map(|rest| rest.split(' ').next().unwrap());
    let asked: Vec<_> = asked.map(|name| name.split_once("::").unwrap()).collect();
    assert!(asked.len() >= 3, "{asked:?}");
    for (file, name) in asked {
        let path = root().join(format!("tests/{file}.rs"));
        let tests = std::fs::read_to_string(path).unwrap();
        assert!(
            tests.contains(&format!("fn {name}")),
            "no test of tests/{file}.rs begins so: {name}"
        );
    }
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

/// Whether `text`, a Rust file, defines `name`: a function or type, or as `Type::function` one within an `impl`
/// of that type.
fn defines(text: &str, name: &str) -> bool {
    // The word after `kind` in a line, as the name of a function after `fn`.
    let named = |line: &str, kind: &str| {
        let rest = line.split(kind).nth(1)?;
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
        Some(rest[..end].to_owned())
    };
    let has = |line: &str, kind: &str, word: &str| named(line, kind).is_some_and(|n| n == word);
    let Some((of, function)) = name.split_once("::") else {
        let kinds = ["fn ", "struct ", "trait "];
        return text.lines().any(|line| kinds.iter().any(|kind| has(line, kind, name)));
    };
    let blocks = text.split("\nimpl").skip(1);
    let mut blocks = blocks.map(|block| block.split("\n}").next().unwrap());
    blocks.any(|block| {
        let (head, body) = block.split_once('\n').unwrap_or((block, "")); // `impl A for B {}`
        let is_of = has(head, " for ", of) || has(head, " ", of) && !head.contains(" for ");
        is_of && body.lines().any(|line| has(line, "fn ", function))
    })
}

#[test]
fn what_the_reading_path_names_is_found_in_the_file_it_names() {
    assert!(defines("struct A;\n\nimpl<L> B for A<L> {\n    fn f() {}\n}\n", "A::f"));
    assert!(!defines("\nimpl A {\n}\nimpl B {\n    fn f() {}\n}\n", "A::f"));
    assert!(!defines("fn g() {} // f\n", "f"));

    let readme = readme();
    // Rows of tables that link to a source: of the guide's equations, and of the order to read in.
    let (mut seen, mut order) = (0, Vec::new());
    for row in readme.lines().filter(|line| line.starts_with('|') && line.contains("](src/")) {
        let files: Vec<&str> =
            row.split("](").skip(1).map(|rest| rest.split(')').next().unwrap()).collect();
        let texts: Vec<String> =
            files.iter().map(|file| std::fs::read_to_string(root().join(file)).unwrap()).collect();
        for name in row.split('`').skip(1).step_by(2) {
            assert!(texts.iter().any(|text| defines(text, name)), "{name} is not in {files:?}");
            seen += 1;
        }
        if row.as_bytes()[2].is_ascii_digit() {
            order.push(files[0].trim_start_matches("src/").trim_end_matches(".rs").to_owned());
        }
    }
    assert!(seen >= 14, "{seen}");
    assert_eq!(order, ["particle", "simulation", "integrator", "force"]);

    // The library says the same order.
    let library = std::fs::read_to_string(root().join("src/lib.rs")).unwrap();
    let path = library.split("Reading order").nth(1).unwrap().split("Then").next().unwrap();
    let rooms = path.split("[`").skip(1).map(|rest| rest.split("`]").next().unwrap());
    let rooms: Vec<&str> = rooms.filter(|room| !room.contains("::")).collect();
    assert_eq!(rooms, order);
}
