//! Bounces on one wall: from the flight before and the flight after, whatever happened between.

use glam::DVec2;

use super::film::Film;
use super::flight::{Flights, Run};
use super::rubric::Rubric;
use super::verdict::{Failure, Status, Verdict};
use super::wall::{WALLS, Wall};
use super::words::{Finding, Quantity};

/// A bounce; speeds in m a frame.
#[derive(Clone, Copy, Debug)]
pub struct Bounce {
    /// Wall, one of the bits of [`WALLS`].
    pub wall: u8,
    /// Disc.
    pub disc: usize,
    /// Frame before it.
    pub begin: usize,
    /// Frame after it.
    pub frame: usize,
    /// Speed towards the wall where they touch.
    pub before: f64,
    /// Speed away from it where they part.
    pub after: f64,
    /// How long they touch, frames.
    pub touching: f64,
    /// Gravity towards the wall, m a frame².
    pub pull: f64,
    /// Change of the speed along the wall, gravity taken off.
    pub slip: f64,
    /// What printing makes of a speed at most.
    pub blur: f64,
}

impl Bounce {
    /// Whether gravity alone brought the disc back: it met no wall.
    fn fell_back(&self) -> bool {
        self.pull < 0.0 && -self.pull * self.touching > 0.7 * (self.before + self.after)
    }
}

/// All bounces on one wall with nobody else near, fast enough to be measured.
pub fn all(film: &Film, flights: &Flights, rubric: &Rubric) -> Vec<Bounce> {
    let of_disc = |i: usize| {
        let pairs = flights.runs[i].windows(2);
        pairs.filter_map(move |pair| bounce(film, flights, rubric, i, (pair[0], pair[1])))
    };
    (0..film.n())
        .flat_map(of_disc)
        .filter(|one| one.before > slowest(one, flights, rubric) && !one.fell_back())
        .collect()
}

/// Below it a bounce is not measured: digits, and gravity's part in the contact.
fn slowest(bounce: &Bounce, flights: &Flights, rubric: &Rubric) -> f64 {
    let weight = flights
        .interval(rubric)
        .map_or(0.0, |interval| 10.0 * flights.pull.length() / (rubric.omega0(true) * interval));
    weight.max(20.0 * bounce.blur)
}

fn bounce(
    film: &Film,
    flights: &Flights,
    rubric: &Rubric,
    i: usize,
    (first, second): (Run, Run),
) -> Option<Bounce> {
    let gap = &flights.near[first.end..second.begin];
    if gap.iter().any(|row| row[i].partner.is_some() || row[i].many) {
        return None;
    }
    let walls = gap.iter().fold(0, |walls, row| walls | row[i].walls);
    let (normal, _) = WALLS.into_iter().find(|(_, bit)| *bit == walls)?; // one, and no corner
    let along = normal.perp();
    let centre = DVec2::from(rubric.corner) + DVec2::splat(0.5 * rubric.side);
    // Along the normal: how far it still is to the touch, and the speed there by v² = u² + 2 a s.
    let pull = flights.pull.dot(normal);
    let touch = 0.5 * rubric.side - film.radius(i);
    let square = |velocity: DVec2, k: usize| {
        velocity.dot(normal).powi(2) + 2.0 * pull * (touch - (film.at(k, i) - centre).dot(normal))
    };
    let before = flights.velocity(film, i, first, first.end);
    let after = flights.velocity(film, i, second, second.begin);
    let squares = [square(before, first.end), square(after, second.begin)];
    if squares[0] <= 0.0 || squares[1] < 0.0 {
        return None; // it turned before it touched
    }
    let speeds = squares.map(f64::sqrt);
    // From the last free frame to the touch, and from the parting to the next: a way over a mean speed.
    let way = |k: usize| touch - (film.at(k, i) - centre).dot(normal);
    let to_touch = 2.0 * way(first.end) / (before.dot(normal) + speeds[0]);
    let from_parting = 2.0 * way(second.begin) / (speeds[1] - after.dot(normal));
    let frames = (second.begin - first.end) as f64;
    let slip = (after - before - flights.pull * frames).dot(along);
    Some(Bounce {
        wall: walls,
        disc: i,
        begin: first.end,
        frame: second.begin,
        before: speeds[0],
        after: speeds[1],
        touching: frames - to_touch - from_parting,
        pull,
        slip: slip.abs(),
        blur: Flights::velocity_blur(film, first) + Flights::velocity_blur(film, second),
    })
}

/// A wall changes the velocity across it and not along it.
pub fn verdict(bounces: &[Bounce]) -> Verdict {
    if bounces.len() < 2 {
        return Status::NotSeen;
    }
    let is_bad = |one: &&Bounce| one.slip > 0.05 * one.before + 4.0 * one.blur;
    let bad: Vec<&Bounce> = bounces.iter().filter(is_bad).collect();
    match bad.first() {
        // One in five: a disc that nobody saw may have been met as well.
        Some(worst) if 5 * bad.len() > bounces.len() => {
            let failure = Failure::of(Finding::WallDragsAlong, None);
            let failure = failure.at(worst.frame, &[worst.disc]).on(Wall::of(worst.wall));
            Status::Failed(failure.with(Quantity::SlipOverSpeed, worst.slip / worst.before))
        }
        _ => Status::Passed,
    }
}
