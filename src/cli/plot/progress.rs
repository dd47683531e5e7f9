//! How far a long drawing is, on terminals only, from the second second on.

use std::cell::Cell;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// What is done sooner shows no bar.
const PATIENCE: Duration = Duration::from_secs(1);

/// A bar, or a count where the end is not known.
pub struct Progress {
    began: Instant,
    bar: ProgressBar,
    is_shown: Cell<bool>,
}

impl Progress {
    /// Begins to count `frames`, if known how many.
    pub fn begin(frames: Option<usize>) -> Self {
        let bar = ProgressBar::with_draw_target(
            frames.map(|frames| frames as u64),
            ProgressDrawTarget::hidden(),
        );
        let template = match frames {
            Some(_) => "{bar:40} {percent:>3} %  frame {pos} of {len}  {eta} left",
            None => "{spinner} reading, frame {pos}",
        };
        let style = ProgressStyle::with_template(template).expect("a fixed, tested template");
        Self { began: Instant::now(), bar: bar.with_style(style), is_shown: Cell::new(false) }
    }

    /// One frame more is done.
    pub fn advance(&self) {
        self.bar.inc(1);
        if !self.is_shown.get() && self.began.elapsed() > PATIENCE {
            self.is_shown.set(true);
            self.bar.set_draw_target(ProgressDrawTarget::stderr_with_hz(10));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
