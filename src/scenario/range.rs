//! The checks that numbers pass at the entrance: the value, or an error with the allowed range and
//! a way out.

use super::error::ScenarioError;
use super::number::Num;

/// `value` if it is in `range`.
pub(super) fn whole(
    field: &str,
    value: i64,
    range: std::ops::RangeInclusive<i64>,
    way_out: &str,
) -> Result<u64, ScenarioError> {
    if range.contains(&value) {
        return Ok(value as u64);
    }
    let allowed = match *range.end() {
        i64::MAX => format!("must be a whole number, at least {}", range.start()),
        end => format!("must be a whole number from {} to {end}", range.start()),
    };
    Err(ScenarioError::out_of_range(field, value, allowed, way_out))
}

pub(super) fn positive(field: &str, value: f64, way_out: &str) -> Result<f64, ScenarioError> {
    if value > 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(ScenarioError::out_of_range(field, Num(value), "must be a finite number above 0", way_out))
}

/// `value` if it is in `range`.
pub(super) fn within(
    field: &str,
    value: f64,
    range: std::ops::RangeInclusive<f64>,
    way_out: &str,
) -> Result<f64, ScenarioError> {
    if range.contains(&value) {
        return Ok(value);
    }
    let allowed = format!("must be from {} to {}", Num(*range.start()), Num(*range.end()));
    Err(ScenarioError::out_of_range(field, Num(value), allowed, way_out))
}

pub(super) fn not_negative(field: &str, value: f64, way_out: &str) -> Result<f64, ScenarioError> {
    if value >= 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(ScenarioError::out_of_range(
        field,
        Num(value),
        "must be a finite number, 0 or more",
        way_out,
    ))
}

pub(super) fn finite(field: &str, value: f64) -> Result<f64, ScenarioError> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(ScenarioError::out_of_range(field, Num(value), "must be a finite number", "write a number"))
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
        true => format!("must be above 0 and below half the side of the box, {} m", Num(largest)),
        false => "must be a finite number above 0".to_owned(),
    };
    let metres = radius / 1000.0;
    let way_out = if radius > 0.0 && field == "radius" && side < 0.01 {
        format!("--radius {}, or a larger --side", Num(round_down(0.01 * side)))
    } else if radius >= 0.01 && metres < 0.1 * side {
        format!("lengths are in metres: {radius} mm is {} m, or write {radius}mm", Num(metres))
    } else if field == "radius" {
        format!("--radius {}", Num(round_down(0.0025 * side)))
    } else {
        "a radius between these".to_owned()
    };
    Err(ScenarioError::out_of_range(field, Num(radius), allowed, way_out))
}

/// `value` cut to one digit.
fn round_down(value: f64) -> f64 {
    let digit = 10f64.powi(value.log10().floor() as i32);
    format!("{:.0e}", (value / digit + 1e-9).floor() * digit).parse().unwrap_or(value)
}
