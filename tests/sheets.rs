//! What is written from graded submissions, held to what each reader expects: key by key and type by type,
//! by real parsers, and with a submission that tries to forge its grade.

use std::fs;
use std::path::Path;
use std::process::Output;

use assert_cmd::Command;
use parsim2d::grading::feedback::check50::check50;
use parsim2d::grading::feedback::class::html_of_class;
use parsim2d::grading::feedback::classroom50::{Classroom, classroom50, utc};
use parsim2d::grading::feedback::codegrade::codegrade;
use parsim2d::grading::feedback::csv::csv_of_class;
use parsim2d::grading::feedback::gradescope::gradescope;
use parsim2d::grading::feedback::json::{json_of_class, json_of_student};
use parsim2d::grading::feedback::junit::junit;
use parsim2d::grading::feedback::student::html_of_student;
use parsim2d::grading::feedback::survey::mistakes;
use parsim2d::grading::feedback::text::{text_of_class, text_of_student};
use parsim2d::grading::feedback::vpl::vpl;
use parsim2d::grading::feedback::words::ENGLISH;
use parsim2d::grading::feedback::{Entry, Graded, Ungraded};
use parsim2d::grading::judge::check::Check;
use parsim2d::grading::judge::mistake::Mistake;
use parsim2d::grading::judge::rubric::{Rubric, Visibility};
use parsim2d::grading::judge::verdict::{Failure, Report, Status};
use parsim2d::grading::judge::words::{Finding, Quantity};
use serde_json::{Value, json};

/// What a submission may print to be taken for something else.
const HOSTILE: &str = "</pre><script>alert(1)</script><img src=x onerror=alert(1)>\u{1b}[2J\u{1b}]0;x\u{7}\n\
    Grade :=>> 100\n--|>\nGrade :=>> 100\r\nx\rGrade :=>> 100\u{2028}Grade :=>> 100\u{b}Grade :=>> 100\n\
    Comment :=>> all right\n]]>&amp;\u{0}\u{ffff}\u{202e}' onload=\"x\"";

use crate::support::runs;

use runs::names as files;

fn rubric(text: &str) -> Rubric {
    Rubric::parse(text).unwrap()
}

/// A whole submission: the checks up to `builds` passed, and `failed` after them.
fn graded(rubric: &Rubric, failed: &[(Check, Failure)]) -> Graded {
    let mut report = Report::of_submission(rubric);
    for check in Check::ALL {
        let failure = failed.iter().find(|(known, _)| *known == check);
        let status = match failure {
            Some((_, failure)) => Status::Failed(failure.clone()),
            None if check == Check::RestitutionPair => Status::NotSeen,
            None => Status::Passed,
        };
        report.decide(check, || status);
    }
    let mut graded = Graded::new("Rossi, Mario", "submissions/Rossi, Mario", report);
    graded.tier = "A: bubblewrap".to_owned();
    graded.seconds = 1.5;
    graded
}

fn euler() -> Failure {
    Failure::of(Finding::EnergyGrows, Mistake::ExplicitEuler)
        .at(399, &[])
        .with(Quantity::EnergyChange, 5.5607)
}

/// Everything in it is hostile, the hint of the rubric too.
fn hostile() -> Graded {
    let mut hints = String::from("[hints]\ndoes_not_build = '''");
    hints += &HOSTILE.replace(['\0', '\u{1b}', '\u{7}', '\r', '\u{b}', '\u{ffff}'], "");
    let rubric = rubric(&(hints.replace("' onload", " onload") + "'''"));
    let mut graded = graded(&rubric, &[(Check::Builds, Failure::does_not_build(HOSTILE))]);
    graded.name = HOSTILE.to_owned();
    graded.tier = HOSTILE.to_owned();
    graded.log = HOSTILE.to_owned();
    graded
}

