//! The recipes of `docs/grading-platforms.md`, run as they stand there in a tree like the platform's.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// The first block of `language` after a line that begins with `heading`.
fn block(heading: &str, language: &str, k: usize) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/grading-platforms.md");
    let text = fs::read_to_string(path).unwrap();
    let below = text.split_once(&format!("\n{heading}\n")).unwrap().1;
    let block = below.split(&format!("\n```{language}\n")).nth(k + 1).unwrap();
    block.split_once("\n```\n").unwrap().0.to_owned() + "\n"
}

fn write_script(path: &Path, text: &str) {
    fs::write(path, text).unwrap();
    fs::set_permissions(path, fs::Permissions::from_mode(0o755)).unwrap();
}

/// Two discs that fall and never meet anybody: as many frames as a film has to have.
fn falling() -> String {
    let frame = |k: i32| {
        let y = 0.03 - 1e-5 * f64::from(k * k);
        format!("0.01 {y:.9} 5e-4\n0.03 {y:.9} 5e-4\n\n")
    };
    (0..20).map(frame).collect()
}

/// The program and a rubric beside each other.
fn take_along(folder: &Path) {
    symlink(env!("CARGO_BIN_EXE_parsim2d"), folder.join("parsim2d")).unwrap();
    fs::write(folder.join("course.toml"), "n = [2]\n").unwrap();
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&[output.stdout.as_slice(), &output.stderr].concat()).into_owned()
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}

#[test]
fn gradescopes_script_leaves_results_and_none_if_grading_did_not_work() {
    let tree = tempfile::tempdir().unwrap();
    let at = |name: &str| tree.path().join(name);
    for folder in ["source", "submission"] {
        fs::create_dir(at(folder)).unwrap();
    }
    take_along(&at("source"));
    write_script(&at("run_autograder"), &block("## Gradescope", "bash", 1));
    let run = || {
        let mut command = Command::new(at("run_autograder"));
        command.current_dir(tree.path()).env("AUTOGRADER", tree.path()).output().unwrap()
    };
    let results = at("results/results.json");
    let output = run();
    assert_eq!(output.status.code(), Some(3), "nothing handed in: {}", said(&output));
    assert!(!results.exists());
    for (frames, least, most) in [(falling(), 11.0, 17.0), (String::new(), 0.0, 0.0)] {
        fs::write(at("submission/out.txt"), frames).unwrap();
        let output = run();
        assert!(output.status.success(), "{}", said(&output));
        let score = json(&results)["score"].as_f64().unwrap();
        assert!((least..=most).contains(&score), "{score}");
        assert_eq!(fs::read_dir(at("results")).unwrap().count(), 1);
    }
    fs::write(at("source/course.toml"), "n = two").unwrap();
    assert_eq!(run().status.code(), Some(2));
    assert!(!results.exists(), "an older one would be taken for this one's");
}

#[test]
fn what_is_there_if_gradescopes_script_is_killed_is_legal() {
    let script = block("## Gradescope", "bash", 1);
    let line = script.lines().find(|line| line.starts_with("printf")).unwrap();
    let text = line.split('\'').nth(3).unwrap();
    let value: Value = serde_json::from_str(text).unwrap();
    assert_eq!((&value["score"], value["tests"].as_array().unwrap().len()), (&Value::from(0), 0));
}

#[test]
fn classroom_50s_autograder_writes_the_result_beside_the_student_s_files() {
    let tree = tempfile::tempdir().unwrap();
    let bundle = tree.path().join("bundle");
    let checkout = tree.path().join("checkout");
    fs::create_dir(&bundle).unwrap();
    fs::create_dir(&checkout).unwrap();
    fs::write(bundle.join("course.toml"), "n = [2]\n").unwrap();
    fs::copy(env!("CARGO_BIN_EXE_parsim2d"), bundle.join("parsim2d")).unwrap();
    fs::write(bundle.join("autograder.py"), block("## Classroom 50", "python", 0)).unwrap();
    fs::write(checkout.join("result.json"), "{\"score\": 100}").unwrap();
    let run = || {
        let mut command = Command::new("python3");
        command.arg(bundle.join("autograder.py")).current_dir(&checkout);
        command.env("CLASSROOM", "physics").env("ASSIGNMENT", "discs");
        command.env("SUBMISSION_TAG", "submit/2026-06-01T14-32-05Z-a1b2c3d");
        command.env("COMMIT_URL", "https://example.org/c").output()
    };
    let Ok(output) = run() else {
        eprintln!("skipped: no python3 here");
        return;
    };
    assert_eq!(output.status.code(), Some(3), "{}", said(&output));
    assert!(!checkout.join("result.json").exists(), "one that was handed in counts for nothing");
    fs::write(checkout.join("out.txt"), falling()).unwrap();
    let output = run().unwrap();
    assert!(output.status.success(), "{}", said(&output));
    let result = json(&checkout.join("result.json"));
    assert_eq!((&result["score"], &result["max-score"]), (&100.into(), &100.into()));
    assert_eq!(
        (&result["classroom"], &result["datetime"]),
        (&"physics".into(), &"2026-06-01T14:32:05Z".into())
    );
    assert_eq!(result["review"], "https://example.org/c");
}

#[test]
fn vpls_script_makes_an_execution_that_prints_one_grade() {
    let tree = tempfile::tempdir().unwrap();
    take_along(tree.path());
    let at = |name: &str| tree.path().join(name);
    fs::write(at("vpl_environment.sh"), "VPL_GRADEMIN=0\nVPL_GRADEMAX=30\n").unwrap();
    write_script(&at("vpl_evaluate.sh"), &block("## Moodle VPL", "bash", 0));
    let run = |name: &str| Command::new(at(name)).current_dir(tree.path()).output().unwrap();
    assert!(run("vpl_evaluate.sh").status.success());
    let nothing = said(&run("vpl_execution"));
    assert!(nothing.contains("not your fault") && !nothing.contains("Grade :=>>"), "{nothing}");
    fs::write(at("out.txt"), falling()).unwrap();
    let graded = said(&run("vpl_execution"));
    assert!(graded.ends_with("Grade :=>> 30\n"), "{graded}");
}

#[test]
fn every_script_is_one_that_bash_understands() {
    let scripts = [("## Gradescope", 0), ("## Gradescope", 1), ("## Moodle VPL", 0)];
    let tree = tempfile::tempdir().unwrap();
    for (heading, k) in scripts {
        let script = block(heading, "bash", k);
        let path = tree.path().join("script");
        write_script(&path, &script);
        let output = Command::new("bash").arg("-n").arg(&path).output().unwrap();
        assert!(output.status.success(), "{script}\n{}", said(&output));
    }
}
