//! The momentum of two discs while they touch, frame by frame.
//!
//! Two discs that are near each other and nobody else push each other only: their centre falls as a free disc
//! does, whatever their forces are. A pair that is pushed the same way runs off together instead, and never
//! parts, so that no flight follows by which a meeting could be judged.

use glam::DVec2;

use super::film::Film;
use super::flight::Flights;
use super::mistake::Mistake;
use super::rubric::Rubric;
use super::verdict::Failure;
use super::words::{Finding, Quantity};

/// Pairs whose centre is pushed, and far more than they are pushed apart.
pub fn run_off(film: &Film, flights: &Flights, rubric: &Rubric) -> Option<Failure> {
    // Without the pull nobody can tell a push from a fall.
    flights.interval(rubric)?;
    let least = 20.0 * (flights.pull.length() + film.usual_blur());
    let bend = |k: usize, i: usize| {
        film.at(k - 1, i) - 2.0 * film.at(k, i) + film.at(k + 1, i) - flights.pull
    };
    let mut found = Vec::new();
    // Across lost frames all go farther than usual, and two that lie together do alike.
    let is_used = |k: usize| !flights.near[k].iter().all(|near| near.many);
    for k in (1..flights.near.len()).filter(|&k| is_used(k) && is_used(k - 1)) {
        for (i, near) in flights.near[k].iter().enumerate() {
            let Some(j) = near.partner.map(|j| j as usize).filter(|&j| i < j) else { continue };
            let bends = [bend(k, i), bend(k, j)];
            let (both, apart) = (bends[0] + bends[1], bends[0] - bends[1]);
            let is_pushed = both.length() > least.max(4.0 * apart.length());
            if is_pushed && is_alone(film, k, [i, j]) {
                found.push((k, [i, j], bends));
            }
        }
    }
    // Two, for one may be an accident of who was near.
    let [(k, discs, bends), _, ..] = found[..] else { return None };
    let [a, b] = bends.map(DVec2::length);
    let failure = Failure::of(Finding::PushedAlike, Mistake::ReactionSign).at(k, &discs);
    Some(failure.with(Quantity::BendFirst, a).with(Quantity::BendSecond, b))
}

/// Whether two discs touch in frame `k`, and nobody else and no wall is near them in the frames around it.
fn is_alone(film: &Film, k: usize, [i, j]: [usize; 2]) -> bool {
    let gap = |k: usize, a: usize, b: usize| {
        (film.at(k, a) - film.at(k, b)).length() / (film.radius(a) + film.radius(b))
    };
    let to_wall = |k: usize, a: usize| {
        let place = film.at(k, a) - film.corner;
        place.min_element().min(film.side - place.max_element()) / film.radius(a)
    };
    let is_free = |k: usize, a: usize| {
        let others = (0..film.n()).filter(|&b| b != i && b != j);
        to_wall(k, a) > 2.0 && others.into_iter().all(|b| gap(k, a, b) > 1.5)
    };
    gap(k, i, j) < 1.0 && (k - 1..=k + 1).all(|k| is_free(k, i) && is_free(k, j))
}