/// One of each kind: right, wrong, partial credit, hostile, does not build, one that could not be graded.
fn class() -> Vec<Entry> {
    let usual = Rubric::default();
    let kept = rubric(
        "[partial]\nexplicit_euler = 0.5\n[visibility]\nbox = 'hidden'\nstart = 'after_due_date'",
    );
    let start = Failure::of(Finding::StartsOverlapping, Mistake::PlacedOverlapping).at(0, &[3, 7]);
    let lost = rubric("skipped = 'lost'");
    let mut formula = graded(&usual, &[(Check::Start, start)]);
    formula.name = "=HYPERLINK(\"http://x\";\"y\")".to_owned();
    vec![
        Ok(graded(&usual, &[])),
        Ok(formula),
        Ok(graded(&kept, &[(Check::Energy, euler())])),
        Ok(hostile()),
        Ok(graded(&lost, &[(Check::Builds, Failure::does_not_build("a.cpp:1: error"))])),
        Ok(graded(&usual, &[(Check::Warnings, Failure::warned("unused <x>"))])),
        Err(Ungraded { name: HOSTILE.to_owned(), why: HOSTILE.to_owned() }),
    ]
}

fn all() -> Vec<Graded> {
    class().into_iter().flatten().collect()
}

/// The same while checks are still to come: after the first `k`.
fn partial(graded: &Graded, k: usize) -> Graded {
    let mut part = graded.clone();
    part.report.checks.truncate(k);
    part.is_partial = true;
    part
}

/// Holds an object to `key: type` lines; `?` marks a key that may be missing, `|` separates words that a
/// string may be. No other key may be there.
fn hold(value: &Value, shape: &[&str]) {
    let object = value.as_object().unwrap_or_else(|| panic!("no object: {value}"));
    let mut known = Vec::new();
    for line in shape {
        let (key, kind) = line.split_once(": ").unwrap();
        let (key, is_optional) = (key.trim_end_matches('?'), key.ends_with('?'));
        known.push(key);
        let Some(value) = object.get(key) else {
            assert!(is_optional, "{key} is missing in {value}");
            continue;
        };
        let holds = match kind {
            "string" => value.is_string(),
            "number" => value.is_number(),
            "whole" => value.is_u64(),
            "bool" => value.is_boolean(),
            "bool or null" => value.is_boolean() || value.is_null(),
            "string or null" => value.is_string() || value.is_null(),
            "object" => value.is_object(),
            "object or null" => value.is_object() || value.is_null(),
            "array" => value.is_array(),
            "strings" => value.as_array().is_some_and(|all| all.iter().all(Value::is_string)),
            words => value.as_str().is_some_and(|text| words.split('|').any(|word| word == text)),
        };
        assert!(holds, "{key} is no {kind}: {value}");
    }
    for key in object.keys() {
        assert!(known.contains(&key.as_str()), "{key} is not in the specification");
    }
}

fn close(a: f64, b: f64) {
    assert!(
        (a - b).abs() < 1e-5,
        "{a} is not {b}: scores are rounded to six decimals, 17 of them add up"
    );
}

/// The text of a document, parsed again: what a platform gets.
fn reread(value: &Value) -> Value {
    serde_json::from_str(&value.to_string()).unwrap()
}

/// <https://gradescope-autograders.readthedocs.io/en/latest/specs/>
const GRADESCOPE: [&str; 11] = [
    "score?: number",
    "execution_time?: number",
    "output?: string",
    "output_format?: text|html|simple_format|md|ansi",
    "test_output_format?: text|html|simple_format|md|ansi",
    "test_name_format?: text|html|simple_format|md|ansi",
    "visibility?: hidden|after_due_date|after_published|visible",
    "stdout_visibility?: hidden|after_due_date|after_published|visible",
    "extra_data?: object",
    "tests?: array",
    "leaderboard?: array",
];
const GRADESCOPE_TEST: [&str; 11] = [
    "score?: number",
    "max_score?: number",
    "status?: passed|failed",
    "name?: string",
    "name_format?: text|html|simple_format|md|ansi",
    "number?: string",
    "output?: string",
    "output_format?: text|html|simple_format|md|ansi",
    "tags?: strings",
    "visibility?: hidden|after_due_date|after_published|visible",
    "extra_data?: object",
];

#[test]
fn gradescope_gets_what_its_specification_says_at_any_moment() {
    for graded in all() {
        for k in 0..=graded.report.checks.len() {
            let results = reread(&gradescope(&partial(&graded, k), &ENGLISH));
            hold(&results, &GRADESCOPE);
            let tests = results["tests"].as_array().unwrap();
            assert_eq!(tests.len(), k);
            tests.iter().for_each(|value| hold(value, &GRADESCOPE_TEST));
            let earned = partial(&graded, k).report.earned();
            close(results["score"].as_f64().unwrap(), earned);
        }
        hold(&reread(&gradescope(&graded, &ENGLISH)), &GRADESCOPE);
    }
}

