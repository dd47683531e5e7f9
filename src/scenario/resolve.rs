//! From what was said to a checked scenario.

use super::error::ScenarioError;
use super::framed::FramedDiscs;
use super::quantity::Quantity;
use super::settings::{DtSetting, Settings};
use super::{DampingChoice, DtSetBy, Scenario, StepChoice};
use crate::number::{shortest, time_step};

impl Scenario {
    /// Fills in what `settings` leave open from the preset and checks everything that can be
    /// checked before the discs are placed. `draw_seed` is asked for a seed if none was said.
    pub fn resolve(
        settings: &Settings,
        draw_seed: impl FnOnce() -> u64,
    ) -> Result<Self, ScenarioError> {
        Self::resolve_with(settings, draw_seed, None)
    }

    /// The same; the discs of `--start`, if it was said, are `frame` and the file is not read.
    pub(super) fn resolve_with(
        settings: &Settings,
        draw_seed: impl FnOnce() -> u64,
        frame: Option<FramedDiscs>,
    ) -> Result<Self, ScenarioError> {
        settings.check_exclusive()?;
        settings.check()?;
        let usual = settings.preset.unwrap_or_default().values();
        let seed = settings.seed.map_or_else(draw_seed, |seed| seed as u64);
        let mut scenario = Self::of(settings, &usual, seed);
        scenario.take_discs(settings, usual.n, frame)?;
        scenario.check_step()?;
        Ok(scenario)
    }

    /// The time step must be stable, unless asked otherwise.
    fn check_step(&self) -> Result<(), ScenarioError> {
        if let (false, Some(refusal)) = (self.allow_unstable, self.refusal()) {
            return Err(ScenarioError::Unstable(Box::new(refusal)));
        }
        self.check_clock()
    }

    /// The run must have a number of steps that can be counted: at least one, unless no time at
    /// all was asked for.
    pub(super) fn check_clock(&self) -> Result<(), ScenarioError> {
        let (dt, time) = (self.dt(), self.time);
        let (allowed, way_out) = if time / dt >= 1e15 {
            ("at most 1e15 steps", "a shorter --time")
        } else if time > 0.0 && self.steps() == 0 {
            ("at least one step", "a longer --time")
        } else {
            return Ok(());
        };
        let allowed = format!("{allowed} of dt = {}", time_step(dt));
        Err(ScenarioError::out_of_range("time", shortest(time), allowed, way_out))
    }
}

/// The value said, or `otherwise`, in SI units.
pub(super) fn si<D>(said: Option<Quantity<D>>, otherwise: f64) -> f64 {
    said.map_or(otherwise, |quantity| quantity.si)
}

impl DampingChoice {
    /// What `settings` say of it, if anything.
    pub(super) fn of(settings: &Settings) -> Option<Self> {
        let Settings { eta, gamma, restitution, .. } = settings;
        let eta = eta.map(|eta| Self::Eta(eta.si));
        let gamma = gamma.map(|gamma| Self::Gamma(gamma.si));
        eta.or(gamma).or(restitution.map(|e| Self::Restitution(e.si)))
    }
}

impl StepChoice {
    /// What `settings` say of it, if anything.
    pub(super) fn of(settings: &Settings) -> Option<Self> {
        let dt = settings.dt.map(|dt| match dt {
            DtSetting::Auto => Self::Auto,
            DtSetting::Seconds(dt) => Self::Seconds(dt),
        });
        settings.nt.map(|nt| Self::Nt(nt.si)).or(dt)
    }
}

impl DtSetBy {
    /// Who chooses the time step if these `settings` are said.
    pub(super) fn of(settings: &Settings) -> Self {
        match StepChoice::of(settings) {
            Some(StepChoice::Nt(_)) => Self::Nt,
            Some(StepChoice::Seconds(_)) => Self::Dt,
            Some(StepChoice::Auto) => Self::Auto,
            None => Self::Preset,
        }
    }
}
