//! The energy of all discs, per mass and in frames: v²/2 + c y of each disc's last free flight.
//!
//! A disc in contact counts with what it had before, so the energy in the springs needs not be known.
//! Read where it must be constant or fall, the sum tells an integrator or a dashpot that makes energy.

use super::bounce::{self, Bounce, is_explicit};
use super::collision::{self, Collision};
use super::film::Film;
use super::flight::{Flights, median};
use super::mistake::Mistake;
use super::rubric::Rubric;
use super::verdict::{Failure, Status, Verdict};
use super::words::{Finding, Quantity};

/// What the checks before found.
#[derive(Clone, Copy, Debug)]
pub struct Seen<'a> {
    /// Bounces on walls.
    pub bounces: &'a [Bounce],
    /// Meetings of two.
    pub collisions: &'a [Collision],
    /// Whether a start or a contact was already said to be wrong.
    pub told: bool,
}

/// The energy never grows, and does not fall if nothing takes it.
pub fn verdict(film: &Film, flights: &Flights, rubric: &Rubric, seen: Seen) -> Verdict {
    let energy = sums(film, flights, rubric);
    let Some((start, end)) = ends(&energy).filter(|_| flights.is_sharp(rubric)) else {
        return Status::NotSeen;
    };
    let change = end / start - 1.0;
    let last = film.frames.len() - 1;
    let failed = |finding, cause| {
        let failure = Failure::of(finding, cause).at(last, &[]);
        let failure = failure.with(Quantity::EnergyChange, change);
        let e = [bounce::usual(seen.bounces), collision::usual(seen.collisions)];
        let e = e.into_iter().flatten().next();
        Status::Failed(match e {
            Some(e) => failure.with(Quantity::Restitution, e),
            None => failure,
        })
    };
    if change.abs() > rubric.energy_tolerance && seen.told {
        return Status::NotSeen; // it comes from what was judged already
    }
    if change > rubric.energy_tolerance {
        return failed(Finding::EnergyGrows, Some(gain_cause(seen, rubric)));
    }
    if rubric.is_elastic() && change < -rubric.energy_tolerance {
        return failed(Finding::EnergyFalls, Some(Mistake::EnergyLostElastic));
    }
    Status::Passed
}

fn gain_cause(seen: Seen, rubric: &Rubric) -> Mistake {
    let measured =
        [(bounce::usual(seen.bounces), true), (collision::usual(seen.collisions), false)];
    for (e, is_wall) in measured {
        let Some(e) = e else { continue };
        let expected = rubric.expected_restitution(is_wall).1;
        if expected < 0.97 && (e * expected - 1.0).abs() < 0.03 {
            return Mistake::DampingSign; // e and 1/e
        }
        if is_explicit((e / expected).ln(), is_wall) {
            return Mistake::ExplicitEuler;
        }
    }
    Mistake::EnergyPump
}

/// The sum over all discs at each frame; a disc counts with its last free flight, or its first.
fn sums(film: &Film, flights: &Flights, rubric: &Rubric) -> Vec<f64> {
    let frames = film.frames.len();
    let mut sums = vec![0.0; frames];
    for i in 0..film.n() {
        let runs = &flights.runs[i];
        let floor = rubric.corner[1] + film.radius(i);
        let of = |k: usize| {
            let run = runs[k];
            let velocity = flights.velocity(film, i, run, run.begin);
            0.5 * velocity.length_squared() - flights.pull.y * (film.at(run.begin, i).y - floor)
        };
        if runs.is_empty() {
            continue;
        }
        let mut known = 0;
        let mut energy = of(0);
        for (k, sum) in sums.iter_mut().enumerate() {
            while runs.get(known + 1).is_some_and(|next| next.begin <= k) {
                known += 1;
                energy = of(known);
            }
            *sum += energy;
        }
    }
    sums
}

/// Medians over the first and the last tenth, if there are frames enough and anything moves.
fn ends(energy: &[f64]) -> Option<(f64, f64)> {
    let tenth = energy.len() / 10;
    if tenth < 1 {
        return None;
    }
    let start = median(energy[..tenth].iter().copied());
    let end = median(energy[energy.len() - tenth..].iter().copied());
    (start > 0.0 && end.is_finite()).then_some((start, end))
}
