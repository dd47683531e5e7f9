//! Discs so far out that rounding swallows their steps: a number of 1e9 m has neighbours 1.2e-7 m away.

use super::finding::{Finding, Matter, Verdict};
use super::{DiscSource, Scenario};
use crate::analysis::twin::next_up;
use crate::number::{at_most, shortest};
use crate::particle::Particle;

/// A step of fewer spacings than this is rounded by an eighth of itself, or more.
const SPACINGS: f64 = 4.0;

/// A velocity component below this part of the speed does not count.
const SIDEWAYS: f64 = 1e-3;

/// A coordinate whose step is lost in it.
struct Lost {
    who: String,
    at: f64,   // m
    path: f64, // m a step
}

impl Scenario {
    /// Discs that stand still, or move by jumps, though they have a speed.
    pub(super) fn far_finding(&self) -> Option<Finding> {
        let Lost { who, at, path } = self.lost_step()?;
        let spacing = spacing_at(at);
        let what_happens = match path < 0.5 * spacing {
            true => "it stands still",
            false => "it moves by jumps",
        };
        Some(Finding {
            matter: Matter::Start,
            verdict: Verdict::Coarse,
            what: format!(
                "far out: {who} moves {} m in a step, and numbers near {} m are {} m apart, so that {what_happens}",
                at_most(path, 3),
                at_most(at, 3),
                at_most(spacing, 3)
            ),
            fault: match &self.discs {
                DiscSource::Equal(_) => "--side".to_owned(),
                DiscSource::Listed(..) => format!("{who}: position"),
                DiscSource::Frame { .. } => "--start".to_owned(),
            },
            value: shortest(at),
            ways_out: vec!["positions nearer to the origin".to_owned()],
        })
    }

    fn lost_step(&self) -> Option<Lost> {
        let dt = self.dt();
        let lost = |(id, disc): (usize, Particle)| {
            let speed = disc.velocity.length();
            let axes = [(disc.position.x, disc.velocity.x), (disc.position.y, disc.velocity.y)];
            let (at, path) = axes
                .map(|(at, velocity)| {
                    (at, if velocity.abs() < SIDEWAYS * speed { 0.0 } else { dt * velocity.abs() })
                })
                .into_iter()
                .find(|&(at, path)| is_lost(at, path))?;
            Some(Lost { who: format!("disc {id}"), at, path })
        };
        let placed = |speed: f64| {
            let (at, path) = (self.side, dt * speed);
            is_lost(at, path).then(|| Lost {
                who: "a disc near the far walls".to_owned(),
                at,
                path,
            })
        };
        match &self.discs {
            DiscSource::Equal(_) => placed(self.speed),
            DiscSource::Listed(listed, groups) => {
                let fastest = groups.iter().map(|group| group.speed).fold(0.0, f64::max);
                listed.iter().copied().enumerate().find_map(lost).or_else(|| placed(fastest))
            }
            DiscSource::Frame { discs, .. } => discs.iter().enumerate().find_map(lost),
        }
    }
}

/// Whether a step of `path` (m) from `at` (m) is lost by more than rounding should take.
fn is_lost(at: f64, path: f64) -> bool {
    path > 0.0 && path < SPACINGS * spacing_at(at)
}

/// From a number to its next neighbour away from zero.
fn spacing_at(at: f64) -> f64 {
    next_up(at.abs()) - at.abs()
}
