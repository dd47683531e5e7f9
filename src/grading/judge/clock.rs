//! When frames were taken, for programs that write one as soon as the time has passed the next whole millisecond.
//!
//! Then so many steps lie between two frames, or one more, and discs seem to jump ahead or to lag behind, all at once
//! and in proportion to their speeds. That is no mistake. From free flights follows by what part of a frame each came
//! early or late; if there are two lengths of the time between frames and no others, a plausible step apart,
//! discs are put where they were at even times, and what follows sees frames equally far apart. Anything else that
//! times do (a step that grows, frames that were lost) is left as it is.

use std::f64::consts::PI;

use glam::DVec2;

use super::film::Film;
use super::flight::{Flights, Run};
use super::rubric::{Law, Rubric};

/// Rounds of fitting flights to times and times to flights, at most: in short flights times converge slowly.
const ROUNDS: usize = 200;

/// Places of discs in flight that are looked at in all rounds together.
const MOST_WORK: usize = 20_000_000;

/// Rounds after which it is seen whether frames come early or late at all.
const FIRST: usize = 3;

/// A frame's time is known if digits make less of it than this, frames.
const KNOWN: f64 = 0.02;

/// Frames of a flight that tell of times: a parabola takes three.
const LEAST: usize = 4;

/// The fewest steps of a contact with a wall that a course asks for are 10; a few less for other step sizes.
const LEAST_STEPS: f64 = 8.0;

/// The largest step of hard discs, or where gravity does not tell the time, frames.
const LARGEST_PART: f64 = 0.1;

/// Discs in flight that make a frame's time known.
const WITNESSES: usize = 3;

/// Fewer times between frames tell nothing.
const FEWEST: usize = 6;

/// Less than this part of a frame is not seen in anything.
const LEAST_PART: f64 = 5e-4;

/// When frames were taken.
#[derive(Clone, Debug)]
struct Clock {
    /// How late each frame is, frames.
    late: Vec<f64>,
    /// How far that may be off by the printed digits; infinite where nobody flies.
    blur: Vec<f64>,
    /// How many discs tell it.
    witnesses: Vec<usize>,
    /// Gravity, m a frame².
    pull: DVec2,
    /// The largest step that is plausible, frames: nothing comes later or earlier.
    largest: f64,
}

impl Film {
    /// The film with discs where they were at even times, if frames came early or late by a step.
    pub fn evenly_timed(mut self, rubric: &Rubric) -> Self {
        let flights = Flights::plain(&self, rubric);
        let long = |(i, runs): (usize, &Vec<Run>)| {
            let long = runs.iter().filter(|run| run.end + 1 - run.begin >= LEAST);
            long.map(|&run| (i, run)).collect::<Vec<_>>()
        };
        let runs: Vec<(usize, Run)> = flights.runs.iter().enumerate().flat_map(long).collect();
        let seconds = flights.interval(rubric).filter(|_| rubric.law == Law::Spring);
        let largest = seconds
            .map_or(LARGEST_PART, |interval| PI / (LEAST_STEPS * rubric.omega0(true) * interval));
        let mut clock = Clock::even(&self, flights.pull, largest);
        let places: usize = runs.iter().map(|(_, run)| run.end + 1 - run.begin).sum();
        for round in 0..ROUNDS.min(MOST_WORK / places.max(1)).max(FIRST + 1) {
            if round == FIRST && !clock.gap().is_some_and(|gap| gap.is_seen) {
                return self;
            }
            clock.adjust(&self, &runs);
        }
        if let Some(gap) = clock.gap().filter(|gap| gap.is_of_two) {
            clock.forget_what_is_not_known(gap.part);
            clock.set(&mut self, &runs);
        }
        self
    }
}

/// How the times between frames differ.
#[derive(Clone, Copy, Debug)]
struct Gap {
    /// By what part of a frame the longer half is longer than the shorter.
    part: f64,
    /// Whether it is more than digits make.
    is_seen: bool,
    /// Whether they take two values and no others.
    is_of_two: bool,
}

