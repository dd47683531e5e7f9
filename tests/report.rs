//! The report of a run: one page that holds together without network, and shows what the run wrote.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use parsim2d::page::words::ENGLISH;
use tempfile::TempDir;

fn parsim2d(folder: &Path, arguments: &[&str]) -> assert_cmd::assert::Assert {
    Command::cargo_bin("parsim2d").unwrap().current_dir(folder).args(arguments).assert()
}

fn report_of(arguments: &[&str], code: i32) -> (TempDir, String) {
    let folder = TempDir::new().unwrap();
    parsim2d(folder.path(), arguments).code(code);
    parsim2d(folder.path(), &["report"]).success();
    let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
    (folder, page)
}

/// A page is an HTML file whose elements close and which loads nothing.
fn assert_whole(page: &str) {
    assert!(page.starts_with("<!doctype html>\n<html lang=\"en\">"));
    assert!(page.ends_with("</html>\n"));
    for tag in ["html", "head", "body", "style", "svg", "figure", "table", "dl", "ul", "pre", "div"]
    {
        let opened =
            page.matches(&format!("<{tag}>")).count() + page.matches(&format!("<{tag} ")).count();
        assert_eq!(opened, page.matches(&format!("</{tag}>")).count(), "{tag}");
    }
    let links = ["src=", "@import", "url(http", "<script", "<link", "<iframe"];
    for link in links {
        assert!(!page.contains(link), "{link}");
    }
    let addresses = page.matches("http").count();
    assert_eq!(addresses, page.matches("http://www.w3.org/2000/svg").count(), "an address");
    // Every name that is used is given once on the whole page.
    let ids: Vec<&str> =
        page.split(" id=\"").skip(1).map(|s| s.split('"').next().unwrap()).collect();
    let mut once = ids.clone();
    once.sort_unstable();
    once.dedup();
    assert_eq!(ids.len(), once.len());
}

#[test]
fn a_report_shows_what_a_run_was_and_what_came_of_it() {
    let (folder, page) =
        report_of(&["-n", "30", "--radius", "5e-4", "--seed", "4", "--time", "50ms"], 0);
    assert_whole(&page);
    let headings = [
        ENGLISH.how_to_repeat,
        ENGLISH.results,
        ENGLISH.diagnosis,
        ENGLISH.energy,
        ENGLISH.frames,
        ENGLISH.speeds,
        ENGLISH.parameters,
        ENGLISH.data,
    ];
    let mut rest = page.as_str();
    for heading in headings {
        let at = rest.find(&format!("<h2>{heading}</h2>")).unwrap_or_else(|| panic!("{heading}"));
        rest = &rest[at..];
    }
    assert_eq!(page.matches("<svg ").count(), 4);
    let typed = "parsim2d -n 30 --radius 5e-4 --seed 4 --time 50ms";
    assert!(page.contains(&format!("<code>{typed}</code>")));
    assert!(page.contains("seed = 4") && page.contains(env!("CARGO_PKG_VERSION")));
    for file in ["trajectory.txt", "energy.csv", "out.txt", "last-run.toml"] {
        assert!(page.contains(&format!("<a href=\"{file}\">")), "{file}");
        assert!(folder.path().join(file).exists());
    }
    // Discs of the first and of the last frame.
    assert!(page.matches("<circle ").count() >= 60);
    // The same run, the same page.
    let again = report_of(&["-n", "30", "--radius", "5e-4", "--seed", "4", "--time", "50ms"], 0).1;
    assert_eq!(page, again);
}

#[test]
fn the_run_that_a_report_names_is_the_same_run() {
    let (folder, page) =
        report_of(&["-n", "5", "--seed", "9", "--time", "10ms", "--gravity", "3"], 0);
    let hash = |folder: &Path| {
        let text = fs::read_to_string(folder.join("last-run.toml")).unwrap();
        text.lines().find(|line| line.contains("state_hash")).unwrap().to_owned()
    };
    let first = hash(folder.path());
    parsim2d(folder.path(), &["last-run.toml"]).success();
    assert_eq!(hash(folder.path()), first);
    assert!(page.contains(first.split(" = ").nth(1).unwrap()));
}

#[test]
fn a_run_that_went_wrong_is_reported_with_its_failure() {
    let (_folder, page) = report_of(&["--kn", "500", "--seed", "1"], 1);
    assert_whole(&page);
    assert!(page.contains(&format!("<h2>{}</h2>", ENGLISH.failure)));
    assert!(page.contains("<dt>parameter at fault</dt><dd>--kn</dd>"));
    assert!(page.contains("<dt>its value</dt><dd>500</dd>"));
}

