//! Frames that are right but for how they are written: columns in another order, another unit, another corner of the
//! box.
//!
//! Each is told only if radii or places are wrong as they were read, and right as they are put: so a right film is never
//! touched, and what follows is judged as if it had been written rightly. One mistake costs one check.

use glam::DVec2;

use super::check::Check;
use super::digits::Digits;
use super::film::Film;
use super::lines::COLUMNS;
use super::misread::Misread;
use super::mistake::Mistake;
use super::rubric::Rubric;
use super::spot::Spot;
use super::verdict::{Failure, Status};
use super::words::{Finding, Quantity};

/// What lengths are printed in, units a metre: cm and mm.
const UNITS: [f64; 2] = [1e2, 1e3];

/// Frames in which it is looked for where the box is.
const FRAMES: usize = 50;

/// The columns of x, y and r that make right what is wrong as it stands in the first three, if there are any: x before
/// y, the nearer the better.
pub fn columns(sample: &[[f64; COLUMNS]], rubric: &Rubric) -> Option<[usize; 3]> {
    if rubric.radius.is_empty() || sample.is_empty() {
        return None;
    }
    let spot = |row: &[f64; COLUMNS], [x, y, r]: [usize; 3]| Spot {
        position: DVec2::new(row[x], row[y]),
        radius: row[r],
    };
    let spots = |columns: [usize; 3]| sample.iter().map(move |row| spot(row, columns));
    if spots([0, 1, 2]).any(|spot| has_right_radius(&spot, rubric)) {
        return None;
    }
    let varies = |k: usize| sample.len() == 1 || sample.iter().any(|row| row[k] != sample[0][k]);
    let pairs = (1..COLUMNS).flat_map(|way| (0..COLUMNS - way).map(move |x| (x, x + way)));
    let pairs = pairs.filter(|&(x, y)| varies(x) && varies(y));
    let orders = pairs.flat_map(|(x, y)| (0..COLUMNS).map(move |r| [x, y, r]));
    let mut orders = orders.filter(|[x, y, r]| r != x && r != y);
    orders.find(|&order| are_right(spots(order), rubric))
}

/// Whether most radii are such as the rubric asks for, in m as they were read: a coordinate may be one by chance.
pub fn has_radii_asked(film: &Film, rubric: &Rubric) -> bool {
    let spots = film.frames.iter().flatten();
    let right = spots.clone().filter(|spot| has_right_radius(spot, rubric)).count();
    film.misread.is_none() && 2 * right > spots.count()
}

fn has_right_radius(spot: &Spot, rubric: &Rubric) -> bool {
    rubric.radius.iter().any(|asked| (spot.radius / asked - 1.0).abs() < 1e-3)
}

/// Whether half of the spots and more have a right radius (there may be a border), and of these all lie in the box, three
/// of four as whole discs.
fn are_right(spots: impl Iterator<Item = Spot>, rubric: &Rubric) -> bool {
    let (mut all, mut right, mut whole) = (0, 0, 0);
    for spot in spots {
        all += 1;
        if has_right_radius(&spot, rubric) {
            if !is_in(spot.position, 1e-9 * rubric.side, rubric) {
                return false;
            }
            right += 1;
            whole += usize::from(is_in(spot.position, -0.99 * spot.radius, rubric));
        }
    }
    right > 0 && 2 * right >= all && 4 * whole >= 3 * right
}

/// Whether a place lies in the box, or so far outside, m.
fn is_in(position: DVec2, slack: f64, rubric: &Rubric) -> bool {
    let low = position - DVec2::from(rubric.corner);
    low.min_element() >= -slack && low.max_element() <= rubric.side + slack
}

impl Film {
    /// Puts right another unit or another corner of the box, and notes it.
    pub(super) fn put_right(&mut self, rubric: &Rubric) {
        if let Some(unit) = self.unit(rubric) {
            self.misread = Some(Misread::Unit(unit));
            self.digits = match self.digits {
                Digits::Fixed(decimals) => Digits::Fixed(decimals + unit.log10().round() as i32),
                general => general,
            };
            for spot in self.frames.iter_mut().flatten() {
                *spot = in_unit(spot, unit);
            }
        } else if let Some(shift) = self.shift(rubric) {
            self.misread = Some(Misread::Shifted(shift));
            self.digits = match self.digits {
                // What was printed is up to half a side long, wherever it is now.
                general @ Digits::General(_) => {
                    Digits::Fixed(-(2.0 * general.half_unit(0.5 * self.side)).log10().round() as i32)
                }
                fixed => fixed,
            };
            for spot in self.frames.iter_mut().flatten() {
                spot.position -= shift;
            }
        }
    }

    /// The unit in which lengths are right, if they are not in m.
    fn unit(&self, rubric: &Rubric) -> Option<f64> {
        let first = self.frames.first()?;
        if rubric.radius.is_empty() || first.iter().any(|spot| has_right_radius(spot, rubric)) {
            return None;
        }
        let is_right =
            |unit: &f64| are_right(first.iter().map(|spot| in_unit(spot, *unit)), rubric);
        UNITS.into_iter().find(is_right)
    }

    /// How far the box is shifted, if discs are at home there in all frames, and not in the rubric's.
    fn shift(&self, rubric: &Rubric) -> Option<DVec2> {
        let step = self.frames.len().div_ceil(FRAMES).max(1);
        let spots = || self.frames.iter().step_by(step).flatten();
        let discs: Vec<&Spot> = spots().filter(|spot| is_disc(spot, rubric)).collect();
        let share = |shift: DVec2| {
            let is_home = |spot: &&&Spot| is_in(spot.position - shift, spot.radius, rubric);
            discs.iter().filter(is_home).count() as f64 / discs.len().max(1) as f64
        };
        if discs.is_empty() || share(DVec2::ZERO) > 0.8 {
            return None;
        }
        let half = -0.5 * rubric.side;
        let shifts = [DVec2::splat(half), DVec2::new(half, 0.0), DVec2::new(0.0, half)];
        shifts.into_iter().find(|&shift| share(shift) > 0.98)
    }

    /// What a check says of a film that was put right; nothing if that is another's, or the film was right.
    pub fn failure_as_written(&self, check: Check) -> Option<Status> {
        let first = self.frames.first()?.first()?;
        let at = |finding, cause| Failure::of(finding, cause).at(0, &[]);
        let failure = match (check, self.misread?) {
            (Check::Radii, Misread::Columns(columns)) => columns.into_iter().fold(
                at(Finding::ColumnsExchanged, Mistake::ColumnsExchanged),
                |failure, column| failure.with(Quantity::Column, column as f64 + 1.0),
            ),
            (Check::Radii, Misread::Unit(unit)) => at(Finding::OtherUnit, Mistake::OtherUnit)
                .with(Quantity::Radius, unit * first.radius)
                .with(Quantity::RadiusAsked, first.radius),
            (Check::Box, Misread::Shifted(shift)) => at(Finding::BoxShifted, Mistake::BoxShifted)
                .with(Quantity::CornerX, self.corner.x + shift.x)
                .with(Quantity::CornerY, self.corner.y + shift.y),
            _ => return None,
        };
        Some(Status::Failed(failure))
    }
}

/// A spot whose lengths are so many times what they are in m.
fn in_unit(spot: &Spot, unit: f64) -> Spot {
    Spot { position: spot.position / unit, radius: spot.radius / unit }
}

/// Whether a spot may be a disc of the course, and is none of a border.
fn is_disc(spot: &Spot, rubric: &Rubric) -> bool {
    rubric.radius.is_empty() || has_right_radius(spot, rubric)
}
