//! How stiff contacts are, when they last for several frames.
//!
//! A spring makes a disc swing: its second difference over frames is -2 (1 - cos(omega T)) times the
//! overlap, T the time between frames. With T from gravity that gives omega, and omega² over the
//! rubric's is the stiffness over the rubric's. The course's springs are done in half a frame and
//! leave no trace; what is seen here is too soft, or filmed very finely.

use glam::DVec2;

use super::film::Film;
use super::flight::{Flights, median};
use super::mistake::Mistake;
use super::rubric::{Law, Rubric};
use super::verdict::Failure;
use super::wall::WALLS;
use super::words::{Finding, Quantity};

/// The stiffness of one kind of contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Stiffness {
    /// Over the rubric's; the median.
    pub ratio: f64,
    /// Whether it goes with the distance of the centres.
    pub goes_with_distance: bool,
    /// Whether the times of contacts tell it, and not swings seen in frames.
    pub is_timed: bool,
    /// Below it contacts are called soft, above it stiff.
    bounds: [f64; 2],
    place: (usize, Vec<usize>),
}

/// A second difference within a contact.
struct Sample {
    ratio: f64,
    /// Distance of the centres over that at which they touch.
    distance: f64,
    frame: usize,
    discs: Vec<usize>,
}

impl Stiffness {
    /// Of walls and of pairs, where five frames in a row are within a contact with nobody else.
    pub fn of(film: &Film, flights: &Flights, rubric: &Rubric) -> [Option<Self>; 2] {
        let interval = flights.interval(rubric).filter(|_| rubric.law == Law::Spring);
        let Some(interval) = interval else { return [None, None] };
        let (mut walls, mut pairs) = (Vec::new(), Vec::new());
        for k in 2..film.frames.len().saturating_sub(2) {
            let near = [k - 2, k - 1, k, k + 1].map(|k| &flights.near[k]);
            for i in 0..film.n() {
                let before = near[0][i];
                if before.many || near.iter().any(|row| row[i] != before) {
                    continue;
                }
                if let (0, Some(j)) = (before.walls, before.partner) {
                    let j = j as usize;
                    if i < j && near.iter().all(|row| row[j].partner == Some(i as u32)) {
                        pairs.extend(pair(film, k, [i, j], interval * rubric.omega0(false)));
                    }
                } else if before.partner.is_none() {
                    let wall = WALLS.into_iter().find(|(_, bit)| *bit == before.walls);
                    let swing = interval * rubric.omega0(true);
                    let one = |(normal, _)| at_wall(film, flights, (k, i), normal, swing, rubric);
                    walls.extend(wall.and_then(one));
                }
            }
        }
        [Self::from(walls), Self::from(pairs)]
    }

    fn from(samples: Vec<Sample>) -> Option<Self> {
        // A path that is straight within what should be a contact: it begins elsewhere, and that is
        // another mistake.
        let all = samples.len();
        let samples: Vec<Sample> = samples.into_iter().filter(|one| one.ratio > 0.0).collect();
        let is_spring = samples.len() >= 3 && 5 * samples.len() >= 4 * all;
        let shown = samples.get(samples.len() / 2).filter(|_| is_spring)?;
        let ratio = median(samples.iter().map(|one| one.ratio));
        // Spread of the logarithm, as it is and with the distance taken out.
        let spread = |of: fn(&Sample) -> f64| {
            let middle = median(samples.iter().map(of));
            median(samples.iter().map(|one| (of(one) / middle).ln().abs()))
        };
        let goes_with_distance =
            spread(|one| one.ratio / one.distance) < 0.5 * spread(|one| one.ratio);
        let place = (shown.frame, shown.discs.clone());
        // Five times softer: the literal distance to a wall, or a dashpot, makes less of a difference.
        let stiff = if samples.len() >= 10 { 1.7 } else { f64::INFINITY };
        Some(Self { ratio, goes_with_distance, is_timed: false, bounds: [0.2, stiff], place })
    }

    /// Measured by the times of contacts, and right within a `factor`.
    pub fn timed(ratio: f64, place: (usize, Vec<usize>), factor: f64) -> Self {
        let bounds = [1.0 / factor, factor];
        Self { ratio, goes_with_distance: false, is_timed: true, bounds, place }
    }

    /// Whether contacts are softer than asked.
    pub fn is_soft(&self) -> bool {
        self.ratio < self.bounds[0]
    }

    /// Whether contacts are stiffer than asked.
    pub fn is_stiff(&self) -> bool {
        self.ratio > self.bounds[1]
    }

    /// Whether contacts are not as stiff as asked.
    pub fn is_off(&self) -> bool {
        self.is_soft() || self.is_stiff()
    }

