//! Ways of free discs that tell a mistake by themselves.

use glam::DVec2;

use super::{Flights, Run, Sample, median};
use crate::grading::judge::film::Film;
use crate::grading::judge::mistake::Mistake;
use crate::grading::judge::verdict::Failure;
use crate::grading::judge::words::{Finding, Quantity};

/// Forces that are never set to zero add up: the pull is one step's, two steps', three steps'. So the second
/// differences of those who have met nobody are twice as large in the second frame as they were in the first.
pub(super) fn grows(film: &Film) -> Option<Failure> {
    if film.frames.len() < 4 {
        return None;
    }
    let n = film.n();
    let bend = |k: usize, i: usize| film.at(k - 1, i) - 2.0 * film.at(k, i) + film.at(k + 1, i);
    let first = median((0..n).map(|i| bend(1, i).y));
    let blur = 4.0 * film.usual_blur();
    let is = |k: usize, pull: f64| {
        let off = move |i: usize| (bend(k, i) - DVec2::new(0.0, pull)).length();
        move |i: &usize| off(*i) < blur + 0.05 * pull.abs()
    };
    let alike = (0..n).filter(is(1, first)).count();
    let doubled = (0..n).filter(is(1, first)).filter(is(2, 2.0 * first)).count();
    let is_seen = first.abs() > 20.0 * blur && 2 * alike > n && doubled >= 3.max(n / 10);
    is_seen.then(|| {
        let failure = Failure::of(Finding::PullGrows, Mistake::ForcesNotReset).at(2, &[]);
        failure.with(Quantity::PullY, 2.0 * first).with(Quantity::UsualPullY, first)
    })
}

/// A disc that nobody is near and that stays where it is for three frames: something has stopped it. At the
/// top of its flight a right one goes by twice the usual second difference in them.
pub(super) fn stops(film: &Film, flights: &Flights) -> Option<Failure> {
    let blur = 2.0 * film.usual_blur();
    // Later most may hang: what all have at first.
    let bend = |i: usize| film.at(0, i) - 2.0 * film.at(1, i) + film.at(2, i);
    if median((0..film.n()).map(|i| bend(i).length())) < 8.0 * blur {
        return None;
    }
    let (k, i) = (0..film.n()).find_map(|i| {
        let is_there = |run: &&Run| run.end - run.begin >= 3;
        let still = |k: usize| (k..k + 3).all(|k| film.at(k + 1, i).distance(film.at(k, i)) < blur);
        let mut runs = flights.runs[i].iter().filter(is_there);
        runs.find_map(|run| (run.begin..run.end - 2).find(|&k| still(k))).map(|k| (k, i))
    })?;
    Some(Failure::of(Finding::StopsInFlight, Mistake::StoppedInTheAir).at(k + 2, &[i]))
}

/// The second difference changes from place to place.
pub(super) fn not_constant(flights: &Flights, off: usize) -> Failure {
    let samples = &flights.samples;
    let worst = samples.iter().max_by(|a, b| flights.off(a).total_cmp(&flights.off(b)));
    let worst = worst.unwrap_or(&samples[0]);
    let (slope, left) = drag(samples);
    let cause = if left < 0.2 && slope < 0.0 {
        Some(Mistake::FrictionInFlight)
    } else if comes_together(flights) {
        Some(Mistake::TimeStepNotConstant)
    } else {
        is_capped(flights).then_some(Mistake::SpeedsSet)
    };
    Failure::of(Finding::PullNotConstant, cause)
        .at(worst.middle, &[worst.disc])
        .with(Quantity::PullX, worst.value.x)
        .with(Quantity::PullY, worst.value.y)
        .with(Quantity::UsualPullX, flights.pull.x)
        .with(Quantity::UsualPullY, flights.pull.y)
        .with(Quantity::Share, off as f64 / samples.len() as f64)
}

/// The line `value = constant + slope velocity` through the samples, and the part of their spread that it
/// leaves.
fn drag(samples: &[Sample]) -> (f64, f64) {
    let n = samples.len() as f64;
    let value = samples.iter().map(|s| s.value).sum::<DVec2>() / n;
    let velocity = samples.iter().map(|s| s.velocity).sum::<DVec2>() / n;
    let (mut vv, mut va, mut aa) = (0.0, 0.0, 0.0);
    for sample in samples {
        let (dv, da) = (sample.velocity - velocity, sample.value - value);
        vv += dv.length_squared();
        va += dv.dot(da);
        aa += da.length_squared();
    }
    if vv == 0.0 || aa == 0.0 { (0.0, 1.0) } else { (va / vv, 1.0 - va * va / (vv * aa)) }
}

/// Whether at each frame nearly all discs are off, or nearly none.
fn comes_together(flights: &Flights) -> bool {
    let last = flights.samples.iter().map(|s| s.middle).max().unwrap_or(0);
    let (mut off, mut all) = (vec![0usize; last + 1], vec![0usize; last + 1]);
    for sample in &flights.samples {
        all[sample.middle] += 1;
        off[sample.middle] += usize::from(flights.off(sample) > 1.0);
    }
    let frames: Vec<usize> = (0..=last).filter(|&k| all[k] >= 3).collect();
    let together = frames.iter().filter(|&&k| 10 * off[k] >= 8 * all[k]).count();
    let none = frames.iter().filter(|&&k| 10 * off[k] <= 2 * all[k]).count();
    let is_either = 10 * (together + none) >= 7 * frames.len();
    frames.len() >= 5 && is_either && 20 * together >= frames.len()
}

/// Whether those that do not fall as the others are all of one speed, and nobody is faster.
fn is_capped(flights: &Flights) -> bool {
    let speed = |sample: &&Sample| sample.velocity.length();
    let highest = flights.samples.iter().map(|sample| speed(&sample)).fold(0.0, f64::max);
    let off: Vec<&Sample> = flights.samples.iter().filter(|one| flights.off(one) > 1.0).collect();
    let at_top = off.iter().filter(|sample| speed(sample) > 0.95 * highest).count();
    off.len() >= 10 && 10 * at_top >= 8 * off.len()
}
