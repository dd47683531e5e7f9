//! A scenario written back as TOML: what `--print-config` prints, and what a run leaves behind.

use std::fmt::{self, Write};

use super::settings::Settings;
use super::{DampingChoice, DiscSource, DtSetBy, Scenario, StepChoice};
use crate::particle::Particle;

impl Scenario {
    /// The whole scenario as a file that reproduces the run, with units in comments.
    pub fn to_toml(&self) -> String {
        let mut text = String::new();
        self.write_toml(&mut text).expect("writing to a string does not fail");
        text
    }

    /// The same without what says only where and how fast the run wrote: the text of `last-run.toml`,
    /// which depends on no path. Run it, and the files of the run come again.
    ///
    /// `discs` are those of the run at its start: what came from a frame is listed, as far as there are
    /// not too many, so that the record holds without that file.
    pub fn record(&self, discs: &[Particle]) -> String {
        const MOST_LISTED: usize = 20_000;
        let everything = match &self.discs {
            DiscSource::Frame { .. } if discs.len() <= MOST_LISTED => {
                let listed = DiscSource::Listed(discs.to_vec(), Vec::new());
                Self { discs: listed, speed: 0.0, ..self.clone() }.to_toml()
            }
            _ => self.to_toml(),
        };
        let elsewhere = [
            "out_dir = ",
            "slowdown = ",
            "threads = ",
            "checkpoint_every = ",
            "json = ",
            "quiet = ",
        ];
        let is_kept = |line: &&str| !elsewhere.iter().any(|key| line.starts_with(key));
        // Keys of the top level come first; nothing of a disc begins with these.
        everything.lines().filter(is_kept).map(|line| format!("{line}\n")).collect()
    }

    fn write_toml(&self, out: &mut String) -> fmt::Result {
        writeln!(out, "# parsim2d {}: every choice of this run", env!("CARGO_PKG_VERSION"))?;
        writeln!(out, "preset = \"{}\"", self.preset.name())?;
        if let DiscSource::Equal(n) = self.discs {
            writeln!(out, "n = {n}")?;
        }
        writeln!(out, "seed = {}", self.seed)?;
        self.write_physics(out)?;
        self.write_time(out)?;
        self.write_start(out)?;
        self.write_output(out)?;
        self.write_tables(out)
    }

    fn write_physics(&self, out: &mut String) -> fmt::Result {
        writeln!(out, "\nside = {:?} # m", self.side)?;
        if !matches!(self.discs, DiscSource::Frame { has_radii: true, .. }) {
            writeln!(out, "radius = {:?} # m", self.radius)?;
        }
        if !matches!(self.discs, DiscSource::Frame { has_masses: true, .. }) {
            writeln!(out, "mass = {:?} # kg", self.mass)?;
        }
        let way = if self.gravity.is_vertical() { "downward" } else { "y up" };
        writeln!(out, "gravity = {} # m/s2, {way}", self.gravity)?;
        writeln!(out, "kn = {:?} # N/m", self.stiffness)?;
        match self.damping {
            DampingChoice::Eta(eta) => writeln!(out, "eta = {eta:?} # kg/s")?,
            DampingChoice::Gamma(gamma) => writeln!(out, "gamma = {gamma:?} # 1/s")?,
            DampingChoice::Restitution(e) => writeln!(out, "restitution = {e:?}")?,
        }
        writeln!(out, "no_tension = {}", !self.tension)?;
        writeln!(out, "walls = {}", self.walls)
    }

    fn write_time(&self, out: &mut String) -> fmt::Result {
        writeln!(out)?;
        match (self.step, self.dt_set_by) {
            // Said by the preset, and left to it, so that the run knows who set its time step.
            (StepChoice::Nt(nt), DtSetBy::Preset) => writeln!(out, "# nt = {nt:?}, by the preset")?,
            (StepChoice::Nt(nt), _) => writeln!(out, "nt = {nt:?}")?,
            (StepChoice::Seconds(dt), _) => writeln!(out, "dt = {dt:?} # s")?,
            (StepChoice::Auto, _) => writeln!(out, "dt = \"auto\"")?,
        }
        writeln!(out, "# dt is {:?} s", self.dt())?;
        writeln!(out, "time = {:?} # s", self.time)?;
        writeln!(out, "integrator = \"{}\"", self.integrator.name())?;
        writeln!(out, "allow_unstable = {}", self.allow_unstable)
    }

