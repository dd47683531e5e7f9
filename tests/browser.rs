//! The pages in a browser, where there is one: a report fills two sheets at most, a player plays.

use std::fs;
use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

use crate::support::browser_is_missing;
use crate::support::plotting::{parsim2d, plot, simulate};

/// Opens `page` of `folder` with more flags, without a window or network; what was printed.
fn opened(folder: &Path, page: &str, flags: &[&str]) -> (String, String) {
    let profile = TempDir::new().unwrap(); // tests run side by side
    let output = Command::new("chromium")
        .current_dir(folder)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"])
        .args(["--disable-background-networking", "--disable-component-update", "--disable-sync"])
        .args(["--enable-logging=stderr", "--virtual-time-budget=3000", "--no-pdf-header-footer"])
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .args(flags)
        .arg(format!("file://{}/{page}", folder.display()))
        .output()
        .unwrap();
    let [said, remarks] =
        [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    assert!(output.status.success(), "{page}: {remarks}");
    (said, remarks)
}

/// How many sheets `page` fills; `style` comes first in it.
fn sheets(folder: &Path, page: &str, style: &str) -> usize {
    let text = fs::read_to_string(folder.join(page)).unwrap();
    fs::write(folder.join("styled.html"), text.replace("<style>", &format!("<style>{style}")))
        .unwrap();
    opened(folder, "styled.html", &["--print-to-pdf=sheets.pdf"]);
    let pdf = fs::read(folder.join("sheets.pdf")).unwrap();
    let pdf = String::from_utf8_lossy(&pdf).into_owned();
    pdf.matches("/Type /Page\n").count()
}

/// A scenario with all that makes a report long: listed discs, groups, two findings, a failure.
const LONGEST: &str = "kn = 500\neta = 1.5e3\nallow_unstable = true\ntime = 0.05\n\
    [[disc]]\nposition = [0.01, 0.02]\nvelocity = [0.5, 0]\nmass = 1e-4\n\
    [[disc]]\nposition = [0.02, 0.02]\nvelocity = [-0.5, 0]\nmass = 1e-2\n\
    [[disc]]\nposition = [0.03, 0.02]\n[[population]]\nn = 100\nradius = 2e-4\n\
    [[population]]\nn = 10\nradius = 5e-4\nspeed = 1\n";

#[test]
fn a_report_prints_on_two_sheets() {
    if browser_is_missing("how a report prints") {
        return;
    }
    let runs: [(&[&str], i32); 6] = [
        (&["--seed", "1", "--time", "0.2"], 0),
        (&["-n", "1000", "--radius", "5e-4", "--seed", "1", "--time", "5ms"], 0),
        (&["--kn", "500", "--seed", "1"], 1),
        (&["--eta", "1.5e3", "--allow-unstable", "--seed", "1", "--time", "0.1"], 0),
        (&["-n", "2", "--radius", "5e-4", "--seed", "1", "--time", "0.1"], 0),
        (&["longest.toml", "--seed", "3"], 0),
    ];
    for (arguments, code) in runs {
        let folder = TempDir::new().unwrap();
        fs::write(folder.path().join("longest.toml"), LONGEST).unwrap();
        let run = parsim2d(folder.path()).args(arguments).output().unwrap();
        assert_eq!(run.status.code(), Some(code), "{arguments:?}");
        assert!(parsim2d(folder.path()).arg("report").output().unwrap().status.success());
        for paper in ["@page{size:A4}", "@page{size:letter}"] {
            let sheets = sheets(folder.path(), "report.html", paper);
            assert!((1..=2).contains(&sheets), "{arguments:?} {paper}: {sheets} sheets");
        }
    }
}

#[test]
fn a_player_plays_and_the_one_of_a_report_waits() {
    if browser_is_missing("the player") {
        return;
    }
    let folder = simulate("-n 20 --seed 1 -q --time 0.5");
    plot(folder.path(), "trajectory trajectory.txt --html");
    assert!(parsim2d(folder.path()).arg("report").output().unwrap().status.success());
    for (page, begins) in [("trajectory.html", true), ("report.html", false)] {
        let (dom, remarks) = opened(folder.path(), page, &["--dump-dom"]);
        let clock = dom.split("<output id=\"clock\">").nth(1).unwrap();
        let clock = clock.split('<').next().unwrap();
        let time: f64 =
            clock.strip_prefix("t = ").unwrap().strip_suffix(" s").unwrap().parse().unwrap();
        // Three of the twelve seconds that a run of 0.5 s lasts, to a frame of 2.5 ms at either end.
        let there = if begins { 0.125 } else { 0.0 };
        assert!((time - there).abs() < 0.006, "{page}: {clock}");
        assert!(dom.contains(if begins { ">Pause</button>" } else { ">Play</button>" }));
        // The energies of that moment stand beside it.
        let now = dom.split("<dl id=\"now\">").nth(1).unwrap().split("</dl>").next().unwrap();
        assert_eq!(now.matches(" mJ</dd>").count(), 5, "{now}");
        assert!(!remarks.contains("CONSOLE"), "{remarks}");
    }
}