#[test]
fn gradescope_scores_read_back_are_the_points_of_the_report() {
    for graded in all() {
        let results = reread(&gradescope(&graded, &ENGLISH));
        let tests = results["tests"].as_array().unwrap();
        let sum = |key: &str| tests.iter().filter_map(|test| test[key].as_f64()).sum::<f64>();
        let report = &graded.report;
        close(sum("score"), report.earned());
        close(sum("max_score"), report.earned() + report.lost());
        let whole = report.earned() + report.lost() + report.open();
        close(results["score"].as_f64().unwrap(), report.percent() / 100.0 * whole);
        let with_score = tests.iter().filter(|test| test.get("score").is_some());
        for test in with_score {
            let is_full = test["score"] == test["max_score"];
            assert_eq!(test["status"] == "passed", is_full, "{test}");
        }
    }
    let all = class();
    let kept = gradescope(all[2].as_ref().unwrap(), &ENGLISH);
    let of = |id: &str| {
        let tests = kept["tests"].as_array().unwrap();
        tests.iter().find(|test| test["extra_data"]["id"] == id).unwrap().clone()
    };
    assert_eq!(
        (of("energy")["score"].as_f64(), of("energy")["max_score"].as_f64()),
        (Some(1.0), Some(2.0))
    );
    assert_eq!(of("energy")["extra_data"]["cause"], "explicit_euler");
    assert_eq!(
        [&of("box")["visibility"], &of("start")["visibility"]],
        ["hidden", "after_due_date"]
    );
    assert!(of("restitution_pair").get("score").is_none(), "not seen: no points");
}

/// <https://github.com/foundation50/classroom50/wiki/Advanced-Autograding>
const CLASSROOM: [&str; 12] = [
    "schema: classroom50/result/v1",
    "classroom: string",
    "assignment: string",
    "submission: string",
    "commit: string",
    "release: string",
    "review: string",
    "datetime: string",
    "graded_at: string",
    "score: whole",
    "max-score: whole",
    "tests: array",
];
const CLASSROOM_TEST: [&str; 4] =
    ["test-name: string", "passed: bool", "score: whole", "max-score: whole"];

#[test]
fn classroom_50_gets_whole_numbers_that_sum_and_a_hundred_only_for_everything() {
    let classroom = Classroom {
        commit: "https://example.org/commit".to_owned(),
        submission: "submit/2026-06-01T14-32-05Z-a1b2c3d".to_owned(),
        datetime: utc(1_790_000_000),
        ..Classroom::default()
    };
    for graded in all() {
        let result = reread(&classroom50(&graded, &classroom, &ENGLISH));
        hold(&result, &CLASSROOM);
        let tests = result["tests"].as_array().unwrap();
        tests.iter().for_each(|value| hold(value, &CLASSROOM_TEST));
        let report = &graded.report;
        let (score, most) =
            (result["score"].as_u64().unwrap(), result["max-score"].as_u64().unwrap());
        assert_eq!((most, score == 100), (100, report.lost() == 0.0));
        let lost = report.failures().count() as f64 + 1.0; // each check is rounded by less than one
        assert!((score as f64 - report.percent()).abs() < lost, "{score} {}", report.percent());
        let sum = |key: &str| tests.iter().map(|test| test[key].as_u64().unwrap()).sum::<u64>();
        assert_eq!((sum("score"), sum("max-score")), (score, most), "hidden checks count as well");
        let shown = result["tests"].to_string();
        let usual = |check: &Check| report.rubric().visibility_of(*check) == Visibility::Visible;
        for (check, status) in report.checks.iter().filter(|(_, s)| *s == Status::Passed) {
            assert_eq!(shown.contains(&format!("\"{}: ", check.id())), usual(check), "{status:?}");
        }
    }
    assert_eq!(utc(1_790_000_000), "2026-09-21T14:13:20Z");
}

