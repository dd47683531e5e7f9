//! The frames of a run as a page carries them: five bytes a disc, thinned out where they are many.

use glam::DVec2;

use crate::figure::frame::speed;
use crate::figure::scene::View;
use crate::figure::survey::Survey;
use crate::output::frames::Frame;

/// A film has at most so many frames.
pub const MOST_FRAMES: usize = 400;
/// A film shows at most so many discs.
pub const MOST_DISCS: usize = 25_000;
/// Discs times frames of a film, at most: 3.3 MB of text.
pub const MOST_PLACES: usize = 500_000;
/// Rather than fewer frames than this, a film has fewer discs.
const FEWEST_FRAMES: usize = 100;
/// Bytes of a disc in a frame: 2 for x, 2 for y, the low one first, 1 for the speed.
pub const BYTES: usize = 5;
/// The largest place: x and y are 0 to this across the picture.
pub const SCALE: u16 = u16::MAX;
/// The largest speed, that of the fastest disc of all.
pub const FASTEST: u8 = 254;
/// Said instead of a speed: the disc is not in this frame, or not in the picture.
pub const ABSENT: u8 = 255;

/// Frames being gathered for a page. Each disc keeps its number, which is its row.
#[derive(Clone, Debug)]
pub struct Film {
    survey: Survey,
    kept: usize,
    disc_step: usize,
    seen: usize,
    times: Vec<Option<f64>>, // s
    radii: Vec<f64>,         // m
    places: Vec<u8>,
}

impl Film {
    /// An empty film of the frames that `survey` has seen.
    pub fn begin(survey: Survey) -> Self {
        let (frames, discs) = (survey.frames.max(1), survey.most_discs.max(1));
        let room = (MOST_PLACES / discs).clamp(FEWEST_FRAMES, MOST_FRAMES);
        let kept = frames.min(room);
        let disc_step = (kept * discs).div_ceil(MOST_PLACES).max(discs.div_ceil(MOST_DISCS));
        let discs = discs.div_ceil(disc_step);
        Self {
            survey,
            kept,
            disc_step,
            seen: 0,
            times: Vec::new(),
            radii: vec![0.0; discs],
            places: Vec::new(),
        }
    }

    /// The number of the frame, of those surveyed, that is number `k` of the film; the first and the
    /// last are among them.
    fn wanted(&self, k: usize) -> usize {
        let last = self.survey.frames.saturating_sub(1);
        if self.kept < 2 { last } else { (k * last + (self.kept - 1) / 2) / (self.kept - 1) }
    }

    /// Takes in the next frame of those surveyed, if it is one of those kept.
    pub fn add(&mut self, frame: &Frame) {
        let index = self.seen;
        self.seen += 1;
        if self.times.len() >= self.kept || self.wanted(self.times.len()) != index {
            return;
        }
        self.times.push(frame.time);
        let view = self.view();
        for (disc, radius) in self.radii.iter_mut().enumerate() {
            let row = frame.rows.get(disc * self.disc_step).filter(|row| view.holds(row.position));
            let Some(row) = row else {
                self.places.extend([0, 0, 0, 0, ABSENT]);
                continue;
            };
            *radius = radius.max(row.radius);
            let [x, y] = place(row.position, view).map(u16::to_le_bytes);
            let share = (speed(row) / self.survey.fastest * f64::from(FASTEST)).round(); // NaN at rest
            self.places.extend([x[0], x[1], y[0], y[1], share as u8]);
        }
    }

    /// Frames of the film, and of the file.
    pub fn frames(&self) -> (usize, usize) {
        (self.times.len(), self.survey.frames)
    }

    /// Every so-manieth disc is shown.
    pub fn disc_step(&self) -> usize {
        self.disc_step
    }

    /// Discs that the film shows.
    pub fn discs(&self) -> usize {
        self.radii.len()
    }

    /// Times of the frames, s, if all say one and each is later than the one before.
    pub fn times(&self) -> Option<Vec<f64>> {
        let times: Vec<f64> = self.times.iter().copied().collect::<Option<_>>()?;
        times.is_sorted_by(|a, b| a < b).then_some(times)
    }

    /// Radii of the discs, m, the largest that each ever had; one for all if they are equal.
    pub fn radii(&self) -> &[f64] {
        let are_equal = self.radii.iter().all(|radius| *radius == self.radii[0]);
        if are_equal { &self.radii[..1] } else { &self.radii }
    }

    /// Speed of the fastest disc, m/s, if the frames have velocities and anything moves.
    pub fn fastest(&self) -> Option<f64> {
        let Survey { has_velocities, fastest, .. } = self.survey;
        (has_velocities && fastest > 0.0).then_some(fastest)
    }

    /// Side of the box, m, if there is one.
    pub fn side(&self) -> Option<f64> {
        self.survey.side
    }

    /// What is shown of the plane.
    pub fn view(&self) -> View {
        self.survey.view()
    }

    /// All places, frame by frame and disc by disc, as base64.
    pub fn places(&self) -> String {
        base64(&self.places)
    }
}

/// Where a point lies across the picture, from its lower left corner, 0 to [`SCALE`].
fn place(position: DVec2, view: View) -> [u16; 2] {
    let share = (position - view.corner) / view.width * f64::from(SCALE);
    [share.x, share.y].map(|share| share.round() as u16)
}

/// Bytes as text (RFC 4648).
///
/// ```
/// use parsim2d::page::film::base64;
/// assert_eq!(["f", "fo", "foo"].map(|s| base64(s.as_bytes())), ["Zg==", "Zm8=", "Zm9v"]);
/// ```
pub fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |k: usize| u32::from(three.get(k).copied().unwrap_or(0));
        let whole = byte(0) << 16 | byte(1) << 8 | byte(2);
        for k in 0..4 {
            let digit = DIGITS[(whole >> (18 - 6 * k) & 63) as usize];
            text.push(if k > three.len() { '=' } else { char::from(digit) });
        }
    }
    text
}
