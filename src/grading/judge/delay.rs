//! How late forces act, by the angular momentum that two discs lose about each other.
//!
//! Explicit Euler moves a disc by its old velocity, so a push shows one step late: along a line of
//! centres that has turned by then. The kick a dt then has an arm, and the relative angular momentum L = r × v becomes
//! L (1 - a dt²/r) in each step, so that a contact takes dt w/r of it, w the change of the relative velocity. Kicks
//! and drifts of Eq. (3) and of Verlet leave L as it is, whatever the dashpot does: so a film tells the two
//! mistakes apart that make energy alike.

use std::f64::consts::PI;

use super::collision::Collision;
use super::flight::{Flights, median};
use super::rubric::{Law, Rubric};

/// Meetings of which fewer tell nothing.
const LEAST: usize = 3;

/// The median of the loss of angular momentum over that of explicit Euler with undamped springs, if it is
/// what makes pairs give back `restitution`: 0 if forces act in time, 1 if they act a step late, more if
/// a dashpot hides part of the gain. None if it cannot be told.
pub fn delay(
    collisions: &[Collision],
    restitution: f64,
    flights: &Flights,
    rubric: &Rubric,
) -> Option<f64> {
    let interval = flights.interval(rubric).filter(|_| rubric.law == Law::Spring)?;
    // e = exp(pi omega0 dt / 2); dt in frames.
    let step = 2.0 * restitution.ln() / (PI * rubric.omega0(false) * interval);
    let ratio = |one: &Collision| {
        let along = one.speed * (1.0 - one.aim * one.aim).sqrt();
        let expected = step * (1.0 + restitution) * along / one.touch * one.aim;
        // A velocity that is off by the blur acts at the distance of the frames, some touching distances.
        let is_seen = one.is_push() && (0.2..0.8).contains(&one.aim) && expected > 4.0 * one.blur;
        is_seen.then_some(one.lost / expected)
    };
    let ratios: Vec<f64> = collisions.iter().filter_map(ratio).collect();
    (ratios.len() >= LEAST).then(|| median(ratios.into_iter()))
}
