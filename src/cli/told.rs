//! What `last-run.toml` tells of the frames beside it: nothing, unless it is the record of their run.

use std::fmt;
use std::io;
use std::path::Path;

use crate::number::shortest;
use crate::output::frames::Frame;
use crate::output::place::plain_text;
use crate::output::record;
use crate::scenario::error::ScenarioError;
use crate::scenario::settings::Settings;
use crate::scenario::{Scenario, file};

/// The record of a run.
pub(super) struct Told {
    /// The file as it is.
    pub text: String,
    /// What it says, or what is wrong with that.
    pub said: Result<(Settings, Scenario), ScenarioError>,
}

/// Why nothing is known of a run.
#[derive(Debug)]
pub(super) enum Untold {
    /// There is no record, or it cannot be read.
    Unreadable(io::Error),
    /// It is not the record of a run, or of another one.
    Unfit(String),
}

impl fmt::Display for Untold {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreadable(why) if why.kind() == io::ErrorKind::NotFound => {
                f.write_str("there is none")
            }
            Self::Unreadable(why) => write!(f, "{why}"),
            Self::Unfit(why) => f.write_str(why),
        }
    }
}

impl Told {
    /// The record at `path`, if it is one.
    pub fn read(path: &Path) -> Result<Self, Untold> {
        let text = plain_text(path).map_err(Untold::Unreadable)?;
        if text.trim().is_empty() {
            return Err(Untold::Unfit("it is empty".to_owned()));
        }
        if !record::is_one(&text) {
            return Err(Untold::Unfit("no run of parsim2d wrote it".to_owned()));
        }
        let said = file::parse(&text, path);
        if said.as_ref().is_ok_and(|settings| !settings.is_whole()) {
            return Err(Untold::Unfit("it is cut off, or was changed".to_owned()));
        }
        let said = said.and_then(|settings| {
            let scenario = Scenario::resolve(&settings, || 0)?;
            Ok((settings, scenario))
        });
        Ok(Self { text, said })
    }

    /// The same if `frame` is one of its run; `is_last` of a frame that must be the run's last.
    pub fn of(self, frame: &Frame, is_last: bool) -> Result<Self, Untold> {
        match self.difference(frame, is_last) {
            Some(why) => Err(Untold::Unfit(why)),
            None => Ok(self),
        }
    }

    /// What this record and `frame` contradict each other in.
    fn difference(&self, frame: &Frame, is_last: bool) -> Option<String> {
        let Ok((_, scenario)) = &self.said else { return None };
        // Frames have nine digits, and the time step is a quotient of two such numbers.
        let differs = |a: f64, b: f64| (a - b).abs() > 1e-7 * a.abs().max(b.abs());
        let other = |what: String| format!("it is of another run: {what}");
        let (n, rows) = (scenario.n(), frame.rows.len());
        if n != rows {
            return Some(other(format!("it tells of {n} discs, the frames have {rows}")));
        }
        if let Some(side) = frame.side.filter(|&side| differs(side, scenario.side)) {
            let told = scenario.side;
            return Some(other(format!("it tells of a box of {told} m, the frames of {side} m")));
        }
        let (step, time) = (frame.step?, frame.time?);
        let (dt, seen) = (scenario.dt(), time / step as f64);
        if step > 0 && differs(dt, seen) {
            return Some(other(format!(
                "its time step is {} s, that of the frames {} s",
                shortest(dt),
                shortest(seen)
            )));
        }
        let done = record::results(&self.text).find(|(name, _)| *name == "steps")?.1;
        let done: u64 = done.parse().ok()?;
        (step > done || is_last && step < done)
            .then(|| other(format!("it tells of {done} steps, the frame is of step {step}")))
    }
}
