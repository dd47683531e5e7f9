//! The ranges of numbers, checked at the entrance: the value, or an error with the allowed range and a way out.

use super::error::ScenarioError;
use crate::number::{rounded_down, shortest};

/// The finite numbers from `least` to `most`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The lower end.
    pub least: f64,
    /// The upper end, which belongs to it unless it is infinite.
    pub most: f64,
    /// Whether the lower end does not belong to it.
    pub is_open: bool,
    /// How it is said, where that is more than its ends.
    pub words: &'static str,
}

/// Any finite number.
pub const ANY: Range = from_to(f64::NEG_INFINITY, f64::INFINITY);
/// What is above zero.
pub const ABOVE_0: Range = above_to(0.0, f64::INFINITY);
/// What is not below zero.
pub const FROM_0: Range = from_to(0.0, f64::INFINITY);
/// What is not below one.
pub const FROM_1: Range = from_to(1.0, f64::INFINITY);

/// From `least` to `most`, both included.
pub const fn from_to(least: f64, most: f64) -> Range {
    Range { least, most, is_open: false, words: "" }
}

/// Above `least`, and up to `most`.
pub const fn above_to(least: f64, most: f64) -> Range {
    Range { least, most, is_open: true, words: "" }
}

impl Range {
    fn has(self, value: f64) -> bool {
        let is_high = if self.is_open { value > self.least } else { value >= self.least };
        is_high && value <= self.most && value.is_finite()
    }

    /// `value` of the `field` if it is in this range.
    pub(super) fn check(
        self,
        field: &str,
        value: f64,
        way_out: &str,
    ) -> Result<f64, ScenarioError> {
        if self.has(value) {
            return Ok(value);
        }
        Err(ScenarioError::out_of_range(field, shortest(value), self.allowed(), way_out))
    }

    /// The whole number `value` of the `field` if it is in this range.
    pub(super) fn check_whole(
        self,
        field: &str,
        value: i64,
        way_out: &str,
    ) -> Result<u64, ScenarioError> {
        if self.has(value as f64) {
            return Ok(value as u64);
        }
        let allowed = match self {
            Self { least, most: f64::INFINITY, .. } => {
                format!("must be a whole number, at least {least}")
            }
            Self { least, most, .. } => format!("must be a whole number from {least} to {most}"),
        };
        Err(ScenarioError::out_of_range(field, value, allowed, way_out))
    }

    /// What must be, in words.
    fn allowed(self) -> String {
        let (least, most) = (shortest(self.least), shortest(self.most));
        match (self.is_open, self.most) {
            _ if !self.words.is_empty() => self.words.to_owned(),
            _ if self == ANY => "must be a finite number".to_owned(),
            (true, f64::INFINITY) => format!("must be a finite number above {least}"),
            (false, f64::INFINITY) => format!("must be a finite number, {least} or more"),
            (true, _) => format!("must be above {least} and at most {most}"),
            (false, _) => format!("must be from {least} to {most}"),
        }
    }
}

/// The radius of a disc in a box of `side` (m): positive, and less than half the side where there
/// are walls on both sides.
pub(super) fn radius_in(
    side: f64,
    field: &str,
    radius: f64,
    walls: bool,
) -> Result<f64, ScenarioError> {
    let largest = if walls { 0.5 * side } else { f64::INFINITY };
    if radius > 0.0 && radius.is_finite() && radius < largest {
        return Ok(radius);
    }
    let allowed = match walls {
        true => {
            format!("must be above 0 and below half the side of the box, {} m", shortest(largest))
        }
        false => "must be a finite number above 0".to_owned(),
    };
    let metres = radius / 1000.0;
    let way_out = if radius > 0.0 && field == "radius" && side < 0.01 {
        format!("--radius {}, or a larger --side", shortest(rounded_down(0.01 * side, 1)))
    } else if radius >= 0.01 && metres < 0.1 * side {
        format!("lengths are in metres: {radius} mm is {} m, or write {radius}mm", shortest(metres))
    } else if field == "radius" {
        format!("--radius {}", shortest(rounded_down(0.0025 * side, 1)))
    } else {
        "a radius between these".to_owned()
    };
    Err(ScenarioError::out_of_range(field, shortest(radius), allowed, way_out))
}
