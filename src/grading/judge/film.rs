//! A film: the same discs in frame after frame, in metres.

use glam::DVec2;

use super::digits::Digits;
use super::misread::Misread;
use super::rubric::Rubric;
use super::spot::Spot;

/// Frames in which a film that is fine enough shows discs that are not fast yet.
const EARLY: usize = 10;

/// Frames as written, without torn ones and without a constant border.
#[derive(Clone, Debug)]
pub struct Film {
    /// The frames; a wrong program's may differ in length.
    pub frames: Vec<Vec<Spot>>,
    /// For each frame, whether it follows the one before it directly (nothing was dropped).
    pub follows: Vec<bool>,
    /// How finely positions were printed.
    pub digits: Digits,
    /// Frames that were cut and left out.
    pub torn: usize,
    /// Whether it was cut where discs began to run wild.
    pub is_wild: bool,
    /// Whether the printed radii were diameters, and have been halved.
    pub halved: bool,
    /// Whether its first three columns of more were taken for x, y and r, and nothing says that they are.
    pub is_taken: bool,
    /// How it was written instead of `x y r` in m, if it was; it has been put right.
    pub misread: Option<Misread>,
    /// Side of the box, m.
    pub side: f64,
    /// Lower left corner of the box, m.
    pub corner: DVec2,
}

impl Film {
    /// The first frames, as many as make up so much `work`: frames times the square of discs.
    pub fn within(self, work: usize) -> Self {
        let n = self.n().max(1);
        self.before((work / n.saturating_mul(n)).max(12))
    }

    /// Discs in the first frame.
    pub fn n(&self) -> usize {
        self.frames.first().map_or(0, Vec::len)
    }

    /// Where disc `i` is in frame `k`, m.
    pub fn at(&self, k: usize, i: usize) -> DVec2 {
        self.frames[k][i].position
    }

    /// Radius of disc `i`, m.
    pub fn radius(&self, i: usize) -> f64 {
        self.frames[0][i].radius
    }

    /// Whether nobody moves at all, in a film long enough to tell.
    pub fn is_still(&self) -> bool {
        self.frames.len() >= 10 && self.frames.iter().all(|frame| frame == &self.frames[0])
    }

    /// What a printed position may be off, m: half a unit of the last place, and no less than what
    /// sums in single precision lose (6e-8 of a third of the side).
    pub fn blur(&self, position: DVec2) -> f64 {
        let printed = self.digits.half_unit(position.x).max(self.digits.half_unit(position.y));
        printed.max(2e-8 * self.side)
    }

    /// What any position in the box may be off, m.
    pub fn usual_blur(&self) -> f64 {
        self.blur(DVec2::splat(0.5 * self.side))
    }

    /// The frames before this one.
    pub fn before(mut self, frame: usize) -> Self {
        self.frames.truncate(frame);
        self.follows.truncate(frame);
        self
    }

    /// The film up to where a disc that had long left the box comes to infinity: that disc is judged by
    /// where it left, not by its last numbers.
    pub fn before_it_blew_up(self) -> Self {
        let is_bad = |spot: &Spot| !spot.position.is_finite();
        let Some(k) = self.frames.iter().position(|frame| frame.iter().any(is_bad)) else {
            return self;
        };
        let far = 1e3 * self.side;
        let before = k.checked_sub(1).map(|before| &self.frames[before]);
        let is_far = |spot: &Spot| spot.position.length() > far;
        if before.is_some_and(|frame| frame.iter().any(is_far)) {
            return self.before(k);
        }
        self
    }

    /// The film up to where a disc goes half through the box in a frame: what made it so fast is seen before,
    /// and after it nobody's way can be followed.
    pub fn before_it_ran_wild(mut self) -> Self {
        let is_in = |k: usize, i: usize| {
            let place = self.at(k, i) - self.corner;
            place.min_element() >= 0.0 && place.max_element() <= self.side
        };
        let is_whole = |k: usize| self.frames[k].len() == self.n() && self.follows[k];
        // Whether somebody within the box went farther than this part of it.
        let goes = |k: usize, part: f64| {
            let way = |i: usize| (self.at(k, i) - self.at(k - 1, i)).length();
            let goes = |i: usize| {
                // Through the whole box: it came back at the other side.
                is_in(k, i) && is_in(k - 1, i) && (part..0.9).contains(&(way(i) / self.side))
            };
            is_whole(k) && is_whole(k - 1) && (0..self.n()).any(goes)
        };
        let frames = self.frames.len();
        let was_calm = !(1..frames.min(EARLY)).any(|k| goes(k, 0.1));
        let first = (1..frames).find(|&k| goes(k, 0.5)).filter(|_| was_calm);
        if let Some(k) = first {
            self.is_wild = true;
            return self.before(k);
        }
        self
    }

    /// The film with radii halved, if what was printed is twice what the rubric asks for.
    pub fn with_true_radii(mut self, rubric: &Rubric) -> Self {
        let is = |radius: f64, asked: f64| (radius / asked - 1.0).abs() < 1e-3;
        let all = |factor: f64| {
            self.n() > 0
                && rubric
                    .radius
                    .iter()
                    .any(|&asked| self.frames[0].iter().all(|spot| is(spot.radius, factor * asked)))
        };
        if all(2.0) && !all(1.0) {
            self.halved = true;
            for spot in self.frames.iter_mut().flatten() {
                spot.radius *= 0.5;
            }
        }
        self
    }
}
