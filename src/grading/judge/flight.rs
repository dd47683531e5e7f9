//! Free flight: the stretches of film in which a disc meets nobody, and what they say of gravity.
//!
//! With frames equally far apart in time, the second difference of a free disc's positions is one
//! constant vector (0, -c) with c = g T², T the time between frames. That is exact for explicit
//! and symplectic Euler and for Verlet, and needs no column of time.

mod falling;
mod odd;

use glam::DVec2;

pub use self::falling::verdict;
use super::film::Film;
use super::near::{self, Near};
use super::rubric::Rubric;

/// Frames `begin` to `end` of a disc that meets nobody between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// First frame.
    pub begin: usize,
    /// Last frame.
    pub end: usize,
}

/// A second difference over frames `middle - half` to `middle + half`.
#[derive(Clone, Copy, Debug)]
struct Sample {
    disc: usize,
    middle: usize,
    /// m a frame².
    value: DVec2,
    /// What printing makes of it at most.
    blur: f64,
    /// m a frame.
    velocity: DVec2,
}

/// The free flights of a film.
#[derive(Clone, Debug)]
pub struct Flights {
    /// Whom each disc may have met in each interval.
    pub near: Vec<Vec<Near>>,
    /// Free stretches of each disc.
    pub runs: Vec<Vec<Run>>,
    /// The second difference that most have, m a frame², and what printing makes of it at most.
    pub pull: DVec2,
    pull_blur: f64,
    /// Intervals left out for being longer or shorter in time than the others.
    pub uneven: usize,
    samples: Vec<Sample>,
}

impl Flights {
    /// Finds them. Frames whose neighbours are at odds with all others were spaced unevenly (a frame
    /// between was lost) and are left out, if they are few.
    pub fn of(film: &Film, rubric: &Rubric) -> Self {
        let plain = near::usable(film, &[]);
        let first = Self::between(film, &plain, rubric);
        let uneven = first.uneven_intervals(film, &plain);
        let count = uneven.iter().filter(|&&is| is).count();
        if count == 0 || 3 * count > plain.len() {
            return first;
        }
        let mut again = Self::between(film, &near::usable(film, &uneven), rubric);
        again.uneven = count;
        again
    }

    /// All of them, whether frames are equally far apart or not.
    pub fn plain(film: &Film, rubric: &Rubric) -> Self {
        Self::between(film, &near::usable(film, &[]), rubric)
    }

    fn between(film: &Film, usable: &[bool], rubric: &Rubric) -> Self {
        let mut flights = Self {
            near: Vec::new(),
            runs: Vec::new(),
            pull: DVec2::ZERO,
            pull_blur: f64::INFINITY,
            uneven: 0,
            samples: Vec::new(),
        };
        // Twice: how low a bounce may hide between frames hangs on what gravity is.
        for _ in 0..2 {
            let drop = 2.0 * flights.pull.length();
            flights.near = near::near(film, usable, drop, rubric);
            flights.runs = (0..film.n()).map(|i| runs(&flights.near, i)).collect();
            flights.measure(film);
        }
        flights
    }

    /// The velocity of disc `i` at frame `k`, the beginning or the end of `run`, m a frame.
    pub fn velocity(&self, film: &Film, i: usize, run: Run, k: usize) -> DVec2 {
        let length = (run.end - run.begin) as f64;
        let mean = (film.at(run.end, i) - film.at(run.begin, i)) / length;
        let sign = if k == run.begin { -0.5 } else { 0.5 };
        mean + self.pull * (sign * length)
    }

    /// What printing makes of that velocity at most, m a frame.
    pub fn velocity_blur(film: &Film, run: Run) -> f64 {
        2.0 * film.usual_blur() / (run.end - run.begin) as f64
    }

    /// The time between frames, s, if gravity is the rubric's.
    pub fn interval(&self, rubric: &Rubric) -> Option<f64> {
        let seen = self.pull.length() > 3.0 * self.pull_blur && rubric.gravity > 0.0;
        seen.then(|| (self.pull.length() / rubric.gravity).sqrt())
    }