#[test]
fn junit_is_xml_whose_counts_are_right() {
    let entries = class();
    let text = junit(&entries, &ENGLISH);
    let document = roxmltree::Document::parse(&text).unwrap();
    let suites: Vec<_> =
        document.root_element().children().filter(|node| node.has_tag_name("testsuite")).collect();
    assert_eq!(suites.len(), entries.len());
    for (suite, entry) in suites.iter().zip(&entries) {
        let cases: Vec<_> = suite.children().filter(|n| n.has_tag_name("testcase")).collect();
        let count = |tag: &str| {
            cases
                .iter()
                .filter(|case| case.children().any(|n| n.has_tag_name(tag)))
                .count()
                .to_string()
        };
        assert_eq!(suite.attribute("tests").unwrap(), cases.len().to_string());
        for (key, tag) in [("failures", "failure"), ("errors", "error"), ("skipped", "skipped")] {
            assert_eq!(suite.attribute(key).unwrap(), count(tag), "{key}");
        }
        for case in &cases {
            assert!(case.attribute("name").is_some() && case.attribute("classname").is_some());
        }
        assert!(suite.attribute("time").unwrap().parse::<f64>().is_ok());
        assert_eq!(entry.is_err(), count("error") == "1");
    }
    let failure =
        document.descendants().find(|node| node.attribute("type") == Some("explicit_euler"));
    assert!(failure.unwrap().text().unwrap().contains("updated with the old velocity"));
}

#[test]
fn vpl_reads_one_grade_the_last_line_whatever_a_submission_prints() {
    for graded in all() {
        let text = vpl(&graded, [0.0, 10.0], &ENGLISH);
        let lines: Vec<&str> =
            text.split(['\n', '\r', '\u{b}', '\u{c}', '\u{85}', '\u{2028}']).collect();
        let tag = |line: &&str| line.trim_start().to_lowercase().starts_with("grade :=>>");
        let grades: Vec<&&str> = lines.iter().filter(|line| tag(line)).collect();
        let expected = format!("Grade :=>> {}", (10.0 * graded.report.percent()).round() / 100.0);
        assert_eq!(grades, [&expected.as_str()]);
        assert!(text.ends_with(&format!("{expected}\n")));
        for mark in ["<|--", "--|>"] {
            assert_eq!(lines.iter().filter(|line| line.trim() == mark).count(), 1, "{text}");
        }
        let comments = lines.iter().filter(|line| line.starts_with("Comment :=>>"));
        assert_eq!(comments.count(), 1, "{text}");
        let inside = lines.iter().skip(2).take_while(|line| **line != "--|>");
        assert!(inside.clone().all(|line| line.starts_with(['>', '-'])), "{text}");
    }
}

#[test]
fn check50_and_codegrade_get_their_shapes() {
    let shape = ["slug: string", "results: array", "version: string"];
    let result = [
        "name: string",
        "description: string",
        "passed: bool or null",
        "log: strings",
        "cause: object or null",
        "data: object",
        "dependency: string or null",
    ];
    for graded in all() {
        let value = reread(&check50(&graded, &ENGLISH));
        hold(&value, &shape);
        let results = value["results"].as_array().unwrap();
        results.iter().for_each(|value| hold(value, &result));
        for value in results {
            let check = Check::named(value["name"].as_str().unwrap()).unwrap();
            let expected = match graded.report.status(check).unwrap() {
                Status::Passed => json!(true),
                Status::Failed(_) => json!(false),
                Status::NotSeen | Status::Skipped(_) | Status::Masked => Value::Null,
            };
            assert_eq!((&value["passed"], value["cause"].is_null()), (&expected, expected == true));
        }
        let points: Value = serde_json::from_str(&codegrade(&graded)).unwrap();
        hold(&points, &["tag: points", "points: string"]);
        let part: f64 = points["points"].as_str().unwrap().parse().unwrap();
        // Cut to four decimals.
        assert!((0.0..1e-4 + 1e-9).contains(&(graded.report.percent() / 100.0 - part)), "{part}");
    }
}

#[test]
fn csv_reads_back_with_every_cell_in_its_column_and_no_formula() {
    let entries = class();
    let text = csv_of_class(&entries);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let head = reader.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), entries.len());
    let cell = |row: usize, name: &str| {
        rows[row][head.iter().position(|column| column == name).unwrap()].to_owned()
    };
    for (k, entry) in entries.iter().enumerate() {
        for value in rows[k].iter() {
            assert!(!value.starts_with(['=', '+', '-', '@', '\t', '\r']), "{value}");
            assert!(!value.contains(['\n', '\r', '\u{1b}']), "{value:?}");
        }
        let Ok(graded) = entry else {
            assert!(cell(k, "percent").is_empty() && !cell(k, "not_graded").is_empty());
            continue;
        };
        let number = |name: &str| cell(k, name).parse::<f64>().unwrap_or(0.0);
        close(number("earned"), graded.report.earned());
        close(number("lost"), graded.report.lost());
        close(number("open"), graded.report.open());
        close(Check::ALL.iter().map(|check| number(check.id())).sum(), graded.report.earned());
    }
    assert_eq!(cell(0, "name"), "Rossi, Mario");
    assert!(cell(1, "name").starts_with("'=HYPERLINK("), "{}", cell(1, "name"));
    assert_eq!(cell(2, "causes"), "explicit_euler");
    assert_eq!(cell(1, "start"), "0", "lost is not the same as not judged");
    assert_eq!((cell(2, "energy"), cell(2, "restitution_pair")), ("1".into(), String::new()));
}