    fn write_start(&self, out: &mut String) -> fmt::Result {
        writeln!(out)?;
        match &self.discs {
            DiscSource::Frame { said, columns, has_velocities, .. } => {
                writeln!(out, "start = {}", quoted(said))?;
                if let Some(columns) = columns {
                    writeln!(out, "columns = {}", quoted(&columns.to_string()))?;
                }
                if *has_velocities {
                    return Ok(());
                }
            }
            DiscSource::Listed(_, groups) if groups.is_empty() => return Ok(()),
            _ => writeln!(out, "placement = \"{}\"", self.placement.name())?,
        }
        writeln!(out, "speed = {:?} # m/s", self.speed)
    }

    fn write_output(&self, out: &mut String) -> fmt::Result {
        let output = &self.output;
        writeln!(out, "\nout_dir = {}", quoted(&output.folder.to_string_lossy()))?;
        if let Some(every) = output.every {
            writeln!(out, "every = {every} # steps")?;
        }
        if let Some(every) = output.energy_every {
            writeln!(out, "energy_every = {every} # steps")?;
        }
        if let Some(slowdown) = output.slowdown {
            writeln!(out, "slowdown = {slowdown:?}")?;
        }
        if let Some(threads) = output.threads {
            writeln!(out, "threads = {threads}")?;
        }
        if let Some(every) = output.checkpoint_every {
            writeln!(out, "checkpoint_every = {every:?} # s of wall time")?;
        }
        writeln!(out, "border = {}", output.border)?;
        writeln!(out, "json = {}", output.json)?;
        writeln!(out, "quiet = {}", output.quiet)
    }

    fn write_tables(&self, out: &mut String) -> fmt::Result {
        let DiscSource::Listed(listed, groups) = &self.discs else {
            return Ok(());
        };
        for disc in listed {
            let (p, v) = (disc.position, disc.velocity);
            writeln!(out, "\n[[disc]]")?;
            writeln!(out, "position = [{:?}, {:?}] # m", p.x, p.y)?;
            writeln!(out, "velocity = [{:?}, {:?}] # m/s", v.x, v.y)?;
            writeln!(out, "radius = {:?} # m", disc.radius)?;
            writeln!(out, "mass = {:?} # kg", disc.mass)?;
        }
        for group in groups {
            writeln!(out, "\n[[population]]")?;
            writeln!(out, "n = {}", group.n)?;
            writeln!(out, "radius = {:?} # m", group.radius)?;
            writeln!(out, "mass = {:?} # kg", group.mass)?;
            writeln!(out, "speed = {:?} # m/s", group.speed)?;
        }
        Ok(())
    }
}

impl Settings {
    /// Whether they say all that a printed scenario says: less would be filled up by a preset, and tell
    /// of a run that never was.
    pub fn is_whole(&self) -> bool {
        let dampings = [self.eta.is_some(), self.gamma.is_some(), self.restitution.is_some()];
        self.preset.is_some()
            && self.seed.is_some()
            && self.side.is_some()
            && (self.mass.is_some() || self.start.is_some()) // a frame may bring masses
            && self.gravity.is_some()
            && self.kn.is_some()
            && dampings.contains(&true)
            && self.no_tension.is_some()
            && self.walls.is_some()
            && self.time.is_some()
            && self.integrator.is_some()
            && self.allow_unstable.is_some()
    }
}

fn quoted(text: &str) -> String {
    if text.contains(char::is_control) {
        // On one line, whatever is in it; JSON's escapes are TOML's too.
        return serde_json::Value::from(text).to_string();
    }
    toml::Value::String(text.to_owned()).to_string()
}