#[test]
fn a_run_that_overflowed_is_reported_up_to_its_last_whole_frame() {
    let lesson = ["--eta", "1.5e3", "--allow-unstable", "--seed", "1", "--time", "0.5"];
    let (_folder, page) = report_of(&lesson, 0);
    assert_whole(&page);
    assert!(page.contains(ENGLISH.cut) && page.contains("<dd>--eta</dd>"));
    let (_folder, page) = report_of(&["--time", "0", "--seed", "1"], 0);
    assert_whole(&page);
}

#[test]
fn one_disc_has_theory_beside_measurement_and_no_histogram() {
    let (_folder, page) = report_of(&["-n", "1", "--radius", "5e-4", "--seed", "1"], 0);
    assert_whole(&page);
    assert!(page.contains(&format!("<h2>{}</h2>", ENGLISH.answer)));
    assert!(page.contains("<td>restitution</td>") && page.contains(ENGLISH.no_speeds));
}

#[test]
fn runs_with_little_to_show_are_reported_too() {
    let still = ["-n", "3", "--gravity", "0", "--seed", "1", "--time", "1ms"];
    let (_folder, page) = report_of(&still, 0);
    assert_whole(&page);
    assert!(page.contains(ENGLISH.no_speeds));
    let (_folder, page) = report_of(&["--energy-every", "0", "--seed", "1", "--time", "1ms"], 0);
    assert_whole(&page);
    assert!(page.contains(ENGLISH.no_energy));
}

#[test]
fn what_a_user_typed_cannot_break_the_page() {
    let folder = TempDir::new().unwrap();
    let evil = "<script>alert('x')<!-- &.toml";
    fs::write(folder.path().join(evil), "n = 2\ntime = '1ms'\n").unwrap();
    parsim2d(folder.path(), &[evil, "--seed", "1"]).success();
    parsim2d(folder.path(), &["report"]).success();
    let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert_whole(&page);
    assert!(page.contains("&lt;script&gt;alert("));
}

#[test]
fn a_page_elsewhere_has_no_links_that_lead_nowhere() {
    let folder = TempDir::new().unwrap();
    let elsewhere = TempDir::new().unwrap();
    parsim2d(folder.path(), &["--time", "1ms", "--seed", "1"]).success();
    let out = elsewhere.path().join("page.html");
    parsim2d(folder.path(), &["report", "-o", out.to_str().unwrap()]).success();
    let page = fs::read_to_string(out).unwrap();
    assert_whole(&page);
    assert!(!page.contains("<a href"));
}

#[test]
fn a_run_from_a_frame_is_repeated_without_that_file() {
    let folder = TempDir::new().unwrap();
    let first = ["-n", "4", "--radius", "5e-4", "--seed", "3", "--time", "5ms"];
    parsim2d(folder.path(), &first).success();
    let hash = || {
        let text = fs::read_to_string(folder.path().join("last-run.toml")).unwrap();
        text.lines().find(|line| line.contains("state_hash")).unwrap().to_owned()
    };
    let start = folder.path().join("start.txt");
    fs::rename(folder.path().join("out.txt"), &start).unwrap();
    let again = ["--start", "start.txt", "--time", "5ms", "--seed", "3"];
    parsim2d(folder.path(), &again).success();
    fs::remove_file(start).unwrap();
    let started = hash();
    parsim2d(folder.path(), &["last-run.toml"]).success();
    assert_eq!(hash(), started);
}

#[test]
fn a_record_that_no_run_wrote_is_not_replaced() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("last-run.toml"), "# mine\nn = 3\n").unwrap();
    let assert = parsim2d(folder.path(), &["--time", "1ms"]).code(2);
    let message = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(message.contains("was not written by a run"), "{message}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn without_a_run_there_is_no_report() {
    let folder = TempDir::new().unwrap();
    for (arguments, part) in [
        (&["report"][..], "last-run.toml tells of no run"),
        (&["report", "no/such/folder"], "last-run.toml tells of no run"),
        (&["report", "-o", "report.pdf"], "the report is a .html file"),
    ] {
        let assert = parsim2d(folder.path(), arguments).code(2);
        let message = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
        assert!(message.contains(part) && message.contains("way out"), "{message}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0, "{arguments:?}");
    }
}
