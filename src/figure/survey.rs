//! A first look at all frames of a file: what to show, in what colours, how many there are.

use super::frame;
use super::scene::{Extent, View};
use crate::output::frames::Frame;

/// What all frames have in common. Takes in one frame at a time, and keeps none.
#[derive(Clone, Copy, Debug)]
pub struct Survey {
    /// Number of frames.
    pub frames: usize,
    /// Number of discs of the first frame.
    pub discs: usize,
    /// Number of discs of the frame with most of them.
    pub most_discs: usize,
    /// The fastest speed of all, m/s.
    pub fastest: f64,
    /// Whether the frames have velocities.
    pub has_velocities: bool,
    /// Side of the box, m, if the first frame says it.
    pub side: Option<f64>,
    extent: Extent,
}

impl Survey {
    /// Of no frame yet.
    pub fn begin() -> Self {
        Self {
            frames: 0,
            discs: 0,
            most_discs: 0,
            fastest: 0.0,
            has_velocities: false,
            side: None,
            extent: Extent::EMPTY,
        }
    }

    /// Takes in a frame.
    pub fn add(&mut self, frame: &Frame) {
        if self.frames == 0 {
            self.side = frame.side;
            self.discs = frame.rows.len();
        }
        self.frames += 1;
        self.most_discs = self.most_discs.max(frame.rows.len());
        self.has_velocities |= frame::has_velocities(frame);
        self.fastest = self.fastest.max(frame::fastest(frame));
        self.extent.add(frame);
    }

    /// The part of the plane that shows all frames.
    pub fn view(&self) -> View {
        View::of(self.extent, self.side)
    }
}
