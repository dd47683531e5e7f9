//! Elastic discs under gravity: a gas. In equilibrium heights are exponential, exp(-m g y / kT) between
//! floor and ceiling, each component of the velocity is Gaussian with variance kT/m, and v² is exponential.
//!
//! kT/m is taken from the velocities, so the heights are held against them. Each is asked by the test of
//! Kolmogorov and Smirnov, with frames so far apart that they know little of each other.

use std::f64::consts::PI;

use glam::DVec2;

use super::super::collision::Collision;
use super::super::film::Film;
use super::super::flight::Flights;
use super::super::mistake::Mistake;
use super::super::rubric::Rubric;
use super::super::verdict::{Failure, Status, Verdict};
use super::super::words::{Finding, Quantity};
use super::scales::Scales;

/// Meetings of each disc, and fall times, before the first frame that is used, and from one to the next.
const BEFORE: (usize, f64) = (3, 10.0);
const BETWEEN: (usize, f64) = (1, 2.0);

/// Fewer discs are no gas; fewer places of discs tell nothing.
const LEAST: (usize, usize) = (10, 200);

/// A true gas fails one of the four tests once in ten thousand films: sqrt(-ln(1e-4 / 8) / 2).
const ALPHA: f64 = 2.376;

/// Fuller than this near the floor, the law of ideal gases is off too far.
const FULLEST: f64 = 0.2;

/// A disc at a frame: height over the floor in m, velocity in m a frame.
struct Place {
    height: f64,
    velocity: DVec2,
}

/// Whether heights and velocities are those of a gas, in a film that is long enough.
pub(super) fn verdict(
    film: &Film,
    (flights, collisions): (&Flights, &[Collision]),
    rubric: &Rubric,
    scales: &Scales,
) -> Verdict {
    let chosen = chosen(film, collisions, scales);
    let of = |&k: &usize| (0..film.n()).filter_map(move |i| place(film, flights, rubric, (k, i)));
    let places: Vec<Place> = chosen.iter().flat_map(of).collect();
    if film.n() < LEAST.0 || places.len() < LEAST.1 {
        return Status::NotSeen;
    }
    let count = places.len() as f64;
    let heat = places.iter().map(|one| one.velocity.length_squared()).sum::<f64>() / count / 2.0;
    let scale = heat / flights.pull.length();
    let full = fullness(film, rubric, scale, scales.way);
    if heat.is_nan() || heat <= 0.0 || full > FULLEST {
        return Status::NotSeen;
    }
    // With n discs of one energy a component is no true Gaussian: off by 0.5/n at most (measured: 0.02 of
    // 10, 0.01 of 20). Discs that fill a part of the floor push heights up: by less than half of that
    // part (measured: 0.03 at 0.07, 0.06 at 0.17).
    let spare = ALPHA / count.sqrt() + 0.01 + 0.5 / film.n() as f64;
    let found = [speeds(&places, heat), heights(&places, scale, scales.way)];
    let may = [spare, spare + 0.5 * full];
    let what = [(Finding::NotGaussian, Some(Mistake::SpeedsSet)), (Finding::NotExponential, None)];
    // What is further off is more likely the cause of the other.
    let worst = usize::from(found[1] / may[1] > found[0] / may[0]);
    if found[worst] <= may[worst] {
        return Status::Passed;
    }
    let (finding, cause) = what[worst];
    let failure = Failure::of(finding, cause).at(*chosen.last().unwrap_or(&0), &[]);
    let failure = failure.with(Quantity::Distance, found[worst]);
    let failure = failure.with(Quantity::LargestDistance, may[worst]);
    Status::Failed(failure.with(Quantity::Places, count))
}

/// How far velocities are from those of a gas of this `heat`, kT/m, at most.
fn speeds(places: &[Place], heat: f64) -> f64 {
    let gaussian = |v: f64| normal(v / heat.sqrt());
    let exponential = |square: f64| 1.0 - (-square / (2.0 * heat)).exp();
    let of = |value: fn(&Place) -> f64| places.iter().map(value).collect::<Vec<f64>>();
    let all = [
        distance(of(|one| one.velocity.x), gaussian),
        distance(of(|one| one.velocity.y), gaussian),
        distance(of(|one| one.velocity.length_squared()), exponential),
    ];
    all.into_iter().fold(0.0, f64::max)
}

