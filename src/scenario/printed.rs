//! A scenario written back as TOML: what `--print-config` prints, and what a run leaves behind.

use std::fmt::{self, Write};

use super::key::Key;
use super::keys::KEYS;
use super::settings::{DtSetting, Settings};
use super::{DampingChoice, DiscSource, DtSetBy, Scenario, StepChoice};
use crate::particle::Particle;

impl Scenario {
    /// The whole scenario as a file that reproduces the run, with units in comments.
    pub fn to_toml(&self) -> String {
        self.printed(|_| true)
    }

    /// The same without what says only where and how fast the run wrote: the text of `last-run.toml`,
    /// which depends on no path. Run it, and the files of the run come again.
    ///
    /// `discs` are those of the run at its start: what came from a frame is listed, as far as there are
    /// not too many, so that the record holds without that file.
    pub fn record(&self, discs: &[Particle]) -> String {
        const MOST_LISTED: usize = 20_000;
        let is_kept = |key: &Key| !key.is_of_machine;
        match &self.discs {
            DiscSource::Frame { .. } if discs.len() <= MOST_LISTED => {
                let listed = DiscSource::Listed(discs.to_vec(), Vec::new());
                Self { discs: listed, speed: 0.0, ..self.clone() }.printed(is_kept)
            }
            _ => self.printed(is_kept),
        }
    }

    fn printed(&self, is_kept: impl Fn(&Key) -> bool) -> String {
        let mut text = String::new();
        let printed =
            self.write_keys(&mut text, is_kept).and_then(|()| self.write_tables(&mut text));
        printed.expect("writing to a string does not fail");
        text
    }

    /// The keys section by section.
    fn write_keys(&self, out: &mut String, is_kept: impl Fn(&Key) -> bool) -> fmt::Result {
        writeln!(out, "# parsim2d {}: every choice of this run", env!("CARGO_PKG_VERSION"))?;
        let mut lines = Vec::new();
        self.said().each(&mut |key, said| {
            let said = said.filter(|_| is_kept(key));
            let line = said.map(|said| format!("{} = {}", key.name, said.text(key.unit)));
            let all = line.into_iter().chain(self.remark_behind(key));
            lines.push((key, all.collect::<Vec<_>>()));
        });
        for section in KEYS.chunk_by(|a, b| a.section == b.section) {
            let section = section[0].section;
            if !section.is_empty() {
                writeln!(out)?;
            }
            for comes_first in [true, false] {
                let is_next = |key: &Key| key.section == section && key.comes_first == comes_first;
                let lines = lines.iter().filter(|(key, _)| is_next(key));
                lines.flat_map(|(_, lines)| lines).try_for_each(|line| writeln!(out, "{line}"))?;
            }
        }
        Ok(())
    }

    /// What is to be told at the place of `key`, and is no key.
    fn remark_behind(&self, key: &Key) -> Option<String> {
        match (key.name, self.step, self.dt_set_by) {
            // Said by the preset, and left to it, so that the run knows who set its time step.
            ("nt", StepChoice::Nt(nt), DtSetBy::Preset) => {
                Some(format!("# nt = {nt:?}, by the preset"))
            }
            ("dt", ..) => Some(format!("# dt is {:?} s", self.dt())),
            _ => None,
        }
    }

    /// What has to be said for this scenario; its single discs and groups aside.
    fn said(&self) -> Settings {
        let mut said = Settings { no_tension: Some(!self.tension), ..Settings::default() };
        self.say(&mut said);
        self.output.say(&mut said);
        match self.damping {
            DampingChoice::Eta(eta) => said.eta = Some(eta.into()),
            DampingChoice::Gamma(gamma) => said.gamma = Some(gamma.into()),
            DampingChoice::Restitution(e) => said.restitution = Some(e.into()),
        }
        match self.step {
            StepChoice::Nt(_) if self.dt_set_by == DtSetBy::Preset => {}
            StepChoice::Nt(nt) => said.nt = Some(nt.into()),
            StepChoice::Seconds(dt) => said.dt = Some(DtSetting::Seconds(dt)),
            StepChoice::Auto => said.dt = Some(DtSetting::Auto),
        }
        match &self.discs {
            DiscSource::Equal(n) => said.n = Some(*n as i64),
            DiscSource::Listed(_, groups) if groups.is_empty() => {
                (said.placement, said.speed) = (None, None);
            }
            DiscSource::Listed(..) => {}
            DiscSource::Frame {
                said: file,
                columns,
                has_velocities,
                has_masses,
                has_radii,
                ..
            } => {
                (said.start, said.columns) = (Some(file.clone()), columns.clone());
                said.placement = None;
                said.speed = said.speed.filter(|_| !has_velocities);
                said.mass = said.mass.filter(|_| !has_masses);
                said.radius = said.radius.filter(|_| !has_radii);
            }
        }
        said
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
