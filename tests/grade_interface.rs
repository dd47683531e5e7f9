//! Unit tests of a student's header, as the rubric's `[interface]` describes them: the example of the guide to grading.
#![cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]

use std::fs;
use std::path::Path;

use crate::support::handed_in;

use handed_in::{can_grade, grade, hand_in};
use parsim2d::grading::judge::rubric::Rubric;

/// The guide from these words to the end of their block of code.
fn block(page: &str, first: &str) -> String {
    let from = page.find(first).unwrap_or_else(|| panic!("{first} is not in the page"));
    let rest = &page[from..];
    rest[..rest.find("\n```").unwrap()].to_owned() + "\n"
}

fn page() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/grading.md")).unwrap()
}

const RIGHT: &str = "#include \"particle.h\"\n#include <cmath>\n\
    Vec contactForce(const Particle &a, const Particle &b, double kn, double eta) {\n\
    double dx = a.position.x - b.position.x, dy = a.position.y - b.position.y;\n\
    double d = std::sqrt(dx * dx + dy * dy), overlap = a.radius + b.radius - d;\n\
    if (overlap <= 0) return {0, 0};\n\
    double nx = dx / d, ny = dy / d;\n\
    double vn = (a.velocity.x - b.velocity.x) * nx + (a.velocity.y - b.velocity.y) * ny;\n\
    double f = kn * overlap - eta * vn;\n\
    return {f * nx, f * ny};\n}\n";

/// What is said of a submission with this `particle.cpp` and header, by the rubric of the guide.
fn said_of(particle: &str, header: &str, probe: &str, more: &str) -> (Option<i32>, String) {
    let place = tempfile::tempdir().unwrap();
    let (folder, course) = (place.path().join("Ada"), place.path().join("course"));
    let makefile = "parSim2D:\n\tg++ -o parSim2D simulation.cpp\n";
    let simulation =
        "#include <fstream>\nint main() { std::ofstream(\"out.txt\") << \"0.02 0.02 5e-4\\n\"; }\n";
    let files = [("Makefile", makefile), ("particle.h", header), ("particle.cpp", particle)];
    hand_in(&folder, &files);
    // A file of the probe's name is of no use to who hands it in.
    hand_in(
        &folder,
        &[("simulation.cpp", simulation), ("probe.cpp", "int main() { return 0; }\n")],
    );
    let rubric = block(&page(), "[interface]\nprobe");
    let program = "[program]\nwarnings = []\nsanitizer = []\nframes_at_least = 1\n";
    hand_in(&course, &[("course.toml", &format!("{program}{rubric}{more}")), ("probe.cpp", probe)]);
    let rubric = course.join("course.toml");
    let graded = grade(&[folder.to_str().unwrap(), "--rubric", rubric.to_str().unwrap()]);
    let said = [graded.stdout, graded.stderr].concat();
    (graded.status.code(), String::from_utf8_lossy(&said).into_owned())
}

#[test]
fn the_contact_force_of_the_guides_example_is_told_right_from_wrong() {
    if !can_grade() {
        return;
    }
    let page = page();
    let (header, probe) = (block(&page, "// particle.h"), block(&page, "// probe.cpp"));
    let header = format!("#pragma once\n{header}");
    let attracts = RIGHT.replace("return {f * nx, f * ny};", "return {-f * nx, -f * ny};");
    let pumps = RIGHT.replace("- eta * vn", "+ eta * vn");
    // Discs that do not touch are not pushed: who forgets that pulls.
    let pulls = RIGHT.replace("if (overlap <= 0) return {0, 0};", "");
    let talks = RIGHT.replace("double nx", "puts(\"overlap 7\"); double nx");
    let talks = format!("#include <cstdio>\n{talks}");
    let crashes = RIGHT.replace("double nx", "__builtin_trap(); double nx");
    let renamed = RIGHT.replace("contactForce", "contact_force");
    let cases = [
        (RIGHT, ":) interface: ", ""),
        (&talks, ":) interface: ", ""),
        (&attracts, "[interface_wrong]", "case: two discs that overlap by 1e-4 m, at rest"),
        (&pumps, "came out: -2.94\n    should be: -3.06\n", "case: the same, aslant"),
        (&pulls, "came out: 5\n    should be: 0\n", "case: two discs that do not touch"),
        (&crashes, "ended with an error, or not in its time", "case: two discs that overlap"),
        (&renamed, "[interface_missing]", "contactForce"),
    ];
    for (particle, said, case) in cases {
        let (code, all) = said_of(particle, &header, &probe, "");
        assert_eq!(code, Some(0), "{all}");
        assert!(all.contains(said) && all.contains(case), "{said:?}, {case:?} are not in\n{all}");
    }
    let (_, all) = said_of(&attracts, &header, &probe, "");
    let shown = block(&page, ":( interface: ");
    assert!(all.contains(&shown), "docs/grading.md should show a part of\n{all}");
}

