//! How long contacts last, and what that says of springs and of the places of walls.
//!
//! From the flights before and after follows when two surfaces touched and when they parted, far more
//! finely than frames lie apart: right programs are within 0.02 of pi/omega0 at walls. The time between
//! frames comes from gravity, so what is measured is the stiffness over mass and gravity. A wall at
//! another place also makes contacts longer, but by a way, 2 s/v, and not by a factor.

use super::bounce::Bounce;
use super::collision::Collision;
use super::film::Film;
use super::flight::{Flights, median};
use super::mistake::Mistake;
use super::rubric::{Law, Rubric};
use super::stiffness::Stiffness;
use super::verdict::Failure;
use super::wall::{WALLS, Wall};
use super::words::{Finding, Quantity};
use crate::analysis::collision::{ContactEnd, damping_ratio_for, scaled_duration};

/// A contact that lasts for less than this part of the time asked for is an impulse: right, as no spring
/// is softer than asked.
const IMPULSE: f64 = 0.1;

/// A wall that is felt elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub struct Shift {
    /// How far beyond the wall discs touch, radii.
    pub over_radius: f64,
    /// A frame and the disc.
    pub place: (usize, usize),
    /// The wall.
    pub wall: Wall,
}

impl Shift {
    /// What it looks like.
    pub fn cause(&self) -> Mistake {
        let is_centre = (0.8..1.2).contains(&self.over_radius);
        if is_centre { Mistake::WallAtCentre } else { Mistake::WallElsewhere }
    }

    /// The failure of a wall that is elsewhere.
    pub fn failure(&self) -> Failure {
        let failure = Failure::of(Finding::WallShifted, self.cause());
        let failure = failure.at(self.place.0, &[self.place.1]).on(self.wall);
        failure.with(Quantity::ShiftOverRadius, self.over_radius)
    }
}

/// What the times of contacts at a wall say.
#[derive(Clone, Debug, PartialEq)]
pub enum Touching {
    /// Its stiffness.
    Spring(Stiffness),
    /// Its place.
    Shifted(Shift),
}

/// A contact: how long it lasts over what is right, and where it is seen.
struct Contact {
    ratio: f64,
    place: (usize, Vec<usize>),
}

/// The wall that is furthest from what was asked, if discs met it three times; all together if they met
/// each too seldom.
pub fn wall(
    film: &Film,
    bounces: &[Bounce],
    flights: &Flights,
    rubric: &Rubric,
) -> Option<Touching> {
    let interval = flights.interval(rubric).filter(|_| rubric.law == Law::Spring)?;
    // A disc whose centre goes through the wall may be pushed less there: only slow ones tell.
    let is_slow =
        |one: &&Bounce| one.before < 0.9 * film.radius(one.disc) * rubric.omega0(true) * interval;
    let slow: Vec<&Bounce> = bounces.iter().filter(is_slow).collect();
    let of = |wall: u8| -> Vec<&Bounce> {
        slow.iter().copied().filter(|one| one.wall & wall != 0).collect()
    };
    let each = WALLS.iter().map(|(_, bit)| of(*bit)).filter(|some| some.len() >= 3);
    let all = each.filter_map(|some| told(film, &some, interval, rubric));
    let worst = all.max_by(|a, b| a.0.total_cmp(&b.0));
    worst.or_else(|| told(film, &of(0xf), interval, rubric)).map(|(_, touching)| touching)
}

/// What some bounces say, and by what power of e their times are off.
fn told(film: &Film, some: &[&Bounce], interval: f64, rubric: &Rubric) -> Option<(f64, Touching)> {
    let right = |one: &Bounce| duration(true, one.after / one.before, rubric) / interval;
    let contact = |one: &&Bounce| Contact {
        ratio: one.touching / right(one),
        place: (one.frame, vec![one.disc]),
    };
    let spring = stiffness(some.iter().map(contact).collect(), rubric)?;
    let off = spring.ratio.ln().abs();
    // A factor is the same for all of them, or a way is.
    let of_time = spread(some.iter().map(|one| one.touching / right(one)));
    let ways = some.iter().map(|one| way(one, right(one)));
    if !spring.is_soft() || spread(ways.clone()) > 0.5 * of_time {
        return Some((off, Touching::Spring(spring)));
    }
    let (shown, way) = (some[some.len() / 2], median(ways));
    let (over_radius, place) = (way / film.radius(shown.disc), (shown.frame, shown.disc));
    Some((off, Touching::Shifted(Shift { over_radius, place, wall: Wall::of(shown.wall) })))
}

/// How far beyond the wall a disc touches, if its spring is right, m: there and back in what is left of the
/// time.
fn way(one: &Bounce, right: f64) -> f64 {
    let left = (one.touching - right).max(0.0);
    let gone = |speed: f64, time: f64| speed * time + 0.5 * one.pull * time * time;
    let (mut low, mut high) = (0.0, left);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        let is_short = gone(one.before, middle) < gone(one.after, left - middle);
        if is_short { low = middle } else { high = middle }
    }
    gone(one.before, low)
}

/// The median distance from the median, over the median.
fn spread(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let middle = median(values.clone());
    median(values.map(|value| (value / middle - 1.0).abs()))
}

/// The stiffness of pairs, from meetings that are nearly head-on and do not go deep.
pub fn pair(collisions: &[Collision], flights: &Flights, rubric: &Rubric) -> Option<Stiffness> {
    let interval = flights.interval(rubric).filter(|_| rubric.law == Law::Spring)?;
    let right = |one: &Collision| duration(false, one.restitution, rubric) / interval;
    let deepest = |one: &Collision| one.speed / (rubric.omega0(false) * interval * one.touch);
    let is_plain = |one: &&Collision| one.aim < 0.5 && one.is_push() && deepest(one) < 0.3;
    let contact = |one: &Collision| Contact {
        ratio: one.touching / right(one),
        place: (one.frame, one.discs.to_vec()),
    };
    stiffness(collisions.iter().filter(is_plain).map(contact).collect(), rubric)
}

/// The time that a contact with restitution `e` should take, s: damping makes it longer, and is another
/// check's.
fn duration(is_wall: bool, e: f64, rubric: &Rubric) -> f64 {
    let zeta = damping_ratio_for(e.clamp(0.05, 1.0), ContactEnd::OverlapZero);
    scaled_duration(zeta, ContactEnd::OverlapZero) / rubric.omega0(is_wall)
}

fn stiffness(mut contacts: Vec<Contact>, rubric: &Rubric) -> Option<Stiffness> {
    contacts.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
    let is_enough = contacts.len() >= 2;
    let count = contacts.len();
    let middle = contacts.into_iter().nth(count / 2).filter(|_| is_enough)?;
    let ratio = if middle.ratio < IMPULSE { 1.0 } else { middle.ratio.powi(-2) };
    Some(Stiffness::timed(ratio, middle.place, rubric.stiffness_factor))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn a_contact_without_a_dashpot_takes_half_a_swing() {
        let rubric = Rubric::default();
        // sqrt(k/m) = sqrt(5e4/1e-3), and of a pair with half the mass.
        for (is_wall, omega0) in [(true, 7071.07), (false, 10_000.0)] {
            let time = duration(is_wall, 1.0, &rubric);
            assert!((time * omega0 / PI - 1.0).abs() < 1e-6, "{time}"); // digits of omega0
        }
    }
}
