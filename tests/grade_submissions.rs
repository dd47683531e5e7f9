//! Submissions of which it is known what is wrong with them are built, run and judged: `grade --proof`.
//!
//! The short form takes every right program and some of each kind of the others; all of them, right ones
//! with five seeds, by `make proof` (PARSIM2D_PROOF=all).
#![cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::support::handed_in;

use handed_in::{can_grade, corpus, grade};

/// Of each stage at which a submission can go wrong, and of each kind of harm.
const SHORT: [&str; 24] = [
    "wrong/no_makefile",
    "wrong/does_not_build",
    "wrong/makefile_builds_another_name",
    "wrong/crashes",
    "wrong/ends_without_frames",
    "wrong/another_file_name",
    "wrong/rows_run_together",
    "wrong/sorted_in_place",
    "wrong/diameter_written",
    "wrong/floor_missing",
    "wrong/overlap_not_checked",
    "wrong/gravity_sign",
    "wrong/friction_in_flight",
    "wrong/wall_at_centre",
    "wrong/force_on_one_disc_only",
    "wrong/damping_sign_pair",
    "wrong/explicit_euler",
    "wrong/room_for_100_discs",
    "wrong/compiler_warns",
    "wrong/reads_past_the_end",
    "hostile/fork_bomb",
    "hostile/fake_result",
    "hostile/out_is_a_link",
    "hostile/leaves_a_child",
];

#[test]
fn submissions_with_known_mistakes_lose_the_right_points_for_the_right_reason() {
    if !can_grade() {
        return;
    }
    let is_whole = std::env::var("PARSIM2D_PROOF").is_ok_and(|which| which == "all");
    let mut runs = vec![("1", vec!["right", "wrong", "hostile"])];
    if is_whole {
        runs.extend(["2", "3", "4", "5"].map(|seed| (seed, vec!["right"])));
    } else {
        runs = vec![("1", ["right"].into_iter().chain(SHORT).collect())];
    }
    for (seed, which) in runs {
        let graded = grade(&[&["--proof", "--seed", seed], &which[..]].concat());
        let said = String::from_utf8_lossy(&graded.stdout);
        let table = said.split("\nsubmission ").nth(1).unwrap_or(&said);
        println!("seed {seed}\nsubmission {table}");
        assert_eq!(
            graded.status.code(),
            Some(0),
            "{table}{}",
            String::from_utf8_lossy(&graded.stderr)
        );
    }
    for left in ["results.json", "outside.txt"] {
        assert!(!corpus().join(left).exists(), "a submission wrote {left} outside its folder");
    }
}

#[test]
fn folders_are_graded_by_a_rubric_and_leave_a_page_each_and_tables_of_the_class() {
    if !can_grade() {
        return;
    }
    let place = tempfile::tempdir().unwrap();
    for (name, from) in [("Ada", "right/verlet"), ("Bob <b>", "right/one_file")] {
        let folder = place.path().join("class").join(name);
        fs::create_dir_all(&folder).unwrap();
        for file in fs::read_dir(corpus().join(from)).unwrap().map(Result::unwrap) {
            if file.file_name() != "submission.toml" {
                fs::copy(file.path(), folder.join(file.file_name())).unwrap();
            }
        }
    }
    let rubric = place.path().join("course.toml");
    let text =
        "eta = 0\n[program]\narguments = ['{n}', '{seed}', '{frames}']\nmany = 0\nsanitizer = []";
    fs::write(&rubric, text).unwrap();
    let [ada, bob] = ["Ada", "Bob <b>"].map(|name| place.path().join("class").join(name));
    let [ada, bob, rubric] = [&ada, &bob, &rubric].map(|path| path.to_str().unwrap());
    let done = place.path().join("done");
    let graded = grade(&[
        ada,
        bob,
        "--rubric",
        rubric,
        "--out-dir",
        done.to_str().unwrap(),
        "--fail-under",
        "50",
    ]);
    let said = String::from_utf8_lossy(&graded.stdout);
    let why = String::from_utf8_lossy(&graded.stderr);
    assert_eq!(graded.status.code(), Some(1), "{said}{why}"); // one is below 50 per cent
    let csv = fs::read_to_string(done.join("class.csv")).unwrap();
    let row = |name: &str| csv.lines().find(|line| line.contains(name)).unwrap();
    assert!(row("Ada").contains("100"), "{csv}");
    assert!(row("Bob").contains("no_makefile"), "{csv}");
    let page = fs::read_to_string(done.join("class.html")).unwrap();
    assert!(!page.contains("Bob <b>"), "a name is not markup");
}

