//! Two runs that differ by the last bit of one number: how long they stay comparable.
//!
//! Each meeting of round bodies multiplies a small difference (Sinai 1970): two discs that pass a
//! hair further to the side leave in another direction. The distance between the runs then grows
//! like exp(lambda t), with lambda the largest Lyapunov exponent, until it is as large as the box.
//! That is a property of the discs: no step and no precision does away with it.
//!
//! A coarse step adds to it. After a bounce the energy errs by an amount that hangs on where in a
//! step the touch fell; so does the time of the next touch, and if that shifts by more than a
//! step, the next phase is as good as random. Measured: one disc falling 0.02 m, alone, with N_t = 50
//! and dt one bit longer, goes astray at some 50/s, with N_t = 200 at 13/s, with N_t = 1000 not at all.

use super::line::Line;
use crate::particle::Particle;
use crate::simulation::Simulation;

/// Growth below this factor is no evidence of an exponential: rounding alone drives two regular
/// runs apart by some thousands of the first difference in a hundred thousand steps.
const LEAST_GROWTH: f64 = 1e6;

/// The exponential range begins where the distance has grown by this factor: before, the first
/// contacts are still to come.
const BEGUN: f64 = 100.0;

/// The exponential range ends at this distance, in radii: then the twins meet other discs.
pub const SEPARATE: f64 = 0.01;

/// The next larger number than `value`, which must be positive and finite: one unit in the last
/// place more.
///
/// ```
/// use parsim2d::analysis::twin::next_up;
/// assert_eq!(next_up(1.0), 1.0 + f64::EPSILON);
/// ```
pub fn next_up(value: f64) -> f64 {
    f64::from_bits(value.to_bits() + 1)
}

/// Root mean square distance, m, between discs of the same id.
pub fn distance(a: &[Particle], b: &[Particle]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| a.position.distance_squared(b.position));
    (squares.sum::<f64>() / a.len().max(1) as f64).sqrt()
}

/// Steps `run` and all `twins` `steps` times. Returns the times, s, of about `points` evenly
/// spaced steps, and for each twin its distances from `run`, m, at them. `progress` is told how
/// many steps were done since the last point.
pub fn distances(
    run: &mut Simulation,
    twins: &mut [Simulation],
    steps: u64,
    points: u64,
    progress: &mut dyn FnMut(u64),
) -> Vec<Vec<(f64, f64)>> {
    let every = steps.div_ceil(points.max(1)).max(1);
    let mut distances = vec![Vec::new(); twins.len()];
    let mut next = 0;
    loop {
        for (twin, distances) in twins.iter_mut().zip(&mut distances) {
            (twin.steps()..next).for_each(|_| twin.step());
            (run.steps()..next).for_each(|_| run.step());
            distances.push((run.time(), distance(run.particles(), twin.particles())));
        }
        if next == steps {
            return distances;
        }
        let before = next;
        next = (next + every).min(steps);
        progress(next - before);
    }
}

/// Exponential growth of a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Growth {
    /// lambda of exp(lambda t), 1/s.
    pub rate: f64,
    /// The range the rate was fitted over, s.
    pub from: f64,
    /// Its end, s.
    pub until: f64,
}

impl Growth {
    /// The rate of the line through ln(distance) from where the distance is 100 times the first
    /// one, to where it reaches 1 % of `radius` (m), or to the end of the run. `None` where nothing
    /// grows like an exponential: less than a million-fold, or as well described by a power of
    /// time.
    ///
    /// ```
    /// use parsim2d::analysis::twin::Growth;
    /// let chaos: Vec<_> = (0..200).map(|k| (0.01 * k as f64, 1e-18 * (0.15 * k as f64).exp())).collect();
    /// let growth = Growth::of(&chaos, 1e-4).unwrap();
    /// assert!((growth.rate - 15.0).abs() < 1e-9); // 1/s
    /// let calm: Vec<_> = (0..200).map(|k| (0.01 * k as f64, 1e-18 * (1 + k) as f64)).collect();
    /// assert_eq!(Growth::of(&calm, 1e-4), None);
    /// ```
    pub fn of(distances: &[(f64, f64)], radius: f64) -> Option<Self> {
        let first = distances.iter().map(|p| p.1).find(|&distance| distance > 0.0)?;
        let begun = distances.iter().position(|p| p.1 > BEGUN * first)?;
        let range = &distances[begun..];
        let end = range.iter().position(|p| p.1 >= SEPARATE * radius).unwrap_or(range.len() - 1);
        let range = &range[..=end];
        let grown = range.last()?.1 / first;
        let logarithms = |x: fn(f64) -> f64| {
            let points = range.iter().filter(|p| p.1 > 0.0 && p.0 > 0.0);
            Line::through(&points.map(|p| (x(p.0), p.1.ln())).collect::<Vec<_>>())
        };
        let (exponential, power) = (logarithms(|t| t)?, logarithms(f64::ln)?);
        let is_exponential = grown >= LEAST_GROWTH && exponential.slope > 0.0;
        (is_exponential && range.len() > 3 && !is_better(power, exponential)).then_some(Self {
            rate: exponential.slope,
            from: range[0].0,
            until: range[end].0,
        })
    }

    /// Time in which the distance doubles, s.
    pub fn doubling_time(&self) -> f64 {
        std::f64::consts::LN_2 / self.rate
    }
}

/// A power of time of a moderate degree, with half the scatter, describes the points better.
fn is_better(power: Line, exponential: Line) -> bool {
    power.slope < 4.0 && power.scatter < 0.5 * exponential.scatter
}

/// The first time, s, at which the distance reaches 1 % of `radius` (m).
pub fn separation_time(distances: &[(f64, f64)], radius: f64) -> Option<f64> {
    distances.iter().find(|p| p.1 >= SEPARATE * radius).map(|p| p.0)
}
