//! Statics of long films: what is so in the end whatever way the discs took there.
//!
//! Trajectories cannot be compared, for two right programs part after ten collisions. But discs that
//! lose speed in contacts come to rest at the bottom, and elastic ones become a gas: heights
//! exponential, velocities Gaussian. Both take long. The rules of how long are in fall times
//! t_f = sqrt(2 H / g), H the way from ceiling to floor, and in meetings; in frames t_f = sqrt(2 H / c).

mod gas;
mod scales;

use self::scales::Scales;
use super::collision::Collision;
use super::film::Film;
use super::flight::{Flights, median};
use super::mistake::Mistake;
use super::restitution::Restitutions;
use super::rubric::Rubric;
use super::verdict::{Failure, Status, Verdict};
use super::words::{Finding, Quantity};

/// Fall times over 1 - e after which discs have come to rest. Bounces of what fell from the ceiling end
/// after t_f (1 + e)/(1 - e), half of it or less; a disc that slides between walls has u = l / ((1 - e) t)
/// left at time t, whatever it had before: by then an eighth of the fall speed.
const REST: f64 = 4.0;

/// What may be left then, in fall speeds sqrt(2 g H). Measured: up to 0.05 (e 0.3 to 0.9, 5 to 300 discs).
const RESTLESS: f64 = 0.125;

/// A heap is no looser than this part of the plane (measured: 0.85 at its top); one radius more than twice
/// for discs that lie on a few others.
const LOOSEST: f64 = 0.6;

/// Whether discs come to rest at the bottom, or are a gas in equilibrium.
///
/// `told`: whether something else was already said to be wrong.
pub fn verdict(
    film: &Film,
    (flights, collisions): (&Flights, &[Collision]),
    rubric: &Rubric,
    seen: &Restitutions,
    told: bool,
) -> Verdict {
    let pull = flights.pull.length();
    let way = rubric.side - 2.0 * film.radius(0);
    let is_known = flights.interval(rubric).is_some() && flights.is_sharp(rubric);
    if told || !is_known || way <= 0.0 || seen.is_printed_eta(rubric) {
        return Status::NotSeen;
    }
    let scales = Scales { fall: (2.0 * way / pull).sqrt(), speed: (2.0 * way * pull).sqrt(), way };
    if rubric.is_elastic() {
        return gas::verdict(film, (flights, collisions), rubric, &scales);
    }
    heap(film, rubric, &scales)
}

/// Discs that lose speed: at rest at the bottom in the last quarter, if that begins late enough.
fn heap(film: &Film, rubric: &Rubric, scales: &Scales) -> Verdict {
    let frames = film.frames.len();
    let begin = 3 * frames / 4;
    let ends = [true, false].map(|is_wall| rubric.expected_restitution(is_wall));
    let highest = ends.iter().map(|e| e.1).fold(0.0, f64::max);
    let lowest = ends.iter().map(|e| e.0).fold(1.0, f64::min);
    let is_late = begin as f64 * (1.0 - highest) >= REST * scales.fall;
    // Discs that stick hang on walls and ceilings for long.
    if !is_late || lowest < 0.05 || frames - begin < 10 {
        return Status::NotSeen;
    }
    if let Some((i, height)) = hanging(film, rubric, begin) {
        let failure = Failure::of(Finding::HangsInTheEnd, Mistake::StoppedInTheAir);
        let failure = failure.at(frames - 1, &[i]);
        return Status::Failed(failure.with(Quantity::HeightOverRadius, height / film.radius(i)));
    }
    let speed = median((begin + 1..frames).filter(|&k| film.follows[k]).map(|k| rms(film, k)));
    if speed > RESTLESS * scales.speed + 4.0 * film.usual_blur() {
        let failure = Failure::of(Finding::NeverRests, Mistake::EnergyPump).at(frames - 1, &[]);
        return Status::Failed(failure.with(Quantity::SpeedOverFall, speed / scales.speed));
    }
    Status::Passed
}

/// Root of the mean square of how far discs go in the frame before `k`, m.
fn rms(film: &Film, k: usize) -> f64 {
    let square = |i: usize| (film.at(k, i) - film.at(k - 1, i)).length_squared();
    ((0..film.n()).map(square).sum::<f64>() / film.n() as f64).sqrt()
}

/// The disc that stays highest from frame `begin` on, and its height over the floor, m, if no heap of
/// these discs reaches there.
fn hanging(film: &Film, rubric: &Rubric, begin: usize) -> Option<(usize, f64)> {
    let largest = (0..film.n()).map(|i| film.radius(i)).fold(0.0, f64::max);
    let area: f64 = (0..film.n()).map(|i| std::f64::consts::PI * film.radius(i).powi(2)).sum();
    let top = area / rubric.side / LOOSEST + 4.0 * largest;
    let height = |i: usize, k: usize| film.at(k, i).y - rubric.corner[1] - film.radius(i);
    let least = |i| (begin..film.frames.len()).map(|k| height(i, k)).fold(f64::MAX, f64::min);
    // Columns of discs that were placed one above the other may stand.
    let last = film.frames.len() - 1;
    let is_held = |i: usize| {
        let lies_on = |j: usize| {
            let way = film.at(last, i) - film.at(last, j);
            j != i && way.y > 0.0 && way.length() < 1.05 * (film.radius(i) + film.radius(j))
        };
        (0..film.n()).any(lies_on)
    };
    let all = (0..film.n()).filter(|&i| !is_held(i)).map(|i| (i, least(i)));
    all.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, height)| *height > top)
}
