//! Who may have touched whom between two frames.
//!
//! What happens between frames is not seen. So an interval counts as free only if nobody can have
//! been met on the straight way from frame to frame, on the way on from the frame before, or on the
//! way back from the frame after.

use glam::DVec2;

use super::film::Film;
use super::rubric::Rubric;
use super::wall::WALLS;

/// Whom a disc may have met in an interval.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Near {
    /// Walls, as bits.
    pub walls: u8,
    /// A disc.
    pub partner: Option<u32>,
    /// More than one disc, or the interval cannot be used.
    pub many: bool,
}

impl Near {
    /// Nothing was near.
    pub fn is_free(self) -> bool {
        self == Self::default()
    }

    /// One disc and nothing else was near.
    pub fn with(partner: usize) -> Self {
        Self { partner: Some(partner as u32), ..Self::default() }
    }

    fn meets(&mut self, j: usize) {
        self.many |= self.partner.is_some_and(|known| known as usize != j);
        self.partner = Some(j as u32);
    }
}

/// The intervals of a film that may be used: not across dropped frames, nor the last one, for
/// many programs write their last state whenever it comes.
pub fn usable(film: &Film, uneven: &[bool]) -> Vec<bool> {
    let intervals = film.frames.len().saturating_sub(1);
    let is_last = |k: usize| intervals >= 4 && k + 1 == intervals;
    (0..intervals)
        .map(|k| film.follows[k + 1] && !is_last(k) && !uneven.get(k).is_some_and(|&is| is))
        .collect()
}

/// For each interval and disc, whom it may have met; `drop` is how far a disc falls from rest in
/// two frames, m: one that bounces lower than that may do so between frames unseen.
pub fn near(film: &Film, usable: &[bool], drop: f64, rubric: &Rubric) -> Vec<Vec<Near>> {
    let mut near = vec![vec![Near::default(); film.n()]; usable.len()];
    for (k, row) in near.iter_mut().enumerate() {
        if !usable[k] {
            row.iter_mut().for_each(|one| one.many = true);
            continue;
        }
        let ways: Vec<[DVec2; 4]> = (0..film.n()).map(|i| ways(film, usable, k, i)).collect();
        for (i, one) in row.iter_mut().enumerate() {
            one.walls = walls(film, &ways[i], i, drop, rubric);
        }
        pairs(film, &ways, row);
    }
    near
}

/// Begin and end of an interval, where the way on leads, and where the way back leads.
fn ways(film: &Film, usable: &[bool], k: usize, i: usize) -> [DVec2; 4] {
    let (begin, end) = (film.at(k, i), film.at(k + 1, i));
    let on = match k > 0 && usable[k - 1] {
        true => 2.0 * begin - film.at(k - 1, i),
        false => end,
    };
    let back = match usable.get(k + 1) == Some(&true) {
        true => 2.0 * end - film.at(k + 2, i),
        false => begin,
    };
    [begin, end, on, back]
}

fn walls(film: &Film, ways: &[DVec2; 4], i: usize, drop: f64, rubric: &Rubric) -> u8 {
    let centre = DVec2::from(rubric.corner) + DVec2::splat(0.5 * rubric.side);
    let radius = film.radius(i);
    let slack = 0.1 * radius + 4.0 * film.usual_blur();
    let mut met = 0;
    for (normal, bit) in WALLS {
        let reach = radius + slack + if normal.y != 0.0 { drop } else { 0.0 };
        let is_near = |p: &DVec2| 0.5 * rubric.side - (*p - centre).dot(normal) < reach;
        if ways.iter().any(is_near) {
            met |= bit;
        }
    }
    met
}

fn pairs(film: &Film, ways: &[[DVec2; 4]], row: &mut [Near]) {
    let blur = 8.0 * film.usual_blur();
    let span = |way: &[DVec2; 4]| {
        way.iter().fold((f64::MAX, f64::MIN), |(low, high), p| (low.min(p.x), high.max(p.x)))
    };
    let spans: Vec<(f64, f64)> = ways.iter().map(span).collect();
    for i in 0..ways.len() {
        for j in i + 1..ways.len() {
            let reach = 1.2 * (film.radius(i) + film.radius(j)) + blur;
            let is_apart = spans[i].0 - spans[j].1 > reach || spans[j].0 - spans[i].1 > reach;
            if !is_apart && meet(&ways[i], &ways[j], reach) {
                row[i].meets(j);
                row[j].meets(i);
            }
        }
    }
}

fn meet(i: &[DVec2; 4], j: &[DVec2; 4], reach: f64) -> bool {
    let [begin, end, on, back] = [0, 1, 2, 3].map(|way| j[way] - i[way]);
    [(begin, end), (begin, on), (end, back)].into_iter().any(|(from, to)| nearest(from, to) < reach)
}

/// How near the way from `from` to `to` comes to the origin.
fn nearest(from: DVec2, to: DVec2) -> f64 {
    let way = to - from;
    let square = way.length_squared();
    let t = if square > 0.0 { (-from.dot(way) / square).clamp(0.0, 1.0) } else { 0.0 };
    (from + t * way).length()
}