    /// Whether gravity is known to a twentieth, so that heights may be counted as energy.
    pub fn is_sharp(&self, rubric: &Rubric) -> bool {
        rubric.gravity == 0.0 || self.pull_blur < 0.05 * self.pull.length()
    }

    /// Pull from whole runs, then samples as short as the printed digits allow.
    fn measure(&mut self, film: &Film) {
        let mut whole: Vec<Sample> = self
            .each_run()
            .filter_map(|(i, run)| sample(film, i, run.begin, (run.end - run.begin) / 2))
            .collect();
        whole.sort_by(|a, b| a.blur.total_cmp(&b.blur));
        whole.truncate((whole.len() / 4).max(8));
        self.pull = DVec2::new(
            median(whole.iter().map(|s| s.value.x)),
            median(whole.iter().map(|s| s.value.y)),
        );
        self.pull_blur = median(whole.iter().map(|s| s.blur));
        let half = (4.0 * film.usual_blur() / (0.03 * self.pull.length())).sqrt().ceil();
        let half = if half.is_finite() { half.clamp(1.0, 50.0) as usize } else { 3 };
        let cut = |(i, run): (usize, Run)| {
            let half = half.min((run.end - run.begin) / 2).max(1);
            let begins = (run.begin..).step_by(half).take_while(move |b| b + 2 * half <= run.end);
            begins.filter_map(move |begin| sample(film, i, begin, half)).collect::<Vec<_>>()
        };
        self.samples = self.each_run().flat_map(cut).collect();
    }

    fn each_run(&self) -> impl Iterator<Item = (usize, Run)> {
        self.runs.iter().enumerate().flat_map(|(i, runs)| runs.iter().map(move |&run| (i, run)))
    }

    /// By how much a sample is off, in units of what it may be.
    fn off(&self, sample: &Sample) -> f64 {
        let may = sample.blur + self.pull_blur + 0.02 * self.pull.length();
        (sample.value - self.pull).length() / may
    }

    /// The intervals at frames at which nearly all discs are off together.
    fn uneven_intervals(&self, film: &Film, usable: &[bool]) -> Vec<bool> {
        let frames = film.frames.len();
        let (mut off, mut all) = (vec![0; frames], vec![0; frames]);
        let short = |(i, run): (usize, Run)| {
            (run.begin..run.end - 1).filter_map(move |begin| sample(film, i, begin, 1))
        };
        let samples: Vec<Sample> = self.each_run().flat_map(short).collect();
        // Long runs go across the very intervals that are looked for: the usual pull is that of short ones.
        let usual = DVec2::new(
            median(samples.iter().map(|s| s.value.x)),
            median(samples.iter().map(|s| s.value.y)),
        );
        for one in samples {
            let may = 2.0 * one.blur + 0.02 * usual.length();
            all[one.middle] += 1;
            off[one.middle] += usize::from((one.value - usual).length() > may);
        }
        let is_off = |k: usize| all[k] >= 3 && 10 * off[k] >= 7 * all[k];
        (0..usable.len()).map(|k| is_off(k) && is_off(k + 1)).collect()
    }
}

fn runs(near: &[Vec<Near>], i: usize) -> Vec<Run> {
    let (mut runs, mut begin) = (Vec::new(), None);
    for (k, row) in near.iter().enumerate() {
        match (row[i].is_free(), begin) {
            (true, None) => begin = Some(k),
            (false, Some(from)) => {
                runs.push(Run { begin: from, end: k });
                begin = None;
            }
            _ => {}
        }
    }
    runs.extend(begin.map(|from| Run { begin: from, end: near.len() }));
    runs
}

fn sample(film: &Film, i: usize, begin: usize, half: usize) -> Option<Sample> {
    if half == 0 {
        return None;
    }
    let [a, b, c] = [0, half, 2 * half].map(|ahead| film.at(begin + ahead, i));
    let square = (half * half) as f64;
    Some(Sample {
        disc: i,
        middle: begin + half,
        value: (a - 2.0 * b + c) / square,
        blur: (film.blur(a) + 2.0 * film.blur(b) + film.blur(c)) / square,
        velocity: (c - a) / (2 * half) as f64,
    })
}

/// The median, 0 of nothing.
pub fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
