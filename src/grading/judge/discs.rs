//! Discs and their places: as many as at the start, as large as asked, in the box, apart at the start.

use glam::DVec2;

use super::film::Film;
use super::flight::{Flights, median};
use super::mistake::Mistake;
use super::rubric::{Law, Rubric};
use super::verdict::{Failure, Status, Verdict};
use super::wall::{WALLS, Wall};
use super::words::{Finding, Quantity};

/// The same discs in every frame, in the same order, with finite numbers.
/// `asked` holds the numbers of discs that are right; any, if it is empty.
pub fn kept(film: &Film, asked: &[usize]) -> Verdict {
    for (k, frame) in film.frames.iter().enumerate() {
        let is_bad = |i: &usize| !(frame[*i].position.is_finite() && frame[*i].radius.is_finite());
        if let Some(i) = (0..frame.len()).find(is_bad) {
            let failure = Failure::of(Finding::NotFinite, Mistake::NotANumber);
            return Status::Failed(failure.at(k, &[i]));
        }
        if frame.len() != film.n() {
            let failure = Failure::of(Finding::CountChanges, Mistake::DiscLost).at(k, &[]);
            let failure = failure.with(Quantity::Count, frame.len() as f64);
            return Status::Failed(failure.with(Quantity::CountAtStart, film.n() as f64));
        }
    }
    let nearest = asked.iter().copied().min_by_key(|n| n.abs_diff(film.n()));
    if let Some(n) = nearest.filter(|&n| n != film.n()) {
        let cause = (film.n() < n).then_some(Mistake::DiscLost);
        let failure = Failure::of(Finding::CountNotAsked, cause).at(0, &[]);
        let failure = failure.with(Quantity::Count, film.n() as f64);
        return Status::Failed(failure.with(Quantity::CountAsked, n as f64));
    }
    // One exchange may be a freak of two discs that meet.
    match exchanges(film).as_slice() {
        [(k, i, j), _, ..] => {
            let failure = Failure::of(Finding::OrderChanges, Mistake::DiscOrderChanges);
            Status::Failed(failure.at(*k, &[*i, *j]))
        }
        _ => Status::Passed,
    }
}

/// Frames in which two rows continue each other's paths instead of their own.
fn exchanges(film: &Film) -> Vec<(usize, usize, usize)> {
    let mut found = Vec::new();
    let way = |i: usize, k: usize| (film.at(k, i) - film.at(k - 1, i)).length();
    for k in 2..film.frames.len() {
        let ahead = |i: usize| 2.0 * film.at(k - 1, i) - film.at(k - 2, i);
        let off = |i: usize, j: usize| (film.at(k, i) - ahead(j)).length();
        let jumpers: Vec<usize> =
            (0..film.n()).filter(|&i| off(i, i) > 20.0 * film.radius(i)).collect();
        for (at, &i) in jumpers.iter().enumerate() {
            let is_other = |j: &&usize| {
                let own = off(i, i).min(off(**j, **j));
                // Discs that hit each other head-on exchange paths as well, but do not jump to get there.
                let reach = 2.0 * (way(i, k - 1) + way(**j, k - 1));
                // Who jumps through the whole box came back at the other side.
                let is_calm = way(i, k).max(way(**j, k)) < 0.9 * film.side
                    && way(i, k - 1).max(way(**j, k - 1)) < 0.1 * film.side;
                let is_jump = is_calm && way(i, k).min(way(**j, k)) > reach;
                is_jump && off(i, **j).max(off(**j, i)) < 0.1 * own
            };
            found.extend(jumpers[at + 1..].iter().find(is_other).map(|&j| (k, i, j)));
        }
    }
    found
}

/// Radii constant, above zero, and one of those asked for.
pub fn radii(film: &Film, rubric: &Rubric) -> Verdict {
    if film.halved {
        let printed = 2.0 * film.radius(0);
        let failure = Failure::of(Finding::WrongRadius, Mistake::DiameterAsRadius).at(0, &[0]);
        let failure = failure.with(Quantity::Radius, printed);
        return Status::Failed(failure.with(Quantity::RadiusAsked, film.radius(0)));
    }
    let is_asked = |radius: f64| {
        rubric.radius.is_empty() || rubric.radius.iter().any(|r| (radius / r - 1.0).abs() < 1e-3)
    };
    for (k, frame) in film.frames.iter().enumerate() {
        for (i, spot) in frame.iter().enumerate() {
            let first = film.frames[0].get(i).map_or(spot.radius, |first| first.radius);
            let (finding, which, right) = match spot.radius {
                r if !(r > 0.0 && is_asked(r)) => {
                    (Finding::WrongRadius, Quantity::RadiusAsked, &rubric.radius[..])
                }
                r if (r / first - 1.0).abs() > 1e-3 => {
                    (Finding::RadiusChanges, Quantity::RadiusAtStart, &[first][..])
                }
                _ => continue,
            };
            let failure = Failure::of(finding, None).at(k, &[i]);
            let failure = failure.with(Quantity::Radius, spot.radius);
            return Status::Failed(right.iter().fold(failure, |why, r| why.with(which, *r)));
        }
    }
    Status::Passed
}

