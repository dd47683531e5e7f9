//! Meetings of two discs: from the flights before and after, whatever happened between.
//!
//! Gravity pulls both alike, so relative to one another they fly straight. Two things are then the
//! same before and after, for every force along the line of centres, soft or hard, damped or
//! not, however long it lasts: the sum of the velocities (equal masses), and the relative angular
//! momentum r × v. Neither needs the moment or the place of the contact.

use glam::DVec2;

use super::film::Film;
use super::flight::{Flights, Run};
use super::mistake::Mistake;
use super::verdict::{Failure, Status, Verdict};
use super::words::{Finding, Quantity};

/// A meeting: two discs that would have overlapped, had they flown on. Lengths in m, times in frames.
#[derive(Clone, Copy, Debug)]
pub struct Collision {
    /// The discs.
    pub discs: [usize; 2],
    /// Frame before it.
    pub begin: usize,
    /// Frame after it.
    pub frame: usize,
    /// How near their centres would have come, over the distance at which they touch.
    pub aim: f64,
    /// Change of each velocity, gravity taken off, over the relative speed before.
    pub kicks: [DVec2; 2],
    /// Change of r × v, over the touching distance and the relative speed before.
    pub twist: f64,
    /// How much of |r × v| is lost, in the same unit.
    pub lost: f64,
    /// Relative speed along the centres after over before, at the touching distance.
    pub restitution: f64,
    /// Relative speed before, m a frame.
    pub speed: f64,
    /// Distance at which they touch, m.
    pub touch: f64,
    /// How long they touch, frames.
    pub touching: f64,
    /// What printing makes of a velocity at most, over the relative speed before.
    pub blur: f64,
}

impl Collision {
    fn sum(&self) -> f64 {
        (self.kicks[0] + self.kicks[1]).length()
    }

    /// Whether they pushed each other at all.
    pub fn is_push(&self) -> bool {
        self.size() > 0.03 + 4.0 * self.blur
    }

    /// Twice the larger kick: what equal and opposite ones make together.
    fn size(&self) -> f64 {
        2.0 * self.kicks[0].length().max(self.kicks[1].length())
    }
}

/// All meetings of two discs with no third and no wall near, fast enough to be measured.
pub fn all(film: &Film, flights: &Flights) -> Vec<Collision> {
    let mut found = Vec::new();
    for i in 0..film.n() {
        for pair in flights.runs[i].windows(2) {
            let (first, second) = (pair[0], pair[1]);
            let Some(j) = partner(flights, i, first.end..second.begin) else { continue };
            let same = flights.runs[j].windows(2).find(|p| p[0].end == first.end);
            let Some(same) = same.filter(|p| i < j && p[1].begin == second.begin) else { continue };
            if partner(flights, j, first.end..second.begin) == Some(i) {
                found.extend(meeting(film, flights, [i, j], [first, same[0]], [second, same[1]]));
            }
        }
    }
    found
}

/// The only one whom disc `i` may have met in these intervals.
fn partner(flights: &Flights, i: usize, intervals: std::ops::Range<usize>) -> Option<usize> {
    let mut only = None;
    for row in &flights.near[intervals] {
        let near = row[i];
        if near.walls != 0 || near.many || (only.is_some() && only != near.partner) {
            return None;
        }
        only = near.partner;
    }
    only.map(|j| j as usize)
}

fn meeting(
    film: &Film,
    flights: &Flights,
    discs: [usize; 2],
    first: [Run; 2],
    second: [Run; 2],
) -> Option<Collision> {
    let (begin, end) = (first[0].end, second[0].begin);
    let [before, after] = [(first, begin), (second, end)]
        .map(|(runs, k)| [0, 1].map(|one| flights.velocity(film, discs[one], runs[one], k)));
    let way = film.at(begin, discs[1]) - film.at(begin, discs[0]);
    let way_after = film.at(end, discs[1]) - film.at(end, discs[0]);
    let (relative, relative_after) = (before[1] - before[0], after[1] - after[0]);
    let speed = relative.length();
    let runs = [first[0], first[1], second[0], second[1]];
    let blur = runs.map(|run| Flights::velocity_blur(film, run)).iter().sum::<f64>();
    let touch = film.radius(discs[0]) + film.radius(discs[1]);
    let frames = (end - begin) as f64;
    let moment = -way.dot(relative) / speed.powi(2);
    let aim = way.perp_dot(relative).abs() / speed / touch;
    if speed < 20.0 * blur || aim > 0.9 || !(0.0..=frames).contains(&moment) {
        return None;
    }
    let kicks = [0, 1].map(|one| (after[one] - before[one] - flights.pull * frames) / speed);
    let moments = [way.perp_dot(relative), way_after.perp_dot(relative_after)];
    let lost = (moments[0] - moments[1]) * moments[0].signum() / (touch * speed);
    let across = (aim * speed).powi(2);
    let along_after = (relative_after.length_squared() - across).max(0.0);
    let restitution = (along_after / (speed * speed - across)).sqrt();
    let twist = lost.abs();
    let (frame, blur) = (end, blur / speed);
    let touching =
        frames - to_touch(way, relative, touch) - to_touch(way_after, -relative_after, touch);
    Some(Collision {
        discs,
        begin,
        frame,
        aim,
        kicks,
        twist,
        lost,
        restitution,
        speed,
        touch,
        touching,
        blur,
    })
}

