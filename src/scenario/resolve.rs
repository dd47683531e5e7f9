//! From what was said to a checked scenario.

use std::ops::RangeInclusive;

use super::error::ScenarioError;
use super::exclusive;
use super::framed::FramedDiscs;
use super::gravity::Gravity;
use super::number::Num;
use super::quantity::{MOST_THREADS, Quantity};
use super::range::{finite, not_negative, positive, whole, within};
use super::settings::{DtSetting, Settings};
use super::{DampingChoice, DiscSource, DtSetBy, OutputChoices, Scenario, StepChoice};

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
        exclusive::check(settings)?;
        let preset = settings.preset.unwrap_or_default();
        let usual = preset.values();
        let side = positive("side", si(settings.side, usual.side), "--side 4cm")?;
        let radius = si(settings.radius, usual.radius);
        let mass = si(settings.mass, usual.mass);
        let gravity = settings.gravity.unwrap_or(Gravity::down(usual.gravity));
        let stiffness = si(settings.kn, usual.stiffness);
        let speed = si(settings.speed, 0.0);
        let time = si(settings.time, 1.0);
        let (step, dt_set_by) = step_choice(settings, usual.step)?;
        let mut scenario = Self {
            preset,
            seed: seed(settings.seed, draw_seed)?,
            side,
            radius,
            mass: positive("mass", mass, "--mass 1g")?,
            gravity: finite_gravity(gravity)?,
            stiffness: positive("kn", stiffness, "--kn 5e4")?,
            damping: damping_choice(settings, usual.damping)?,
            tension: !settings.no_tension.unwrap_or(false),
            walls: settings.walls(),
            step,
            dt_set_by,
            time: not_negative("time", time, "--time 1s")?,
            integrator: settings.integrator.unwrap_or_default(),
            allow_unstable: settings.allow_unstable.unwrap_or(false),
            placement: settings.placement.unwrap_or_default(),
            speed: not_negative("speed", speed, "--speed 0.1")?,
            discs: DiscSource::Equal(usual.n),
            output: output_choices(settings)?,
        };
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
        if time / dt >= 1e15 {
            let allowed = format!("at most 1e15 steps of dt = {dt:e} s");
            return Err(ScenarioError::out_of_range(
                "time",
                Num(time),
                allowed,
                "a shorter --time",
            ));
        }
        if time > 0.0 && self.steps() == 0 {
            let allowed = format!("at least one step of dt = {dt:e} s");
            return Err(ScenarioError::out_of_range("time", Num(time), allowed, "a longer --time"));
        }
        Ok(())
    }
}

fn finite_gravity(gravity: Gravity) -> Result<Gravity, ScenarioError> {
    gravity.vector.to_array().into_iter().try_for_each(|g| finite("gravity", g).map(|_| ()))?;
    Ok(gravity)
}

/// The value said, or `otherwise`, in SI units.
pub(super) fn si<D>(said: Option<Quantity<D>>, otherwise: f64) -> f64 {
    said.map_or(otherwise, |quantity| quantity.si)
}

fn seed(said: Option<i64>, draw_seed: impl FnOnce() -> u64) -> Result<u64, ScenarioError> {
    said.map_or_else(|| Ok(draw_seed()), |seed| whole("seed", seed, 0..=i64::MAX, "--seed 1"))
}

impl Settings {
    pub(super) fn walls(&self) -> bool {
        self.walls.unwrap_or(!self.no_walls.unwrap_or(false))
    }
}

fn damping_choice(
    settings: &Settings,
    usual: DampingChoice,
) -> Result<DampingChoice, ScenarioError> {
    if let Some(eta) = settings.eta {
        return Ok(DampingChoice::Eta(not_negative("eta", eta.si, "--eta 1.5e-3")?));
    }
    if let Some(gamma) = settings.gamma {
        return Ok(DampingChoice::Gamma(not_negative("gamma", gamma.si, "--gamma 1.5e3")?));
    }
    match settings.restitution.map(|e| e.si) {
        None => Ok(usual),
        Some(e) if e > 0.0 && e <= 1.0 => Ok(DampingChoice::Restitution(e)),
        Some(e) => Err(ScenarioError::out_of_range(
            "restitution",
            Num(e),
            "must be above 0 and at most 1",
            "--restitution 0.9 (1 is elastic; for more damping than any e gives, --eta)",
        )),
    }
}

fn step_choice(
    settings: &Settings,
    usual: StepChoice,
) -> Result<(StepChoice, DtSetBy), ScenarioError> {
    match (settings.nt.map(|nt| nt.si), settings.dt) {
        (Some(nt), _) if nt >= 1.0 && nt.is_finite() => Ok((StepChoice::Nt(nt), DtSetBy::Nt)),
        (Some(nt), _) => Err(ScenarioError::out_of_range(
            "nt",
            Num(nt),
            "must be at least 1 step in a contact; the guide says 10 to 50",
            "--nt 50",
        )),
        (None, Some(DtSetting::Auto)) => Ok((StepChoice::Auto, DtSetBy::Auto)),
        (None, Some(DtSetting::Seconds(dt))) => {
            Ok((StepChoice::Seconds(positive("dt", dt, "--dt auto")?), DtSetBy::Dt))
        }
        (None, None) => Ok((usual, DtSetBy::Preset)),
    }
}

/// Wall seconds for a simulated second: up to thirty years.
const SLOWDOWNS: RangeInclusive<f64> = 1e-9..=1e9;

/// Wall seconds between checkpoints. More often than that a run does little else; more than thirty years are more
/// than some clocks can tell.
const INTERVALS: RangeInclusive<f64> = 1e-3..=1e9;

fn output_choices(settings: &Settings) -> Result<OutputChoices, ScenarioError> {
    let steps = |field, said: Option<i64>, least| {
        said.map(|k| whole(field, k, least..=i64::MAX, "leave it out for the default")).transpose()
    };
    let cores = "--threads 1, or as many as there are cores";
    let threads = settings.threads.map(|k| whole("threads", k, 1..=MOST_THREADS, cores));
    let slowdown = settings.slowdown.map(|x| within("slowdown", x.si, SLOWDOWNS, "--slowdown 10"));
    let checkpoint_every = settings
        .checkpoint_every
        .map(|x| within("checkpoint_every", x.si, INTERVALS, "--checkpoint-every 10min"));
    Ok(OutputChoices {
        folder: settings.out_dir.clone().unwrap_or_else(|| ".".into()),
        every: steps("every", settings.every, 1)?,
        energy_every: steps("energy_every", settings.energy_every, 0)?,
        slowdown: slowdown.transpose()?,
        threads: threads.transpose()?.map(|threads| threads as usize),
        checkpoint_every: checkpoint_every.transpose()?,
        border: settings.border.unwrap_or(false),
        json: settings.json.unwrap_or(false),
        quiet: settings.quiet.unwrap_or(false),
    })
}