/// How far heights are from an exponential of this `scale` up to the ceiling, m, at most.
fn heights(places: &[Place], scale: f64, way: f64) -> f64 {
    let most = 1.0 - (-way / scale).exp();
    let barometric = |height: f64| ((1.0 - (-height / scale).exp()) / most).clamp(0.0, 1.0);
    distance(places.iter().map(|one| one.height).collect(), barometric)
}

/// Frames far enough from the start and from each other, by meetings and by fall times.
///
/// Meetings are those in which discs were seen to push each other: who passes by unmoved, in a column of
/// its own, shares no energy. All but a tenth of the discs must have had so many. Only a part of
/// all meetings is seen well enough to count.
fn chosen(film: &Film, collisions: &[Collision], scales: &Scales) -> Vec<usize> {
    let mut pushes: Vec<&Collision> = collisions.iter().filter(|one| one.is_push()).collect();
    pushes.sort_by_key(|one| one.frame);
    let (mut chosen, mut met, mut since) = (Vec::new(), vec![0; film.n()], 0);
    let (mut wanted, mut fall) = BEFORE;
    for one in pushes {
        one.discs.iter().for_each(|&i| met[i] += 1);
        let lonely = met.iter().filter(|&&count| count < wanted).count();
        if 10 * lonely <= film.n() && (one.frame - since) as f64 >= fall * scales.fall {
            chosen.push(one.frame);
            met.fill(0);
            since = one.frame;
            (wanted, fall) = BETWEEN;
        }
    }
    chosen
}

/// Where a disc is, and its velocity by its flight then, or its last one before.
fn place(film: &Film, flights: &Flights, rubric: &Rubric, (k, i): (usize, usize)) -> Option<Place> {
    let runs = &flights.runs[i];
    let run = *runs[..runs.partition_point(|run| run.begin <= k)].last()?;
    let ahead = k.min(run.end) - run.begin;
    let velocity = flights.velocity(film, i, run, run.begin) + flights.pull * ahead as f64;
    let height = film.at(k, i).y - rubric.corner[1] - film.radius(i);
    Some(Place { height, velocity })
}

/// Part of the plane that discs fill at the floor, where heights have this `scale`, m.
fn fullness(film: &Film, rubric: &Rubric, scale: f64, way: f64) -> f64 {
    let area: f64 = (0..film.n()).map(|i| PI * film.radius(i).powi(2)).sum();
    area / (rubric.side * scale * (1.0 - (-way / scale).exp()))
}

/// The part of a normal distribution below `x` standard deviations, to 1e-7: Abramowitz and Stegun, 26.2.17.
fn normal(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.231_641_9 * x.abs());
    let factors = [1.330_274_429, -1.821_255_978, 1.781_477_937, -0.356_563_782, 0.319_381_530];
    let sum = factors.iter().fold(0.0, |sum, factor| (sum + factor) * t);
    let above = sum * (-0.5 * x * x).exp() / (2.0 * PI).sqrt();
    if x > 0.0 { 1.0 - above } else { above }
}

/// How far the distribution of `values` is from the true one, at most (Kolmogorov, Smirnov).
fn distance(mut values: Vec<f64>, truly: impl Fn(f64) -> f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let count = values.len() as f64;
    let off = |(k, &value): (usize, &f64)| {
        let (part, truth) = (k as f64, truly(value));
        (truth - part / count).abs().max((truth - (part + 1.0) / count).abs())
    };
    values.iter().enumerate().map(off).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normal_distribution_has_its_tabulated_values() {
        // Half below the middle, 0.8413447 below one deviation, 0.9772499 below two.
        for (x, part) in [(0.0, 0.5), (1.0, 0.841_344_7), (-2.0, 0.022_750_1)] {
            assert!((normal(x) - part).abs() < 1e-6, "{} at {x}", normal(x));
        }
    }

    #[test]
    fn evenly_spread_values_are_half_a_step_from_even_and_all_at_one_place_are_far() {
        let even = (0..10).map(|k| (f64::from(k) + 0.5) / 10.0).collect();
        assert!((distance(even, |x| x) - 0.05).abs() < 1e-12); // exact but for rounding
        assert!((distance(vec![0.5; 10], |x| x) - 0.5).abs() < 1e-12);
    }
}