#[test]
fn a_probe_that_prints_too_little_or_cannot_be_built_here_is_no_number() {
    if !can_grade() {
        return;
    }
    let page = page();
    let header = format!("#pragma once\n{}", block(&page, "// particle.h"));
    let silent = "#include \"particle.h\"\nint main() {}\n";
    let (_, all) = said_of(RIGHT, &header, silent, "");
    assert!(all.contains("numbers printed: 0\n    numbers expected: 2\n"), "{all}");
    // The instructor's compiler is missing: that is nobody's loss.
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("Ada");
    hand_in(&folder, &[("Makefile", "parSim2D:\n\ttouch parSim2D\n")]);
    let rubric = "[program]\nfiles = ['Makefile']\n[interface]\nprobe = 'probe.cpp'\nbuild = ['no-such-compiler']\n\
        run = ['./probe']\n[[interface.case]]\nname = 'a'\nstdin = ''\nexpected = [1.0]\n";
    hand_in(place.path(), &[("course.toml", rubric), ("probe.cpp", silent)]);
    let rubric = place.path().join("course.toml");
    let graded = grade(&[folder.to_str().unwrap(), "--rubric", rubric.to_str().unwrap()]);
    let said = String::from_utf8_lossy(&graded.stderr);
    assert_eq!(graded.status.code(), Some(3), "{said}");
    assert!(said.contains("no-such-compiler"), "{said}");
}

#[test]
fn a_rubric_with_a_probe_elsewhere_or_cases_that_decide_nothing_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let course = place.path().join("course");
    hand_in(&course, &[("probe.cpp", "int main() {}\n"), ("out.txt", "")]);
    hand_in(place.path(), &[("probe.cpp", "int main() {}\n")]);
    std::os::unix::fs::symlink("../probe.cpp", course.join("linked.cpp")).unwrap();
    let absolute = place.path().join("probe.cpp");
    let with = |probe: &str, more: &str| {
        format!(
            "[interface]\nprobe = {probe:?}\nbuild = ['make']\nrun = ['./probe']\n[[interface.case]]\n\
             name = 'a'\nstdin = ''\n{more}"
        )
    };
    let right = "expected = [1.0]";
    let cases = [
        (with("probe.cpp", right), 0, ""),
        (with("../probe.cpp", right), 2, "the probe lies in the rubric's folder"),
        (with(absolute.to_str().unwrap(), right), 2, "the probe lies in the rubric's folder"),
        (with("linked.cpp", right), 2, "the probe lies in the rubric's folder"),
        (with("nowhere.cpp", right), 2, "interface.probe = \"nowhere.cpp\": No such file"),
        (with("probe.cpp", "expected = []"), 2, "expected = [] of the case \"a\""),
        (with("probe.cpp", "expected = [nan]"), 2, "expected = [NaN] of the case \"a\""),
        (with("probe.cpp", "expected = [1]\ntolerance = 0.0"), 2, "tolerance = 0 of the case"),
    ];
    for (rubric, code, said) in cases {
        hand_in(&course, &[("course.toml", &rubric)]);
        let out = course.join("out.txt");
        let rubric_file = course.join("course.toml");
        let graded =
            grade(&["--frames", out.to_str().unwrap(), "--rubric", rubric_file.to_str().unwrap()]);
        let why = String::from_utf8_lossy(&graded.stderr);
        assert_eq!(graded.status.code(), Some(code), "{rubric}\n{why}");
        assert!(why.contains(said), "{rubric}\n{why}");
    }
}

#[test]
fn the_example_that_init_rubric_leaves_commented_out_is_a_rubric() {
    let text = parsim2d::grading::judge::rubric::COMMENTED;
    let from = text.find("# [interface]\n").unwrap();
    let example: String =
        text[from..].lines().map(|line| line.replacen("# ", "", 1) + "\n").collect();
    let rubric = Rubric::parse(&example).unwrap();
    assert_eq!(rubric.interface.unwrap().case[0].expected, [-5.0, 0.0]);
    assert!(Rubric::parse(text).unwrap().interface.is_none());
}