/// A flight fitted: place and speed at the mean of its times.
struct Flight {
    time: f64,
    place: DVec2,
    velocity: DVec2,
}

impl Flight {
    fn of(film: &Film, clock: &Clock, i: usize, run: Run) -> Self {
        let all = || run.begin..=run.end;
        let count = (run.end + 1 - run.begin) as f64;
        let time = all().map(|k| clock.time(k)).sum::<f64>() / count;
        let (mut place, mut velocity, mut square) = (DVec2::ZERO, DVec2::ZERO, 0.0);
        for k in all() {
            let since = clock.time(k) - time;
            let straight = film.at(k, i) - 0.5 * clock.pull * since * since;
            place += straight / count;
            velocity += straight * since;
            square += since * since;
        }
        Self { time, place, velocity: velocity / square }
    }

    /// Where it is at a time, and how fast.
    fn at(&self, time: f64, pull: DVec2) -> (DVec2, DVec2) {
        let since = time - self.time;
        let place = self.place + self.velocity * since + 0.5 * pull * since * since;
        (place, self.velocity + pull * since)
    }
}

impl Clock {
    fn even(film: &Film, pull: DVec2, largest: f64) -> Self {
        let frames = film.frames.len();
        Self {
            late: vec![0.0; frames],
            blur: vec![f64::INFINITY; frames],
            witnesses: vec![0; frames],
            pull,
            largest,
        }
    }

    fn time(&self, k: usize) -> f64 {
        k as f64 + self.late[k]
    }

    /// Fits flights to the times, then times and gravity to the flights.
    fn adjust(&mut self, film: &Film, runs: &[(usize, Run)]) {
        // For each frame what each disc says of it, and by what weight.
        let mut said: Vec<Vec<(f64, f64)>> = vec![Vec::new(); self.late.len()];
        let (mut bend, mut weight) = (DVec2::ZERO, 0.0);
        for &(i, run) in runs {
            let flight = Flight::of(film, self, i, run);
            let count = (run.end + 1 - run.begin) as f64;
            let since = |k: usize| self.time(k) - flight.time;
            let spread = (run.begin..=run.end).map(|k| since(k).powi(2)).sum::<f64>() / count;
            for (k, said) in said.iter_mut().enumerate().take(run.end + 1).skip(run.begin) {
                let (place, velocity) = flight.at(self.time(k), self.pull);
                let off = film.at(k, i) - place;
                let square = velocity.length_squared();
                if square > 0.0 {
                    said.push((off.dot(velocity) / square, square));
                }
                let curve = 0.5 * (since(k).powi(2) - spread);
                bend += off * curve;
                weight += curve * curve;
            }
        }
        for (k, mut said) in said.into_iter().enumerate() {
            let late = weighted_median(&mut said);
            let all: f64 = said.iter().map(|(_, weight)| weight).sum();
            let digits = film.usual_blur() / all.max(f64::MIN_POSITIVE).sqrt();
            let count = said.len();
            said.iter_mut().for_each(|(value, _)| *value = (*value - late).abs());
            let spread = 2.0 * weighted_median(&mut said) / (count as f64).sqrt();
            self.blur[k] = digits.max(spread);
            self.witnesses[k] = count;
            self.late[k] = (self.late[k] + late).clamp(-self.largest, self.largest);
        }
        if weight > 0.0 {
            self.pull += bend / weight;
        }
    }

