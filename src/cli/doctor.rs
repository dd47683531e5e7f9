//! `parsim2d doctor`: which optional programs are on this machine, and what each is good for.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

use clap::Args;
use serde::Serialize;

use super::failure::Failure;
use crate::echo;
use crate::grading::sandbox::{Options, Refused, Sandbox, Tier};

#[derive(Args)]
pub(super) struct DoctorArguments {
    /// The findings as one JSON object on stdout
    #[arg(long)]
    json: bool,
}

/// A program that does not tell its version within this time does not work.
const PATIENCE: Duration = Duration::from_secs(3);

/// A program that parsim2d can do without.
struct Helper {
    name: &'static str,
    version_flag: &'static str,
    unlocks: &'static str,
    without: &'static str,
}

const HELPERS: [Helper; 3] = [
    Helper {
        name: "gnuplot",
        version_flag: "--version",
        unlocks: "watching a run live (plot/loop.plot), and PNG and PDF from every .gp script",
        without: "`parsim2d plot` draws SVG and GIF, `parsim2d report` an HTML page",
    },
    Helper {
        name: "ffmpeg",
        version_flag: "-version",
        unlocks: "films: ffmpeg -i trajectory.gif trajectory.mp4",
        without: "`parsim2d plot trajectory --gif` makes an animation that browsers show",
    },
    Helper {
        name: "bwrap",
        version_flag: "--version",
        unlocks: "the best sandbox for `parsim2d grade`",
        without: "grade takes the next best sandbox, if one works here",
    },
];

/// What was found of one program.
#[derive(Serialize)]
struct Found {
    program: &'static str,
    path: Option<PathBuf>,
    version: Option<String>,
    unlocks: &'static str,
}

/// What was found of this machine.
#[derive(Serialize)]
struct Findings {
    version: &'static str,
    cores: usize,
    folder_can_be_written: bool,
    programs: Vec<Found>,
    /// The sandbox that `grade` would use, if one works, and why no better one.
    sandbox: StudentCode,
}

/// How student code would be kept from doing harm.
#[derive(Serialize)]
struct StudentCode {
    tier: Option<Tier>,
    refused: Vec<Refused>,
    error: Option<String>,
}

impl StudentCode {
    fn probe() -> Self {
        match Sandbox::open(&Options::default()) {
            Ok(sandbox) => Self {
                tier: Some(sandbox.tier()),
                refused: sandbox.refused().to_vec(),
                error: None,
            },
            Err(why) => Self { tier: None, refused: Vec::new(), error: Some(why.to_string()) },
        }
    }
}

pub(super) fn examine(arguments: &DoctorArguments) -> Result<ExitCode, Failure> {
    let findings = Findings {
        version: env!("CARGO_PKG_VERSION"),
        cores: std::thread::available_parallelism().map_or(1, usize::from),
        folder_can_be_written: tells_writable(Path::new(".")),
        programs: HELPERS.iter().map(look_for).collect(),
        sandbox: StudentCode::probe(),
    };
    let mut out = io::stdout().lock();
    if arguments.json {
        serde_json::to_writer(&mut out, &findings).map_err(io::Error::from)?;
        writeln!(out)?;
    } else {
        write_text(&mut out, &findings)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn write_text(out: &mut impl Write, findings: &Findings) -> io::Result<()> {
    writeln!(out, "parsim2d {}, {} cores", findings.version, findings.cores)?;
    match findings.folder_can_be_written {
        true => writeln!(out, "this folder can be written")?,
        false => writeln!(out, "this folder cannot be written: use --out-dir with another one")?,
    }
    writeln!(out, "simulating needs no other program; these would help:\n")?;
    for (helper, found) in HELPERS.iter().zip(&findings.programs) {
        let state = match (&found.path, &found.version) {
            (Some(path), Some(version)) => format!("{version}, {}", echo::path(path)),
            (Some(path), None) => format!("{} does not start", echo::path(path)),
            (None, _) => "not found".to_owned(),
        };
        writeln!(out, "{:<8} {state}", helper.name)?;
        writeln!(out, "         for {}", helper.unlocks)?;
        if found.version.is_none() {
            writeln!(out, "         without it: {}", helper.without)?;
        }
    }
    let StudentCode { tier, refused, error } = &findings.sandbox;
    match (tier, error) {
        (Some(tier), _) => writeln!(out, "\ngrade's sandbox: tier {tier}, {}", tier.words())?,
        (None, Some(why)) => writeln!(out, "\ngrade's sandbox: {why}")?,
        (None, None) => {}
    }
    for Refused { tier, why } in refused {
        writeln!(out, "         not tier {tier}: {why}")?;
    }
    Ok(())
}

fn look_for(helper: &Helper) -> Found {
    let path = on_path(helper.name);
    let version = path.as_deref().and_then(|path| version(path, helper.version_flag));
    Found { program: helper.name, path, version, unlocks: helper.unlocks }
}

/// The program's file in the folders of PATH.
fn on_path(name: &str) -> Option<PathBuf> {
    let folders = std::env::var_os("PATH")?;
    let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    std::env::split_paths(&folders).map(|folder| folder.join(&file)).find(|path| path.is_file())
}

/// The first line that the program says of its version.
fn version(path: &Path, flag: &str) -> Option<String> {
    let mut child = Command::new(path)
        .arg(flag)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .ok()?;
    let asked = Instant::now();
    while child.try_wait().ok()?.is_none() {
        if asked.elapsed() > PATIENCE {
            let _ = child.kill(); // it does not answer: as good as not there
            let _ = child.wait();
            return None;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    let said = child.wait_with_output().ok()?;
    let text = String::from_utf8_lossy(&said.stdout).into_owned();
    let line = text.lines().next()?.trim();
    // ffmpeg goes on about its authors.
    let short = line.split(" Copyright").next().unwrap_or(line);
    (!short.is_empty()).then(|| short.to_owned())
}

/// Tries with a file that is removed again.
fn tells_writable(folder: &Path) -> bool {
    let path = folder.join(format!("parsim2d.{}.tmp", std::process::id()));
    let created = std::fs::OpenOptions::new().write(true).create_new(true).open(&path).is_ok();
    created && std::fs::remove_file(&path).is_ok()
}
