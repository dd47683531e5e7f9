//! The momentum of two discs while they touch, frame by frame.
//!
//! Two discs that are near each other and nobody else push each other only: their centre falls as a free disc
//! does, whatever their forces are. A pair that is pushed the same way runs off together instead, and never
//! parts, so that no flight follows by which a meeting could be judged.

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
    // Across lost frames all go farther than usual, and two that lie together do alike.
    let is_used = |k: usize| !flights.near[k].iter().all(|near| near.many);
    let used = (1..flights.near.len()).filter(|&k| is_used(k) && is_used(k - 1));
    let is_pushed = |k: usize, [i, j]: [usize; 2]| {
        let (both, apart) = (bend(k, i) + bend(k, j), bend(k, i) - bend(k, j));
        both.length() > least.max(4.0 * apart.length()) && is_alone(film, k, [i, j])
    };
    let partner = |k: usize, i: usize| flights.near[k][i].partner.map(|j| j as usize);
    let pairs = |k: usize| (0..film.n()).filter_map(move |i| Some([i, partner(k, i)?]));
    // Twice on end, for once may be an accident of who was near.
    let (k, discs) =
        used.flat_map(|k| pairs(k).map(move |pair| (k, pair))).find(|&(k, pair)| {
            pair[0] < pair[1]
                && k + 1 < flights.near.len()
                && is_pushed(k, pair)
                && is_pushed(k + 1, pair)
        })?;
    let [a, b] = discs.map(|one| bend(k, one).length());
    let failure = Failure::of(Finding::PushedAlike, Mistake::ReactionSign).at(k, &discs);
    Some(failure.with(Quantity::BendFirst, a).with(Quantity::BendSecond, b))
}

/// Whether two discs touch in frame `k`, and nobody else and no wall is near them.
fn is_alone(film: &Film, k: usize, [i, j]: [usize; 2]) -> bool {
    let gap = |k: usize, a: usize, b: usize| {
        (film.at(k, a) - film.at(k, b)).length() / (film.radius(a) + film.radius(b))
    };
    let to_wall = |k: usize, a: usize| {
        let place = film.at(k, a) - film.corner;
        place.min_element().min(film.side - place.max_element())
    };
    // Who is near enough to have come and gone between frames counts as well.
    let way = |k: usize, a: usize| {
        film.at(k, a).distance(film.at(k - 1, a)).max(film.at(k + 1, a).distance(film.at(k, a)))
    };
    let is_far = |k: usize, a: usize, b: usize| {
        let touch = film.radius(a) + film.radius(b);
        film.at(k, a).distance(film.at(k, b)) > 1.5 * touch + way(k, b)
    };
    let is_free = |k: usize, a: usize| {
        let mut others = (0..film.n()).filter(|&b| b != i && b != j);
        to_wall(k, a) > 2.0 * film.radius(a) + way(k, a) && others.all(|b| is_far(k, a, b))
    };
    gap(k, i, j) < 1.0 && is_free(k, i) && is_free(k, j)
}
