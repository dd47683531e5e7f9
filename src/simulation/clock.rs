//! The clock of a simulation: steps done, and the time they took.

use crate::discs::columns::{Array, ArrayView, rows};

/// Steps and time. The time step may change: time is counted from where it last did, so that it does not
/// gather a rounding error at each step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Clock {
    steps: u64,
    dt: f64, // s
    /// The step at which `dt` was last changed, and the time then, s.
    base_steps: u64,
    base_time: f64,
}

impl Clock {
    /// At t = 0, with steps of `dt` s.
    pub fn new(dt: f64) -> Self {
        Self { dt, ..Self::default() }
    }

    /// One step more.
    pub fn tick(&mut self) {
        self.steps += 1;
    }

    /// Steps of `dt` s from now on.
    pub fn set_dt(&mut self, dt: f64) {
        if dt.to_bits() != self.dt.to_bits() {
            *self = Self { steps: self.steps, dt, base_steps: self.steps, base_time: self.time() };
        }
    }

    /// Steps done.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The time step, s.
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// Time, s: that of the last change of the time step, and the steps since times the time step.
    pub fn time(&self) -> f64 {
        self.base_time + (self.steps - self.base_steps) as f64 * self.dt
    }

    /// What it remembers, by name.
    pub fn arrays(self) -> [(&'static str, ArrayView<'static>); 2] {
        let counts = [self.steps, self.base_steps].into_iter();
        [
            ("steps", ArrayView::of_rows(counts)),
            ("clock", ArrayView::of_rows([[self.dt, self.base_time]].into_iter())),
        ]
    }

    /// The clock that `arrays` have, taken out of them.
    ///
    /// # Errors
    ///
    /// Names the array that is missing or does not fit.
    pub fn from_arrays(arrays: &mut Vec<(String, Array)>) -> Result<Self, String> {
        let counts: Vec<u64> = rows(arrays, "steps", Some(2))?;
        let [dt, base_time]: [f64; 2] = rows(arrays, "clock", Some(1))?[0];
        let (steps, base_steps) = (counts[0], counts[1]);
        if base_steps > steps {
            return Err("array steps: dt was changed after the last step".to_owned());
        }
        Ok(Self { steps, dt, base_steps, base_time })
    }
}