    /// How the times between frames differ, if enough of them are known.
    fn gap(&self) -> Option<Gap> {
        let is_told = |k: usize| self.blur[k] < KNOWN && self.witnesses[k] >= WITNESSES;
        let is_known = |k: &usize| is_told(*k) && is_told(*k + 1);
        let known: Vec<usize> = (0..self.late.len() - 1).filter(is_known).collect();
        let time = |k: usize| self.late[k + 1] - self.late[k];
        let mut times: Vec<f64> = known.iter().map(|&k| time(k)).collect();
        let mut blurs: Vec<f64> = known.iter().map(|&k| self.blur[k]).collect();
        if times.len() < FEWEST {
            return None;
        }
        times.sort_by(f64::total_cmp);
        blurs.sort_by(f64::total_cmp);
        // Without what is made of something that was met unseen, or of frames that were lost.
        let middle = times[times.len() / 2];
        let [begin, end] = [-1.1, 1.1]
            .map(|factor| times.partition_point(|&time| time < middle + factor * self.largest));
        let (all, times) = (times.len(), times.get(begin..end)?);
        if 4 * times.len() <= 3 * all {
            return None;
        }
        let [mut short, mut long] = [1, 19].map(|part| times[part * (times.len() - 1) / 20]);
        let mean = |some: &[f64]| some.iter().sum::<f64>() / some.len() as f64;
        for _ in 0..20 {
            let border = times.partition_point(|&time| time < 0.5 * (short + long));
            if border > 0 && border < times.len() {
                (short, long) = (mean(&times[..border]), mean(&times[border..]));
            }
        }
        let part = long - short;
        let is_near = |time: &&f64| (*time - short).abs().min((*time - long).abs()) < 0.35 * part;
        let of_two = times.iter().filter(is_near).count();
        let is_seen = part > LEAST_PART.max(8.0 * blurs[blurs.len() / 2]);
        let border = 0.5 * (short + long);
        let are_by_turns = || by_turns(&known, |k| time(k) > border);
        Some(Gap {
            part,
            is_seen,
            is_of_two: is_seen && 20 * of_two >= 17 * times.len() && are_by_turns(),
        })
    }

    /// Leaves frames where they are of which too little is known.
    fn forget_what_is_not_known(&mut self, gap: f64) {
        for (late, blur) in self.late.iter_mut().zip(&self.blur) {
            if *blur > 0.25 * gap {
                *late = 0.0;
            }
        }
    }

    /// Puts discs where they were at even times.
    fn set(&self, film: &mut Film, runs: &[(usize, Run)]) {
        let frames = film.frames.len();
        let mut even = film.frames.clone();
        for (k, frame) in even.iter_mut().enumerate().filter(|(k, _)| self.late[*k] != 0.0) {
            // In contacts the way from the frame before to the next: only free flights are measured.
            let before = if k > 0 && film.follows[k] { k - 1 } else { k };
            let after = if k + 1 < frames && film.follows[k + 1] { k + 1 } else { k };
            let time = self.time(after) - self.time(before);
            for (i, spot) in frame.iter_mut().enumerate().filter(|_| time > 0.0) {
                let velocity = (film.at(after, i) - film.at(before, i)) / time;
                spot.position -= velocity * self.late[k];
            }
        }
        for &(i, run) in runs {
            let flight = Flight::of(film, self, i, run);
            for (k, frame) in even.iter_mut().enumerate().take(run.end + 1).skip(run.begin) {
                let [(then, _), (now, _)] =
                    [k as f64, self.time(k)].map(|time| flight.at(time, self.pull));
                frame[i].position = film.at(k, i) + then - now;
            }
        }
        film.frames = even;
    }
}

/// Whether the rarer of two lengths hardly ever comes twice running, as with whole steps it must; what drifts does not go
/// so to and fro.
fn by_turns(known: &[usize], is_long: impl Fn(usize) -> bool) -> bool {
    let long = known.iter().filter(|&&k| is_long(k)).count();
    let is_rare = |k: usize| is_long(k) == (2 * long <= known.len());
    let twice = |pair: &&[usize]| pair[1] == pair[0] + 1 && is_rare(pair[0]) && is_rare(pair[1]);
    5 * known.windows(2).filter(twice).count() <= long.min(known.len() - long)
}

/// The median of values with weights; 0 of nothing.
fn weighted_median(said: &mut [(f64, f64)]) -> f64 {
    said.sort_by(|a, b| a.0.total_cmp(&b.0));
    let all: f64 = said.iter().map(|(_, weight)| weight).sum();
    let mut below = 0.0;
    let is_middle = |(_, weight): &&(f64, f64)| {
        below += weight;
        below >= 0.5 * all
    };
    said.iter().find(is_middle).map_or(0.0, |(value, _)| *value)
}
