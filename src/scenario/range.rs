//! The checks that numbers pass at the entrance: the value, or an error with the allowed range and
//! a way out.

use super::error::ScenarioError;

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
    Err(ScenarioError::out_of_range(
        field,
        value,
        "must be a finite number above 0",
        way_out,
    ))
}

pub(super) fn not_negative(field: &str, value: f64, way_out: &str) -> Result<f64, ScenarioError> {
    if value >= 0.0 && value.is_finite() {
        return Ok(value);
    }
    Err(ScenarioError::out_of_range(
        field,
        value,
        "must be a finite number, 0 or more",
        way_out,
    ))
}

pub(super) fn finite(field: &str, value: f64) -> Result<f64, ScenarioError> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(ScenarioError::out_of_range(
        field,
        value,
        "must be a finite number",
        "write a number",
    ))
}

/// A radius must be positive, and less than half the side where there are walls on both sides.
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
    let allowed = format!("must be above 0 and below half the side of the box, {largest} m");
    let way_out = match radius / 1000.0 {
        metres if radius >= largest && metres < 0.1 * side => {
            format!("lengths are in metres: {radius} mm is {metres} m, or write {radius}mm")
        }
        _ => "--radius 1e-4, or a larger --side".to_owned(),
    };
    Err(ScenarioError::out_of_range(field, radius, allowed, way_out))
}