/// How long two discs fly until they touch, frames, from where one is seen from the other and how fast it
/// comes nearer; if they would pass, until they are nearest.
fn to_touch(way: DVec2, relative: DVec2, touch: f64) -> f64 {
    let square = relative.length_squared();
    let nearest = -way.dot(relative) / square;
    let aside = way.perp_dot(relative).powi(2) / square;
    nearest - ((touch * touch - aside).max(0.0) / square).sqrt()
}

/// What printing may make of a twist: a velocity is off, and acts at the distance of the frames.
fn most_twist(one: &Collision) -> f64 {
    0.2 + 40.0 * one.blur
}

/// Two discs push each other equally, oppositely, along the line of their centres.
pub fn verdict(collisions: &[Collision]) -> Verdict {
    if collisions.len() < 2 {
        return Status::NotSeen;
    }
    // Full on: who only grazes is hardly pushed.
    let (deep, shallow): (Vec<&Collision>, Vec<&Collision>) =
        collisions.iter().filter(|one| one.aim < 0.8).partition(|one| one.aim < 0.5);
    let through = |some: &[&Collision]| some.iter().filter(|one| !one.is_push()).count();
    let passed = [through(&deep), through(&shallow)];
    let shown = deep.iter().chain(&shallow).find(|one| !one.is_push());
    if let Some(one) = shown.filter(|_| {
        2 * (passed[0] + passed[1]) > deep.len() + shallow.len()
            || passed[1] >= 2 && 3 * passed[1] > 2 * shallow.len()
    }) {
        let is_near = !deep.is_empty() && 2 * passed[0] < deep.len();
        let cause = if is_near { Mistake::ContactAtOneRadius } else { Mistake::Tunnelling };
        let failure = Failure::of(Finding::PassThrough, cause).at(one.frame, &one.discs);
        return Status::Failed(failure.with(Quantity::Aim, one.aim));
    }
    let pushes: Vec<&Collision> = collisions.iter().filter(|one| one.is_push()).collect();
    unequal(&pushes).or_else(|| crooked(&pushes)).map_or(Status::Passed, Status::Failed)
}

/// What is bad in more than a fifth of the meetings, and more than once.
fn often<'a>(all: &[&'a Collision], is_bad: impl Fn(&Collision) -> bool) -> Option<&'a Collision> {
    let bad: Vec<&'a Collision> = all.iter().copied().filter(|one| is_bad(one)).collect();
    let is_often = bad.len() >= 2 && 5 * bad.len() > all.len();
    bad.first().copied().filter(|_| is_often)
}

fn unequal(pushes: &[&Collision]) -> Option<Failure> {
    let worst = often(pushes, |one| one.sum() > 0.1 + 4.0 * one.blur)?;
    // Kicks the same way, of the same size.
    let alike = |one: &Collision| one.sum() > 0.8 * one.size();
    if let Some(one) = often(pushes, alike) {
        let failure = Failure::of(Finding::PushedAlike, Mistake::ReactionSign);
        let failure = failure.at(one.frame, &one.discs);
        let [a, b] = one.kicks.map(DVec2::length);
        return Some(failure.with(Quantity::KickFirst, a).with(Quantity::KickSecond, b));
    }
    let lonely = |one: &Collision| {
        let [a, b] = one.kicks.map(DVec2::length);
        a.min(b) < 0.1 * a.max(b) + one.blur
    };
    let cause = often(pushes, lonely).map(|_| Mistake::ForceOnOneDiscOnly);
    let [a, b] = worst.kicks.map(DVec2::length);
    let failure = Failure::of(Finding::PushesUnequal, cause).at(worst.frame, &worst.discs);
    Some(failure.with(Quantity::KickFirst, a).with(Quantity::KickSecond, b))
}

fn crooked(pushes: &[&Collision]) -> Option<Failure> {
    let worst = often(pushes, |one| one.twist > most_twist(one))?;
    let failure = Failure::of(Finding::PushCrooked, None).at(worst.frame, &worst.discs);
    Some(failure.with(Quantity::Twist, worst.twist))
}