/// A page as XML: every tag closed, every attribute quoted, all text escaped.
fn well_formed(page: &str) -> String {
    let page = page.strip_prefix("<!doctype html>\n").unwrap();
    let mut parts = page.split("<meta ");
    let begin = parts.next().unwrap().to_owned();
    parts.fold(begin, |xml, part| xml + "<meta " + &part.replacen('>', "/>", 1))
}

#[test]
fn pages_are_well_formed_and_bring_no_element_and_no_address_of_a_submission() {
    const KNOWN: &str = "html head meta title style body h1 h2 h3 p div span section article strong \
        dl dt dd pre table thead tbody tr th td a figure figcaption svg rect circle line text g path \
        polyline defs clipPath";
    let known: Vec<&str> = KNOWN.split_whitespace().collect();
    let entries = class();
    let files: Vec<String> = (0..entries.len()).map(|k| format!("Rossi {k} <>&\"")).collect();
    let class_page = html_of_class(&entries, &files, &ENGLISH);
    let pages = all().iter().map(|graded| html_of_student(graded, &ENGLISH)).collect::<Vec<_>>();
    for page in pages.iter().chain([&class_page]) {
        let xml = well_formed(page);
        let document =
            roxmltree::Document::parse(&xml).unwrap_or_else(|why| panic!("{why}\n{page}"));
        for node in document.descendants().filter(|node| node.is_element()) {
            assert!(known.contains(&node.tag_name().name()), "{:?}", node.tag_name());
            for attribute in node.attributes() {
                assert!(!attribute.name().starts_with("on") && attribute.name() != "src");
                let is_link = attribute.name() == "href";
                assert!(!is_link || attribute.value().starts_with("Rossi%20"), "{attribute:?}");
            }
        }
        let outside = page.replace("http://www.w3.org/2000/svg", "");
        let text: String = document.descendants().filter_map(|node| node.text()).collect();
        assert!(!outside.contains("url(") && !outside.contains("@import"));
        assert!(!page.contains(['\u{1b}', '\u{202e}', '\0']) && !text.is_empty());
    }
    assert!(pages[3].contains("&lt;script&gt;alert(1)"), "it is shown as text");
    // On a narrow page they move aside, and no word is cut.
    assert_eq!(class_page.matches("<div class=\"wide\"><table>").count(), 2, "{class_page}");
    assert!(class_page.contains("does_not_build") && class_page.contains("2 of 6"), "{class_page}");
}

#[test]
fn a_sheet_says_what_is_wrong_what_it_looks_like_how_it_was_graded_and_stays_kind() {
    let pages: Vec<String> = all().iter().map(|graded| html_of_student(graded, &ENGLISH)).collect();
    for part in [
        "the energy of all discs grows; frame 399",
        "5.561",
        "updated with the old velocity",
        "which velocity moves the disc",
        "1 of 2 points",
        "time that grading took, s",
        "parsim2d 0.",
        "0.04",
        "It costs no points.",
        "can be judged only when this is right: energy is never made.",
        "checks that count and are not shown: 1",
    ] {
        assert!(pages[2].contains(part), "{part:?} is not in\n{}", pages[2]);
    }
    assert!(!pages[2].contains("bubblewrap"), "how it was kept apart is for instructors");
    let hidden = "id=\"box\"";
    assert!(pages[0].contains(hidden) && !pages[2].contains(hidden), "the rubric hides it");
    assert!(pages[2].contains("id=\"start\""), "handed back after the due date");
    let part = html_of_student(&partial(&all()[0], 5), &ENGLISH);
    assert!(part.contains("Grading has not ended") && !pages[0].contains("Grading has not ended"));
}

