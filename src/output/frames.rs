//! Frames: where the discs are at one moment, and what they are. One disc a line, `x y r` and more, for
//! gnuplot, numpy and people.
//!
//! A frame begins with one `#` line of names and values, `# step 0 time_s 0 n 20 side_m 0.04 columns x y r`.
//! In a file of many frames two blank lines stand *before* every frame but the first, which is
//! what gnuplot's `index` counts (a trailing gap would add a phantom frame).
//!
//! Files of others are read, too, each format in a file of its own: [`table`] (headings by name, CSV, Poeschel
//! and Schwager's), [`xyz`], [`lammps`]. What their columns are is said by a heading, by hand ([`layout`]),
//! or guessed ([`guess`]).

pub mod column;
mod comment;
pub mod csv;
pub mod format;
mod frame;
pub mod guess;
mod head;
mod ids;
pub mod lammps;
pub mod layout;
mod lines;
mod reader;
mod remarks;
mod rows;
mod separator;
pub mod table;
pub mod text;
pub mod writer;
pub mod xyz;

use std::io::BufRead;

pub use self::frame::{Frame, FrameRow};
pub use self::head::{Columns, Head};
pub use self::reader::{Frames, Reading};
pub use self::remarks::Told;
pub(super) use self::rows::write_rows;
pub use self::text::{write_border, write_frame};

/// Reads one frame, number `wanted` from 0, or the last. Of tables: rows past the `n` of the
/// frame's header (a border) are left out, and any run of blank lines ends a frame.
///
/// Errors are sentences that name the line.
pub fn read_frame(input: impl BufRead, wanted: Option<usize>) -> Result<Frame, String> {
    read_frame_as(input, &Reading::default(), wanted).map(|(frame, _)| frame)
}

/// The same of a file that is read as `said`; also what is to be told of it.
pub fn read_frame_as(
    input: impl BufRead,
    said: &Reading,
    wanted: Option<usize>,
) -> Result<(Frame, Told), String> {
    let mut frames = Frames::read_as(input, said);
    let mut last = None;
    while let Some(frame) = frames.next_frame()? {
        if wanted == Some(frames.read() - 1) {
            let told = frames.told();
            frames.check_order_after(&frame)?;
            return Ok((frame.whole()?, told));
        }
        last = Some(frame);
    }
    match (wanted, last) {
        (_, None) => Err("it holds no frame".to_owned()),
        (Some(k), Some(_)) => {
            Err(format!("frame {k} was asked for; it holds frames 0 to {}", frames.read() - 1))
        }
        (None, Some(frame)) => Ok((frame.whole()?, frames.told())),
    }
}
