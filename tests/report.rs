//! The report of a run: one page that holds together without network, and shows what the run wrote.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use parsim2d::page::gas::NoGas;
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
    for tag in [
        "html", "head", "body", "style", "svg", "figure", "table", "dl", "div", "section",
        "canvas", "button", "script", "span",
    ] {
        let opened =
            page.matches(&format!("<{tag}>")).count() + page.matches(&format!("<{tag} ")).count();
        assert_eq!(opened, page.matches(&format!("</{tag}>")).count(), "{tag}");
    }
    let links = ["src=", "@import", "url(http", "<link", "<iframe", " onload=", " onerror="];
    for link in links {
        assert!(!page.contains(link), "{link}");
    }
    assert!(page.contains("content=\"default-src 'none'; style-src 'unsafe-inline'; script-src"));
    // The frames and what plays them, and no other script.
    let scripts: Vec<&str> = page.split("<script").skip(1).collect();
    assert_eq!(scripts.len(), 2);
    assert!(scripts[0].starts_with(" type=\"application/json\" id=\"film\">{"));
    assert!(scripts[1].contains(include_str!("../src/page/player.js")));
    let addresses = page.matches("://").count();
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
        ENGLISH.player_heading,
        ENGLISH.parameters,
        ENGLISH.results,
        ENGLISH.own_words,
        ENGLISH.diagnosis,
        ENGLISH.energy,
        ENGLISH.frames,
        ENGLISH.velocity,
        ENGLISH.speeds,
    ];
    let mut rest = page.as_str();
    for heading in headings {
        let at = rest.find(&format!("<h2>{heading}</h2>")).unwrap_or_else(|| panic!("{heading}"));
        rest = &rest[at..];
    }
    assert_eq!(page.matches("<svg ").count(), 6);
    assert!(page.matches("class=\"arrow\"").count() >= 20);
    let typed = "parsim2d -n 30 --radius 5e-4 --seed 4 --time 50ms";
    assert!(page.contains(&format!("<code>{typed}</code>")));
    assert!(page.contains("<dt>seed</dt><dd>4</dd>") && page.contains(env!("CARGO_PKG_VERSION")));
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
fn the_command_of_a_report_repeats_a_run_whose_seed_was_drawn() {
    for typed in ["-n 5 --time 10ms", "-n 5 --time 10ms --seed=77", "mine.toml"] {
        let elsewhere = TempDir::new().unwrap();
        let folder = TempDir::new().unwrap();
        for folder in [&folder, &elsewhere] {
            fs::write(folder.path().join("mine.toml"), "n = 4\ntime = '5ms'\n").unwrap();
        }
        parsim2d(folder.path(), &typed.split(' ').collect::<Vec<_>>()).success();
        parsim2d(folder.path(), &["report"]).success();
        let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
        let command = page.split("<code>").nth(1).unwrap().split("</code>").next().unwrap();
        let words: Vec<&str> = command.split(' ').skip(1).collect();
        assert_eq!(command.matches("--seed").count(), 1, "{command}");
        parsim2d(elsewhere.path(), &words).success();
        let [frames, again] = [&folder, &elsewhere]
            .map(|folder| fs::read(folder.path().join("trajectory.txt")).unwrap());
        assert!(frames == again, "{command}");
    }
}

#[test]
fn maxwells_curve_stands_only_beside_a_gas_in_equilibrium() {
    let gas = "-n 60 --radius 5e-4 --seed 1 --gravity 0 --speed 0.5 --restitution 1 --time 0.3";
    let cases = [
        ("", ENGLISH.maxwell),
        ("-n 20", (ENGLISH.no_maxwell)(NoGas::Few)),
        ("--restitution 0.5", (ENGLISH.no_maxwell)(NoGas::Cooling)),
        ("--no-walls", (ENGLISH.no_maxwell)(NoGas::Open)),
        // All begin with one speed, and have not met.
        ("--time 10ms", (ENGLISH.no_maxwell)(NoGas::Sparse)),
        // A fall from rest, to the floor.
        ("--gravity 9.81 --speed 0 --time 60ms", (ENGLISH.no_maxwell)(NoGas::Unsteady)),
        ("--energy-every 0", (ENGLISH.no_maxwell)(NoGas::Unknown)),
        ("mixed.toml", (ENGLISH.no_maxwell)(NoGas::Unlike)),
    ];
    for (change, said) in cases {
        let folder = TempDir::new().unwrap();
        let two = "[[population]]\nn = 30\n[[population]]\nn = 30\nmass = '2g'\n";
        fs::write(folder.path().join("mixed.toml"), two).unwrap();
        let changed: Vec<&str> = change.split_whitespace().collect();
        // What is changed is said once; a file says itself how many discs there are.
        let is_replaced =
            |flag: &str| changed.contains(&flag) || flag == "-n" && change == "mixed.toml";
        let words: Vec<&str> = gas.split(' ').collect();
        let kept = words.chunks(2).filter(|pair| !is_replaced(pair[0])).flatten().copied();
        let arguments: Vec<&str> = kept.chain(changed.iter().copied()).collect();
        parsim2d(folder.path(), &arguments).success();
        parsim2d(folder.path(), &["report"]).success();
        let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
        let said = maud::html! { (said) }.into_string();
        assert!(page.contains(&said), "{change}");
        assert_eq!(page.contains("Maxwell, 2D"), change.is_empty(), "{change}");
    }
}