    /// What another stiffness looks like. A mass that is left out, or put in, is a factor of just its number.
    pub fn cause(&self, rubric: &Rubric) -> Mistake {
        let is_mass = (self.ratio.ln().abs() - rubric.mass.ln().abs()).abs() < 2.0_f64.ln();
        let is_far = !(0.1..10.0).contains(&self.ratio);
        if is_mass && is_far { Mistake::ForceOverWrongMass } else { Mistake::StiffnessWrong }
    }

    /// What another stiffness of pairs looks like, where walls are as asked.
    pub fn cause_of_pair(&self, rubric: &Rubric) -> Mistake {
        if self.goes_with_distance {
            Mistake::NormalNotNormalised
        } else if (1.7..2.3).contains(&self.ratio) {
            Mistake::ForceAppliedTwice
        } else {
            self.cause(rubric)
        }
    }

    /// The failure of contacts that are too soft, or too stiff.
    pub fn failure(&self, cause: Mistake) -> Failure {
        let finding =
            if self.is_soft() { Finding::ContactTooSoft } else { Finding::ContactTooStiff };
        let failure = Failure::of(finding, cause).at(self.place.0, &self.place.1);
        failure.with(Quantity::Stiffness, self.ratio)
    }
}

/// The stiffness that turns `overlap` into the second difference `bend`; none if that is within
/// what printing makes of it, or too fast for the frames.
fn ratio(bend: f64, overlap: f64, blur: f64, swing: f64) -> Option<f64> {
    let cosine = 1.0 - 0.5 * bend / overlap;
    let is_seen = bend > 8.0 * blur && cosine > 0.0;
    is_seen.then(|| (cosine.acos() / swing).powi(2))
}

/// The stiffness at the middle of five places in a row within a contact: 0 where the path is not bent
/// as a spring bends it, none if they are not all within.
///
/// One sharp push between frames bends the path at two frames; a swing bends it at three and more.
fn swinging(overlaps: [f64; 5], bends: [f64; 3], least: f64, blur: f64, swing: f64) -> Option<f64> {
    let is_within = overlaps.iter().all(|overlap| (least..1e3 * least).contains(overlap));
    let ratios = [0, 1, 2].map(|k| ratio(bends[k], overlaps[k + 1], blur, swing));
    let is_swing = ratios.iter().all(Option::is_some);
    is_within.then_some(ratios[1].filter(|_| is_swing).unwrap_or(0.0))
}

fn pair(film: &Film, k: usize, [i, j]: [usize; 2], swing: f64) -> Option<Sample> {
    let ways = around(k).map(|k| film.at(k, j) - film.at(k, i));
    let (touch, blur) = (film.radius(i) + film.radius(j), film.usual_blur());
    let bend =
        |k: usize| (ways[k] - 2.0 * ways[k + 1] + ways[k + 2]).dot(ways[k + 1].normalize_or_zero());
    let least = (0.05 * touch).max(10.0 * blur);
    let overlaps = ways.map(|way| touch - way.length());
    let ratio = swinging(overlaps, [0, 1, 2].map(bend), least, 8.0 * blur, swing)?;
    Some(Sample { ratio, distance: ways[2].length() / touch, frame: k, discs: vec![i, j] })
}

fn around(k: usize) -> [usize; 5] {
    [k - 2, k - 1, k, k + 1, k + 2]
}

fn at_wall(
    film: &Film,
    flights: &Flights,
    (k, i): (usize, usize),
    normal: DVec2,
    swing: f64,
    rubric: &Rubric,
) -> Option<Sample> {
    let centre = DVec2::from(rubric.corner) + DVec2::splat(0.5 * rubric.side);
    let touch = 0.5 * rubric.side - film.radius(i);
    let depths = around(k).map(|k| (film.at(k, i) - centre).dot(normal) - touch);
    let pull = flights.pull.dot(normal);
    let bend = |k: usize| pull - (depths[k] - 2.0 * depths[k + 1] + depths[k + 2]);
    let blur = film.usual_blur();
    let least = (0.1 * film.radius(i)).max(10.0 * blur);
    let ratio = swinging(depths, [0, 1, 2].map(bend), least, 4.0 * blur, swing)?;
    Some(Sample { ratio, distance: 1.0, frame: k, discs: vec![i] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_swing_seen_in_three_frames_gives_its_stiffness() {
        for (stiffness, swing) in [(1.0, 0.3), (1e-3, 6.0), (2.0, 0.2)] {
            let phase = f64::sqrt(stiffness) * swing;
            let [a, b, c] = [0.7, 0.7 + phase, 0.7 + 2.0 * phase].map(f64::sin);
            let found = ratio(-(a - 2.0 * b + c), b, 1e-9, swing).unwrap();
            // Exact but for rounding.
            assert!((found / stiffness - 1.0).abs() < 1e-6, "{found} for {stiffness}");
        }
        assert_eq!(ratio(1e-9, 0.1, 1e-9, 1.0), None, "within what printing makes");
    }
}
