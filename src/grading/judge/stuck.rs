//! Discs that touch and do not part: what a damping far above critical does.
//!
//! Such a contact has no flight after it, so it is no bounce and no meeting. It is told by what follows
//! the flight before: some frames at the same wall or partner with nobody else near, in which the
//! distance hardly changes. On a floor discs come to rest anyway: there only those count that
//! should still rise after that.

use std::f64::consts::PI;
use std::ops::Range;

use super::film::Film;
use super::flight::{Flights, Run};
use super::near::Near;
use super::rubric::Rubric;
use super::wall::WALLS;

/// Frames in which they stay together, after those in which the contact comes about.
const STAYS: usize = 2;

/// Places, a frame and its discs, where discs stayed together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stuck {
    /// At walls, each with the bit of its wall.
    pub walls: Vec<(u8, (usize, Vec<usize>))>,
    /// Two discs.
    pub pairs: Vec<(usize, Vec<usize>)>,
}

impl Stuck {
    /// Finds them.
    pub fn of(film: &Film, flights: &Flights, rubric: &Rubric) -> Self {
        let mut stuck = Self::default();
        // A right contact would be over, and half as long again.
        let lasts = flights.interval(rubric).map_or(0.0, |t| 1.5 * PI / (rubric.omega0(false) * t));
        let (before, most) = (2 + lasts.ceil() as usize, film.frames.len());
        for i in 0..film.n() {
            for &run in &flights.runs[i] {
                let gap = run.end..run.end + (STAYS + before).min(most);
                if gap.end > flights.near.len() || run.end - run.begin < 2 {
                    continue;
                }
                if let Some(wall) = stays_at_wall(film, flights, i, run, gap.clone(), rubric) {
                    stuck.walls.push((wall, (gap.end, vec![i])));
                } else if let Some(j) = stays_with(film, flights, i, run, gap.clone()) {
                    stuck.pairs.push((gap.end, vec![i, j]));
                }
            }
        }
        stuck
    }
}

/// Whether a distance, m, hardly changes at the end of a gap, beside the speed, m a frame, at which
/// it was closed: less than a twentieth comes back.
fn stays(distance: impl Fn(usize) -> f64, speed: f64, blur: f64, gap: &Range<usize>) -> bool {
    let change = (distance(gap.end) - distance(gap.end - STAYS)).abs() / STAYS as f64;
    speed > 20.0 * blur && change < 0.05 * speed
}

fn stays_at_wall(
    film: &Film,
    flights: &Flights,
    i: usize,
    run: Run,
    gap: Range<usize>,
    rubric: &Rubric,
) -> Option<u8> {
    let near = flights.near[gap.start][i];
    let is_same = flights.near[gap.clone()].iter().all(|row| row[i] == near);
    let wall = WALLS.into_iter().find(|(_, bit)| *bit == near.walls);
    let (normal, bit) = wall.filter(|_| is_same && near.partner.is_none())?;
    let speed = flights.velocity(film, i, run, run.end).dot(normal);
    let middle = film.corner + 0.5 * rubric.side;
    let distance =
        |k: usize| 0.5 * rubric.side - film.radius(i) - (film.at(k, i) - middle).dot(normal);
    let is_reached = distance(run.end) < 2.0 * speed;
    let rises = rubric.expected_restitution(true).0 * speed;
    // It would still rise at the end.
    let is_high = rises > 1.3 * gap.len() as f64 * flights.pull.dot(normal);
    let blur = Flights::velocity_blur(film, run);
    (is_reached && is_high && stays(distance, speed, blur, &gap)).then_some(bit)
}

fn stays_with(
    film: &Film,
    flights: &Flights,
    i: usize,
    run: Run,
    gap: Range<usize>,
) -> Option<usize> {
    let near = flights.near[gap.start][i];
    let j = near.partner.filter(|_| near.walls == 0 && !near.many)? as usize;
    let is_same = |row: &Vec<Near>| row[i] == near && row[j] == Near::with(i);
    let other = flights.runs[j].iter().find(|other| other.end == run.end)?;
    if j < i || other.end - other.begin < 2 || !flights.near[gap.clone()].iter().all(is_same) {
        return None;
    }
    let relative =
        flights.velocity(film, j, *other, run.end) - flights.velocity(film, i, run, run.end);
    let way = |k: usize| film.at(k, j) - film.at(k, i);
    let touch = film.radius(i) + film.radius(j);
    let aim = way(run.end).perp_dot(relative).abs() / relative.length() / touch;
    let speed = -relative.dot(way(run.end).normalize_or_zero());
    let distance = |k: usize| way(k).length() - touch;
    let is_met = aim < 0.5 && distance(run.end) < 2.0 * speed;
    let blur = 2.0 * Flights::velocity_blur(film, run);
    (is_met && stays(distance, speed, blur, &gap)).then_some(j)
}