#[test]
fn a_report_has_a_line_for_a_name_and_a_place_for_an_answer() {
    let (folder, page) = report_of(&["-n", "3", "--time", "1ms", "--seed", "1"], 0);
    for class in ["name", "own"] {
        assert!(page.contains(&format!("class=\"{class}\" contenteditable=\"true\"")), "{class}");
    }
    parsim2d(folder.path(), &["report", "--name", "Ada <Lovelace>"]).success();
    let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert_whole(&page);
    assert!(page.contains("aria-label=\"Name\">Ada &lt;Lovelace&gt;</span>"));
}

#[test]
fn a_report_draws_no_box_around_a_run_without_walls() {
    let run = ["-n", "12", "--time", "5ms", "--seed", "1", "--speed", "0.1"];
    let (_folder, page) = report_of(&run, 0);
    assert_eq!(page.matches("class=\"box\"").count(), 3);
    let (_folder, page) = report_of(&[&run[..], &["--no-walls"]].concat(), 0);
    assert!(!page.contains("class=\"box\"") && page.contains("\"side\":null"));
}

#[test]
fn many_listed_discs_take_a_few_lines() {
    let folder = TempDir::new().unwrap();
    let disc = |k: usize| format!("[[disc]]\nposition = [{}, 0.01]\n", 0.002 * (k + 1) as f64);
    let scenario = format!("time = '1ms'\n{}", (0..19).map(disc).collect::<String>());
    fs::write(folder.path().join("row.toml"), scenario).unwrap();
    parsim2d(folder.path(), &["row.toml"]).success();
    parsim2d(folder.path(), &["report"]).success();
    let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
    assert_whole(&page);
    assert!(page.contains("<th>position, m</th>") && page.contains("<td>[0.016, 0.01]</td>"));
    assert!(!page.contains("<td>[0.018, 0.01]</td>"));
    assert!(page.contains("and 11 more in last-run.toml"));
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
    // Files of strangers: a record, a failure, frames that say more than numbers.
    let lines = "preset = \"guide\"\nn = 2\n\n[[x</script><script>alert(1)</script>]]\ny = \"<img src=x>\"\n";
    let results = "# result: command = </code><script>alert(1)</script>\n# result: <b> = <i>\n";
    let record = format!("# parsim2d 0.1.0\n{lines}{results}");
    fs::write(folder.path().join("last-run.toml"), record).unwrap();
    let failure = "{\"what\": \"</script><img src=x onerror=alert(1)>\", \"discs\": \"<b>\"}";
    fs::write(folder.path().join("failure.json"), failure).unwrap();
    parsim2d(folder.path(), &["report", "--name", "</span><script>alert(1)</script>"]).success();
    let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
    for tag in ["<b>", "<i>", "<img", "<script>alert"] {
        assert!(!page.contains(tag), "{tag}");
    }
    assert_eq!(page.matches("<script").count(), 2);
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

#[test]
fn a_ledger_that_cannot_be_read_is_told_of_and_one_that_was_not_kept_is_not_missed() {
    let (folder, page) = report_of(&["-n", "2", "--time", "1ms", "--seed", "1"], 0);
    assert!(!page.contains(ENGLISH.no_energy));
    let ledger = fs::read_to_string(folder.path().join("energy.csv")).unwrap();
    let lines: Vec<&str> = ledger.lines().collect();
    let torn = format!("{}\nnan,nan,1e308,inf,x\n", lines[..5].join("\n"));
    for (text, said) in [(torn.as_str(), "line 6"), (&ledger[..ledger.len() - 9], "line")] {
        fs::write(folder.path().join("energy.csv"), text).unwrap();
        let told = parsim2d(folder.path(), &["report"]).success().get_output().stderr.clone();
        let told = String::from_utf8(told).unwrap();
        let page = fs::read_to_string(folder.path().join("report.html")).unwrap();
        assert!(told.starts_with("note: ") && told.contains(said), "{told}");
        assert!(page.contains("energy.csv: ") && !page.contains(ENGLISH.no_energy), "{told}");
    }
    let (_, page) =
        report_of(&["-n", "2", "--time", "1ms", "--seed", "1", "--energy-every", "0"], 0);
    assert!(page.contains(ENGLISH.no_energy));
}
