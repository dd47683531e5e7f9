//! The scenario of a run that goes on from a checkpoint.

use std::path::Path;

use glam::DVec2;

use super::error::ScenarioError;
use super::framed::FramedDiscs;
use super::settings::Settings;
use super::{DiscSource, Scenario, file};
use crate::output::recorder::OutputPlan;
use crate::output::written::Written;
use crate::particle::Particle;
use crate::simulation::state::{Array, ArrayView};

/// Name of the array with the discs of `--start`.
const FRAME: &str = "frame";
/// Numbers of a disc in it: x y vx vy r m.
const PER_DISC: usize = 6;

impl Scenario {
    /// What the text of the scenario does not hold: the discs of `--start`, whose file may be gone by the
    /// time the run goes on.
    pub fn arrays(&self) -> Vec<(&'static str, ArrayView<'_>)> {
        let DiscSource::Frame { discs, .. } = &self.discs else { return Vec::new() };
        let of_disc = |p: Particle| {
            [p.position.x, p.position.y, p.velocity.x, p.velocity.y, p.radius, p.mass]
        };
        vec![(FRAME, ArrayView::of_rows(discs.iter().map(of_disc)))]
    }

    /// The scenario of a checkpoint, from its `text` and `arrays`, of which its own is taken, with the `changes` said now; and whether they
    /// give it a new end. That leaves the intervals of the files as they were `written`, default or not.
    pub fn continued(
        text: &str,
        arrays: &mut Vec<(String, Array)>,
        written: &Written,
        changes: Settings,
    ) -> Result<(Self, bool), ScenarioError> {
        let settings = file::parse(text, Path::new("the scenario of the checkpoint"))?;
        let has_new_end =
            changes.time.is_some_and(|new| Some(new.si) != settings.time.map(|t| t.si));
        let mut settings = changes.over(settings);
        if has_new_end {
            let whole = |steps: u64| i64::try_from(steps).ok();
            settings.every = settings.every.or_else(|| whole(written.frame_every));
            settings.energy_every = settings.energy_every.or_else(|| whole(written.energy_every));
        }
        let frame = arrays.iter().position(|(name, _)| name == FRAME);
        let frame = frame.map(|at| match arrays.swap_remove(at).1 {
            Array::Numbers(numbers) => numbers.chunks_exact(PER_DISC).map(disc).collect(),
            Array::Counts(_) => FramedDiscs::default(),
        });
        Ok((Self::resolve_with(&settings, || 0, frame)?, has_new_end))
    }

    /// What the run that goes on writes: into its folder, at the intervals it was begun with.
    pub fn continued_plan(&self, written: &Written) -> Result<OutputPlan, ScenarioError> {
        let start = match &self.discs {
            DiscSource::Frame { .. } => self.place()?,
            _ => Vec::new(), // the record says how to place them
        };
        Ok(OutputPlan {
            frame_every: written.frame_every,
            energy_every: written.energy_every,
            ..self.output_plan_with(self.record(&start))
        })
    }
}

fn disc(numbers: &[f64]) -> Particle {
    let position = DVec2::new(numbers[0], numbers[1]);
    let mut disc = Particle::at_rest(position, numbers[4], numbers[5]);
    disc.velocity = DVec2::new(numbers[2], numbers[3]);
    disc
}