/// How far a disc's edge is beyond the wall with `normal`, m.
fn beyond(position: DVec2, radius: f64, normal: DVec2, rubric: &Rubric) -> f64 {
    let centre = DVec2::from(rubric.corner) + DVec2::splat(0.5 * rubric.side);
    (position - centre).dot(normal) + radius - 0.5 * rubric.side
}

/// Nobody goes further into a wall than its speed allows.
///
/// `told`: what the times of contacts say of the walls. `slack`: how many times that depth is right.
pub fn inside(
    film: &Film,
    flights: &Flights,
    slack: f64,
    told: Option<Mistake>,
    rubric: &Rubric,
) -> Verdict {
    if let Some((k, i, normal)) = wraps(film) {
        let failure = Failure::of(Finding::ComesBackOpposite, Mistake::WallMissing).at(k, &[i]);
        return Status::Failed(failure.on(Wall::with_normal(normal)));
    }
    let mut deepest = (0.0, 0, 0, DVec2::ZERO);
    for i in 0..film.n() {
        let radius = film.radius(i);
        let begins = |normal: &DVec2| beyond(film.at(0, i), radius, *normal, rubric) > radius;
        if WALLS.iter().any(|(normal, _)| begins(normal)) {
            continue; // it began outside: that is another check's
        }
        let limit = slack * sink(film, flights, i, rubric);
        for k in 0..film.frames.len() {
            for (normal, _) in WALLS {
                let depth = beyond(film.at(k, i), radius, normal, rubric) - film.usual_blur();
                if depth > limit && depth / limit > deepest.0 {
                    deepest = (depth / limit, k, i, normal);
                }
            }
        }
    }
    let (over, k, i, normal) = deepest;
    if over == 0.0 {
        return Status::Passed;
    }
    let (radius, limit) = (film.radius(i), slack * sink(film, flights, i, rubric));
    let depth = over * limit;
    let pull = flights.pull;
    let cause = told.or_else(|| outside_cause(film, (i, normal), depth, (limit, pull), rubric));
    let failure = Failure::of(Finding::LeavesTheBox, cause).at(k, &[i]);
    let failure = failure.on(Wall::with_normal(normal));
    let failure = failure.with(Quantity::DepthOverRadius, depth / radius);
    Status::Failed(failure.with(Quantity::LargestDepthOverRadius, limit / radius))
}

/// A disc that leaves by a wall and comes back by the opposite one: a frame, the disc, the wall's normal.
fn wraps(film: &Film) -> Option<(usize, usize, DVec2)> {
    let middle = film.corner + DVec2::splat(0.5 * film.side);
    let is_at =
        |k: usize, i: usize, normal: DVec2| (film.at(k, i) - middle).dot(normal) > 0.4 * film.side;
    let is_wrap = |k: usize, i: usize, normal: DVec2| {
        let calm = (film.at(k - 1, i) - film.at(k - 2, i)).length() < 0.1 * film.side;
        let way = (film.at(k, i) - film.at(k - 1, i)).dot(-normal);
        calm && way > 0.8 * film.side && is_at(k - 1, i, normal) && is_at(k, i, -normal)
    };
    let places = (2..film.frames.len()).flat_map(|k| (0..film.n()).map(move |i| (k, i)));
    let mut all = places.flat_map(|(k, i)| WALLS.map(|(normal, _)| (k, i, normal)));
    all.find(|&(k, i, normal)| is_wrap(k, i, normal))
}

/// How deep a right program's disc may sink into a wall, m: v/omega0 and the weight, with a third to
/// spare; by the literal distance to the wall a centre beyond it is pushed less, up to twice as deep.
/// Hard discs may go a step too far before they are turned: a tenth of a radius.
fn sink(film: &Film, flights: &Flights, i: usize, rubric: &Rubric) -> f64 {
    if rubric.law == Law::Hard {
        return 0.1 * film.radius(i);
    }
    let fall = (2.0 * rubric.gravity * rubric.side).sqrt();
    let observed = flights.interval(rubric).map_or(0.0, |interval| {
        // Within the box only: what is outside is what is being asked about.
        let is_in = |k: usize| {
            WALLS.iter().all(|(normal, _)| beyond(film.at(k, i), 0.0, *normal, rubric) < 0.0)
        };
        let steps = (1..film.frames.len()).filter(|&k| is_in(k) && is_in(k - 1));
        let way = |k: usize| (film.at(k, i) - film.at(k - 1, i)).length();
        steps.map(way).fold(0.0, f64::max) / interval
    });
    let omega0 = rubric.omega0(true);
    let depth = 1.33 * (fall.max(observed) / omega0 + 2.0 * rubric.gravity / omega0.powi(2));
    if depth < film.radius(i) { depth } else { 2.0 * depth }
}