#[test]
fn our_own_json_has_stable_keys_for_a_submission_and_for_a_class() {
    let shape = [
        "schema: parsim2d/grade/v1",
        "percent: number",
        "earned: number",
        "lost: number",
        "open: number",
        "frames: whole",
        "discs: whole",
        "torn_frames: whole",
        "uneven_frames: whole",
        "notes: array",
        "checks: array",
        "version: string",
        "name: string",
        "file: string",
        "tier: string or null",
        "log: string",
        "seconds: number",
        "partial: bool",
    ];
    for graded in all() {
        hold(&reread(&json_of_student(&graded, true, &ENGLISH)), &shape);
    }
    let class = reread(&json_of_class(&class(), &ENGLISH));
    hold(
        &class,
        &[
            "schema: parsim2d/class/v1",
            "version: string",
            "median_percent: number",
            "mistakes: array",
            "submissions: array",
            "not_graded: array",
        ],
    );
    assert_eq!(
        class["mistakes"][0],
        json!({"cause": "does_not_build", "checks": ["builds"], "submissions": 2})
    );
    assert_eq!(class["submissions"].as_array().unwrap().len(), 6);
}

#[test]
fn a_mistake_seen_in_two_checks_is_one_of_a_submission() {
    let lost = |check| (check, Failure::of(Finding::WrongRestitution, Mistake::RestitutionWrong));
    let both = graded(&Rubric::default(), &[Check::WallBounce, Check::PairCollision].map(lost));
    let one = graded(&Rubric::default(), &[lost(Check::WallBounce)]);
    let found = mistakes(&[Ok(one), Ok(both)]);
    let checks = vec![Check::WallBounce, Check::PairCollision];
    assert_eq!(found, [(Some(Mistake::RestitutionWrong), checks, 2)]);
}

#[test]
fn per_cent_are_cut_alike_everywhere_and_one_submission_is_no_submissions() {
    // 2999 of 3000 points are no full marks: 99.9, and not 100.
    let rubric = rubric("[points]\nfree_flight = 2977.0\nrestitution_pair = 0\n");
    let almost = graded(&rubric, &[(Check::Radii, euler())]);
    let sum = almost.report.percent();
    assert!((99.95..100.0).contains(&sum), "{sum}");
    let entries = [Ok(almost.clone())];
    for (what, said) in [
        ("text", text_of_student(&almost, &ENGLISH)),
        ("page", html_of_student(&almost, &ENGLISH)),
        ("class", text_of_class(&entries, &ENGLISH)),
        ("class page", html_of_class(&entries, &[], &ENGLISH)),
    ] {
        assert!(said.contains("99.9") && !said.contains("(100 %)"), "{what}: {said}");
    }
    let [one, two] = [1, 2].map(|n| html_of_class(&vec![entries[0].clone(); n], &[], &ENGLISH));
    assert!(one.contains(">1 submission;") && two.contains(">2 submissions;"), "{one}");
}

#[test]
fn a_terminal_gets_no_codes_from_a_submission() {
    let text = text_of_class(&class(), &ENGLISH) + &text_of_student(&hostile(), &ENGLISH);
    assert!(!text.contains(['\u{1b}', '\u{7}', '\r', '\0', '\u{202e}']), "{text:?}");
    assert_eq!(text_of_class(&class(), &ENGLISH).lines().count(), 8, "a line each, and the head");
}

/// Two discs that fall and never meet anybody: as many frames as a film has to have.
fn falling() -> String {
    let frame = |k: i32| {
        let y = 0.03 - 1e-5 * f64::from(k * k);
        format!("0.01 {y:.9} 5e-4\n0.03 {y:.9} 5e-4\n\n")
    };
    (0..20).map(frame).collect()
}

fn grade(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::cargo_bin("parsim2d").unwrap();
    command.current_dir(folder).arg("grade").args(arguments).output().unwrap()
}

