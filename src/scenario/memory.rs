//! How much memory a run takes: to be known before it is taken, for a system that has no more ends a program without
//! a word.

use super::error::ScenarioError;
use super::{DiscSource, Scenario};
use crate::number::{bytes, rounded_down};

/// The program itself, its buffers, and what it reads.
const PROGRAM: f64 = 12e6; // bytes
/// A disc of a run: measured at 236 to 256 bytes in runs of a million.
const DISC: f64 = 260.0; // bytes
/// What is kept of a disc that came from a frame, and of the frame while it is read.
const FRAMED_DISC: f64 = 80.0; // bytes
/// What a helper keeps for itself.
const HELPER: f64 = 0.1e6; // bytes

impl Scenario {
    /// The memory that a run of this scenario takes at most, all included, in bytes: an estimate on the safe side.
    ///
    /// ```
    /// use parsim2d::scenario::Scenario;
    /// let million = Scenario::from_toml("n = 1_000_000\nside = 1\nthreads = 1").unwrap();
    /// assert_eq!(million.memory(), 272_000_000);
    /// ```
    pub fn memory(&self) -> u64 {
        let disc = match &self.discs {
            DiscSource::Frame { .. } => DISC + FRAMED_DISC,
            _ => DISC,
        };
        (PROGRAM + self.n() as f64 * disc + (self.threads() - 1) as f64 * HELPER) as u64
    }

    /// Refuses a run that takes more memory than there `is` (bytes), which `whose` names.
    ///
    /// # Errors
    ///
    /// [`ScenarioError::OutOfRange`] with the bytes that are needed and those that are there.
    pub fn fit_memory(&self, is: u64, whose: &str) -> Result<(), ScenarioError> {
        let needed = self.memory();
        // What has no room in the box either is refused for that, before any disc is made.
        let is_too_full =
            matches!(self.discs, DiscSource::Equal(_)) && self.packing_fraction() >= 1.0;
        if needed <= is || is_too_full {
            return Ok(());
        }
        let n = self.n();
        let a_disc = (needed as f64 - PROGRAM) / n as f64;
        let most = ((is as f64 - PROGRAM) / a_disc).max(0.0);
        let most = rounded_down(most, 2) as u64; // a number to type
        let allowed = format!(
            "so many discs need about {} of memory, and there are {} ({whose})",
            bytes(needed),
            bytes(is)
        );
        let (field, way_out) = match &self.discs {
            DiscSource::Equal(_) if most > 0 => ("n", format!("-n {most}, or more memory")),
            _ => ("the number of discs", "fewer discs, or more memory".to_owned()),
        };
        Err(ScenarioError::out_of_range(field, n, allowed, way_out))
    }
}