/// What drives a disc so deep into a wall, by its way beyond it.
fn outside_cause(
    film: &Film,
    (i, normal): (usize, DVec2),
    depth: f64,
    (limit, pull): (f64, DVec2),
    rubric: &Rubric,
) -> Option<Mistake> {
    if depth <= limit + 1.05 * film.radius(i) {
        return Some(Mistake::WallAtCentre);
    }
    // Somebody who came back tells more than who is still out.
    let all = (0..film.n()).filter_map(|j| Trip::of(film, j, normal, rubric));
    let mut all = all.filter(|trip| trip.way.iter().any(|out| *out > limit));
    let own = Trip::of(film, i, normal, rubric)?;
    let trip = all.find(|trip| trip.is_back).unwrap_or(own);
    // Second differences outward, beyond the wall, beside those of free flight: gravity pulls by g
    // T²; what a wall pulls with grows with the way.
    let bends: Vec<f64> = trip.way.windows(3).map(|w| w[0] - 2.0 * w[1] + w[2]).collect();
    let blur = film.blur(film.at(film.frames.len() - 1, i));
    let free = pull.dot(normal);
    let is_straight = |bend: &&f64| (*bend - free).abs() < 0.1 * free.abs() + 8.0 * blur;
    if trip.is_back {
        // Gravity gives back as much speed as it took, a wall turns more.
        let turn: f64 =
            bends.iter().filter(|bend| !is_straight(bend)).map(|bend| free - bend).sum();
        let speeds = trip.ends();
        if free < -blur && turn < 0.5 * (speeds[0] + speeds[1]) {
            return Some(Mistake::WallMissing);
        }
        let is_shot = 2 * bends.iter().filter(is_straight).count() > bends.len();
        return Some(if is_shot { Mistake::WallElsewhere } else { Mistake::StiffnessWrong });
    }
    let [Some(first), Some(last)] = [bends.first(), bends.last()] else { return None };
    let pull = pull.length();
    let grows = last.is_nan() || *last > 4.0 * first.abs().max(2.0 * pull).max(8.0 * blur);
    Some(if grows { Mistake::InwardWallNormal } else { Mistake::WallMissing })
}

/// What a disc does beyond a wall, until it comes back.
struct Trip {
    /// How far its centre is out in each frame, m.
    way: Vec<f64>,
    is_back: bool,
}

impl Trip {
    fn of(film: &Film, i: usize, normal: DVec2, rubric: &Rubric) -> Option<Self> {
        let out = |k: usize| beyond(film.at(k, i), 0.0, normal, rubric);
        let begin = (1..film.frames.len()).find(|&k| out(k) >= 0.0 && out(k - 1) < 0.0)?;
        let is_in = |out: &f64| *out < 0.0;
        let way = (begin..film.frames.len()).map(out).take_while(|out| !is_in(out));
        let way: Vec<f64> = way.collect();
        let is_back = begin + way.len() < film.frames.len();
        Some(Self { way, is_back })
    }

    /// Speeds outward at the beginning and inward at the end, m a frame.
    fn ends(&self) -> [f64; 2] {
        let speed = |pair: &[f64]| (pair[1] - pair[0]).abs();
        let mut pairs = self.way.windows(2);
        let first = pairs.next().map_or(0.0, speed);
        [first, pairs.last().map_or(first, speed)]
    }
}

/// How deep contacts may be that have begun before the first frame, m. A program that writes after its steps, and whose
/// discs have speeds from the start, shows such: v/omega0 of the usual speed and twice of it, and no more than three
/// tenths of a radius. Of those that start at rest nobody has got so far.
fn under_way(film: &Film, flights: &Flights, rubric: &Rubric) -> f64 {
    let Some(interval) = flights.interval(rubric).filter(|_| rubric.law == Law::Spring) else {
        return 0.0;
    };
    let ways = (0..film.n()).map(|i| (film.at(1, i) - film.at(0, i)).length());
    let usual = median(ways);
    if usual < 4.0 * flights.pull.length() {
        return 0.0;
    }
    (2.0 * usual / (rubric.omega0(true) * interval)).min(0.3 * film.radius(0))
}

/// Nobody overlaps anybody, or a wall, in the first frame.
pub fn start(film: &Film, flights: &Flights, rubric: &Rubric) -> Verdict {
    let blur = 4.0 * film.usual_blur() + under_way(film, flights, rubric);
    for i in 0..film.n() {
        let (position, radius) = (film.at(0, i), film.radius(i));
        let deepest = WALLS.iter().map(|(normal, _)| beyond(position, radius, *normal, rubric));
        let deepest = deepest.fold(f64::MIN, f64::max);
        if deepest > blur + 1e-3 * radius {
            let failure = Failure::of(Finding::StartsInWall, Mistake::PlacedOutside).at(0, &[i]);
            return Status::Failed(failure.with(Quantity::DepthOverRadius, deepest / radius));
        }
    }
    for i in 0..film.n() {
        for j in i + 1..film.n() {
            let touch = film.radius(i) + film.radius(j);
            let overlap = touch - (film.at(0, i) - film.at(0, j)).length();
            if overlap > blur + 1e-3 * touch {
                let failure = Failure::of(Finding::StartsOverlapping, Mistake::PlacedOverlapping);
                let failure = failure.at(0, &[i, j]);
                let over = overlap / film.radius(i);
                return Status::Failed(failure.with(Quantity::DepthOverRadius, over));
            }
        }
    }
    Status::Passed
}