#[test]
fn files_that_are_open_when_the_grader_starts_do_not_reach_submissions() {
    if !can_grade() {
        return;
    }
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("curious");
    fs::create_dir(&folder).unwrap();
    fs::write(
        folder.join("Makefile"),
        "parSim2D: simulation.cpp\n\tg++ -o parSim2D simulation.cpp\n",
    )
    .unwrap();
    let program = "#include <cstdio>\n#include <cerrno>\n#include <unistd.h>\n\
        int main() { char b[9]; for (int fd = 3; fd < 200; fd++) \
        if (read(fd, b, 9) >= 0 || errno != EBADF) printf(\"open: %d\\n\", fd); \
        printf(\"looked\\n\"); return 3; }";
    fs::write(folder.join("simulation.cpp"), program).unwrap();
    let rubric = place.path().join("course.toml");
    fs::write(&rubric, "[program]\nfiles = ['Makefile']\nwarnings = []\nsanitizer = []").unwrap();
    // A duplicate stays open in programs that are started.
    let secret = fs::File::open(&rubric).unwrap();
    let left_open = nix::unistd::dup(&secret).unwrap();
    let graded = grade(&[folder.to_str().unwrap(), "--rubric", rubric.to_str().unwrap()]);
    drop(left_open);
    let said = String::from_utf8_lossy(&graded.stdout);
    assert!(said.contains("looked") && !said.contains("open:"), "{said}");
}

#[test]
fn a_proof_of_folders_that_describe_nothing_is_refused_with_a_way_out() {
    let place = tempfile::tempdir().unwrap();
    fs::create_dir(place.path().join("Ada")).unwrap();
    fs::write(place.path().join("Ada/Makefile"), "all:\n").unwrap();
    let folder = place.path().to_str().unwrap();
    // With nothing else, beside one that is described, a file alone, and nothing of that name.
    for which in [&[folder][..], &["right/euler", folder], &["README.md"], &["nobody"]] {
        let refused = grade(&[&["--proof"], which].concat());
        let why = String::from_utf8_lossy(&refused.stderr);
        assert_eq!(refused.status.code(), Some(2), "{which:?}: {why}");
        assert!(why.contains("submission.toml") && why.contains("way out"), "{why}");
        assert!(refused.stdout.is_empty(), "{}", String::from_utf8_lossy(&refused.stdout));
    }
}

#[test]
fn an_interrupted_proof_leaves_no_folder_and_others_could_not_look_into_it() {
    use std::os::unix::fs::PermissionsExt;
    if !can_grade() {
        return;
    }
    let temporary = tempfile::tempdir().unwrap();
    let folders = || fs::read_dir(temporary.path()).unwrap().map(|entry| entry.unwrap().path());
    let mut proof = Command::new(env!("CARGO_BIN_EXE_parsim2d"))
        .args(["grade", "--proof", "wrong/takes_for_ever"])
        .current_dir(corpus())
        .env("TMPDIR", temporary.path())
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .unwrap();
    // Its description is laid out in one folder, built and run in another.
    let is_running = || {
        let holds = |inner: &str| folders().any(|folder| folder.join(inner).exists());
        holds("work/0/takes_for_ever/Makefile") && holds("work/parSim2D")
    };
    for _ in 0..3000 {
        if is_running() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    assert!(is_running(), "not within a minute: {:?}", folders().collect::<Vec<_>>());
    for folder in folders() {
        let name = folder.file_name().unwrap().to_str().unwrap().to_owned();
        assert!(!name.contains(&proof.id().to_string()), "{name} can be guessed");
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
        assert_eq!((mode(&folder), mode(&folder.join("work"))), (0o711, 0o700), "{name}");
    }
    let pid = nix::unistd::Pid::from_raw(proof.id() as i32);
    nix::sys::signal::kill(pid, nix::sys::signal::Signal::SIGINT).unwrap();
    assert_eq!(proof.wait().unwrap().code(), Some(130));
    assert_eq!(folders().collect::<Vec<_>>(), Vec::<PathBuf>::new());
}
