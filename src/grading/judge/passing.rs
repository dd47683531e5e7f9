//! Discs that pass through one another although others push: pairs that a loop leaves out.
//!
//! A share of all meetings says nothing of them, for they may be one pair of a hundred. But a right
//! program has none at all, where discs are too slow to go through: then it is enough to see two.

use super::collision::Collision;
use super::film::Film;
use super::flight::Flights;
use super::mistake::Mistake;
use super::rubric::Rubric;
use super::verdict::Failure;
use super::words::{Finding, Quantity};

/// Half as fast again as anybody was seen: speeds are means over frames.
const SPARE: f64 = 1.5;

/// Part of the touching distance to which nobody sinks in, if slow.
const DEEP: f64 = 0.5;

/// Two discs that fly or lie through one another, if that is seen twice.
pub fn left_out(
    film: &Film,
    flights: &Flights,
    collisions: &[Collision],
    rubric: &Rubric,
) -> Option<Failure> {
    // How far two discs sink in at a relative speed of 1 m a frame, m.
    let depth = SPARE / (rubric.omega0(false) * flights.interval(rubric)?);
    let is_slow = |one: &&Collision| depth * one.speed < DEEP * one.touch;
    let unmoved = |one: &&Collision| one.aim < 0.8 && !one.is_push();
    let flown: Vec<(usize, [usize; 2])> = collisions
        .iter()
        .filter(|one| is_slow(one) && unmoved(one))
        .map(|one| (one.frame, one.discs))
        .collect();
    let inside = deep(film, depth * 2.0 * fastest(film));
    let worse = if flown.len() >= inside.len() { flown } else { inside };
    // One may be an accident of digits.
    let [shown, _, ..] = worse[..] else { return None };
    let failure = Failure::of(Finding::SomePassThrough, Mistake::PairsLeftOut);
    Some(failure.at(shown.0, &shown.1).with(Quantity::Meetings, worse.len() as f64))
}

/// The longest way of a disc in a frame, m.
fn fastest(film: &Film) -> f64 {
    let follows = (1..film.frames.len()).filter(|&k| film.follows[k]);
    let ways = follows.flat_map(|k| (0..film.n()).map(move |i| film.at(k, i) - film.at(k - 1, i)));
    ways.map(glam::DVec2::length).fold(0.0, f64::max)
}

/// The first frame of each meeting in which two discs are nearer than half the touching distance, if nobody
/// is fast enough to sink in that far, `depth` m.
fn deep(film: &Film, depth: f64) -> Vec<(usize, [usize; 2])> {
    let mut found = Vec::new();
    for i in 0..film.n() {
        for j in i + 1..film.n() {
            let touch = film.radius(i) + film.radius(j);
            let is_deep =
                |k: usize| (film.at(k, i) - film.at(k, j)).length() < (1.0 - DEEP) * touch;
            if depth > DEEP * touch {
                continue;
            }
            let begins = |&k: &usize| is_deep(k) && (k == 0 || !is_deep(k - 1));
            found.extend((0..film.frames.len()).filter(begins).map(|k| (k, [i, j])));
        }
    }
    found
}