#[test]
fn a_class_gets_a_folder_of_sheets_and_a_bad_file_stops_nobody() {
    let folder = tempfile::tempdir().unwrap();
    let names = ["a b.txt", "<img src=x onerror=alert(1)>.txt", "$(touch owned) \"&`.txt"];
    for name in names {
        fs::write(folder.path().join(name), falling()).unwrap();
    }
    let mut arguments = vec!["--frames"];
    arguments.extend(names);
    arguments.extend(["nowhere.txt", "--out-dir", "done", "--format", "gradescope", "-j", "3"]);
    let output = grade(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("error: nowhere.txt cannot be read"), "{said}");
    assert!(said.contains("[4/4]"), "{said}");
    let stems = ["a_b.txt", "img_src_x_onerror_alert_1_.txt", "touch_owned_.txt"];
    let endings = ["gradescope.json", "html", "json"];
    let mut expected: Vec<String> =
        stems.iter().flat_map(|stem| endings.map(|ending| format!("{stem}.{ending}"))).collect();
    expected.extend(["class.csv", "class.html", "class.json"].map(str::to_owned));
    expected.sort();
    assert_eq!(files(&folder.path().join("done")), expected, "nothing temporary is left");
    let table = String::from_utf8(output.stdout).unwrap();
    assert_eq!(table.lines().count(), 5, "{table}");
    let page = fs::read_to_string(folder.path().join("done/class.html")).unwrap();
    for stem in stems {
        assert!(page.contains(&format!("href=\"{stem}.html\"")), "{page}");
    }
    assert_eq!(files(folder.path()).len(), names.len() + 1, "nobody touched anything else");
}

#[test]
fn formats_go_to_standard_output_or_to_one_file_and_what_does_not_fit_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.txt"), falling()).unwrap();
    fs::write(folder.path().join("b.txt"), "").unwrap();
    let cases: [(&str, i32, &str); 12] = [
        ("--frames a.txt --format gradescope", 0, "\"max_score\": 1.0"),
        ("--frames a.txt --format classroom50", 0, "classroom50/result/v1"),
        ("--frames a.txt --format junit", 0, "<testsuite name=\"a.txt\""),
        ("--frames a.txt b.txt --format junit", 0, "<testsuite name=\"b.txt\""),
        ("--frames a.txt --format vpl", 0, "\nGrade :=>> 100\n"),
        ("--frames a.txt --format html", 0, "<h1>Graded: a.txt</h1>"),
        ("--frames a.txt b.txt --format html", 0, "<h1>The class</h1>"),
        ("--frames a.txt b.txt --format csv --fail-under 50", 1, "b.txt,0,0,17,"),
        ("--frames a.txt b.txt --format vpl", 2, "--out-dir"),
        ("--frames a.txt --format vpl --format csv", 2, "--out-dir"),
        ("--frames a.txt --format word", 2, "possible values"),
        ("--frames nowhere.txt --format gradescope", 3, "nowhere.txt cannot be read"),
    ];
    for (arguments, code, part) in cases {
        let output = grade(folder.path(), &arguments.split_whitespace().collect::<Vec<_>>());
        let said = [output.stdout.as_slice(), b"\n", &output.stderr].concat();
        let said = String::from_utf8(said).unwrap();
        assert_eq!(output.status.code(), Some(code), "{arguments}\n{said}");
        assert!(said.contains(part), "{arguments}: {part:?} is not in\n{said}");
    }
    let unreadable = grade(folder.path(), &["--frames", "nowhere.txt", "--format", "gradescope"]);
    assert!(unreadable.stdout.is_empty(), "no score of 0 for what is not the student's fault");
    let out = ["--frames", "a.txt", "--format", "gradescope", "--out", "results.json"];
    assert!(grade(folder.path(), &out).status.success());
    let results = fs::read(folder.path().join("results.json")).unwrap();
    let results: Value = serde_json::from_slice(&results).unwrap();
    assert!(results["tests"].as_array().unwrap().len() > 5);
    assert_eq!(files(folder.path()), ["a.txt", "b.txt", "results.json"]);
}

#[test]
fn vpl_takes_its_scale_from_the_environment() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.txt"), falling()).unwrap();
    for (low, high, code, part) in
        [("0", "30", 0, "Grade :=>> 30\n"), ("1", "much", 2, "VPL_GRADEMAX=much is not a number")]
    {
        let mut command = Command::cargo_bin("parsim2d").unwrap();
        command.env("VPL_GRADEMIN", low).env("VPL_GRADEMAX", high).current_dir(&folder);
        let output =
            command.args(["grade", "--frames", "a.txt", "--format", "vpl"]).output().unwrap();
        let said = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        assert_eq!(output.status.code(), Some(code), "{said}");
        assert!(said.contains(part), "{said}");
    }
}
